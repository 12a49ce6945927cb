// Pictures of positions that are rebuilt wrongly, beside right ones: for chapter 04.
#pragma once

#include <string>

#include "chapters/notebook/notebook.h"
#include "chapters/props/position_ways.h"
#include "chapters/props/switched_ao.h"

namespace crevice {

// The picture of one of three ways that are wrong, and of the right one.
struct WrongWay {
    Notebook::Named wrong, right;
};
inline WrongWay wrong_way(const SwitchedView& view, const SwitchedAo& shown, const Way& way,
                          const char* caption, const char* right_caption) {
    const auto cubes = [&](Position position) { return unit_cubes(shown.gbuffer, view.camera(), position); };
    return {{std::string("cubes_") + way.name, cubes(way.position), caption},
            {std::string("cubes_not_") + way.name, cubes(by_far_plane), right_caption}};
}

}  // namespace crevice
