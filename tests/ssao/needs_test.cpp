#include "ssao/needs.h"

#include <algorithm>
#include <memory>

#include <doctest/doctest.h>

#include "scenes/builtin_scenes.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

std::string reason(const Needs& needs, const std::string& what) {
    const auto at = std::find_if(needs.left_out.begin(), needs.left_out.end(),
                                 [&](const LeftOut& item) { return item.what == what; });
    return at == needs.left_out.end() ? "" : at->why;
}

// The subset of all buffers whose bits are set.
WantedBuffers subset(unsigned bits) {
    WantedBuffers wanted;
    for (unsigned i = 0; i < std::size(kBufferNames); ++i) {
        if ((bits >> i & 1) != 0) wanted.insert(kBufferNames[i]);
    }
    return wanted;
}

}  // namespace

TEST_CASE("needs: everything, when everything is asked for") {
    const Needs needs = needs_of(still_life(), all_buffers(), {}, false);
    CHECK(needs.normal_depth);
    CHECK(needs.normals);
    CHECK(needs.ao);
    CHECK(needs.blur);
    CHECK(needs.lit);
    CHECK(reason(needs, "ao") == "");
    CHECK(all_buffers().size() == 6);
}

TEST_CASE("needs: bent normals when they are asked for, or when the light of a scene with a sky reads them") {
    const AoWork read{.lit_reads_bent_normals = true};
    Scene under_sky = still_life();
    under_sky.sky_cube = std::make_shared<CubeMap>();
    for (const bool keep_all : {false, true}) {
        const auto needed = [&](const Scene& scene, const WantedBuffers& wanted, const AoWork& ao) {
            return needs_of(scene, wanted, ao, keep_all).bent_normals;
        };
        CAPTURE(keep_all);
        CHECK(!needed(under_sky, all_buffers(), {}));
        CHECK(needed(under_sky, {"bent_normal"}, {}));
        CHECK(needed(under_sky, {"lit"}, read));
        CHECK(!needed(still_life(), {"lit"}, read));
        CHECK(needed(under_sky, {"ao_raw"}, read) == keep_all);  // which draws the lit image, too
        CHECK(!needed(under_sky, {"bent_normal"}, {.computed = false}));
    }
    const Needs alone = needs_of(still_life(), {"bent_normal"}, {}, false);
    CHECK(alone.ao);
    CHECK(alone.normals);
    CHECK(!alone.blur);
    CHECK(!alone.lit);
}

TEST_CASE("needs: only what the asked buffers depend on") {
    struct Case {
        WantedBuffers wanted;
        bool normals, ao, blur, lit;
    };
    const Case cases[] = {
        {{"view_depth"}, false, false, false, false},
        {{"ndc_depth"}, false, false, false, false},
        {{"normal"}, true, false, false, false},
        {{"ao_raw"}, true, true, false, false},
        {{"ao_blurred"}, true, true, true, false},
        {{"ao_raw", "view_depth"}, true, true, false, false},
        {{"lit"}, true, true, true, true},
        {{"lit", "normal"}, true, true, true, true},
        {{}, false, false, false, false},
    };
    for (const Case& expected : cases) {
        std::string names;
        for (const std::string& name : expected.wanted) names += name + " ";
        CAPTURE(names);
        const Needs needs = needs_of(still_life(), expected.wanted, {}, false);
        CHECK(needs.normal_depth);
        CHECK(needs.normals == expected.normals);
        CHECK(needs.ao == expected.ao);
        CHECK(needs.blur == expected.blur);
        CHECK(needs.lit == expected.lit);
    }
}

