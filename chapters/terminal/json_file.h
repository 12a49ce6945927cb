// A JSON file that a person or another program wrote: what is wrong in it is told with its line.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "rasterizer/base/error.h"

namespace crevice {

// Where a value stands: the keys and the indices, as decimals, that lead to it from the top.
using JsonPlace = std::vector<std::string>;

JsonPlace below(JsonPlace place, const std::string& step);

// A number, a word, or true or false, as it would be typed on a command line.
std::string word_of(const nlohmann::ordered_json& value);

// What is nested deeper is nobody's plan, and ends the stack of who prints it.
inline constexpr int kDeepestJson = 100;

class JsonFile {
 public:
    using Json = nlohmann::ordered_json;

    // `name` is what messages call it. They come as UsageError where `code` is ExitCode::usage, else as InputError. Throws
    // one for a text that is no JSON, or no object, or nested deeper than kDeepestJson.
    JsonFile(std::string text, std::string name, ExitCode code);

    const Json& root() const { return root_; }

    // Of a value that is there, counted from 1; 1 where there is none.
    int line_of(const JsonPlace& place) const;

    // "NAME:LINE: WHAT"; `what` ends with what to do.
    [[noreturn]] void refuse(const std::string& what, const JsonPlace& place) const;

    // Calls body(). What it refuses with an Error is refused as what stands at `place`.
    template <class Body>
    decltype(auto) at(const JsonPlace& place, const Body& body) const {
        try {
            return body();
        } catch (const Error& error) {
            refuse(error.what(), place);
        }
    }

    // Refuses members of an object that are not among the known ones.
    void require_known(const Json& object, const JsonPlace& place,
                       const std::vector<std::string>& known) const;

    // Calls body(item, its place) for each item of a list. Refuses what is no list, an empty one, and items that are given
    // twice.
    template <class Body>
    void for_each(const Json& list, const JsonPlace& place, const Body& body) const {
        require_list(list, place);
        for (std::size_t i = 0; i < list.size(); ++i) body(list[i], below(place, std::to_string(i)));
    }

 private:
    void require_list(const Json& list, const JsonPlace& place) const;
    [[noreturn]] void refuse_at(const std::string& what, int line) const;

    std::string text_, name_;
    ExitCode code_;
    Json root_;
};

}  // namespace crevice
