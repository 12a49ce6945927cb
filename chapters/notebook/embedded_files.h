// Files of the repository that are part of the program, so that its pages can quote them wherever it runs.
#pragma once

#include <optional>
#include <string_view>

namespace crevice {

// The bytes of a file, by its path from the repository's root ("ssao/methods/luna_kernel.h"); those of the packages
// that pages are made with stand under page/ ("page/katex.js"). Nothing where there is no such file.
std::optional<std::string_view> embedded_file(std::string_view path);

}  // namespace crevice
