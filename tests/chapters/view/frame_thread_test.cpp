// The thread that draws what a window shows.
#include <chrono>
#include <functional>
#include <thread>

#include <doctest/doctest.h>

#include "chapters/view/view_state.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"

using namespace crevice;

namespace {

constexpr int kPatience_ms = 60000;

ViewWish wish_for(const std::string& scene, const std::string& method) {
    ViewWish wish;
    wish.words.scene = scene;
    wish.words.ao = method;
    wish.words.size = "64x36";
    wish.shown = {"ao_blurred"};
    return wish;
}

// The newest frame once it is as wanted.
std::shared_ptr<const ViewFrame> frame_when(const FrameThread& frames,
                                            const std::function<bool(const ViewFrame&)>& is_wanted) {
    for (int waited = 0; waited < kPatience_ms; ++waited) {
        if (const auto frame = frames.newest(); frame != nullptr && is_wanted(*frame)) return frame;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    REQUIRE_MESSAGE(false, "no such frame within a minute");
    return nullptr;
}

}  // namespace

TEST_CASE("frame_thread: a frame has the bits that the program draws for the words it tells") {
    FrameThread frames({});
    ViewWish wish = wish_for("cornell", "xjun");
    Camera camera;
    camera.eye = {0.123456789, 1, -6};
    camera.target = {0, 1, 0};
    wish.camera = camera;
    frames.wish(wish);
    const auto frame = frame_when(frames, [](const ViewFrame&) { return true; });
    REQUIRE(frame->error == "");
    LabSession session;
    const DrawnFrame& drawn = session.draw(frame->words);
    REQUIRE(frame->hashes.size() == 1);
    CHECK(frame->hashes.front().second == content_hash(drawn.frame().ao_blurred));
    CHECK(frame->words.camera.eye == "0.1234568,1,-6");
}

TEST_CASE("frame_thread: what cannot be drawn is told, and the frame before stays") {
    FrameThread frames({});
    ViewWish wish = wish_for("cornell", "xjun");
    frames.wish(wish);
    frame_when(frames, [](const ViewFrame&) { return true; });
    wish.words.params = {"radius=-1"};
    ++wish.revision;
    frames.wish(wish);
    const auto frame = frame_when(frames, [](const ViewFrame& f) { return !f.error.empty(); });
    CHECK(frame->error.find("radius") != std::string::npos);
    CHECK(picture_in(*frame, "ao_blurred") != nullptr);
    wish.words.params = {};
    ++wish.revision;
    frames.wish(wish);
    frame_when(frames, [](const ViewFrame& f) { return f.error.empty(); });
}

TEST_CASE("frame_thread: a first frame that cannot be drawn is an error of its own kind") {
    const auto fails = [](const ViewWish& wish) {
        FrameThread frames({});
        frames.wish(wish);
        frame_when(frames, [](const ViewFrame&) { return false; });
    };
    CHECK_THROWS_AS(fails(wish_for("nosuch.obj", "xjun")), InputError);
    ViewWish no_samples = wish_for("cornell", "xjun");
    no_samples.words.params = {"samples=0"};
    CHECK_THROWS_AS(fails(no_samples), UsageError);
}

TEST_CASE("view_state: what is asked of a frame goes where the next one has it not") {
    ViewState state;
    state.wish = wish_for("cornell", "xjun");
    state.wish.pixel = {60, 30};
    state.wish.truth = true;
    state.use_size("64x32");
    CHECK(state.wish.pixel == std::pair{60, 30});
    state.use_size("60x30");
    CHECK_FALSE(state.wish.pixel);
    state.use_method("none");
    CHECK_FALSE(state.wish.truth);
}

TEST_CASE("frame_thread: a pixel is told and truth refines without another frame") {
    FrameThread frames({});
    ViewWish wish = wish_for("cornell", "xjun");
    frames.wish(wish);
    frame_when(frames, [](const ViewFrame&) { return true; });
    wish.pixel = {30, 20};
    frames.wish(wish);
    const auto probed = frame_when(frames, [](const ViewFrame& f) { return !f.probe.empty(); });
    CHECK(probed->probe.find("pixel (30, 20)") != std::string::npos);
    wish.truth = true;
    frames.wish(wish);
    const auto judged = frame_when(frames, [](const ViewFrame& f) { return f.truth && f.truth->rays >= 16; });
    CHECK(judged->drawn == 1);
    CHECK(judged->truth->rmse > 0);
    CHECK(judged->truth->rmse < 0.5);
    CHECK(picture_in(*judged, kAoError) != nullptr);
    // Showing it draws nothing anew.
    wish.shown = {kTruth};
    ++wish.revision;
    frames.wish(wish);
    const int rays = judged->truth->rays;
    CHECK(frame_when(frames, [&](const ViewFrame& f) { return f.truth && f.truth->rays > rays; })->drawn ==
          1);
}

TEST_CASE("view_state: another method keeps a buffer only where it has it") {
    ViewState state;
    state.wish = wish_for("cornell", "gtao");
    state.show(0, kBentNormal);
    state.use_method("xjun");
    CHECK(state.wish.shown == std::vector<std::string>{"ao_blurred"});
    state.show(1, "lit");
    CHECK(state.layout == ViewLayout::split);
    state.show(1, "");
    CHECK(state.layout == ViewLayout::one);
    CHECK(state.wish.shown.size() == 1);
    state.use_preset("luna");
    CHECK(state.wish.words.scene == "columns_luna");
    CHECK(state.wish.words.ao == "luna");
}
