#include "chapters/notebook/prose_numbers.h"

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"

using namespace crevice;

TEST_CASE("prose numbers: in text, in mathematics, never in code") {
    const ProseNumbers numbers = {{"rmse", "0.12"}, {"n", "14"}};
    CHECK(with_numbers("It is {rmse}, {n} times.", numbers) == "It is 0.12, 14 times.");
    CHECK(with_numbers("`{rmse}` and ``{n}``", numbers) == "`{rmse}` and ``{n}``");
    CHECK(with_numbers("$x_{n} = {{n}}$ and $$\\frac{a}{{{n}}}$$", numbers) ==
          "$x_{n} = 14$ and $$\\frac{a}{14}$$");
    CHECK(with_numbers("braces {Of} {} { n } stay, and $ alone, and ` too", numbers) ==
          "braces {Of} {} { n } stay, and $ alone, and ` too");
    CHECK_THROWS_WITH_AS(
        with_numbers("{a} {rmse} {b}", numbers),
        "the prose names numbers that no cell before it makes (a, b); make them with number()", UsageError);
    CHECK(numbers_named("{a} `{b}` ${{c}}$") == std::vector<std::string>{"a", "c"});
}

TEST_CASE("prose numbers: taken out of a phrase they leave a pattern, which makes the phrase again") {
    struct Phrase {
        std::string text, pattern;
    };
    for (const Phrase& phrase :
         {Phrase{"min -0.25", "min {1}"}, Phrase{"from 2 (white) to 1e+06.", "from {1} (white) to {2}."},
          Phrase{"-1e-07 blue, +0.5 red", "{1} blue, +{2} red"}, Phrase{"[0,1]", "[{1},{2}]"},
          Phrase{"non-linear, 3even", "non-linear, {1}even"}, Phrase{"no number", "no number"},
          Phrase{"", ""}}) {
        CAPTURE(phrase.text);
        ProseNumbers numbers;
        CHECK(numbers_taken_out(phrase.text, numbers) == phrase.pattern);
        CHECK(with_numbers(phrase.pattern, numbers) == phrase.text);
    }
}
