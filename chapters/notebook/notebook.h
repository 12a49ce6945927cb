// The notebook that a chapter's source becomes when it runs. The cells are those of the source (percent_format.h); what
// the code shows, tabulates, plots and checks lands under the cell that did so. Everything appears on the terminal at
// once, and becomes OUT/NAME.html, OUT/NAME/NAME.md and NAME.ipynb. The files hold no date, no wall time and no path,
// so two runs write the same bytes.
//
// Texts are Markdown in English. They name computed numbers as {name} (prose_numbers.h), mathematics stands between $,
// and their Chinese comes from chapters/zh (translation.h).
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "chapters/notebook/cells.h"
#include "chapters/notebook/picture.h"
#include "chapters/notebook/plot.h"
#include "chapters/notebook/prose_numbers.h"
#include "chapters/notebook/translation.h"

namespace crevice {

struct NotebookOptions {
    std::filesystem::path out = "out";    // the directory that all notebooks share
    Size size = {640, 360};               // pixels; the size of a chapter's pictures
    std::uint32_t seed = 1;               // for whatever the chapter samples
    std::string scene = "";               // shown instead of the chapter's own; empty: those
    std::vector<std::string> words = {};  // name=value, given to every method that the chapter runs
    std::string cell = "";                // run up to this cell, and show only what it puts out; empty: all
    std::string silent_until = "";        // say nothing before this cell; empty: say all
    BookLanguage language = BookLanguage::both;  // of the pages; the terminal speaks English unless it is zh
    bool step = false;                           // ask after each cell what to do
    bool quiet = false;                          // nothing on the terminal but failed checks
};

// What a chapter is made from.
struct ChapterSource {
    std::string name;  // NN_topic
    std::string file;  // from the repository's root
    std::vector<SourceCell> cells;
    Translation chinese = {};
};

// The wish to leave a chapter before its end, thrown out of it: its one cell is done, or the reader said so.
struct LeaveChapter {
    enum class Why { cell_done, quit, run_again };
    Why why = Why::cell_done;
    std::string word = "";  // run_again: with this parameter
    std::string cell = "";  // run_again: silent until here
};

class Notebook {
 public:
    // Pictures go to OUT/NAME. Throws OutputError when that directory cannot be made, UsageError for a cell that is
    // not in the source.
    Notebook(NotebookOptions options, ChapterSource source);
    Notebook(NotebookOptions options, ChapterSource source, std::ostream& terminal, std::istream& answers);

    const NotebookOptions& options() const { return options_; }
    Size size() const { return options_.size; }
    std::uint32_t seed() const { return options_.seed; }
    // The scene to show where the chapter shows this one.
    std::string scene(const std::string& own) const { return options_.scene.empty() ? own : options_.scene; }

    // A computed number that texts from here on name as {name}: with so many digits after the point, or as it is.
    // Throws UsageError when the name has been used.
    void number(const std::string& name, double value, int decimals);
    void number(const std::string& name, const std::string& text);
    // Several: all with so many digits after the point; or each as it is, whole numbers included.
    struct Measured {
        const char* name;
        double value;
    };
    void numbers(int decimals, const std::vector<Measured>& measured);
    struct Worded {
        const char* name;
        std::string text;
        Worded(const char* said_as, std::string words) : name(said_as), text(std::move(words)) {}
        Worded(const char* said_as, std::integral auto whole) : name(said_as), text(std::to_string(whole)) {}
    };
    void numbers(const std::vector<Worded>& worded);

