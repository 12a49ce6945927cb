// Normals turned by a matrix that is not the inverse transpose, and what AO makes of them: for chapter 03.
#pragma once

#include <string>
#include <vector>

#include "rasterizer/draw/normal_depth.h"

namespace crevice {

struct NormalError {
    double most_deg = 0;  // the largest angle to the right normal; one that vanished counts 180
    double share = 0;     // of those with a right normal: off by more than one degree
};

// Both of one size. Pixels where `right` has no normal do not count.
NormalError normal_error(const Image3& normals, const Image3& right);

// A scene by the inverse transpose and by another matrix: normals, X_Jun's AO, and how far they differ.
struct ComparedNormals {
    Image3 right, wrong;
    Image<float> ao_right, ao_wrong;
    NormalError off;
    double shade_lost = 0, shade_invented = 0;  // mean over the AO map of how much lighter, darker it got
};
ComparedNormals compare_normals(const Scene& scene, NormalMatrix matrix, Size size);
// {name, largest angle, share that is off, shade lost, shade invented}
std::vector<std::string> normals_row(const std::string& name, const ComparedNormals& both);

// On a floor, all stretched by (2, 1, 2): Luna's box; a box that was turned before; a ball.
Scene stretched_scene();

// SSAO explored multiplies float4(n, 0) by all of (W^-1)^T V, X_Jun n by the upper 3x3 of that product.
enum class NormalProduct { float4, float3x3 };

// The largest angle, degrees, that one of the two leaves between a scene's normals and the right ones.
// `erased`: W has lost its translation before, which is X_Jun's cure. Matrices are this lab's, for column
// vectors.
double tutorial_error_deg(const Scene& scene, const Camera& camera, NormalProduct product, bool erased);

}  // namespace crevice
