// ray_cast_ao() of many points, piece by piece, so that progress can be told.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

// One value a point, in [0,1], 1 = open. Each piece has random numbers of its own, those of the seed that
// seed_of_piece(0, 1, 2 ...) gives, so the values do not depend on the threads. on_progress, if there is one,
// is called with the number of points that each piece had. Throws UsageError as ray_cast_ao() does.
std::vector<float> cast_in_pieces(const RayScene& scene, std::span<const SurfacePoint> points,
                                  RayAoSettings settings,
                                  const std::function<std::uint32_t(std::uint32_t piece)>& seed_of_piece,
                                  const Run& run, const std::function<void(long long)>& on_progress);

}  // namespace crevice
