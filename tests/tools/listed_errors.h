// The errors of the listing behind hbao_plus, each by its switch.
#pragma once

#include "ssao/methods/hbao_plus.h"

namespace crevice {

struct NamedChange {
    const char* name;
    void (*change)(HbaoPlusSettings&);
};
inline const NamedChange kListedErrors[] = {
    {"table", [](HbaoPlusSettings& s) { s.table = RayTable::listed; }},
    {"turns", [](HbaoPlusSettings& s) { s.turns = TurnFormat::unorm8; }},
    {"projected_by", [](HbaoPlusSettings& s) { s.projected_by = ProjectedBy::width; }},
    {"near_samples", [](HbaoPlusSettings& s) { s.near_samples = NearSamples::clamped; }},
};

}  // namespace crevice
