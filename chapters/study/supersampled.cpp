#include "chapters/study/supersampled.h"

#include <algorithm>
#include <cmath>

#include "chapters/study/seen_points.h"
#include "ssao/light/shade.h"

namespace crevice {

namespace {

constexpr int kSide = 2;  // samples of a pixel, across and down

Image<float> with_contrast(Image<float> ao) {
    for (float& a : ao.pixels) a = a * a * a * a;  // X_Jun's exponent
    return ao;
}

// Each pixel repeated for its samples.
Image<float> repeated(const Image<float>& pixels) {
    Image<float> samples({kSide * pixels.size.width, kSide * pixels.size.height}, 0.0f);
    for (int y = 0; y < samples.size.height; ++y) {
        for (int x = 0; x < samples.size.width; ++x) samples.at(x, y) = pixels.at(x / kSide, y / kSide);
    }
    return samples;
}

Image3 mean_of_samples(const Image3& samples, Size size) {
    Image3 mean(size, glm::vec3(0));
    for (int y = 0; y < kSide * size.height; ++y) {
        for (int x = 0; x < kSide * size.width; ++x) {
            const glm::vec3 share = samples.at(x, y) * (1.0f / (kSide * kSide));
            mean.set(x / kSide, y / kSide, mean.at(x / kSide, y / kSide) + share);
        }
    }
    return mean;
}

// 1 where a pixel's samples differ as the blur's edges do: in normal or, scene units, in depth.
Image<float> edges_of(const GBuffer& samples, Size size) {
    Image<float> edge(size, 0.0f);
    for (int y = 0; y < kSide * size.height; ++y) {
        for (int x = 0; x < kSide * size.width; ++x) {
            const int x0 = x / kSide * kSide, y0 = y / kSide * kSide;
            const float z = samples.view_depth.at(x, y), z0 = samples.view_depth.at(x0, y0);
            const glm::vec3 n = samples.normal.at(x, y), n0 = samples.normal.at(x0, y0);
            const bool both_sky = std::isinf(z) && std::isinf(z0);
            const float cosine = n.x * n0.x + n.y * n0.y + n.z * n0.z;
            if (!both_sky && !(std::fabs(z - z0) <= 0.2f && cosine >= 0.8f))
                edge.at(x0 / kSide, y0 / kSide) = 1;
        }
    }
    return edge;
}

}  // namespace

Supersampled supersample(const Scene& scene, const Camera& camera, Size size) {
    const GBuffer pixels = normal_depth(scene, camera, size),
                  samples = normal_depth(scene, camera, {kSide * size.width, kSide * size.height});
    const Image<float> ao = with_contrast(noiseless_ao(pixels, camera));
    const auto lit = [&](const Image<float>& sample_ao) {
        return mean_of_samples(shade(scene, camera, samples.depth, sample_ao), size);
    };
    Supersampled result{shade(scene, camera, pixels.depth, ao),
                        lit(with_contrast(noiseless_ao(samples, camera))), lit(repeated(ao)),
                        Image<float>(size, 0.0f), edges_of(samples, size)};
    double at_edges = 0, edges = 0, elsewhere = 0, others = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            result.off.at(x, y) = result.four_with_one.y.at(x, y) - result.four.y.at(x, y);
            const double off = std::fabs(double(result.off.at(x, y)));
            if (result.edge.at(x, y) > 0) {
                at_edges += off, edges += 1;
            } else {
                elsewhere += off, others += 1;
            }
        }
    }
    result.off_at_edges = at_edges / std::max(edges, 1.0);
    result.off_elsewhere = elsewhere / std::max(others, 1.0);
    result.edge_share = edges / (edges + others);
    return result;
}

}  // namespace crevice
