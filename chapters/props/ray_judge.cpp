#include "chapters/props/ray_judge.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "ssao/rays/ray_cast_ao.h"
#include "ssao/rays/surface_points.h"

namespace crevice {

namespace {

// How far apart, of view depth, a texel and a pixel at its centre may be to show one surface.
constexpr float kOneSurface = 0.01f;

// Whether two neighbours show one plane, as far as their normals tell.
bool alike(const AoInputs& inputs, const Texel& a, const Texel& b) {
    constexpr float kSameNormal = 0.9999f;
    return glm::dot(inputs.normal.at(a.x, a.y), inputs.normal.at(b.x, b.y)) > kSameNormal;
}

}  // namespace

RayJudge::RayJudge(const SwitchedView& view, const ProbedView& drawn, std::uint32_t seed)
    : rays_(ray_scene(view.scene(), view.camera().eye)),
      relative_from_view_(camera_matrices(view.camera(), drawn.ao().size).relative_from_view),
      radius_(view.request({}).settings.method.ao.as<LunaSettings>().radius) {
    const Size size = drawn.ao().size;
    const GBuffer gbuffer = normal_depth(view.scene(), view.camera(), size);
    const SurfacePoints points = surface_points(view.scene(), view.camera(), gbuffer);
    RayAoSettings settings;
    settings.rays = kRays;
    settings.radius = radius_;
    settings.seed = seed;
    truth_ = picture_of(points, ray_cast_ao(rays_, points.points, settings));
    settings.radius = 2 * radius_;
    twice_as_far_ = picture_of(points, ray_cast_ao(rays_, points.points, settings));
    known_ = Image<std::uint8_t>(size, 0);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const float z = gbuffer.view_depth.at(x, y), texel_z = drawn.inputs().view_depth.at(x, y);
            if (std::isfinite(z) && std::fabs(z - texel_z) < kOneSurface * z) known_.at(x, y) = 1;
        }
    }
}

Image<float> RayJudge::signed_error(const ProbedView& drawn) const {
    Image<float> error(truth_.size, 0.0f);
    for (int y = 0; y < error.size.height; ++y) {
        for (int x = 0; x < error.size.width; ++x) {
            if (known_.at(x, y) != 0)
                error.at(x, y) = drawn.ao().at(x, y) - std::pow(truth_.at(x, y), drawn.exponent());
        }
    }
    return error;
}

bool RayJudge::is_open_plane(const ProbedView& drawn, int x, int y) const {
    const Size size = truth_.size;
    if (x == 0 || y == 0 || x + 1 == size.width || y + 1 == size.height) return false;
    if (known_.at(x, y) == 0 || twice_as_far_.at(x, y) < 1) return false;
    const AoInputs& inputs = drawn.inputs();
    return alike(inputs, {x, y}, {x - 1, y}) && alike(inputs, {x, y}, {x + 1, y}) &&
           alike(inputs, {x, y}, {x, y - 1}) && alike(inputs, {x, y}, {x, y + 1});
}

std::vector<Texel> RayJudge::wrong_texels(const ProbedView& drawn, float by) const {
    const Image<float>& ao = drawn.ao();
    std::vector<Texel> wrong;
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            if (ao.at(x, y) < 1 - by && is_open_plane(drawn, x, y)) wrong.push_back({x, y});
        }
    }
    std::ranges::stable_sort(wrong, {}, [&](const Texel& t) { return ao.at(t.x, t.y); });
    return wrong;
}

std::vector<FalseBorder> RayJudge::false_borders(const ProbedView& drawn, float least) const {
    const Image<float>& ao = drawn.ao();
    const auto truth = [&](const Texel& t) { return std::pow(truth_.at(t.x, t.y), drawn.exponent()); };
    std::vector<FalseBorder> borders;
    const auto look = [&](const Texel& a, const Texel& b) {
        if (b.x >= ao.size.width || b.y >= ao.size.height) return;
        if (known_.at(a.x, a.y) == 0 || known_.at(b.x, b.y) == 0 || !alike(drawn.inputs(), a, b)) return;
        const float step = ao.at(b.x, b.y) - ao.at(a.x, a.y), height = std::fabs(step);
        if (height <= least || std::fabs(truth(a) - truth(b)) >= height / 4) return;
        borders.push_back(step > 0 ? FalseBorder{a, b, height} : FalseBorder{b, a, height});
    };
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            look({x, y}, {x + 1, y});
            look({x, y}, {x, y + 1});
        }
    }
    std::ranges::stable_sort(borders, std::greater<>(), &FalseBorder::height);
    return borders;
}

bool RayJudge::is_free(const Explanation& texel, std::size_t sample) const {
    const glm::vec3 way = relative_from_view_ * texel.samples[sample].offset;
    const glm::vec3 n = glm::normalize(relative_from_view_ * texel.n_view);
    // The point of a texel between four pixels may lie a little beneath a curved surface.
    const glm::vec3 start = relative_from_view_ * texel.p_view + 0.01f * radius_ * n;
    return !occluded(rays_, {start, way}, 1);
}

std::optional<std::size_t> RayJudge::guilty_sample(const Explanation& texel) const {
    std::optional<std::size_t> guilty;
    for (std::size_t i = 0; i < texel.samples.size(); ++i) {
        const float taken = texel.samples[i].contribution;
        if (taken <= 0 || !is_free(texel, i)) continue;
        if (!guilty || taken > texel.samples[*guilty].contribution) guilty = i;
    }
    return guilty;
}

ChangedSample changed_most(const Explanation& a, const Explanation& b) {
    ChangedSample most;
    double largest = 0, all = 0;
    for (std::size_t i = 0; i < a.samples.size(); ++i) {
        const double change = std::fabs(static_cast<double>(a.samples[i].contribution) -
                                        static_cast<double>(b.samples[i].contribution));
        all += change;
        if (change > largest) largest = change, most.sample = i;
    }
    most.share = all > 0 ? largest / all : 0;
    return most;
}

}  // namespace crevice
