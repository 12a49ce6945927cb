// The compute form of AO and blur against the pixel form: the same bits whatever the settings, the sizes, the
// apron and the run; and its counts of reads against those made by hand.
#include <string>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/compute/compute_ssao.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"
#include "tests/tools/switches.h"

using namespace crevice;

namespace {

// Numbers that follow from one seed.
class Draw {
 public:
    explicit Draw(int seed) : seed_(seed) {}
    float between(float low, float high) { return low + (high - low) * noise(71, seed_, ++drawn_); }
    int between(int low, int high) {  // both included
        return low + static_cast<int>(noise(71, seed_, ++drawn_) * static_cast<float>(high - low + 1));
    }
    template <class T, std::size_t N>
    T one_of(const T (&values)[N]) {
        return values[static_cast<std::size_t>(between(0, static_cast<int>(N) - 1))];
    }

 private:
    int seed_, drawn_ = 0;
};

constexpr BufferFormat kFormats[] = {BufferFormat::float32, BufferFormat::float16_toward_zero,
                                     BufferFormat::float16_nearest_even};

Run some_run(Draw& draw) {
    Run run;
    run.threads = draw.between(1, 3);
    run.lanes = draw.one_of({1, 0});
    const Isa isa = draw.one_of({Isa::baseline, Isa::avx2, Isa::avx512});
    run.isa = isa_available(isa) ? isa : Isa::baseline;
    run.kept = draw.one_of({KeptWork{}, KeptWork::all()});
    return run;
}

LunaSettings some_settings(Draw& draw) {
    LunaSettings s;
    s.samples = draw.between(1, 14);
    s.radius = draw.between(0.0f, 3.0f);
    s.fade_start = draw.between(0.0f, 1.0f);
    s.fade_end = s.fade_start + draw.between(0.0f, 3.0f);
    s.epsilon = draw.between(0.0f, 0.1f);
    s.exponent = draw.between(0.5f, 6.0f);
    s.seed = static_cast<std::uint32_t>(draw.between(1, 1000));
    s.as_published = draw.between(0, 1) == 1;
    s.ao_scale = draw.one_of({0.5f, 1.0f});
    s.format = draw.one_of(kFormats);
    if (draw.between(0, 1) == 1) draw.one_of(kAoSwitches).turn_on(s);
    return s;
}

AoInputs some_inputs(Draw& draw, const LunaSettings& settings, float sky_share) {
    const Size size = {draw.between(1, 90), draw.between(1, 90)};
    Camera camera = made_up_camera();
    const AoFetch fetch = draw.one_of(kTutorialMethods).fetch(settings);
    if (draw.between(0, 3) == 0) return ao_inputs(made_up_gbuffer(size, sky_share), camera, fetch);
    const Scene scene = still_life();
    if (draw.between(0, 3) == 0) camera.projection = Projection::orthographic;
    return ao_inputs(normal_depth(scene, camera, size), camera, fetch);
}

std::string text(Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

}  // namespace

TEST_CASE("compute AO: the pixel version's bits, for random settings, scenes, sizes, aprons and runs") {
    int strays_seen = 0, occluded_seen = 0;
    for (int seed = 0; seed < 120; ++seed) {
        Draw draw(seed);
        const LunaSettings settings = some_settings(draw);
        const AoInputs inputs = some_inputs(draw, settings, 0.3f);
        const int apron = draw.between(0, kWidestApron);
        const Run run = some_run(draw);
        CAPTURE(seed);
        CAPTURE(text(inputs.picture));
        CAPTURE(apron);
        const Image<float> pixel = luna_occlusion(inputs, settings, {}).ao;
        const GroupedAo grouped = luna_occlusion_in_groups(inputs, settings, apron, run);
        CHECK(content_hash(grouped.ao) == content_hash(pixel));
        CHECK(grouped.reads.direct >= 0);
        strays_seen += buffer_statistics(grouped.strays).max > 0;
        occluded_seen += buffer_statistics(pixel).min < 1;
    }
    CHECK(strays_seen > 40);
    CHECK(occluded_seen > 60);
}

// At one unit a pixel the samples of radius r stay within r pixels: an apron as wide holds them all.
TEST_CASE("compute AO: a sample strays where it leaves the apron, and only there") {
    const Size size = {70, 40};
    AoInputs inputs = plain_inputs(size, 50);
    LunaSettings settings{.radius = 6};
    const Run all{.kept = KeptWork::all()};
    const auto strays = [&](int apron) {
        return buffer_statistics(luna_occlusion_in_groups(inputs, settings, apron, all).strays);
    };
    CHECK(strays(7).max == 0);
    CHECK(strays(0).max > 0);
    CHECK(strays(0).mean > strays(2).mean);
    CHECK(strays(2).mean > strays(5).mean);
    // In the middle of a group, 8 texels from its edge, no sample strays even without an apron.
    const Image<float> none = luna_occlusion_in_groups(inputs, settings, 0, all).strays;
    CHECK(none.at(7, 7) == 0);
    CHECK(none.at(24, 24) == 0);
    CHECK(none.at(15, 7) > 0);
    CHECK(none.at(16, 24) > 0);
    settings.radius = 1000;
    CHECK(luna_occlusion_in_groups(inputs, settings, 0, all).strays.at(20, 20) > 10);
}

TEST_CASE("compute AO: reads of the map, counted by hand") {
    const Size size = {40, 20};  // groups of 16, 16 and 8 texels across, 16 and 4 down
    AoInputs inputs = plain_inputs(size, 50);
    inputs.view_depth.at(16, 3) = kInfinity;  // no surface, no sample
    const LunaSettings settings{.samples = 5, .radius = 2};
    const Run all{.kept = KeptWork::all()};
    const GroupedAo grouped = luna_occlusion_in_groups(inputs, settings, 3, all);
    CHECK(buffer_statistics(grouped.strays).max == 0);
    CHECK(grouped.reads.direct == (40 * 20 - 1) * 4 * 5);
    // Each axis: the group, two pixels right of it, three more at either end; -1 and size + 1 are the last.
    const int columns = (1 + 16 + 2 + 3) + (3 + 16 + 2 + 3) + (3 + 8 + 2),
              rows = (1 + 16 + 2 + 3) + (3 + 4 + 2);
    CHECK(grouped.reads.grouped == columns * rows);
    const GroupedAo without = luna_occlusion_in_groups(inputs, settings, 0, all);
    double strays = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) strays += without.strays.at(x, y);
    }
    CHECK(strays > 0);
    CHECK(without.strays.at(16, 4) > 0);
    CHECK(without.strays.at(16, 3) == 0);
    CHECK(without.reads.grouped == (18 + 18 + 10) * (18 + 6) + 4 * static_cast<std::int64_t>(strays));
}

