// Where in an OBJ a statement stands, and its numbers.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/obj/obj_lines.h"
#include "rasterizer/obj/obj_numbers.h"

namespace crevice {

// As many numbers as a statement gives; absent ones are 0.
template <class Number, std::size_t kMost>
struct Numbers {
    std::array<Number, kMost> values{};
    std::size_t count = 0;
};

struct ObjPlace {
    const std::string& name;  // the path, for messages
    std::size_t line = 0;

    std::string text() const { return name + ":" + std::to_string(line) + ": "; }
    [[noreturn]] void fail(const std::string& what) const { throw InputError(text() + what); }

    template <class Number>
    Number number(std::string_view token) const {
        const std::optional<Number> value = number_in<Number>(token);
        if (!value) fail("this is not a number (" + std::string(token) + "); " + number_advice(token));
        return *value;
    }

    // Takes the next number off the front of `rest`; nothing at the end and at a comment.
    template <class Number>
    std::optional<Number> take_number(std::string_view& rest) const {
        std::size_t begin = 0;
        while (begin < rest.size() && is_blank(rest[begin])) ++begin;
        // Where digits end at a blank, they are a word of their own.
        const char* const end = rest.data() + rest.size();
        Number value = 0;
        const auto [stop, error] = number_from_text(rest.data() + begin, end, value);
        if (error == std::errc() && (stop == end || is_blank(*stop))) {
            rest.remove_prefix(static_cast<std::size_t>(stop - rest.data()));
            return value;
        }
        const std::string_view token = take_word(rest);
        return token.empty() ? std::nullopt : std::optional(number<Number>(token));
    }

    // Of a statement that has between `least` and kMost.
    template <class Number, std::size_t kMost>
    Numbers<Number, kMost> numbers(std::string_view keyword, std::string_view rest, std::size_t least) const {
        Numbers<Number, kMost> read;
        for (std::optional<Number> value = take_number<Number>(rest); value;
             value = take_number<Number>(rest)) {
            if (read.count < kMost) read.values[read.count] = *value;
            ++read.count;
        }
        if (read.count < least || read.count > kMost) {
            const std::string wanted =
                std::to_string(least) + (least == kMost ? "" : " to " + std::to_string(kMost));
            fail("`" + std::string(keyword) + "` has the wrong count of numbers (" +
                 std::to_string(read.count) + "); give " + wanted);
        }
        return read;
    }
};

}  // namespace crevice