TEST_CASE(
    "needs: shadow, sky, textures, normal maps and cut-outs only of scenes that have them, and only when "
    "lit") {
    const char* const parts[] = {"shadow", "sky", "texture coordinates", "tangents", "cut-outs"};
    const auto left_out = [&](const char* name, SceneDetail detail, const WantedBuffers& wanted) {
        std::string which;
        const Needs needs = needs_of(find_builtin_scene(name)->make(detail), wanted, {}, false);
        for (const char* part : parts) which += reason(needs, part).empty() ? "" : std::string(part) + "; ";
        CHECK(needs.shadow == reason(needs, "shadow").empty());
        CHECK(needs.sky == reason(needs, "sky").empty());
        return which;
    };
    CHECK(left_out("fence", SceneDetail::surfaces, all_buffers()) == "");
    CHECK(left_out("columns_luna", SceneDetail::surfaces, all_buffers()) == "cut-outs; ");
    CHECK(left_out("columns_luna", SceneDetail::shapes, all_buffers()) ==
          "shadow; sky; texture coordinates; tangents; cut-outs; ");
    CHECK(left_out("columns_luna", SceneDetail::surfaces, {"ao_raw"}) ==
          "shadow; sky; texture coordinates; tangents; cut-outs; ");
    CHECK(left_out("fence", SceneDetail::shapes, {"ao_raw"}) == "shadow; sky; tangents; ");
    const Scene luna = columns_luna_scene(SceneDetail::surfaces);
    CHECK(reason(needs_of(luna, {"normal"}, {}, false, true), "tangents").empty());
    CHECK(reason(needs_of(luna, {"normal"}, {}, false, true), "texture coordinates").empty());
    CHECK(left_out("noise_wall", SceneDetail::surfaces, all_buffers()) ==
          "shadow; sky; tangents; cut-outs; ");
}

TEST_CASE("needs: no AO method, no blur, no triangles") {
    const Needs none = needs_of(still_life(), all_buffers(), {.computed = false}, false);
    CHECK(!none.ao);
    CHECK(!none.blur);
    CHECK(none.lit);
    CHECK(reason(none, "ao").find("none") != std::string::npos);
    const Needs unblurred =
        needs_of(still_life(), all_buffers(), {.why_no_blur = "blur_iterations is 0"}, false);
    CHECK(unblurred.ao);
    CHECK(!unblurred.blur);
    CHECK(reason(unblurred, "blur").find("blur_iterations") != std::string::npos);
    const Needs empty = needs_of(empty_scene(), all_buffers(), {}, false);
    CHECK(!empty.ao);
    CHECK(!empty.blur);
    CHECK(reason(empty, "ao").find("no triangles") != std::string::npos);
}

TEST_CASE(
    "needs: whatever is asked for, every 'no' has a reason and every 'yes' none; keep_all says no 'no'") {
    const Scene with = still_life(), without = empty_scene();
    for (unsigned bits = 0; bits < 64; ++bits) {
        for (const Scene* scene : {&with, &without}) {
            for (const bool ao_on : {false, true}) {
                for (const char* why_no_blur : {"blur_iterations is 0", static_cast<const char*>(nullptr)}) {
                    for (const bool keep_all : {false, true}) {
                        CAPTURE(bits);
                        CAPTURE(scene->name);
                        CAPTURE(ao_on);
                        CAPTURE((why_no_blur != nullptr));
                        CAPTURE(keep_all);
                        const Needs needs = needs_of(
                            *scene, subset(bits), {.computed = ao_on, .why_no_blur = why_no_blur}, keep_all);
                        CHECK(needs.normals == reason(needs, "normals").empty());
                        CHECK(needs.ao == reason(needs, "ao").empty());
                        CHECK(needs.blur == reason(needs, "blur").empty());
                        CHECK(needs.lit == reason(needs, "lit").empty());
                        CHECK(needs.materials == reason(needs, "materials").empty());
                        CHECK((!needs.blur || needs.ao));
                        CHECK((!(needs.ao || needs.lit) || needs.normals));
                        if (!keep_all) continue;
                        CHECK(needs.normals);
                        CHECK(needs.lit);
                        CHECK(needs.ao == ao_on);
                        CHECK(needs.blur == ao_on);
                    }
                }
            }
        }
    }
}

TEST_CASE("needs: without a reader of normals there are none") {
    const Scene scene = still_life();
    const AoWork depth_only{.reads_normals = false};
    CHECK(!needs_of(scene, {"ao_raw"}, depth_only, false).normals);
    CHECK(needs_of(scene, {"ao_raw"}, {}, false).normals);
    CHECK(needs_of(scene, {"ao_raw", "normal"}, depth_only, false).normals);
    CHECK(needs_of(scene, {"lit"}, depth_only, false).normals);
    CHECK(needs_of(scene, {"ao_raw"}, depth_only, true).normals);
}
