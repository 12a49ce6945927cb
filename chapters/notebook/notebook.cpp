#include "chapters/notebook/notebook.h"

#include <algorithm>
#include <cctype>
#include <iostream>
#include <utility>

#include <unistd.h>

#include "chapters/notebook/jupyter.h"
#include "chapters/notebook/markdown_text.h"
#include "chapters/notebook/step_through.h"
#include "chapters/notebook/terminal_text.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

// Whether there is something to translate: a word of two small letters or more, outside of `code` and {numbers}.
// Abbreviations and units (AO, NDC, MB) are the same in Chinese, and what holds digits is a number or a name.
bool has_words(const std::string& text) {
    char closing = 0, before = ' ';
    bool pair = false, digits = false;  // in the word so far
    for (const char c : text + " ") {
        const auto byte = static_cast<unsigned char>(closing != 0 ? ' ' : c);
        if (closing != 0) {
            if (c == closing) closing = 0;
        } else if (c == '`' || c == '{') {
            closing = c == '{' ? '}' : '`';
        }
        if (std::isalnum(byte) == 0) {
            if (pair && !digits) return true;
            pair = digits = false;
        }
        digits = digits || std::isdigit(byte) != 0;
        pair = pair || (std::islower(byte) != 0 && std::islower(static_cast<unsigned char>(before)) != 0);
        before = static_cast<char>(byte);
    }
    return false;
}

std::vector<std::string> parts_of(const std::string& text, const std::string& separator) {
    std::vector<std::string> parts;
    std::size_t start = 0;
    for (std::size_t end; (end = text.find(separator, start)) != text.npos; start = end + separator.size())
        parts.push_back(text.substr(start, end - start));
    parts.push_back(text.substr(start));
    return parts;
}

// How the command line asks for these pictures again; nothing for what is so anyway.
std::string flags_of(const NotebookOptions& options) {
    const NotebookOptions usual;
    std::string flags;
    if (options.size != usual.size) flags += " --size " + size_text(options.size);
    if (options.seed != usual.seed) flags += " --seed " + std::to_string(options.seed);
    if (!options.scene.empty()) flags += " --scene '" + options.scene + "'";
    for (const std::string& word : options.words) flags += " --param '" + word + "'";
    return flags;
}

}  // namespace

Notebook::Notebook(NotebookOptions options, ChapterSource source)
    : Notebook(std::move(options), std::move(source), std::cout, std::cin) {}

Notebook::Notebook(NotebookOptions options, ChapterSource source, std::ostream& terminal,
                   std::istream& answers)
    : options_(std::move(options)), source_(std::move(source)), terminal_(terminal), answers_(answers) {
    for (const SourceCell& cell : source_.cells) cells_.push_back({cell, {}, {}});
    target_ = cells_.size();
    std::string known;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        if (cells_[i].source.name == options_.cell) target_ = i;
        if (cells_[i].source.kind != SourceCell::Kind::prose) known += " " + cells_[i].source.name;
    }
    if (!options_.cell.empty() && target_ == cells_.size())
        throw UsageError("--cell: " + name() + " has no such cell (" + options_.cell + "); give one of" +
                         known);
    std::error_code error;
    std::filesystem::create_directories(directory(), error);
    if (error) {
        throw OutputError(directory().string() + ": cannot be made (" + error.message() +
                          "); give --out a directory that may be written to");
    }
}

// Colours and previews only where a person looks: not in a pipe, not in a file.
bool Notebook::wants_colour() const { return &terminal_ == &std::cout && isatty(STDOUT_FILENO) == 1; }

void Notebook::number(const std::string& name, double value, int decimals) {
    number(name, decimal_text(value, decimals));
}

void Notebook::number(const std::string& name, const std::string& text) {
    if (!numbers_.emplace(name, text).second)
        throw UsageError(source_.name + ": two numbers have one name (" + name + "); rename one");
}

void Notebook::numbers(int decimals, const std::vector<Measured>& measured) {
    for (const Measured& number_of : measured) number(number_of.name, number_of.value, decimals);
}

void Notebook::numbers(const std::vector<Worded>& worded) {
    for (const Worded& number_of : worded) number(number_of.name, number_of.text);
}

void Notebook::lacks(const std::string& heading) {
    const std::string line = "<!-- " + heading + " -->";
    if (std::find(untranslated_.begin(), untranslated_.end(), line) == untranslated_.end())
        untranslated_.push_back(line);
}

BookText Notebook::text_of(const std::string& english) {
    const auto chinese = source_.chinese.texts.find(english);
    if (chinese != source_.chinese.texts.end())
        return {with_numbers(english, numbers_), with_numbers(chinese->second, numbers_)};
    if (has_words(english)) lacks("text " + english);
    return {with_numbers(english, numbers_), ""};
}

