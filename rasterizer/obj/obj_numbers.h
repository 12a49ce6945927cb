// Numbers as OBJ and MTL files write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace crevice {

// The nearest number to decimal digits such as 1.5, +2 or 2e-3; infinity or 0 where its type cannot hold it;
// NaN for `nan` and for what old Microsoft run-times print for NaN and infinity (1.#QNAN). Nothing when
// `token` is none of these: `0x10`, `1e`, `1,5` and `12x` are not.
template <class Number>  // float or double
std::optional<Number> number_in(std::string_view token);

// What to do about a token that is no number.
std::string number_advice(std::string_view token);

}  // namespace crevice
