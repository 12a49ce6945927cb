// What the book's pages take from packages, ready to stand inside a page, so that it opens without a network: KaTeX
// (mathematics) and highlight.js (colours of code), from Debian's libjs-katex, fonts-katex and libjs-highlight.js.
#pragma once

#include <string>

namespace crevice {

// KaTeX's style with its fonts inside; fonts that the book does not use are left out.
std::string katex_style();
std::string katex_script();

// highlight.js with C++ as its only language.
std::string highlight_script();

}  // namespace crevice
