// A small chapter that shows one of everything, and the files that it becomes.
#pragma once

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "chapters/notebook/chapter_page.h"
#include "chapters/notebook/notebook.h"
#include "rasterizer/base/file_bytes.h"
#include "tests/tools/error_message.h"
#include "tests/tools/notebook_source.h"
#include "tests/tools/scratch_directory.h"

namespace crevice {

inline NotebookOptions notebook_options_in(const ScratchDirectory& scratch) {
    NotebookOptions options;
    options.out = scratch.path();
    options.size = {4, 2};
    return options;
}

// A chapter of three cells; outputs are put at the lines of the file that they would be called from.
inline constexpr const char* kNotebookSource =
    "// %% intro [markdown]\n"                  // 1
    "// # Raw AO & its radius\n"                // 2
    "//\n"                                      // 3
    "// A *claim*, `code < 1`, $x_{1} < 2$.\n"  // 4
    "\n"                                        // 5
    "// %% pictures\n"                          // 6
    "book.show(\"ao_raw\", ao);\n"              // 7
    "\n"                                        // 8
    "// %% numbers [markdown]\n"                // 9
    "// The mean is {mean}.\n"                  // 10
    "\n"                                        // 11
    "// %% table\n"                             // 12
    "book.table(header, rows);\n";              // 13
inline constexpr int kPictures = 7, kTable = 13;

inline void write_sample(Notebook& book) {
    book.show("ao_raw", ao_picture(Image<float>(book.size(), 0.5f)), "darker where `a < b`", 12.5, kPictures);
    book.show_row({{"left", ao_picture(Image<float>({3, 3}, 0.0f)), "black"},
                   {"right", ao_picture(Image<float>({3, 3}, 1.0f)), "white"}},
                  "side by side", kPictures);
    book.compare({"before", ao_picture(Image<float>({3, 3}, 0.0f))},
                 {"after", ao_picture(Image<float>({3, 3}, 1.0f))}, "", kPictures);
    book.number("mean", 0.5, 2);
    book.table({"method", "RMSE"}, {{"a<b", "0.125"}, {"c|d", "-3e-2"}}, "errors", kTable);
    book.check("every pixel is in [0,1]", true, "min 0.5, max 0.5", kTable);
    book.check("the mean {mean} is above 0.6", false, "it is \"not\"", kTable);
    book.draw("curve", "<svg><text>x</text></svg>", "a curve", kTable);
    book.finish();
}

struct WrittenNotebook {
    std::string terminal, page, markdown, jupyter, png;
    std::vector<NotebookCell> cells;
};

inline WrittenNotebook written_sample(NotebookOptions options, const ScratchDirectory& scratch) {
    constexpr std::uintmax_t kMostBytes = 1 << 24;
    std::ostringstream terminal;
    std::istringstream answers;
    Notebook book(options, notebook_source("07_raw_ao", kNotebookSource), terminal, answers);
    write_sample(book);
    book.write_files();
    const std::string page =
        chapter_page({"07_raw_ao", {"Raw AO", ""}, book.file(), book.failed_checks()}, book.cells(),
                     {{"07_raw_ao", {"Raw AO", ""}, 1}, {"08_blur", {"Blur", ""}, 0}}, BookLanguage::en);
    return {terminal.str(),
            page,
            read_file(scratch / "07_raw_ao" / "07_raw_ao.md", kMostBytes),
            read_file(scratch / "07_raw_ao" / "07_raw_ao.ipynb", kMostBytes),
            read_file(scratch / "07_raw_ao" / "ao_raw.png", kMostBytes),
            book.cells()};
}

inline WrittenNotebook written_sample(bool quiet = false) {
    const ScratchDirectory scratch;
    NotebookOptions options = notebook_options_in(scratch);
    options.quiet = quiet;
    WrittenNotebook sample = written_sample(options, scratch);
    CHECK(!contains(sample.page, scratch.path().string()));
    return sample;
}

}  // namespace crevice
