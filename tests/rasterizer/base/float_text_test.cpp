// Numbers as text: read to the nearest float or double, written so that they come back.
#include "rasterizer/base/float_text.h"

#include <limits>
#include <string>

#include <doctest/doctest.h>

#include "rasterizer/lanes/wide.h"

using namespace crevice;

namespace {

template <class Number>
std::from_chars_result read(const std::string& text, Number& value) {
    return number_from_text(text.data(), text.data() + text.size(), value);
}

}  // namespace

TEST_CASE_TEMPLATE("float text: what is no number is refused, and what follows one is left", Number, float,
                   double) {
    for (const std::string text : {"", "-", "+1", " 1", "x", ".", "-.", "e5", "--1", "- 1"}) {
        CAPTURE(text);
        Number value = 7;
        CHECK(read(text, value).ec == std::errc::invalid_argument);
        CHECK(value == 7);
    }
    const struct {
        std::string text;
        double value;
        std::size_t length;
    } cases[] = {{"1.5", 1.5, 3}, {"-2e-3x", -2e-3, 5}, {".5", 0.5, 2},    {"5.", 5, 2},
                 {"1e", 1, 1},    {"0x10", 0, 1},       {"-0X1p3", 0, 2},  {"1,5", 1, 1},
                 {"1 2", 1, 1},   {"1e+2", 100, 4},     {"100E-2", 1.0, 6}};
    for (const auto& c : cases) {
        CAPTURE(c.text);
        Number value = 7;
        const auto [stop, error] = read(c.text, value);
        CHECK(error == std::errc());
        CHECK(value == static_cast<Number>(c.value));
        CHECK(stop == c.text.data() + c.length);
    }
    Number value = 7;
    CHECK(read("inf", value).ec == std::errc());
    CHECK(value == std::numeric_limits<Number>::infinity());
    CHECK(read("nan", value).ec == std::errc());
    CHECK(value != value);
    value = 7;
    CHECK(read("1e999", value).ec == std::errc::result_out_of_range);
    CHECK(value == 7);
}

TEST_CASE("float text: rounded once, to the nearest float") {
    float value = 0;
    // Halfway between two floats but for the last digit: through a double it would become the lower one.
    CHECK(read("1.00000017881393432617187499", value).ec == std::errc());
    CHECK(value == 0x1.000002p0f);
    CHECK(read("1e-45", value).ec == std::errc());
    CHECK(value == 0x1p-149f);
}

TEST_CASE("float text: the shortest digits that come back to the same bits") {
    CHECK(shortest_text(0.1f) == "0.1");
    CHECK(shortest_text(0.1) == "0.1");
    CHECK(shortest_text(-2.5f) == "-2.5");
    CHECK(shortest_text(0.1f * 3) == "0.3");
    CHECK(shortest_text(16777216.0f) == "16777216");
    std::uint32_t state = 1;
    for (int i = 0; i < 2000; ++i) {
        state = state * 1664525u + 1013904223u;
        const float number = float_from_bits(static_cast<std::int32_t>(state));
        if (number != number || number - number != 0) continue;
        CAPTURE(number);
        float back = 0;
        const std::string text = shortest_text(number);
        CHECK(read(text, back).ptr == text.data() + text.size());
        CHECK(float_bits(back) == float_bits(number));
        CHECK(text.size() <= 15);
    }
}
