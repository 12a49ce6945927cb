// What the peer's AO pass and its blur are given, method by method.
#include <algorithm>
#include <cmath>

#include "chapters/bench/peer_scene.h"
#include "rasterizer/base/error.h"
#include "ssao/blur/box_blur.h"
#include "ssao/blur/edge_blur.h"
#include "ssao/blur/sao_blur_kernel.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/inputs/random_vectors.h"
#include "ssao/methods/gtao_kernel.h"
#include "ssao/methods/hemisphere.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/sao.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {

namespace {

constexpr int kNoiseSide = 64;  // of the tiles of sao and gtao

void add_number(PeerScene& peer, std::string_view name, float value) {
    PeerNumber& number = peer.numbers.emplace_back();
    std::copy(name.begin(), name.end(), number.name.begin());
    number.value = value;
}

void set_map_size(PeerFrame& frame, float scale) {
    const Size size = ao_map_size({frame.width, frame.height}, scale);
    frame.ao_width = size.width;
    frame.ao_height = size.height;
}

std::vector<std::uint8_t> random_texels(std::uint32_t seed) {
    const RandomMap map = random_map(seed);
    const auto byte = [](float component) {
        return static_cast<std::uint8_t>(std::lround((component + 1) * 127.5f));
    };
    std::vector<std::uint8_t> texels;
    for (std::size_t i = 0; i < map.x.size(); ++i) {
        texels.insert(texels.end(), {byte(map.x[i]), byte(map.y[i]), byte(map.z[i]), 255});
    }
    return texels;
}

void set_bilateral(PeerScene& peer, const BlurSettings& blur) {
    require_in_peer(blur.edges == BlurEdges::fixed, "blur edges but fixed ones");
    peer.frame.blur_iterations = blur.iterations;
    peer.blur_weights.assign(blur.weights.begin(), blur.weights.end());
    add_number(peer, "normal_threshold", blur.normal_threshold);
    add_number(peer, "depth_threshold", blur.depth_threshold);
}

// X_Jun's and Luna's: one estimator, two ways to fetch.
void set_tutorial(PeerScene& peer, DepthSource own, const MethodSettings& settings) {
    const LunaSettings& ao = settings.ao.as<LunaSettings>();
    require_in_peer(ao.depth_source == own && ao.format == BufferFormat::float32, "choice of buffers");
    require_in_peer(!shows_artifacts(ao), "artifact switches");
    peer.frame.method = PeerMethod::luna;
    peer.frame.reads_as_luna = own == DepthSource::ndc_depth ? 1 : 0;
    set_map_size(peer.frame, ao.ao_scale);
    const auto offsets = cube_offsets(ao.seed);
    peer.samples.assign(offsets.begin(), offsets.begin() + ao.samples);
    peer.random_map = random_texels(ao.seed);
    const float range = ao.fade_end - ao.fade_start;
    add_number(peer, "radius", ao.radius);
    add_number(peer, "fade_end", ao.fade_end);
    add_number(peer, "inverse_fade", range > 0 ? 1 / range : 3e38f);
    add_number(peer, "epsilon", ao.epsilon);
    add_number(peer, "exponent", ao.exponent);
    set_bilateral(peer, settings.denoiser.as<BlurSettings>());
}

// A tile of noise: of(x, y) for every texel.
template <class Of>
void set_noise(PeerScene& peer, int side, const Of& of) {
    peer.frame.noise_side = side;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) peer.noise.push_back(of(x, y));
    }
}

// What the methods that step from pixel to pixel have in common; a map size must be set.
void set_common(PeerScene& peer, float radius, float exponent, float ao_scale) {
    const PeerFrame& frame = peer.frame;
    set_map_size(peer.frame, ao_scale);
    add_number(peer, "radius", radius);
    add_number(peer, "exponent", exponent);
    add_number(peer, "pixels_per_unit", 0.5f * static_cast<float>(frame.height) / frame.ray_scale.y);
}

