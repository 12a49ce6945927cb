// Completion scripts name every command, flag, scene and method there is; bash finds nothing wrong with its own.
#include <cstdlib>
#include <fstream>

#include <doctest/doctest.h>

#include "scenes/builtin_scenes.h"
#include "ssao/ao_methods.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/error_message.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

TEST_CASE("completion: every shell's script knows scenes, methods, commands and their flags") {
    for (const char* shell : {"bash", "zsh", "fish"}) {
        CAPTURE(std::string(shell));
        const std::string script = crevice_says(std::string("completion ") + shell).text;
        for (const BuiltinScene& scene : builtin_scenes()) CHECK(contains(script, std::string(scene.name)));
        for (const Method& method : ao_methods()) CHECK(contains(script, method.name));
        for (const char* word : {"render", "probe", "compare", "completion", "max-pixels", "preset"}) {
            CAPTURE(std::string(word));
            CHECK(contains(script, word));
        }
    }
    CHECK(crevice_says("completion tcsh").code == 2);
    CHECK(crevice_says("completion").code == 2);
}

TEST_CASE("completion: bash completes a command, a flag, a scene and a method") {
    const ScratchDirectory scratch;
    std::ofstream(scratch / "script") << crevice_says("completion bash").text;
    // Words as bash hands them over, and the one that must be offered.
    const char* const cases[][2] = {{"crevice ren", "render"},
                                    {"crevice compare --max-p", "--max-pixels"},
                                    {"crevice render columns_l", "columns_luna"},
                                    {"crevice render columns --ao gt", "gtao"}};
    for (const auto& tried : cases) {
        const char *const words = tried[0], *const offered = tried[1];
        CAPTURE(std::string(words));
        std::ofstream(scratch / "try")
            << ". '" << (scratch / "script").string() << "'\nCOMP_WORDS=(" << words
            << ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_crevice\n[ \"${COMPREPLY[0]}\" = '" << offered
            << "' ]\n";
        CHECK(std::system(("bash '" + (scratch / "try").string() + "'").c_str()) == 0);
    }
}
