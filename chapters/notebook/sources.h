// The tutorials that comments and chapters name, with author, title and address.
#pragma once

#include <string>

namespace crevice {

// A Markdown table, one line a source. It stands at the head of the book and, word for word, in the README.
std::string sources_table();

}  // namespace crevice
