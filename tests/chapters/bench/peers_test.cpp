// Children that misbehave, and the real peer where it was built.
#include <doctest/doctest.h>

#include <sys/stat.h>

#include <fstream>
#include <sstream>

#include "chapters/bench/agreement.h"
#include "chapters/bench/peer_scene.h"
#include "chapters/bench/peers.h"
#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"
#include "tests/tools/error_message.h"
#include "tests/tools/scratch_directory.h"
#include "tests/tools/tutorial_settings.h"

using namespace crevice;

namespace {

// For what answers at once, on a machine that has a lot else to do; and for what never does.
constexpr double kPatience_s = 120, kLittlePatience_s = 0.5;

std::filesystem::path script(const ScratchDirectory& scratch, const std::string& text) {
    const std::filesystem::path path = scratch / "peer";
    std::ofstream(path) << "#!/bin/sh\n" << text << "\n";
    chmod(path.c_str(), 0700);
    return path;
}

FrameRequest request_for(const char* method, Size size) {
    FrameRequest request;
    request.size = size;
    request.method = &find_method(method);
    request.settings = settings_of(*request.method, {});
    return request;
}

PeerScene trench_stream() {
    const Scene scene = trench_scene();
    return peer_scene(scene, scene.camera, request_for("xjun", kSmallestCompared));
}

std::filesystem::path built_peer() {
    return std::filesystem::path(CREVICE_PROGRAM).parent_path() / "gl_ssao_peer";
}

}  // namespace

TEST_CASE("a peer that is not there, dies, hangs or talks nonsense is an error that says so") {
    struct Case {
        std::string text, named;
        double patience_s = kPatience_s;
    };
    const Case cases[] = {
        {"exit 7", "exit code 7"},
        {"kill -9 $$", "exit code 137"},
        {"head -c 1000 >/dev/null; exit 0", "exit code 0"},
        {"exec sleep 30", "no answer", kLittlePatience_s},
        {"exec 3<&0; cat <&3 >/dev/null & echo hello; wait", "hello"},
    };
    for (const Case& c : cases) {
        CAPTURE(c.text);
        const ScratchDirectory scratch;
        const std::string message = message_of<InputError>([&] {
            PeerSession peer(script(scratch, c.text), 1, c.patience_s);
            peer.load(trench_stream());
        });
        CAPTURE(message);
        CHECK(message.find(c.named) != std::string::npos);
        CHECK(message.find(';') != std::string::npos);  // and what to do
    }
    const std::string missing = message_of<InputError>([] { PeerSession("no_such_peer", 1, kPatience_s); });
    CHECK(missing.find("libgl1-mesa-dri") != std::string::npos);
}

TEST_CASE("times that are no times are refused") {
    for (const std::string times :
         {"1 2 3", "1 2 3 4 5 6 7 8 9", "a b c d e f g h", "0 0 0 0 0 0 0 0", "nan 1 1 1 1 1 1 1"}) {
        CAPTURE(times);
        const ScratchDirectory scratch;
        const std::string text =
            "exec 3<&0; cat <&3 >/dev/null & echo ready fake; sleep .1; echo '" + times + "'; wait";
        const std::string message = message_of<InputError>([&] {
            PeerSession peer(script(scratch, text), 1, kPatience_s);
            CHECK(peer.load(trench_stream()) == "fake");
            peer.frame();
        });
        CHECK(message.find("not an answer") != std::string::npos);
    }
}

TEST_CASE("run_child: exit code and words of a program; one that does not end is ended") {
    const ChildOutcome outcome =
        run_child({"sh", {"-c", "echo $WORD; echo err >&2; exit 3"}, {"WORD=said"}, kPatience_s});
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.output == "said\nerr\n");
    CHECK_THROWS_AS(run_child({"sleep", {"30"}, {}, kLittlePatience_s}), InputError);
    CHECK_THROWS_AS(run_child({"no_such_program_anywhere", {}, {}, kPatience_s}), InputError);
    CHECK(in_path("sh"));
    CHECK(!in_path("no_such_program_anywhere"));
}

namespace {

std::vector<Agreement> agreement_with(PeerSession& peer, const Scene& scene, const FrameRequest& request,
                                      const Frame& ours, const PeerScene& theirs) {
    peer.load(theirs);
    return agreement(scene, request, ours, peer.buffers());
}

// What is not held, in words; empty: the peer draws what we draw. `theirs` is what it is told to draw.
std::string broken_limits(PeerSession& peer, const Scene& scene, const FrameRequest& request,
                          const Frame& ours, const PeerScene& theirs) {
    std::ostringstream broken;
    for (const Agreement& a : agreement_with(peer, scene, request, ours, theirs)) {
        if (!a.holds())
            broken << a.buffer << ", " << a.measure << ": " << a.value << " of " << *a.limit << "; ";
    }
    return broken.str();
}

// Anisotropic filters differ between the two, and with them what is cut out.
Scene trilinear(Scene scene) {
    for (Material& material : scene.materials) material.sampler.filter = TextureFilter::trilinear;
    return scene;
}

}  // namespace

