// The table of AO methods. Everything that works with any method (frames, references, studies, commands, the
// tests of all methods) finds them here; to add one is to add a row in rows/.
#pragma once

#include <span>
#include <string>

#include "ssao/methods/method.h"

namespace crevice {

// In the order in which they are listed. The last is `none`, which computes nothing.
std::span<const Method> ao_methods();

// Throws UsageError listing the methods there are.
const Method& find_method(const std::string& name);

}  // namespace crevice
