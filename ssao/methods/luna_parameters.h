// What can be set of the tutorials' estimator, by name.
#pragma once

#include <vector>

#include "ssao/methods/luna_settings.h"
#include "ssao/methods/parameter.h"

namespace crevice {

// The members of the estimator, then its artifacts, each a switch of its own whose first word is the cure.
std::vector<Parameter<LunaSettings>> luna_parameters();

}  // namespace crevice
