// A function's or a type's own source, as it stands in the repository: what the book quotes cannot drift from it.
#pragma once

#include <string>
#include <string_view>

namespace crevice {

struct CodeListing {
    std::string file;    // from the repository's root
    std::string symbol;  // its name
    int first_line = 0;  // in the file, counted from 1
    std::string code;    // whole lines; the indentation that all share is removed
};

// The definition of `symbol` in `source`, with the comment right above it: the first place where the name is followed
// by a body in braces. Throws UsageError where there is none.
CodeListing code_listing(std::string_view source, const std::string& file, const std::string& symbol);

// The part of it from the first line that contains `from` to the next one that contains `to`. Throws UsageError where
// there is none.
CodeListing part_of(const CodeListing& listing, const std::string& from, const std::string& to);

}  // namespace crevice
