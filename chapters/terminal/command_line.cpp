#include "chapters/terminal/command_line.h"

#include <filesystem>

#include <CLI/CLI.hpp>

#include "rasterizer/base/error.h"

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

// CLI11 would name the word that follows a wrong command, not the command.
void require_known_command(const CLI::App& program, const std::string& name, const std::string& first) {
    const auto is_first = [&](const CLI::App* command) { return command->get_name() == first; };
    if (program.get_require_subcommand_min() == 0 || first.empty() || first[0] == '-') return;
    if (program.get_subcommands(is_first).empty())
        throw UsageError(name + ": there is no such command (" + first + "); " + name + " --help lists them");
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
    require_known_command(*app_, name_of(*app_, argv[0]), argc > 1 ? argv[1] : "");
    try {
        app_->parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app_->exit(error) != 0;
        const std::string name = name_of(*app_, argv[0]);
        throw UsageError(name + ": " + error.what() + "; " + name + " --help tells more");
    }
    return true;
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
