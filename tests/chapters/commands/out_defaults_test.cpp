// Without --out a command writes under out/ or nothing: it leaves nothing else in the directory where it runs.
#include <doctest/doctest.h>

#include <filesystem>
#include <set>
#include <string>

#include "tests/tools/crevice_says.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

TEST_CASE("without --out every command writes into out/, or nothing at all") {
    const std::set<std::string> only_out = {"out"}, nothing;
    struct Written {
        std::string words;
        std::set<std::string> names;
    };
    const Written kWritten[] = {
        {"render cornell --size 32x18", only_out},
        {"render cornell --size 32x18 --frames 0-1", only_out},
        {"probe cornell 9 9 --size 32x18 --picture", only_out},
        {"probe cornell 9 9 --size 32x18", nothing},
        {"truth cornell --size 32x18 --rays 4 --limit-seeds 0 --no-cache", only_out},
        {"bake cornell --vertex --rays 4", only_out},
        {"bake cornell --lightmap --rays 4 --texels 64", only_out},
        {"chapter 10 --size 64x36 --quiet", only_out},
        {"stability --case far_vertex --ao xjun", only_out},
        {"bench cornell --size 32x18", nothing},
        {"sweep quick --list", nothing},
        {"scenes", nothing},
        {"methods", nothing},
        {"params xjun", nothing},
        {"completion bash", nothing},
    };
    for (const auto& [words, names] : kWritten) {
        const ScratchDirectory scratch;
        const Outcome outcome = crevice_says(words, "cd '" + scratch.path().string() + "' && ");
        CAPTURE(words);
        CAPTURE(outcome.text);
        CHECK(outcome.code <= 1);  // of a small chapter a claim may fail; what it writes is the question
        std::set<std::string> written;
        for (const auto& entry : std::filesystem::directory_iterator(scratch.path()))
            written.insert(entry.path().filename().string());
        CHECK(written == names);
    }
}
