// Words of the command line, one a line: each as every kind of value, and all of them as a program's flags.
#include <sstream>
#include <vector>

#include "chapters/terminal/command_line.h"
#include "chapters/terminal/parse.h"
#include "tests/fuzz/fuzzing.h"

using namespace crevice;

namespace {

void read_as_values(const std::string& word) {
    refused_or_read([&] { parse_number("--n", word); });
    refused_or_read([&] { parse_whole("--w", word, -5, 1000); });
    refused_or_read([&] { parse_yes_no("--b", word); });
    refused_or_read([&] { parse_point("--eye", word); });
    refused_or_read([&] { parse_size("--size", word); });
}

void read_as_flags(const std::vector<std::string>& words) {
    CommandLine program("");
    std::string scene, size;
    std::vector<std::string> params;
    bool inset = false;
    CommandLine render = program.subcommand("render", "");
    render.required("SCENE", scene, "");
    render.option("--size", size, "");
    render.option("--param", params, "");
    render.flag("--inset", inset, "");
    std::vector<const char*> arguments = {"crevice"};
    for (const std::string& word : words) {
        if (word.starts_with("-h") || word.starts_with("--h")) return;  // help is printed
        arguments.push_back(word.c_str());
    }
    refused_or_read([&] { program.parse(static_cast<int>(arguments.size()), arguments.data()); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream lines(bytes_of(data, size));
    std::vector<std::string> words;
    for (std::string word; std::getline(lines, word);) words.push_back(word);
    for (const std::string& word : words) read_as_values(word);
    read_as_flags(words);
    return 0;
}
