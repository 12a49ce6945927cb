// The words of a command line. CLI11 reads them, in command_line.cpp alone: a file that includes its headers takes
// seven seconds more to compile.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace crevice {

// What a program reads, or one of its subcommands. Words are kept as they were typed, where the caller keeps them:
// those places must outlive parse().
class CommandLine {
 public:
    // With the lines that --help begins with.
    explicit CommandLine(const std::string& about);

    // `name` is a flag, such as --size, or stands for a word by its place, such as SCENE. What `word` holds is the
    // default that --help shows. Nothing is said in --help of what has no `about`.
    void option(const std::string& name, std::string& word, const std::string& about);
    void option(const std::string& name, std::optional<std::string>& word, const std::string& about);
    // Any number of times.
    void option(const std::string& name, std::vector<std::string>& words, const std::string& about);
    // A word that must be given.
    void required(const std::string& name, std::string& word, const std::string& about);
    // True where it is given.
    void flag(const std::string& name, bool& given, const std::string& about);
    // The same for who asks given().
    void flag(const std::string& name, const std::string& about);

    // A part of the program with words of its own. One of them must be chosen.
    CommandLine subcommand(const std::string& name, const std::string& about);

    // What --version prints.
    void version(const std::string& text);

    // What can be typed after a program's name and, in the first entry, before any subcommand.
    struct CommandWords {
        std::string name, about;
        std::vector<std::string> flags;  // "--size"; those that --help is silent about, too
    };
    std::vector<CommandWords> all_words() const;

    // Reads the words of a program; `help` and `help COMMAND` are --help. False if they asked for help or the version, which
    // it has printed. Throws UsageError, with the nearest command or flag there is.
    bool parse(int argc, const char* const* argv) const;

    // Whether it was this subcommand.
    bool chosen() const;
    // The names of what was given, in the order in which they were declared.
    std::vector<std::string> given() const;

 private:
    explicit CommandLine(std::shared_ptr<CLI::App> app);

    std::shared_ptr<CLI::App> app_;
};

}  // namespace crevice
