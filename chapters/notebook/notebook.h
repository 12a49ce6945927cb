// The notebook that a chapter writes: text, pictures, tables and checked claims, in the order in which they
// are made. Each cell appears on the terminal at once; the same cells become OUT/NAME/NAME.md and NAME.ipynb
// and a part of OUT/index.html. The files hold no date, no wall time and no path, so two runs write the same
// bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "chapters/notebook/cells.h"
#include "chapters/notebook/picture.h"

namespace crevice {

struct NotebookOptions {
    std::filesystem::path out = "out";  // the directory that all notebooks share
    Size size = {640, 360};             // pixels; the size of a chapter's pictures
    std::uint32_t seed = 1;             // for whatever the chapter samples
    bool step = false;                  // wait for Enter after each cell, when stdin is a terminal
    bool quiet = false;                 // nothing on the terminal but failed checks
};

class Notebook {
 public:
    // `name` is NN_topic; pictures go to OUT/NN_topic. Throws OutputError when that directory cannot be made.
    Notebook(NotebookOptions options, std::string name);
    Notebook(NotebookOptions options, std::string name, std::ostream& terminal);

    const NotebookOptions& options() const { return options_; }
    Size size() const { return options_.size; }
    std::uint32_t seed() const { return options_.seed; }

    // Markdown. Indentation that all lines share is removed, so a raw string may be indented with the code.
    void text(const std::string& markdown);
    // Writes NAME.png. `wall_ms`, the time the pass took, is shown on the terminal only. Throws UsageError
    // when the name has been used here or is not made of a-z, 0-9, _ and -; OutputError when the file cannot
    // be written.
    void show(const std::string& name, const Picture& picture, const std::string& caption = "",
              std::optional<double> wall_ms = std::nullopt);
    // The same for pictures to be seen side by side.
    struct Named {
        std::string name;
        Picture picture;
    };
    void show_row(const std::string& caption, const std::vector<Named>& pictures);
    // Plain text. Columns that hold numbers only are set flush right. Throws UsageError for a row of another
    // length.
    void table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows);
    // Records whether a claim made above is true, with the numbers behind it. Returns `ok`.
    bool check(const std::string& claim, bool ok, const std::string& detail = "");
    // Edits to the chapter that are worth a try, each with the change to expect; Markdown.
    void try_it(const std::vector<std::string>& edits);
    // What the published tutorial gets wrong; Markdown.
    void errata(const std::vector<std::string>& items);

    const std::string& name() const { return name_; }
    const std::vector<Cell>& cells() const { return cells_; }
    int checks() const { return checks_; }
    int failed_checks() const { return failed_checks_; }
    // The cells as a part of an HTML page.
    std::string html() const;
    // Writes NAME.md and NAME.ipynb beside the pictures.
    void write_files() const;

 private:
    NotebookPicture store(const std::string& name, const Picture& picture);
    void add(Cell cell, const std::string& terminal_note = "");
    std::filesystem::path directory() const { return options_.out / name_; }

    NotebookOptions options_;
    std::string name_;
    std::ostream& terminal_;
    std::vector<Cell> cells_;
    std::set<std::string> picture_names_;
    int checks_ = 0, failed_checks_ = 0;
};

}  // namespace crevice
