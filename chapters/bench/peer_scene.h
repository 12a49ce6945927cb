// What the peer program is given to draw a scene as a request says.
#pragma once

#include "chapters/bench/peer_stream.h"
#include "chapters/frame/frame.h"

namespace crevice {

// The shadow map is the one that the scene asks for (ssao/light/scene_shadow.h), and the frame ends with the blur where
// the request does not want "lit". Throws UsageError for what the peer does not draw: vertex colours, point lights,
// textures without mip levels between, a reversed or integer depth buffer, 16-bit buffers, artifact switches, AO methods
// that it has no shader for.
PeerScene peer_scene(const Scene& scene, const Camera& camera, const FrameRequest& request);

// Throws UsageError naming what the peer does not have, unless it holds.
void require_in_peer(bool holds, const char* what);

// Sets what the AO pass and its blur are given. Throws UsageError for methods and settings that they do not know.
void set_peer_method(PeerScene& peer, const Method& method, const MethodSettings& settings);

// Our raw AO with G-buffer and random numbers fetched in the peer's way: a texel takes the mean of its pixels. Throws
// UsageError as set_peer_method() does.
RawAo ao_as_peer(const AoView& view, const Method& method, const MethodSettings& settings, const Run& run);

}  // namespace crevice
