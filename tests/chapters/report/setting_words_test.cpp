#include "chapters/report/setting_words.h"

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("setting_words: counts and sizes as people say them, everything else by its name") {
    CHECK(setting_words({"xjun", {}}) == "defaults");
    CHECK(setting_words({"xjun", {{"samples", "1"}}}) == "1 sample");
    CHECK(setting_words({"xjun", {{"samples", "14"}, {"ao_scale", "0.5"}, {"blur_iterations", "0"}}}) ==
          "14 samples, half size, no blur");
    CHECK(setting_words({"xjun", {{"ao_scale", "1"}, {"blur_iterations", "1"}}}) == "full size, 1 blur");
    CHECK(setting_words({"xjun", {{"radius", "0.25"}, {"ao_scale", "0.25"}}}) ==
          "radius 0.25, ao_scale 0.25");
    CHECK(setting_words({"xjun", {{"samples", "2.5"}}}) == "samples 2.5");
}

TEST_CASE("setting_phrase: a setting inside a sentence") {
    CHECK(setting_phrase({"gtao", {}}) == "gtao with its defaults");
    CHECK(setting_phrase({"gtao", {{"samples", "4"}}}) == "gtao with 4 samples");
    CHECK(setting_phrase({"gtao", {{"ao_scale", "0.5"}}}) == "gtao at half size");
    CHECK(setting_phrase(
              {"gtao", {{"samples", "4"}, {"radius", "0.5"}, {"ao_scale", "1"}, {"blur_iterations", "2"}}}) ==
          "gtao with 4 samples, radius 0.5 and 2 blurs at full size");
}

TEST_CASE("listed, view_words") {
    CHECK(listed({}) == "");
    CHECK(listed({"a"}) == "a");
    CHECK(listed({"a", "b"}) == "a and b");
    CHECK(listed({"a", "b", "c"}) == "a, b and c");
    CHECK(view_words({"columns", "", {640, 360}, 10}) == "columns, 640x360");
    CHECK(view_words({"a.obj", "--fov 60", {64, 36}, 10}) == "a.obj --fov 60, 64x36");
}

TEST_CASE("as_code and escaped_markdown: what others wrote stays what it is") {
    CHECK(as_code("a`b") == "`a'b`");
    CHECK(escaped_markdown("a_b <i> $x$ [1](2) *c*") == "a\\_b \\<i\\> \\$x\\$ \\[1\\](2) \\*c\\*");
}
