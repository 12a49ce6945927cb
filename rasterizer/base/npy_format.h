// What the writer and the reader of .npy files share.
#pragma once

#include <string_view>

namespace crevice {

inline constexpr std::string_view kNpyMagic = "\x93NUMPY";

}  // namespace crevice
