// Structs as JSON and back, from one list of their members: fields(archive, value) calls archive("name", value.member)
// for each. A number that is infinite is null, since JSON has no word for it.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "chapters/terminal/json_file.h"
#include "chapters/terminal/json_text.h"
#include "rasterizer/base/image.h"

namespace crevice {

class JsonWriter {
 public:
    using Json = JsonFile::Json;

    template <class T>
    void operator()(const char* name, const T& value) {
        object_[name] = written(value);
    }
    Json object() && { return std::move(object_); }

    static Json written(double value) {
        return value <= std::numeric_limits<double>::max() ? Json(value) : Json(nullptr);
    }
    static Json written(const Size& size) { return {size.width, size.height}; }
    template <class T>
    static Json written(const std::optional<T>& value) {
        return value ? written(*value) : Json(nullptr);
    }
    template <class T>
    static Json written(const std::vector<T>& values) {
        Json list = Json::array();
        for (const T& value : values) list.push_back(written(value));
        return list;
    }
    // Names and words, in their order.
    static Json written(const std::vector<std::pair<std::string, std::string>>& words) {
        Json object = Json::object();
        for (const auto& [name, word] : words) object[name] = word;
        return object;
    }
    template <class T>
    static Json written(const T& value) {
        if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::string>) {
            JsonWriter writer;
            // Listing members changes nothing.
            fields(writer, const_cast<T&>(value));
            return std::move(writer).object();
        } else {
            return value;
        }
    }

 private:
    Json object_ = Json::object();
};

// Throws InputError with the line of what is missing or of another kind.
class JsonReader {
 public:
    using Json = JsonFile::Json;

    JsonReader(const JsonFile& file, const Json& object, JsonPlace place)
        : file_(file), object_(object), place_(std::move(place)) {
        if (!object.is_object()) refuse("not an object", object, place_);
    }

    template <class T>
    void operator()(const char* name, T& value) {
        JsonPlace place = place_;
        if (!object_.contains(name))
            file_.refuse(std::string("has no \"") + name + "\"; make the file anew", place);
        place.emplace_back(name);
        read(object_[name], value, place);
    }

 private:
    [[noreturn]] void refuse(const std::string& what, const Json& value, const JsonPlace& place) const {
        constexpr std::size_t kShown = 40;
        const std::string name = place.empty() ? "" : place.back() + ": ";
        file_.refuse(name + what + " (" + json_line(value).substr(0, kShown) + "); make the file anew", place);
    }

    void read(const Json& json, double& value, const JsonPlace& place) const {
        if (!json.is_number() && !json.is_null()) refuse("not a number", json, place);
        value = json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
    }
    void read(const Json& json, std::string& value, const JsonPlace& place) const {
        if (!json.is_string()) refuse("not a text", json, place);
        value = json.get<std::string>();
    }
    void read(const Json& json, Size& size, const JsonPlace& place) const {
        if (!json.is_array() || json.size() != 2) refuse("not a size", json, place);
        read(json[0], size.width, place);
        read(json[1], size.height, place);
    }
    void read(const Json& json, std::vector<std::pair<std::string, std::string>>& words,
              const JsonPlace& place) const {
        if (!json.is_object()) refuse("not an object", json, place);
        for (const auto& [name, word] : json.items()) {
            words.emplace_back(name, "");
            read(word, words.back().second, below(place, name));
        }
    }
    template <class T>
    void read(const Json& json, std::optional<T>& value, const JsonPlace& place) const {
        if (!json.is_null()) read(json, value.emplace(), place);
    }
    template <class T>
    void read(const Json& json, std::vector<T>& values, const JsonPlace& place) const {
        if (!json.is_array()) refuse("not a list", json, place);
        for (std::size_t i = 0; i < json.size(); ++i)
            read(json[i], values.emplace_back(), below(place, std::to_string(i)));
    }
    template <class T>
    void read(const Json& json, T& value, const JsonPlace& place) const {
        if constexpr (std::is_integral_v<T>) {
            if (!json.is_number_integer()) refuse("not a whole number", json, place);
            // What is too large for a long long is unsigned, and comes out negative.
            const auto whole = json.get<long long>();
            const bool wraps = json.is_number_unsigned() && whole < 0;
            if (wraps || !std::in_range<T>(whole)) refuse("out of range", json, place);
            value = static_cast<T>(whole);
        } else {
            JsonReader reader(file_, json, place);
            fields(reader, value);
        }
    }

    const JsonFile& file_;
    const Json& object_;
    JsonPlace place_;
};

}  // namespace crevice
