// The page that shows how images differ, for `crevice compare` and for golden tests that fail: each pair with
// its difference x 16, the metrics, a histogram and the first differing pixels. One file that opens offline.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ssao/judge/metrics.h"

namespace crevice {

struct DifferenceEntry {
    std::string name;
    Planes a, b;                // either may be empty: there is no such image
    std::string note;           // plain text shown under the name
    bool linear_light = false;  // show three components through the sRGB curve
    bool alpha = false;         // a and b are the alpha of what is named
    std::string layer = {};     // of a file that holds several
    bool unread = false;        // one of its files cannot be read; the note says why

    std::string title() const { return alpha ? name + ", alpha" : name; }
    // What limits and error images go by: the layer, or the file's name without its ending.
    std::string buffer() const { return layer.empty() ? std::filesystem::path(name).stem().string() : layer; }
};

// What the page calls its two sides, and itself.
struct DifferenceLabels {
    std::string title = "Differences";
    std::string a = "A", b = "B";
};

// Entries that differ come first, otherwise in the order given; images of unlike shapes and missing ones
// count as differing. Both pictures of a pair share one mapping, which is printed; the difference is of the
// values shown. Of two components the third is shown as 0, of four the first three are.
std::string difference_page(std::span<const DifferenceEntry> entries, const DifferenceLabels& labels = {});

// Name and value of each metric, as the page and `crevice compare` print them.
std::vector<std::pair<std::string, std::string>> error_rows(const ImageError& error);

}  // namespace crevice
