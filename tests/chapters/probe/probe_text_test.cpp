// The probe's text: the answer first, and numbers that add up as they are printed.
#include "chapters/probe/probe_text.h"

#include <cstdlib>
#include <sstream>

#include <doctest/doctest.h>

#include "chapters/probe/probe_sentences.h"
#include "chapters/probe/text_columns.h"
#include "tests/tools/probed_frame.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr Size kSmall{53, 31};

// The words of a line of a table, which two spaces or more keep apart.
std::vector<std::string> columns_of(const std::string& line) {
    std::vector<std::string> words;
    for (std::size_t start = 0; start < line.size();) {
        const std::size_t end = std::min(line.find("  ", start), line.size());
        words.push_back(line.substr(start, end - start));
        start = line.find_first_not_of(' ', end);
    }
    return words;
}

// The column of that heading in the first table that has it.
std::vector<std::string> column(const std::string& text, const std::string& heading) {
    std::istringstream lines(text);
    std::vector<std::string> found;
    std::size_t at = std::string::npos;
    for (std::string line; std::getline(lines, line);) {
        const std::vector<std::string> words = columns_of(line);
        if (at != std::string::npos) {
            if (words.size() <= at) break;
            found.push_back(words[at]);
        }
        for (std::size_t i = 0; at == std::string::npos && i < words.size(); ++i) {
            if (words[i] == heading) at = i;
        }
    }
    return found;
}

float read(const std::string& word) { return std::strtof(word.c_str(), nullptr); }

// What stands behind a name at the start of a line.
std::string after(const std::string& text, const std::string& name) {
    const std::size_t start = text.find("\n" + padded(name, 12)) + 13;
    return text.substr(start, text.find('\n', start) - start);
}

}  // namespace

TEST_CASE("probe text: the printed contributions add up to the printed sum, and that to the printed value") {
    for (const Method& method : ao_methods()) {
        if (!method.computes_ao()) continue;
        CAPTURE(std::string(method.name));
        const PixelProbe probe = ProbedFrame(still_life(), method, kSmall, {"radius=2"}).at(30, 19);
        const std::string text = probe_text(probe, "ao");
        float sum = 0;
        for (const std::string& word : column(text, "contribution")) sum = sum + read(word);
        CHECK(read(after(text, "sum")) == sum);
        CHECK(read(after(text, "value")) == probe.ao.explanation.value_of_sum(sum));
    }
}

TEST_CASE("probe text: the printed taps of every pass of a blur give the value that it prints") {
    for (const char* name : {"xjun", "hemisphere", "unity", "sao", "gtao"}) {
        CAPTURE(std::string(name));
        const PixelProbe probe = ProbedFrame(still_life(), find_method(name), kSmall).at(30, 19);
        const std::string text = probe_text(probe, "blur");
        std::size_t start = 0;
        for (const ExplainedPass& pass : probe.blur.passes) {
            start = text.find(pass.name + "\n", start);
            REQUIRE(start != std::string::npos);
            const std::string table = text.substr(start);
            const std::vector<std::string> values = column(table, "value"), weights = column(table, "weight");
            float sum = 0, total = 0;
            for (std::size_t i = 0; i < pass.taps.size(); ++i) {
                sum = sum + read(weights[i]) * read(values[i]);
                total = total + read(weights[i]);
            }
            CHECK(sum == pass.sum());
            CHECK(total == pass.total());
        }
    }
}

TEST_CASE("probe text: the answer counts the samples that occlude and names the darkest") {
    PixelProbe probe;
    probe.ao.value = 0.25f;
    probe.ao.explanation.surface = true;
    probe.ao.explanation.samples.resize(3);
    for (ExplainedSample& sample : probe.ao.explanation.samples) sample.offset = {0.5f, 0, 0};
    CHECK(answer(probe) == "AO 0.25: none of 3 samples occludes.");
    ExplainedSample& darkest = probe.ao.explanation.samples[1];
    darkest.contribution = 0.5f;
    darkest.dz = 0.25f;
    darkest.q_screen = {3.25f, 4};
    CHECK(answer(probe) ==
          "AO 0.25: 1 of 3 samples occludes; the darkest is sample 1 at (3.2, 4.0), whose r lies 0.25 in "
          "front of p.");
    probe.ao.explanation.samples[2].contribution = 0.25f;
    darkest.dz = -0.125f;
    CHECK(answer(probe) ==
          "AO 0.25: 2 of 3 samples occlude; the darkest is sample 1 at (3.2, 4.0), whose r lies 0.125 behind "
          "p.");
    darkest.offset = {0, 0, 0};
    CHECK(answer(probe) ==
          "AO 0.25: 2 of 3 samples occlude; the darkest is sample 1, which stands for the texel as a whole.");
    probe.ao.explanation.surface = false;
    CHECK(answer(probe) == "AO 0.25: the texel shows the background, which is open.");
    probe.ao.left_out = "the method is none";
    CHECK(answer(probe) == "AO 0.25: the method is none.");
}

TEST_CASE("probe text: why a triangle is not seen, to the edge and to the kind of edge") {
    PixelFragment f;
    f.outside_edge = 1;
    f.edge = {5, -3, 7};
    CHECK(why(f) == "outside: the pixel's centre lies beyond edge 1");
    f.edge = {5, 0, 7};
    CHECK(why(f) == "outside: the pixel's centre lies on edge 1, which is neither a top nor a left edge");
    f.verdict = FragmentVerdict::equal;
    CHECK(why(f) == "equal: of equal depths the first one stays");
}
