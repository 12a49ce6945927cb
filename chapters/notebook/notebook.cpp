#include "chapters/notebook/notebook.h"

#include <algorithm>
#include <cctype>
#include <iostream>
#include <utility>

#include <unistd.h>

#include "chapters/notebook/animated_webp.h"
#include "chapters/notebook/embedded_files.h"
#include "chapters/notebook/jupyter.h"
#include "chapters/notebook/markdown_text.h"
#include "chapters/notebook/step_through.h"
#include "chapters/notebook/svg.h"
#include "chapters/notebook/terminal_picture.h"
#include "chapters/notebook/terminal_text.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"

namespace crevice {

namespace {

constexpr int kPreviewColumns = 64;

bool is_file_name(const std::string& name) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    return !name.empty() && std::all_of(name.begin(), name.end(), allowed);
}

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

// Two languages of a drawing stand on one page, one of them hidden: what is hidden must not be referred to.
std::string with_ids_of_its_own(std::string svg) {
    for (const std::string_view mark : {" id=\"", "url(#"}) {
        for (std::size_t at = svg.find(mark); at != svg.npos; at = svg.find(mark, at + 1))
            svg.insert(at + mark.size(), "zh-");
    }
    return svg;
}

std::string_view embedded_source(const std::string& file) {
    const auto source = embedded_file(file);
    if (!source)
        throw UsageError(file + ": not a file that the program contains; give its path in the repository");
    return *source;
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

// ---- outputs --------------------------------------------------------------------------------------------------------

void Notebook::put(Output output, const std::string& terminal_note) {
    const auto* check = std::get_if<CheckOutput>(&output);
    const std::string text =
        terminal_text(output, {directory(), options_.language, wants_colour()}) + terminal_note;
    if (check != nullptr && !check->ok && options_.quiet) {
        terminal_ << text << std::flush;
    } else {
        say(text);
    }
    const auto* pictures = std::get_if<PictureOutput>(&output);
    if (pictures != nullptr && wants_colour()) {
        for (const NotebookPicture& shown : pictures->pictures)
            say(terminal_picture(shown.picture, kPreviewColumns));
    }
    cells_[reached_ == 0 ? 0 : reached_ - 1].outputs.push_back(std::move(output));
}

void Notebook::claim_name(const std::string& name) {
    if (!is_file_name(name))
        throw UsageError(source_.name + ": not a picture name (" + name + "); use a-z, 0-9, _ and -");
    if (!names_.insert(name).second)
        throw UsageError(source_.name + ": two pictures have one name (" + name + "); rename one");
}

NotebookPicture Notebook::store(const Named& named) {
    claim_name(named.name);
    NotebookPicture stored{named.name,
                           named.picture,
                           png_bytes(named.picture.size, named.picture.channels, named.picture.pixels),
                           text_of(named.caption),
                           about(named.picture),
                           named.command};
    write_file_atomically(directory() / (named.name + ".png"), stored.png);
    // For the notebooks, whose cells go on computing with what a cell of the chapter has shown.
    if (!options_.cell.empty() && !named.picture.values.empty())
        write_file_atomically(directory() / (named.name + ".npy"), npy_bytes(named.picture.values));
    return stored;
}

void Notebook::show(const std::string& name, const Picture& picture, const std::string& caption,
                    std::optional<double> wall_ms, int line) {
    if (!begins(line)) return;
    put(PictureOutput{PictureOutput::Layout::row, {store({name, picture, caption})}, {}},
        wall_ms ? "    " + decimal_text(*wall_ms, 2) + " ms\n" : "");
}

void Notebook::show(const Named& named, int line) { show_row({named}, "", line); }

void Notebook::show_row(const std::vector<Named>& pictures, const std::string& caption, int line) {
    if (!begins(line)) return;
    PictureOutput output{PictureOutput::Layout::row, {}, text_of(caption)};
    for (const Named& named : pictures) output.pictures.push_back(store(named));
    put(std::move(output));
}

void Notebook::compare(const Named& before, const Named& after, const std::string& caption, int line) {
    if (!begins(line)) return;
    if (before.picture.size != after.picture.size)
        throw UsageError(source_.name + ": two sizes behind one slider (" + size_text(before.picture.size) +
                         ", " + size_text(after.picture.size) + "); make them equal");
    put(PictureOutput{PictureOutput::Layout::pair, {store(before), store(after)}, text_of(caption)});
}

void Notebook::film(const std::string& name, const std::vector<Picture>& frames, int frame_ms,
                    const std::string& caption, int line) {
    if (!begins(line)) return;
    const std::optional<std::string> webp = animated_webp(frames, frame_ms);
    const BookText text = text_of(caption);
    if (!webp) return;
    claim_name(name);
    write_file_atomically(directory() / (name + ".webp"), *webp);
    put(FilmOutput{name, frames.front().size, static_cast<int>(frames.size()), *webp, text});
}

void Notebook::draw(const std::string& name, const std::string& svg, const std::string& caption, int line) {
    if (!begins(line)) return;
    claim_name(name);
    write_file_atomically(directory() / (name + ".svg"), standalone_svg(svg));
    const std::string chinese =
        with_words(svg, [this](const std::string& words) { return text_of(words).in(BookLanguage::zh); });
    put(DrawingOutput{name, {svg, chinese == svg ? "" : with_ids_of_its_own(chinese)}, text_of(caption)});
}

void Notebook::plot(const std::string& name, const Plot& plot, const std::string& caption, int line) {
    draw(name, plot_svg(plot), caption, line);
}

void Notebook::table(const std::vector<std::string>& header,
                     const std::vector<std::vector<std::string>>& rows, const std::string& caption,
                     int line) {
    if (!begins(line)) return;
    const auto texts_of = [this](const std::vector<std::string>& words) {
        std::vector<BookText> texts;
        for (const std::string& word : words) texts.push_back(text_of(word));
        return texts;
    };
    TableOutput table{texts_of(header), {}, text_of(caption)};
    for (const auto& row : rows) {
        if (row.size() != header.size())
            throw UsageError(source_.name + ": a table row of another length (" + std::to_string(row.size()) +
                             " cells for " + std::to_string(header.size()) + " columns); fill it up");
        table.rows.push_back(texts_of(row));
    }
    put(std::move(table));
}

bool Notebook::check(const std::string& claim, bool ok, const std::string& detail, int line) {
    if (!begins(line)) return ok;
    ++checks_;
    if (!ok) ++failed_checks_;
    put(CheckOutput{text_of(claim), ok, detail});
    return ok;
}

void Notebook::listing(const std::string& file, const std::string& symbol, const std::string& caption,
                       int line) {
    if (!begins(line)) return;
    put(ListingOutput{code_listing(embedded_source(file), file, symbol), text_of(caption)});
}

void Notebook::listing_part(const std::string& file, const std::string& symbol, const std::string& from,
                            const std::string& to, const std::string& caption, int line) {
    if (!begins(line)) return;
    put(ListingOutput{part_of(code_listing(embedded_source(file), file, symbol), from, to),
                      text_of(caption)});
}

void Notebook::transcript(const std::string& text, const std::string& caption, int line) {
    if (!begins(line)) return;
    put(TranscriptOutput{text, text_of(caption)});
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
