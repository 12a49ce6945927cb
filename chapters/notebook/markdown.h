// The prose of a chapter as HTML.
#pragma once

#include <string>
#include <string_view>

namespace crevice {

// CommonMark with tables; raw HTML in it is shown, not obeyed. Throws InputError if the text cannot be
// parsed.
std::string html_from_markdown(std::string_view markdown);

}  // namespace crevice
