// Three sections of chapter 11, on what it costs to take one sample a texel, at half the picture's size, and
// to read the map with a sampler.
#pragma once

#include "chapters/notebook/notebook.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

void half_resolution(Notebook& book);
void multisampling(Notebook& book, const Scene& columns);
void shifted_rows(Notebook& book, const Scene& columns);

}  // namespace crevice
