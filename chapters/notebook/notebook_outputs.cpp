// What a chapter's code puts out: each output is stored under its cell, and its files are written at once.
#include "chapters/notebook/notebook.h"

#include <algorithm>
#include <ostream>
#include <string_view>
#include <utility>

#include "chapters/notebook/animated_webp.h"
#include "chapters/notebook/code_listing.h"
#include "chapters/notebook/embedded_files.h"
#include "chapters/notebook/svg.h"
#include "chapters/notebook/terminal_picture.h"
#include "chapters/notebook/terminal_text.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

constexpr int kPreviewColumns = 64;

bool is_file_name(const std::string& name) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    return !name.empty() && std::all_of(name.begin(), name.end(), allowed);
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

}  // namespace crevice
