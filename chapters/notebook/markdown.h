// The prose of a chapter as HTML.
#pragma once

#include <string>
#include <string_view>

namespace crevice {

// CommonMark with tables, and $mathematics$ as <x-equation>, which page.js sets. A line that begins with <details>,
// <summary> or </details> folds what stands between; tags inside a line are shown, not obeyed. Throws InputError if the
// text cannot be parsed.
std::string html_from_markdown(std::string_view markdown);

}  // namespace crevice
