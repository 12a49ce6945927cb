// How a name that is not known is refused: with the nearest one that is.
#pragma once

#include <string>
#include <vector>

#include "rasterizer/base/error.h"

namespace crevice {

// That of `known` which a slip of the fingers would turn into `word`: letters left out, added, exchanged with others or
// with their neighbours, one for every three. The first of equals; empty: there is none.
std::string nearest_name(const std::string& word, const std::vector<std::string>& known);

// "did you mean NAME? ", or nothing.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

// "WHERE: there is no such KIND (NAME); did you mean X? There are A, B, C"
UsageError no_such(const std::string& where, const std::string& kind, const std::string& name,
                   const std::vector<std::string>& known);

}  // namespace crevice