TEST_CASE("the peer draws the same pictures, and what is wrong in one pass is noticed") {
    if (!std::filesystem::exists(built_peer())) {
        MESSAGE("skipped: gl_ssao_peer was not built (libegl-dev libgl-dev libegl-mesa0 libgl1-mesa-dri)");
        return;
    }
    struct Case {
        Scene scene;
        const char* method;
    };
    const Case cases[] = {{columns_scene(), "xjun"},
                          {columns_luna_scene(), "xjun"},
                          {columns_luna_scene(SceneDetail::surfaces), "luna"},
                          {columns_2022_scene(SceneDetail::surfaces), "xjun"}};
    for (const Case& c : cases) {
        const Scene& scene = c.scene;
        CAPTURE(scene.name);
        const FrameRequest request = request_for(c.method, {640, 360});
        const Frame ours = render_frame(scene, scene.camera, request);
        PeerSession peer(built_peer(), 2, kPatience_s);
        const PeerScene right = peer_scene(scene, scene.camera, request);
        CHECK(broken_limits(peer, scene, request, ours, right) == "");
        FrameRequest wrong = request;
        ao_of(wrong.settings).radius *= 1.1f;
        CHECK(broken_limits(peer, scene, request, ours, peer_scene(scene, scene.camera, wrong)) != "");
        if (right.frame.shadow.side == 0) continue;
        PeerScene no_bias = right, no_normal_maps = right, no_sky = right;
        no_bias.frame.shadow.bias_constant = no_bias.frame.shadow.bias_slope = 0;
        for (PeerDraw& draw : no_normal_maps.draws) draw.normal_map = kNoPeerTexture;
        no_sky.sky.assign(no_sky.sky.size(), 0.5f);
        for (const PeerScene& other : {no_bias, no_normal_maps, no_sky})
            CHECK(broken_limits(peer, scene, request, ours, other) != "");
    }
}

TEST_CASE("the peer cuts out what we cut out") {
    if (!std::filesystem::exists(built_peer())) {
        MESSAGE("skipped: gl_ssao_peer was not built (libegl-dev libgl-dev libegl-mesa0 libgl1-mesa-dri)");
        return;
    }
    const Scene scene = trilinear(fence_scene(SceneDetail::surfaces));
    const FrameRequest request = request_for("xjun", {640, 360});
    const Frame ours = render_frame(scene, scene.camera, request);
    PeerSession peer(built_peer(), 2, kPatience_s);
    const PeerScene right = peer_scene(scene, scene.camera, request);
    PeerScene whole = right;
    for (PeerDraw& draw : whole.draws) draw.alpha_cutoff = 0;
    // At the edges of holes the two may differ: which mip level a pixel reads is found in other ways.
    const auto at_other_depth = [&](const PeerScene& theirs) {
        for (const Agreement& a : agreement_with(peer, scene, request, ours, theirs)) {
            if (std::string(a.buffer) == "view_depth") return a.value;
        }
        return -1.0;
    };
    const double with_holes = at_other_depth(right), without = at_other_depth(whole);
    CAPTURE(with_holes);
    CAPTURE(without);
    CHECK(with_holes >= 0);
    CHECK(with_holes < 1);
    CHECK(without > 5);
}

TEST_CASE("the peer's other methods find the same AO, and another number of any of them is noticed") {
    if (!std::filesystem::exists(built_peer())) {
        MESSAGE("skipped: gl_ssao_peer was not built (libegl-dev libgl-dev libegl-mesa0 libgl1-mesa-dri)");
        return;
    }
    Scene flat = columns_luna_scene();
    flat.camera.projection = Projection::orthographic;
    flat.camera.ortho_height = 10;
    for (const char* method : {"hemisphere", "sao", "gtao"}) {
        for (const Scene& scene : {columns_luna_scene(), flat}) {
            CAPTURE(method);
            CAPTURE(static_cast<int>(scene.camera.projection));
            FrameRequest request = request_for(method, {640, 360});
            request.wanted.erase("lit");
            const Frame ours = render_frame(scene, scene.camera, request);
            PeerSession peer(built_peer(), 2, kPatience_s);
            const PeerScene right = peer_scene(scene, scene.camera, request);
            CHECK(broken_limits(peer, scene, request, ours, right) == "");
            if (scene.camera.projection == Projection::orthographic) continue;
            for (const char* parameter : {"radius", "seed", "blur_iterations"}) {
                CAPTURE(parameter);
                FrameRequest other = request;
                const double value = value_of(*request.method, request.settings.method, parameter).value();
                other.settings.method =
                    with_value(*request.method, request.settings.method, parameter, value + 1);
                CHECK(broken_limits(peer, scene, request, ours, peer_scene(scene, scene.camera, other)) !=
                      "");
            }
        }
    }
}
