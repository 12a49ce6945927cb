#include "chapters/props/probed_view.h"

#include <doctest/doctest.h>

#include "tests/tools/crevice_says.h"

using namespace crevice;

namespace {

// What the terminal answers in a transcript; dots stand for lines that are left out.
std::vector<std::string> answers_in(const std::string& transcript) {
    std::vector<std::string> answers;
    for (const TranscriptLine& line : lines_of(TranscriptOutput{transcript, {}})) {
        if (!line.typed && line.text != "...") answers.push_back(line.text);
    }
    return answers;
}

}  // namespace

TEST_CASE("probed view: the transcript holds lines that `crevice probe` prints") {
    const SwitchedView view("columns", {64, 36});
    const ProbedView drawn(view, {"epsilon=0"});
    const PixelProbe probe = drawn.probe({15, 13});
    CHECK(probe.ao.x == 15);
    CHECK(probe.ao.y == 13);
    CHECK(probe.ao.value == drawn.ao().at(15, 13));
    const std::string command = drawn.probe_command({15, 13});
    REQUIRE(command.starts_with("crevice "));
    const std::string said = "\n" + crevice_says(command.substr(std::string("crevice ").size())).text;
    const std::vector<std::string> answers = answers_in(drawn.terminal_transcript(probe, 3));
    REQUIRE(answers.size() == 4);
    for (const std::string& line : answers) {
        CAPTURE(line);
        CHECK(said.find("\n" + line + "\n") != std::string::npos);
    }
    CHECK(answers[2].starts_with("3 "));
}
