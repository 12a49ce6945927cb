#include "chapters/terminal/command_line.h"

#include <algorithm>
#include <filesystem>

#include <CLI/CLI.hpp>

#include "rasterizer/base/no_such.h"

namespace crevice {

namespace {

template <class Word>
CLI::Option& added(CLI::App& app, const std::string& name, Word& word, const std::string& about) {
    CLI::Option* const option = app.add_option(name, word, about);
    if (about.empty()) option->group("");
    return *option;
}

// The program and the subcommands that its words chose.
std::string name_of(const CLI::App& program, const char* path) {
    std::string name = std::filesystem::path(path).filename().string();
    for (const CLI::App* command : program.get_subcommands()) name += " " + command->get_name();
    return name;
}

std::vector<std::string> commands_of(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands(nullptr)) names.push_back(command->get_name());
    return names;
}

std::vector<std::string> flags_of(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

// CLI11 would name the word that follows a wrong command, not the command.
void require_known_command(const CLI::App& program, const std::string& name, const std::string& first) {
    const std::vector<std::string> known = commands_of(program);
    if (known.empty() || first.empty() || first[0] == '-' ||
        std::count(known.begin(), known.end(), first) > 0)
        return;
    std::vector<std::string> words = known;
    for (const std::string& flag : flags_of(program)) words.push_back(flag);
    throw UsageError(name + ": there is no such command (" + first + "); " + did_you_mean(first, words) +
                     name + " --help lists them");
}

// CLI11 names the words that a wrong flag leaves over, the last one first. The flag itself, and the nearest one there is.
void require_known_flags(const CLI::App& command, const std::string& name,
                         const std::vector<std::string>& words) {
    const std::vector<std::string> known = flags_of(command);
    for (const std::string& word : words) {
        const std::string flag = word.substr(0, word.find('='));
        if (word == "--") return;
        if (!word.starts_with("--") || std::count(known.begin(), known.end(), flag) > 0) continue;
        throw UsageError(name + ": there is no such flag (" + flag + "); " + did_you_mean(flag, known) +
                         name + " --help lists them");
    }
}

// CLI11 takes an empty word for none, and the flag's default would be used: `--ao "$METHOD"` without that variable.
void require_no_empty_word(const std::string& name, const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const bool ends_in_equals = word.starts_with("--") && word.find('=') == word.size() - 1;
        if (!word.empty() && !ends_in_equals) continue;
        const bool behind_flag = word.empty() && i > 0 && words[i - 1].starts_with("--");
        if (!behind_flag && word.empty())
            throw UsageError(name + ": a word is empty (); leave it away, or write what it should be");
        const std::string flag = behind_flag ? words[i - 1] : word.substr(0, word.size() - 1);
        throw UsageError(flag + ": no value (); write one behind it, or leave the flag away");
    }
}

}  // namespace

CommandLine::CommandLine(const std::string& about) : app_(std::make_shared<CLI::App>(about)) {}

CommandLine::CommandLine(std::shared_ptr<CLI::App> app) : app_(std::move(app)) {}

void CommandLine::option(const std::string& name, std::string& word, const std::string& about) {
    CLI::Option& option = added(*app_, name, word, about);
    if (!word.empty()) option.capture_default_str();
}

void CommandLine::option(const std::string& name, std::optional<std::string>& word,
                         const std::string& about) {
    added(*app_, name, word, about);
}

void CommandLine::option(const std::string& name, std::vector<std::string>& words, const std::string& about) {
    // A flag takes one word each time; places take all that come.
    added(*app_, name, words, about).allow_extra_args(name[0] != '-');
}

void CommandLine::required(const std::string& name, std::string& word, const std::string& about) {
    added(*app_, name, word, about).required();
}

void CommandLine::flag(const std::string& name, bool& given, const std::string& about) {
    app_->add_flag(name, given, about);
}

void CommandLine::flag(const std::string& name, const std::string& about) { app_->add_flag(name, about); }

CommandLine CommandLine::subcommand(const std::string& name, const std::string& about) {
    app_->require_subcommand(1);
    auto command = std::make_shared<CLI::App>(about, name);
    app_->add_subcommand(command);
    return CommandLine(std::move(command));
}

bool CommandLine::parse(int argc, const char* const* argv) const {
    std::vector<std::string> words(argv + 1, argv + argc);
    // `help` and `help COMMAND` are --help.
    if (!words.empty() && words[0] == "help" && !commands_of(*app_).empty()) {
        words.erase(words.begin());
        if (words.size() > 1)
            throw UsageError(name_of(*app_, argv[0]) + " help: tells of one command at a time (" + words[1] +
                             "); leave it away");
        words.push_back("--help");
    }
    require_known_command(*app_, name_of(*app_, argv[0]), words.empty() ? "" : words[0]);
    require_no_empty_word(name_of(*app_, argv[0]), words);
    app_->name(std::filesystem::path(argv[0]).filename().string());
    try {
        app_->parse(std::vector<std::string>(words.rbegin(), words.rend()));
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app_->exit(error) != 0;
        const std::string name = name_of(*app_, argv[0]);
        const auto chosen = app_->get_subcommands();
        require_known_flags(chosen.empty() ? *app_ : *chosen.front(), name, words);
        throw UsageError(name + ": " + error.what() + "; " + name + " --help tells more");
    }
    return true;
}

void CommandLine::version(const std::string& text) { app_->set_version_flag("--version", text); }

std::vector<CommandLine::CommandWords> CommandLine::all_words() const {
    std::vector<CommandWords> all = {{"", app_->get_description(), flags_of(*app_)}};
    for (const CLI::App* command : app_->get_subcommands(nullptr))
        all.push_back({command->get_name(), command->get_description(), flags_of(*command)});
    return all;
}

bool CommandLine::chosen() const { return app_->parsed(); }

std::vector<std::string> CommandLine::given() const {
    std::vector<std::string> names;
    for (const CLI::Option* option : app_->get_options()) {
        if (option->count() == 0) continue;
        // get_name() says nothing of what --help does not show.
        const bool by_place = option->get_lnames().empty();
        names.push_back(by_place ? option->get_name(true) : "--" + option->get_lnames().front());
    }
    return names;
}

}  // namespace crevice
