// A renderer's passes and the images between them, as a graph: passes one below the other, what they need from outside
// at their left, what they write at their right, with a line from each image to the passes that read it.
#pragma once

#include <string>
#include <vector>

#include "rasterizer/base/image.h"

namespace crevice {

struct GraphImage {
    std::string name, format;
    Size size;
    int bytes = 0;                     // a texel
    std::vector<std::string> read_by;  // names of passes

    std::string size_words() const;  // "640 x 360, 1.84 MB"
};

struct GraphPass {
    std::string name;
    std::string from_outside;  // what it reads that no pass has made; empty: nothing
    std::vector<GraphImage> writes;
};

std::string pass_graph(const std::string& title, const std::vector<GraphPass>& passes);

}  // namespace crevice