TEST_CASE("compute AO: nothing to do reads nothing; aprons out of range are refused") {
    AoInputs inputs = plain_inputs({33, 9}, 50);
    inputs.view_depth = Image<float>({33, 9}, kInfinity);
    const GroupedAo grouped = luna_occlusion_in_groups(inputs, {});
    CHECK(other_than(grouped.ao, 1) == "");
    CHECK(grouped.reads.grouped == 0);
    CHECK(grouped.reads.direct == 0);
    // A flat surface occludes nothing: its groups are left out, and done when all work is kept.
    const AoInputs flat = plain_inputs({33, 9}, 50);
    CHECK(luna_occlusion_in_groups(flat, {}).reads.grouped == 0);
    CHECK(luna_occlusion_in_groups(flat, {}, 16, Run{.kept = KeptWork::all()}).reads.grouped > 0);
    CHECK_THROWS_WITH_AS(luna_occlusion_in_groups(inputs, {}, -1), doctest::Contains("apron"), UsageError);
    CHECK_THROWS_WITH_AS(luna_occlusion_in_groups(inputs, {}, kWidestApron + 1), doctest::Contains("0..24"),
                         UsageError);
    CHECK_THROWS_AS(luna_occlusion_in_groups(inputs, {.samples = 15}), UsageError);
}

TEST_CASE("compute blur: the pixel version's bits, for random settings, maps, sizes and runs") {
    int changed = 0;
    for (int seed = 0; seed < 80; ++seed) {
        Draw draw(seed + 1000);
        const AoInputs inputs = some_inputs(draw, {.ao_scale = draw.one_of({0.5f, 1.0f})}, 0.1f);
        BlurSettings settings;
        for (float& weight : settings.weights) weight = draw.between(0.01f, 1.0f);
        settings.iterations = draw.between(0, 10);
        settings.normal_threshold = draw.between(-1.0f, 1.0f);
        settings.depth_threshold = draw.between(0.0f, 3.0f);
        settings.format = draw.one_of(kFormats);
        settings.edges = draw.one_of({BlurEdges::fixed, BlurEdges::slope, BlurEdges::none});
        const Run run = some_run(draw);
        const Image<float> ao = noise_image(inputs.size(), 36);
        CAPTURE(seed);
        CAPTURE(text(inputs.size()));
        const Image<float> pixel = bilateral_blur(ao, inputs, settings).ao;
        const GroupedBlur grouped = bilateral_blur_in_groups(ao, inputs, settings, run);
        CHECK(content_hash(grouped.ao) == content_hash(pixel));
        changed += content_hash(pixel) != content_hash(ao);
    }
    CHECK(changed > 60);
}

TEST_CASE("compute blur: the bits where segments meet and end, across and down") {
    for (const int length : {5, 127, 128, 129, 256, 261}) {
        for (const Size size : {Size{length, 3}, {3, length}}) {
            CAPTURE(text(size));
            const Image<float> ao = noise_image(size, 36);
            const AoInputs inputs = plain_inputs(size, 5);
            CHECK(content_hash(bilateral_blur_in_groups(ao, inputs, kXjunBlur).ao) ==
                  content_hash(bilateral_blur(ao, inputs, kXjunBlur).ao));
        }
    }
    CHECK_THROWS_AS(
        bilateral_blur_in_groups(noise_image({3, 3}, 36), plain_inputs({3, 3}, 5), {.iterations = 65}),
        UsageError);
}

TEST_CASE("compute blur: reads of the maps, counted by hand") {
    const Size size = {300, 4};  // across 128, 128 and 44 texels, with 5 more at inner ends; down all 4
    const GroupedBlur once =
        bilateral_blur_in_groups(noise_image(size, 36), plain_inputs(size, 5), {.iterations = 1});
    CHECK(once.reads.grouped == 5 * (4 * (133 + 138 + 49) + 300 * 4));
    // 11 taps but for those outside: 15 of them at either end of a row, and down each texel reads its column.
    CHECK(once.reads.direct == 5 * (4 * (300 * 11 - 30) + 300 * 4 * 4));
    const GroupedBlur twice =
        bilateral_blur_in_groups(noise_image(size, 36), plain_inputs(size, 5), {.iterations = 2});
    CHECK(twice.reads.grouped == 2 * once.reads.grouped);
    CHECK(twice.reads.direct == 2 * once.reads.direct);
}
