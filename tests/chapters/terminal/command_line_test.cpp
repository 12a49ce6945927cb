#include "chapters/terminal/command_line.h"

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"

using namespace crevice;

namespace {

// A program with one command that reads a word of each kind.
struct Program {
    CommandLine program{"A program."};
    CommandLine command = program.subcommand("draw", "Draws.");
    std::string scene, size = "4x3";
    std::optional<std::string> eye, hidden;
    std::vector<std::string> params;
    bool quick = false;

    Program() {
        command.required("SCENE", scene, "what to draw");
        command.option("--size", size, "how large");
        command.option("--eye", eye, "from where");
        command.option("--param", params, "any number");
        command.flag("--quick", quick, "less of it");
        command.option("--hidden", hidden, "");
    }
    bool parse(std::vector<const char*> words) const {
        words.insert(words.begin(), "/bin/program");
        return program.parse(static_cast<int>(words.size()), words.data());
    }
};

std::string refusal(const std::vector<const char*>& words) {
    try {
        Program().parse(words);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "nothing was refused";
}

}  // namespace

TEST_CASE("words arrive where the caller keeps them") {
    const Program p;
    REQUIRE(
        p.parse({"draw", "--param", "a=1", "columns", "--param", "b=2", "--eye", "1,2,3", "--hidden", "x"}));
    CHECK(p.command.chosen());
    CHECK(p.scene == "columns");
    CHECK(p.size == "4x3");
    CHECK(p.eye == "1,2,3");
    CHECK(p.params == std::vector<std::string>{"a=1", "b=2"});
    CHECK(!p.quick);
    CHECK(p.command.given() == std::vector<std::string>{"SCENE", "--eye", "--param", "--hidden"});
}

TEST_CASE("what is wrong is said by the command that was meant") {
    CHECK(refusal({}).starts_with("program: "));
    CHECK(refusal({"darw"}) ==
          "program: there is no such command (darw); did you mean draw? program --help lists them");
    CHECK(refusal({"draw"}).starts_with("program draw: SCENE is required"));
    CHECK(refusal({"draw", "columns", "--siz", "1"}) ==
          "program draw: there is no such flag (--siz); did you mean --size? program draw --help lists them");
    CHECK(refusal({"draw", "columns", "--colour"}) ==
          "program draw: there is no such flag (--colour); program draw --help lists them");
    CHECK(refusal({"draw", "columns", "--size"}).ends_with("; program draw --help tells more"));
}

TEST_CASE("an empty word is none: it is refused, not taken for the flag's default") {
    for (const std::vector<const char*>& words :
         {std::vector<const char*>{"draw", "columns", "--size", ""}, {"draw", "columns", "--size="}})
        CHECK(refusal(words) == "--size: no value (); write one behind it, or leave the flag away");
    CHECK(refusal({"draw", "--eye", "", "columns"}).starts_with("--eye: no value ()"));
    CHECK(refusal({"draw", ""}).starts_with("program: a word is empty ()"));
    CHECK(Program().parse({"draw", "columns", "--param", "a="}));
}

TEST_CASE("help is --help, of the program and of its commands") {
    CHECK(!Program().parse({"help"}));
    CHECK(!Program().parse({"help", "draw"}));
    CHECK(!Program().parse({"draw", "--help"}));
    CHECK(refusal({"help", "darw"}).starts_with("program: "));
    CHECK(refusal({"help", "draw", "columns"}) ==
          "program help: tells of one command at a time (columns); leave it away");
}

TEST_CASE("all words can be listed: for a shell that completes them") {
    const auto words = Program().program.all_words();
    REQUIRE(words.size() == 2);
    CHECK(words[1].name == "draw");
    CHECK(words[1].flags ==
          std::vector<std::string>{"--help", "--size", "--eye", "--param", "--quick", "--hidden"});
}
