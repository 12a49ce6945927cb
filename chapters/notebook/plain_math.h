// Formulas in plain text, for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace crevice {

// A formula of TeX's mathematics in one line of Unicode: "\frac{1}{2\pi} \int_0^{2\pi}" is "1/(2π) ∫[0..2π]". What
// TeX sets above another stands behind a slash or in brackets, indices and powers are small digits where there are any.
// Of commands it does not know the name is left.
std::string plain_math(std::string_view tex);

// Markdown whose $formulas$ and $$formulas$$ are plain text; those in code are no formulas, and stay.
std::string with_plain_math(std::string_view markdown);

}  // namespace crevice