// In Chinese, where it is known; else in English.
std::string Notebook::chinese_phrase(const std::string& english) {
    ProseNumbers numbers;
    const std::string pattern = numbers_taken_out(english, numbers);
    const auto chinese = source_.chinese.texts.find(pattern);
    if (chinese != source_.chinese.texts.end()) return with_numbers(chinese->second, numbers);
    lacks("text " + pattern);
    return english;
}

// Phrase by phrase, so that pictures share their translations.
BookText Notebook::about(const Picture& picture) {
    const std::string statistics = statistics_text(picture.statistics);
    std::string chinese;
    for (const std::string& phrase : parts_of(picture.mapping, "; "))
        chinese += (chinese.empty() ? "" : "；") + chinese_phrase(phrase);
    const char* before = "。";
    for (const std::string& phrase : parts_of(statistics, ", ")) {
        chinese += before + chinese_phrase(phrase);
        before = "，";
    }
    return {picture.mapping + ". " + statistics, chinese};
}

// ---- from cell to cell ----------------------------------------------------------------------------------------------

std::size_t Notebook::cell_at(int line) const {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const SourceCell& cell = cells_[i].source;
        if (line < cell.first_line || line > cell.last_line) continue;
        if (cell.kind == SourceCell::Kind::prose || i + 1 < reached_)
            throw UsageError(source_.file + ":" + std::to_string(line) + ": an output of the cell " +
                             cell.name +
                             ", which is over; return what there is to show, and show it where it belongs");
        return i;
    }
    throw UsageError(source_.file + ":" + std::to_string(line) +
                     ": an output from outside the cells of the chapter");
}

void Notebook::say(const std::string& text) {
    if (!options_.quiet && options_.silent_until.empty()) terminal_ << text << std::flush;
}

void Notebook::ask(std::size_t next) {
    if (!options_.step || !options_.silent_until.empty()) return;
    const StepAnswer answer = asked(cells_, answers_, terminal_);
    const std::string here = cells_[std::min(next, cells_.size()) - 1].source.name;
    switch (answer.kind) {
        case StepAnswer::Kind::go_on: break;
        case StepAnswer::Kind::never_ask: options_.step = false; break;
        case StepAnswer::Kind::quit: throw LeaveChapter{LeaveChapter::Why::quit};
        case StepAnswer::Kind::run_again: throw LeaveChapter{LeaveChapter::Why::run_again, answer.word, here};
    }
}

// Cells up to this one begin, and those before it end; the number of cells is the end of the chapter.
void Notebook::go_to(std::size_t cell) {
    if (cell > target_) throw LeaveChapter{};
    for (; reached_ <= cell; ++reached_) {
        if (reached_ > 0 && !cells_[reached_ - 1].outputs.empty()) ask(reached_);
        if (reached_ == cells_.size()) return;
        NotebookCell& begun = cells_[reached_];
        if (begun.source.name == options_.silent_until) options_.silent_until.clear();
        if (begun.source.kind != SourceCell::Kind::prose || !options_.cell.empty()) continue;
        const auto chinese = source_.chinese.cells.find(begun.source.name);
        const bool translated =
            chinese != source_.chinese.cells.end() && chinese->second.hash == text_hash(begun.source.text);
        if (!translated) lacks("cell " + begun.source.name + " " + text_hash(begun.source.text));
        begun.prose = {with_numbers(begun.source.text, numbers_),
                       translated ? with_numbers(chinese->second.chinese, numbers_) : ""};
        say(terminal_prose(begun.prose.in(options_.language), wants_colour()));
    }
}

void Notebook::finish() { go_to(cells_.size()); }

void Notebook::fail(const std::string& claim, const std::string& detail) {
    ++checks_;
    ++failed_checks_;
    put(CheckOutput{{claim, ""}, false, detail});
}

// Whether what is put out at this line is kept, once its cell has begun.
bool Notebook::begins(int line) {
    const std::size_t cell = cell_at(line);
    go_to(cell);
    return options_.cell.empty() || cell == target_;
}

void Notebook::write_files() const {
    const auto write = [this](const std::string& stem, BookLanguage language) {
        write_file_atomically(directory() / (stem + ".md"), markdown_from_cells(cells_, language));
        write_file_atomically(directory() / (stem + ".ipynb"),
                              jupyter_from_cells(cells_, name(), language, flags_of(options_)));
    };
    const bool translated = !source_.chinese.cells.empty();
    if (options_.language != BookLanguage::zh || !translated) write(name(), BookLanguage::en);
    if (options_.language != BookLanguage::en && translated) write(name() + ".zh", BookLanguage::zh);
}

}  // namespace crevice