    // Each of the following lands under the cell that `line` is in. Throws UsageError where that is prose, or a cell
    // before one that has put something out: a function of the setup returns what it made, and the cell shows it.
    //
    // Writes NAME.png. `wall_ms`, the time the pass took, is shown on the terminal only. Throws UsageError when the
    // name has been used here or is not made of a-z, 0-9, _ and -; OutputError when the file cannot be written.
    void show(const std::string& name, const Picture& picture, const std::string& caption = "",
              std::optional<double> wall_ms = std::nullopt, int line = __builtin_LINE());
    struct Named {
        std::string name;
        Picture picture;
        std::string caption = "";
        std::string command = "";  // NotebookPicture::command
    };
    void show(const Named& named, int line = __builtin_LINE());
    // Pictures to be seen side by side.
    void show_row(const std::vector<Named>& pictures, const std::string& caption = "",
                  int line = __builtin_LINE());
    // Two pictures of one size, on one another behind a slider. Throws UsageError for two sizes.
    void compare(const Named& before, const Named& after, const std::string& caption = "",
                 int line = __builtin_LINE());
    // Pictures of one size as a film that plays when the reader opens it, each for `frame_ms`; writes NAME.webp. Nothing
    // where the program was built without libwebp: the chapter's stills must say as much.
    void film(const std::string& name, const std::vector<Picture>& frames, int frame_ms,
              const std::string& caption, int line = __builtin_LINE());
    // An <svg> that takes the page's colours (svg.h); writes NAME.svg.
    void draw(const std::string& name, const std::string& svg, const std::string& caption,
              int line = __builtin_LINE());
    void plot(const std::string& name, const Plot& plot, const std::string& caption,
              int line = __builtin_LINE());
    // Columns that hold numbers only are set flush right. Throws UsageError for a row of another length.
    void table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
               const std::string& caption = "", int line = __builtin_LINE());
    // A sentence that must be true, with the numbers behind it. Returns `ok`.
    bool check(const std::string& claim, bool ok, const std::string& detail = "",
               int line = __builtin_LINE());
    // The definition of a function or a type of the lab (code_listing.h), with file and line numbers; or its lines
    // from the first that contains `from` to the next that contains `to`.
    void listing(const std::string& file, const std::string& symbol, const std::string& caption = "",
                 int line = __builtin_LINE());
    void listing_part(const std::string& file, const std::string& symbol, const std::string& from,
                      const std::string& to, const std::string& caption = "", int line = __builtin_LINE());

    // What was typed and what was answered (TranscriptOutput).
    void transcript(const std::string& text, const std::string& caption = "", int line = __builtin_LINE());

    // What follows the last output. Called once, after the chapter's function.
    void finish();
    // A failed check of the chapter itself, under the cell that was reached.
    void fail(const std::string& claim, const std::string& detail);

    const std::string& name() const { return source_.name; }
    const std::string& file() const { return source_.file; }
    const std::vector<NotebookCell>& cells() const { return cells_; }
    int checks() const { return checks_; }
    int failed_checks() const { return failed_checks_; }
    // The headings (translation.h) of what the chapter has said in English only, in the order in which it was said.
    const std::vector<std::string>& untranslated() const { return untranslated_; }
    // Writes NAME.md and NAME.ipynb beside the pictures, in each language.
    void write_files() const;

 private:
    bool wants_colour() const;
    std::size_t cell_at(int line) const;
    void go_to(std::size_t cell);
    void ask(std::size_t next);
    void say(const std::string& text);
    bool begins(int line);
    void put(Output output, const std::string& terminal_note = "");
    BookText text_of(const std::string& english);
    BookText about(const Picture& picture);
    std::string chinese_phrase(const std::string& english);
    void lacks(const std::string& heading);
    NotebookPicture store(const Named& named);
    void claim_name(const std::string& name);
    std::filesystem::path directory() const { return options_.out / source_.name; }

    NotebookOptions options_;
    ChapterSource source_;
    std::ostream& terminal_;
    std::istream& answers_;
    std::vector<NotebookCell> cells_;  // all of the source's; prose is filled in when it is reached
    std::size_t reached_ = 0;          // cells before this one are done
    std::size_t target_;               // of options_.cell
    ProseNumbers numbers_;
    std::set<std::string> names_;
    std::vector<std::string> untranslated_;
    int checks_ = 0, failed_checks_ = 0;
};

}  // namespace crevice
