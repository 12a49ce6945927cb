// What a notebook is made of, in order. The writers (terminal, HTML, Markdown, Jupyter) all read these cells.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "rasterizer/base/image.h"

namespace crevice {

struct TextCell {
    enum class Kind { plain, aside };  // an aside (Try, Errata) stands in a box
    Kind kind = Kind::plain;
    std::string markdown;
};

struct NotebookPicture {
    std::string name;  // the file is NAME.png
    Size size;
    std::string about;  // mapping and statistics, one line
    std::string png;    // the file's bytes
};
struct PictureCell {
    std::string caption;                    // plain text, may be empty
    std::vector<NotebookPicture> pictures;  // side by side
};

struct TableCell {
    std::vector<std::string> header;             // plain text
    std::vector<std::vector<std::string>> rows;  // each as long as the header
};

struct CheckCell {
    std::string claim;
    bool ok = false;
    std::string detail;  // the numbers behind it, may be empty
};

using Cell = std::variant<TextCell, PictureCell, TableCell, CheckCell>;

}  // namespace crevice
