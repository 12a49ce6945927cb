// What the peer's AO pass and its blur are given, method by method.
#include <algorithm>
#include <cmath>

#include "chapters/bench/peer_scene.h"
#include "rasterizer/base/error.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/inputs/random_vectors.h"
#include "ssao/methods/luna_settings.h"

namespace crevice {

namespace {

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
void set_tutorial(PeerScene& peer, const Method& method, const MethodSettings& settings) {
    const LunaSettings& ao = settings.ao.as<LunaSettings>();
    const DepthSource own = method.defaults.as<LunaSettings>().depth_source;
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

bool is_tutorial(const Method& method) {
    const std::string name = method.name;
    return name == "xjun" || name == "luna";
}

}  // namespace

RawAo ao_as_peer(const AoView& view, const Method& method, const MethodSettings& settings, const Run& run) {
    AnySettings ao = settings.ao;
    ao.as<LunaSettings>().edge_texels = EdgeTexels::mixed;
    return method.ao(view, ao, run);
}

void set_peer_method(PeerScene& peer, const Method& method, const MethodSettings& settings) {
    if (is_tutorial(method)) return set_tutorial(peer, method, settings);
    throw UsageError("--peers: the peer has no such AO (" + std::string(method.name) +
                     "); choose xjun or luna");
}

}  // namespace crevice