void set_hemisphere(PeerScene& peer, const MethodSettings& settings) {
    const HemisphereSettings& ao = settings.ao.as<HemisphereSettings>();
    const BoxDenoiserSettings& blur = settings.denoiser.as<BoxDenoiserSettings>();
    const bool cured = !ao.as_published && ao.range_check && ao.self_occlusion == SelfOcclusion::plane &&
                       ao.background == BackgroundPosition::far && ao.border == MapBorder::far &&
                       ao.unit_normals && ao.turn_vectors == TurnVectors::circle && !ao.turns_for_1024;
    require_in_peer(cured, "artifact switches");
    require_in_peer(blur.kind == BlurKind::box && !blur.box.shift, "blur of hemisphere but its own");
    peer.frame.method = PeerMethod::hemisphere;
    set_common(peer, ao.radius, ao.exponent, ao.ao_scale);
    add_number(peer, "bias", ao.bias);
    peer.samples = hemisphere_offsets(ao);
    const TurnTile turns(ao.turn_vectors, ao.seed);
    set_noise(peer, kTurnSide, [&](int x, int y) { return glm::vec4(turns.at(x, y), 0); });
    peer.frame.blur_iterations = blur.box.iterations;
    peer.blur_weights = {0.125f, 0.25f, 0.25f, 0.25f, 0.125f};  // half of the texels at the ends
}

void set_sao(PeerScene& peer, const MethodSettings& settings) {
    const SaoSettings& ao = settings.ao.as<SaoSettings>();
    const SaoBlurSettings& blur = settings.denoiser.as<SaoBlurSettings>();
    require_in_peer(!ao.as_published && ao.place == SaoPlace::picked, "artifact switches");
    require_in_peer(blur.kind == SaoBlurKind::sao, "blur of sao but its own");
    peer.frame.method = PeerMethod::sao;
    set_common(peer, ao.radius, ao.exponent, ao.ao_scale);
    add_number(peer, "inverse_radius", ao.radius > kSmallestRadius ? 1 / ao.radius : 0);
    add_number(peer, "intensity", ao.intensity);
    add_number(peer, "bias", ao.bias);
    add_number(peer, "epsilon", ao.epsilon);
    int levels = 0;
    while (levels < ao.levels && std::min(peer.frame.width, peer.frame.height) >> (levels + 1) > 0) ++levels;
    add_number(peer, "levels", static_cast<float>(levels));
    const std::vector<Screen2<float>> taps = sao_spiral(ao);
    for (std::size_t i = 0; i < taps.size(); ++i) {
        const float part = (static_cast<float>(i) + 0.5f) / static_cast<float>(ao.samples);
        peer.samples.emplace_back(taps[i].x, taps[i].y, part);
    }
    const NoiseTile cosine = sao_turn(ao, &SineCosine::cosine), sine = sao_turn(ao, &SineCosine::sine);
    set_noise(peer, kNoiseSide,
              [&](int x, int y) { return glm::vec4(cosine.at<float>(x, y), sine.at<float>(x, y), 0, 0); });
    peer.frame.blur_iterations = blur.iterations;
    add_number(peer, "quads", blur.quads ? 1.0f : 0.0f);
    add_number(peer, "fine", blur.fine ? 1.0f : 0.0f);
    add_number(peer, "quad_limit", kQuadShare * blur.depth);
    add_number(peer, "inverse_depth", inverse_limit(blur));
}

