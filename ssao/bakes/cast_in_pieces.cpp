#include "ssao/bakes/cast_in_pieces.h"

#include <algorithm>

namespace crevice {

std::vector<float> cast_in_pieces(const RayScene& scene, std::span<const SurfacePoint> points,
                                  RayAoSettings settings,
                                  const std::function<std::uint32_t(std::uint32_t piece)>& seed_of_piece,
                                  const Run& run, const std::function<void(long long)>& on_progress) {
    constexpr std::size_t kPiece = 4096;
    std::vector<float> open;
    open.reserve(points.size());
    for (std::size_t first = 0; first < points.size(); first += kPiece) {
        const auto piece = points.subspan(first, std::min(kPiece, points.size() - first));
        settings.seed = seed_of_piece(static_cast<std::uint32_t>(first / kPiece));
        const std::vector<float> values = ray_cast_ao(scene, piece, settings, run);
        open.insert(open.end(), values.begin(), values.end());
        if (on_progress) on_progress(static_cast<long long>(piece.size()));
    }
    return open;
}

}  // namespace crevice
