// Faults that come of rounding, each as a naive program has it, and pictures of what rounding leaves: for chapter 22.
#pragma once

#include <string>
#include <vector>

#include "chapters/stability/stiff_scenes.h"
#include "ssao/methods/luna_occlusion.h"

namespace crevice {

Camera with_planes(Camera camera, double near_plane, double far_plane);

// A tilted plane and, stair by stair, what 16 bits of ndc depth leave of it. A dashed line
// lies `epsilon` in front of a point in its middle.
std::string stairs(double epsilon);

// The near cut of an edge, when z_clip = a w + b has been rounded to float: where on the edge z_clip is 0, and w there.
double w_of_float_cut(const Camera& camera, double w_before, double w_behind);
// {w, w of the cut} of edges from w to -w, w from 1 to 10,000.
std::vector<std::vector<std::string>> float_cut_rows(const Camera& camera);

// The tutorials' estimator without a floor for rounding: epsilon, however far away.
Image<float> ao_without_floor(const AoInputs& inputs, const LunaSettings& settings);

// Every normal turned towards the eye, as if one that looks away had to be wrong.
struct TurnedNormals {
    Image3 normals;
    int turned = 0;
};
TurnedNormals turned_to_eye(const GBuffer& gbuffer, const Camera& camera);

// The block, and a triangle one of whose corners somebody has lost far away.
Scene with_lost_vertex();
Scene without_lost_vertex();
// A ball of few triangles, whose normals say that it is smooth.
Scene coarse_ball();

}  // namespace crevice
