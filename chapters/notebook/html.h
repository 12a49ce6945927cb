// The parts that the lab's HTML pages share. A page is one file that opens offline: style and pictures are
// inside.
#pragma once

#include <string>
#include <string_view>

#include "rasterizer/base/image.h"

namespace crevice {

// `text` with & < > " as entities.
std::string escape_html(std::string_view text);

// And back.
std::string unescape_html(std::string_view html);

// RFC 4648, with padding, without line breaks.
std::string base64(std::string_view bytes);

// The address of the lab, beside a page, that shows what a `crevice render` or `crevice probe` command does.
std::string lab_address(std::string_view command);

// An <img> with the file inside, a PNG or another `type`, at a whole multiple of its size that is at least
// kMinShownWidth wide; `alt` and `classes` are plain text.
inline constexpr int kMinShownWidth = 640;
std::string image_element(std::string_view file, Size size, std::string_view alt,
                          std::string_view classes = "", std::string_view type = "image/png");

// What a page has beyond its body.
struct PageParts {
    std::string head = "";        // further HTML for <head>
    std::string language = "en";  // shown first
    bool script = false;          // page.js: languages, pictures that enlarge and tell their values, sliders
    bool mathematics = false;     // KaTeX, for <x-equation>
    bool code = false;            // highlight.js, for <code class="language-cpp">
    bool plots = false;           // plots.js: plots that zoom and whose points tell what they are
};

// A whole page. `title` is plain text, `body` HTML.
std::string html_page(std::string_view title, std::string_view body, const PageParts& parts = {});

}  // namespace crevice
