#include "chapters/terminal/json_file.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "chapters/terminal/number_text.h"
#include "chapters/terminal/json_text.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/no_such.h"

namespace crevice {

namespace {

using Json = JsonFile::Json;

// Walks through a text that is known to be JSON.
class JsonWalk {
 public:
    explicit JsonWalk(const std::string& text) : text_(text) {}

    // The offset of what stands at the place, of a member that of its key. The end of the text where there is none.
    std::size_t offset_of(const JsonPlace& place) {
        skip_space();
        std::size_t found = at_;
        for (const std::string& step : place) {
            found = text_[at_] == '{' ? enter_member(step) : enter_item(step);
            if (found == text_.size()) break;
        }
        return found;
    }

 private:
    // From '{' to the value of the member of this key.
    std::size_t enter_member(const std::string& key) {
        for (++at_;; ++at_) {
            skip_space();
            if (text_[at_] == '}') return text_.size();
            const std::size_t begin = at_;
            skip_string();
            const bool found = json_from_text(text_.substr(begin, at_ - begin)) == key;
            skip_space();
            ++at_;  // the colon
            skip_space();
            if (found) return begin;
            if (!skip_value()) return text_.size();
        }
    }

    // From '[' to the item of this index.
    std::size_t enter_item(const std::string& index) {
        if (text_[at_] != '[') return text_.size();
        for (int i = 0;; ++i) {
            ++at_;
            skip_space();
            if (text_[at_] == ']') return text_.size();
            if (std::to_string(i) == index) return at_;
            if (!skip_value()) return text_.size();
        }
    }

    // To the comma behind the value; false where there is none, because it was the last one.
    bool skip_value() {
        for (int depth = 0;; ++at_) {
            const char c = text_[at_];
            if (c == '"') {
                skip_string();
                --at_;
            } else if (c == '{' || c == '[') {
                ++depth;
            } else if (depth == 0 && (c == ',' || c == '}' || c == ']')) {
                return c == ',';
            } else if (c == '}' || c == ']') {
                --depth;
            }
        }
    }

    void skip_string() {
        for (++at_; text_[at_] != '"'; ++at_) at_ += text_[at_] == '\\' ? 1 : 0;
        ++at_;
    }

    void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

    const std::string& text_;
    std::size_t at_ = 0;
};

// The offset of the bracket that opens a level too many; none where there is none.
std::optional<std::size_t> too_deep(const std::string& text) {
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string && c == '\\') {
            ++i;
        } else if (c == '"') {
            in_string = !in_string;
        } else if (!in_string && (c == '[' || c == '{') && ++depth > kDeepestJson) {
            return i;
        } else if (!in_string && (c == ']' || c == '}')) {
            --depth;
        }
    }
    return std::nullopt;
}

int line_at(const std::string& text, std::size_t offset) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size()));
    return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

}  // namespace

JsonPlace below(JsonPlace place, const std::string& step) {
    place.push_back(step);
    return place;
}

std::string word_of(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return shortest_text(value.get<double>());
    return json_line(value);
}

JsonFile::JsonFile(std::string text, std::string name, ExitCode code)
    : text_(std::move(text)), name_(std::move(name)), code_(code) {
    if (const std::optional<std::size_t> at = too_deep(text_))
        refuse_at(
            "nested too deeply (more than " + std::to_string(kDeepestJson) + " levels); write it flatter",
            line_at(text_, *at));
    try {
        root_ = json_from_text(text_);
    } catch (const Json::parse_error& error) {
        const bool ends = error.byte > text_.size();
        refuse_at(ends ? "the file ends too soon (" + counted(static_cast<long long>(text_.size()), "byte") +
                             "); " + (code_ == ExitCode::usage ? "finish it" : "make it anew")
                       : "not JSON (at byte " + std::to_string(error.byte) + "); correct what stands there",
                  line_at(text_, error.byte));
    } catch (const Json::out_of_range& error) {
        // "... parsing '1e999'"
        const std::string said = error.what();
        const std::size_t begin = std::min(said.find('\''), said.size() - 1) + 1;
        const std::string number = said.substr(begin, said.rfind('\'') - begin);
        refuse_at("a number is too large to be read (" + number + "); write a smaller one",
                  line_at(text_, text_.find(number)));
    }
    if (!root_.is_object()) refuse("not an object (" + json_line(root_).substr(0, 40) + "); begin with {", {});
}

int JsonFile::line_of(const JsonPlace& place) const {
    const std::size_t offset = JsonWalk(text_).offset_of(place);
    return offset == text_.size() ? 1 : line_at(text_, offset);
}

void JsonFile::refuse(const std::string& what, const JsonPlace& place) const {
    refuse_at(what, line_of(place));
}

void JsonFile::require_known(const Json& object, const JsonPlace& place,
                             const std::vector<std::string>& known) const {
    for (const auto& [key, ignored] : object.items()) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        const std::string where = place.empty() ? "plan" : place.front();
        refuse(no_such(where, "member", key, known).what(), below(place, key));
    }
}

void JsonFile::require_list(const Json& list, const JsonPlace& place) const {
    const std::string& name = place.back();
    if (!list.is_array()) refuse(name + ": not a list (" + json_line(list) + "); write [...]", place);
    if (list.empty()) refuse(name + ": an empty list ([]); give at least one value", place);
    std::set<Json> before;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (!before.insert(list[i]).second)
            refuse(name + ": given twice (" + json_line(list[i]) + "); leave one away",
                   below(place, std::to_string(i)));
    }
}

void JsonFile::refuse_at(const std::string& what, int line) const {
    std::string message = name_ + ":" + std::to_string(line) + ": " + what;
    // A message is one line, whatever the value it quotes is made of.
    std::replace_if(
        message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    if (code_ == ExitCode::usage) throw UsageError(message);
    throw InputError(message);
}

}  // namespace crevice