void set_gtao(PeerScene& peer, const MethodSettings& settings) {
    const GtaoSettings& ao = settings.ao.as<GtaoSettings>();
    const EdgeBlurSettings& blur = settings.denoiser.as<EdgeBlurSettings>();
    require_in_peer(ao.form == GtaoForm::losses && ao.thickness == 0 && ao.step_power == kStepPower,
                    "form of gtao but the lab's own");
    require_in_peer(ao.level_offset == GtaoSettings{}.level_offset, "pyramid of gtao");
    require_in_peer(blur.kind == EdgeBlurKind::edges, "blur of gtao but its own");
    peer.frame.method = PeerMethod::gtao;
    set_common(peer, ao.radius, ao.exponent, ao.ao_scale);
    const SlicePlan plan = slice_plan(ao.samples);
    const float reach = ao.radius_multiplier * ao.radius;
    add_number(peer, "reach", reach);
    add_number(peer, "inverse_fade", GtaoKernel::inverse_or_step(ao.falloff * reach));
    add_number(peer, "steps", static_cast<float>(plan.steps));
    for (const glm::vec2 direction : slice_directions(plan.slices)) peer.samples.emplace_back(direction, 0);
    const SliceNoise noise(ao.seed, plan.slices);
    set_noise(peer, kNoiseSide, [&](int x, int y) {
        return glm::vec4(noise.cosine.at<float>(x, y), noise.sine.at<float>(x, y), noise.step.at<float>(x, y),
                         0);
    });
    peer.frame.blur_iterations = blur.iterations;
}

// A row of what the peer knows: how it is told, and the kernel for a G-buffer fetched in its way.
struct PeerRow {
    const char* name;
    void (*set)(PeerScene& peer, const MethodSettings& settings);
    AoFetch (*fetch)(const AnySettings& settings);
    AoMap (*ao)(const AoInputs& inputs, const AnySettings& settings, const Run& run);
};

template <class S>
AoFetch fetch_of(const AnySettings& settings) {
    return pixel_fetch(settings.as<S>());
}

constexpr PeerRow kRows[] = {
    {"xjun", [](PeerScene& peer, const MethodSettings& s) { set_tutorial(peer, DepthSource::view_depth, s); },
     [](const AnySettings& s) { return xjun_fetch(s.as<LunaSettings>()); },
     [](const AoInputs& inputs, const AnySettings& s, const Run& run) {
         return luna_occlusion(inputs, s.as<LunaSettings>(), run);
     }},
    {"luna", [](PeerScene& peer, const MethodSettings& s) { set_tutorial(peer, DepthSource::ndc_depth, s); },
     [](const AnySettings& s) { return luna_fetch(s.as<LunaSettings>()); },
     [](const AoInputs& inputs, const AnySettings& s, const Run& run) {
         return luna_occlusion(inputs, s.as<LunaSettings>(), run);
     }},
    {"hemisphere", set_hemisphere,
     [](const AnySettings& s) { return hemisphere_fetch(s.as<HemisphereSettings>()); },
     [](const AoInputs& inputs, const AnySettings& s, const Run& run) {
         return hemisphere_ao(inputs, s.as<HemisphereSettings>(), run);
     }},
    {"sao", set_sao, fetch_of<SaoSettings>,
     [](const AoInputs& inputs, const AnySettings& s, const Run& run) {
         return sao(inputs, s.as<SaoSettings>(), run);
     }},
    {"gtao", set_gtao, fetch_of<GtaoSettings>,
     [](const AoInputs& inputs, const AnySettings& s, const Run& run) {
         return gtao(inputs, s.as<GtaoSettings>(), run);
     }},
};

const PeerRow& row_of_peer(const Method& method) {
    std::string known;
    for (const PeerRow& row : kRows) {
        if (std::string(row.name) == method.name) return row;
        known += (known.empty() ? "" : ", ") + std::string(row.name);
    }
    throw UsageError("--ao: the peer has no such AO (" + std::string(method.name) + "); choose one of " +
                     known);
}

}  // namespace

RawAo ao_as_peer(const AoView& view, const Method& method, const MethodSettings& settings, const Run& run) {
    const PeerRow& row = row_of_peer(method);
    AoFetch fetch = row.fetch(settings.ao);
    if (fetch.scale < 1) fetch.edge_texels = EdgeTexels::mixed;  // else a texel has one pixel
    AoInputs inputs = ao_inputs(view.gbuffer, view.camera, fetch, run);
    AoMap map = row.ao(inputs, settings.ao, run);
    return {std::move(map.ao), std::move(map.tiles), std::move(inputs)};
}

void set_peer_method(PeerScene& peer, const Method& method, const MethodSettings& settings) {
    row_of_peer(method).set(peer, settings);
}

}  // namespace crevice
