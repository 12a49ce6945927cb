// Children that misbehave, and the real peer where it was built.
#include <doctest/doctest.h>

#include <sys/stat.h>

#include <fstream>
#include <sstream>

#include "chapters/bench/agreement.h"
#include "chapters/bench/peers.h"
#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"
#include "tests/tools/scratch_directory.h"
#include "tests/tools/tutorial_settings.h"

using namespace crevice;

namespace {

std::filesystem::path script(const ScratchDirectory& scratch, const std::string& text) {
    const std::filesystem::path path = scratch / "peer";
    std::ofstream(path) << "#!/bin/sh\n" << text << "\n";
    chmod(path.c_str(), 0700);
    return path;
}

// The message of an InputError, or "no error".
template <class Action>
std::string input_error_of(const Action& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

PeerScene trench_stream() {
    const Scene scene = trench_scene();
    return peer_scene(scene, scene.camera, kSmallestCompared, settings_of(find_method("xjun"), {}));
}

std::filesystem::path built_peer() {
    return std::filesystem::path(CREVICE_PROGRAM).parent_path() / "gl_ssao_peer";
}

}  // namespace

TEST_CASE("a peer that is not there, dies, hangs or talks nonsense is an error that says so") {
    struct Case {
        std::string text, named;
    };
    const Case cases[] = {
        {"exit 7", "exit code 7"},
        {"kill -9 $$", "exit code 137"},
        {"head -c 1000 >/dev/null; exit 0", "exit code 0"},
        {"exec sleep 30", "no answer"},
        {"exec 3<&0; cat <&3 >/dev/null & echo hello; wait", "hello"},
    };
    for (const Case& c : cases) {
        CAPTURE(c.text);
        const ScratchDirectory scratch;
        const std::string message = input_error_of([&] {
            PeerSession peer(script(scratch, c.text), 1, 0.5);
            peer.load(trench_stream());
        });
        CAPTURE(message);
        CHECK(message.find(c.named) != std::string::npos);
        CHECK(message.find(';') != std::string::npos);  // and what to do
    }
    const std::string missing = input_error_of([] { PeerSession("no_such_peer", 1, 0.5); });
    CHECK(missing.find("libgl1-mesa-dri") != std::string::npos);
}

TEST_CASE("times that are no times are refused") {
    for (const std::string times : {"1 2 3", "a b c d e f g h", "0 0 0 0 0 0 0 0", "nan 1 1 1 1 1 1 1"}) {
        CAPTURE(times);
        const ScratchDirectory scratch;
        const std::string text =
            "exec 3<&0; cat <&3 >/dev/null & echo ready fake; sleep .1; echo '" + times + "'; wait";
        const std::string message = input_error_of([&] {
            PeerSession peer(script(scratch, text), 1, 5);
            CHECK(peer.load(trench_stream()) == "fake");
            peer.frame();
        });
        CHECK(message.find("not an answer") != std::string::npos);
    }
}

TEST_CASE("run_child: exit code and words of a program; one that does not end is ended") {
    const ChildOutcome outcome =
        run_child({"sh", {"-c", "echo $WORD; echo err >&2; exit 3"}, {"WORD=said"}, 5});
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.output == "said\nerr\n");
    CHECK_THROWS_AS(run_child({"sleep", {"30"}, {}, 0.2}), InputError);
    CHECK_THROWS_AS(run_child({"no_such_program_anywhere", {}, {}, 1}), InputError);
    CHECK(in_path("sh"));
    CHECK(!in_path("no_such_program_anywhere"));
}

TEST_CASE("the peer draws the same picture, and another radius is noticed") {
    if (!std::filesystem::exists(built_peer())) {
        MESSAGE("skipped: gl_ssao_peer was not built (libegl-dev libgl-dev libegl-mesa0 libgl1-mesa-dri)");
        return;
    }
    for (const Scene& scene : {columns_scene(), columns_luna_scene()}) {
        FrameRequest request;
        request.size = {640, 360};
        request.method = &find_method("xjun");
        request.settings = settings_of(*request.method, {});
        const Frame ours = render_frame(scene, scene.camera, request);
        PeerSession peer(built_peer(), 2, 120);
        peer.load(peer_scene(scene, scene.camera, request.size, request.settings));
        for (const Agreement& a : agreement(scene, request, ours, peer.buffers())) {
            INFO(scene.name, ", ", a.buffer, ": ", a.value, " of at most ", a.limit);
            CHECK(a.holds());
        }
        FrameSettings wrong = request.settings;
        ao_of(wrong).radius *= 1.1f;
        peer.load(peer_scene(scene, scene.camera, request.size, wrong));
        bool noticed = false;
        for (const Agreement& a : agreement(scene, request, ours, peer.buffers()))
            noticed = noticed || !a.holds();
        INFO(scene.name);
        CHECK(noticed);
    }
}
