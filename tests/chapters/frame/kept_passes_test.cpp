// What a frame takes over from the one before it: the passes whose inputs are the same, and every bit.
#include "chapters/frame/kept_passes.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <utility>

#include <doctest/doctest.h>

#include "chapters/frame/parameter_words.h"
#include "chapters/frame/worked_frame.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/light/scene_shadow.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

using Names = std::set<std::string>;

// With a shadow, a sky and mirrors.
Scene full_scene() {
    Scene scene = still_life();
    scene.shadow = &kBoundsSceneShadow;
    scene.lights[0].direction = glm::vec3(0.48f, -0.64f, 0.6f);
    scene.lights[0].specular = glm::vec3(0.3f);
    scene.light_spin_rad_per_s = 1;
    scene.sky_cube = std::make_shared<const CubeMap>(
        build_cube_map(8, [](glm::vec3 direction) { return 0.5f * direction + 0.5f; }));
    scene.materials.push_back(scene.materials.front());
    scene.meshes.back().parts.front().material = 1;
    scene.materials.back().diffuse = glm::vec3(0.2f, 0.5f, 0.1f);
    return scene;
}

FrameRequest request_for(const char* method, Size size) {
    FrameRequest request;
    request.size = size;
    request.method = &find_method(method);
    request.settings = settings_of(*request.method);
    request.run.threads = 1;
    return request;
}

// All that can be seen of a frame, but what is told of the passes that ran: their times and what they left out.
std::string shown_by(const Frame& frame) {
    std::string all;
    const auto add = [&](const std::string& text) { all += text + "\n"; };
    add("normal " + content_hash(frame.gbuffer.normal));
    add("view_depth " + content_hash(frame.gbuffer.view_depth));
    add("ndc_depth " + content_hash(ndc_depth(frame.gbuffer.depth)));
    add("ao_raw " + content_hash(frame.ao_raw));
    add("ao_blurred " + content_hash(frame.ao_blurred));
    add("bent_normal " + content_hash(frame.bent_normal));
    add("lit " + content_hash(frame.lit));
    add("history " + content_hash(frame.history.ao));
    for (const LeftOut& item : frame.left_out) add(item.what + ": " + item.why);
    for (const PrecisionLoss& loss : frame.precision)
        add(loss.name + (" " + std::to_string(loss.count)) + loss.warning);
    return all;
}

std::string told_of(const SkippedWork& work) {
    return skip_name(work.skip) + (" " + std::to_string(work.count)) + " of " + std::to_string(work.of);
}

Names unchanged(const WorkedFrame& worked) { return {worked.unchanged.begin(), worked.unchanged.end()}; }

// What each kind of work is left out by.
Names passes_of(Skip skip) {
    switch (skip) {
        case Skip::background_pixels: return {"ao"};
        case Skip::open_tiles: return {"ao", "blur"};
        case Skip::second_drawing: return {"lit"};
        default: return {"normal_depth"};
    }
}

// Passes that were kept count nothing, and those that ran what they count in a frame drawn from scratch.
void check_skipped(const WorkedFrame& worked, const Frame& fresh) {
    REQUIRE(worked.frame.skipped.size() == fresh.skipped.size());
    for (std::size_t i = 0; i < fresh.skipped.size(); ++i) {
        const SkippedWork& work = worked.frame.skipped[i];
        const Names passes = passes_of(work.skip);
        const auto kept = std::count_if(passes.begin(), passes.end(), [&](const std::string& pass) {
            return unchanged(worked).contains(pass);
        });
        CAPTURE(told_of(work));
        if (kept == 0) {
            CHECK(told_of(work) == told_of(fresh.skipped[i]));
        } else if (kept == static_cast<std::ptrdiff_t>(passes.size())) {
            CHECK(work.count == 0);
            CHECK(work.of == 0);
        } else {
            // The AO map was kept, and its blur ran.
            CHECK(work.count == fresh.tiles.blur.count(TileWork::open));
            CHECK(work.of == fresh.tiles.blur.count());
        }
    }
}

// A scene, its camera and what is asked for, in which one thing after the other changes.
struct Walk {
    Scene scene = full_scene();
    Camera camera = scene.camera;
    FrameRequest request = request_for("xjun", {40, 24});
    RandomSequence random;

    explicit Walk(std::uint64_t seed) : random(seed) {}

    void use_method() {
        constexpr const char* kMethods[] = {"xjun", "luna", "gtao", "crevice",  "hemisphere",
                                            "sao",  "none", "hbao", "ray_cast", "vertex_bake"};
        request.method = &find_method(kMethods[random.whole(0, 9)]);
        request.settings.method = defaults_of(*request.method);
        request.wanted.erase(kBentNormal);
        if (request.method->bent_normals) request.wanted.insert(kBentNormal);
    }

    // One of its values, or near the one it has; left as it is where that would be out of range.
    void set_parameter() {
        const auto parameters = frame_parameters(*request.method);
        const auto& p =
            parameters[static_cast<std::size_t>(random.whole(0, static_cast<int>(parameters.size()) - 1))];
        FrameSettings settings = request.settings;
        if (p.kind == ParameterKind::number) {
            p.set(settings, p.name == "ao_scale" ? (random.whole(0, 1) == 1 ? 1 : 0.5)
                                                 : p.get(settings) * (random.whole(0, 1) == 1 ? 2 : 0.5));
        } else if (p.kind == ParameterKind::choice) {
            p.set(settings, random.whole(0, static_cast<int>(p.choices.size()) - 1));
        } else {
            constexpr long long kFew = 12;
            const auto highest = static_cast<int>(std::min(p.highest, std::max(0LL, p.lowest) + kFew));
            p.set(settings, random.whole(static_cast<int>(std::max(p.lowest, -kFew)), highest));
        }
        try {
            validate(*request.method, settings.method);
            validate(settings.history);
            request.settings = settings;
        } catch (const UsageError&) {
        }
    }

    void ask_for_buffers() {
        request.wanted.clear();
        for (const char* name : kBufferNames) {
            if (random.whole(0, 2) > 0) request.wanted.insert(name);
        }
        if (request.method->bent_normals) request.wanted.insert(kBentNormal);
    }

    Size map_size() const {
        const std::optional<double> scale = value_of(*request.method, request.settings.method, "ao_scale");
        return ao_map_size(request.size, static_cast<float>(scale.value_or(1)));
    }

    void change_one_thing() {
        switch (random.whole(0, 12)) {
            case 0: camera.eye = {0.5 * random.whole(0, 1), 0.25, -0.5 * random.whole(0, 1)}; break;
            case 1: use_method(); break;
            case 2: scene.lights = lights_at(full_scene(), random.whole(0, 2)); break;
            case 3: request.size = {random.whole(0, 1) == 1 ? 40 : 33, 24}; break;
            case 4: ask_for_buffers(); break;
            case 5:
                request.run.kept = random.whole(0, 2) > 0
                                       ? KeptWork()
                                       : KeptWork::only(static_cast<Skip>(random.whole(0, kSkipCount - 1)));
                break;
            case 6: request.run.tile_size = 16 << random.whole(0, 1); break;
            case 7: scene.ambient_light = glm::vec3(0.25f * static_cast<float>(random.whole(1, 2))); break;
            case 8:
                scene.point_light.reset();
                if (random.whole(0, 3) == 0) scene.point_light.emplace();
                break;
            case 9:
                request.settings.ao_lookup = random.whole(0, 1) == 1 ? AoLookup::joint : AoLookup::exact;
                break;
            case 10: break;  // nothing
            default: set_parameter(); break;
        }
    }
};

}  // namespace

TEST_CASE("kept passes: whatever changes from frame to frame, each has the bits of one drawn from scratch") {
    Names ever_kept;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        Walk walk(seed);
        WorkedFrame worked;
        AoHistory last;
        for (int step = 0; step < 100; ++step) {
            walk.change_one_thing();
            if (walk.random.whole(0, 2) == 0 || last.ao.size != walk.map_size()) last = {};
            CAPTURE(seed);
            CAPTURE(step);
            CAPTURE(std::string(walk.request.method->name));
            worked = worked_frame(walk.scene, walk.camera, walk.request, last, std::move(worked));
            for (const std::string& pass : worked.unchanged) ever_kept.insert(pass);
            show(worked, walk.request);
            const Frame fresh = render_frame(walk.scene, walk.camera, walk.request, last);
            REQUIRE(shown_by(worked.frame) == shown_by(fresh));
            check_skipped(worked, fresh);
            last = worked.frame.history;
        }
    }
    // Each could be taken over at some step.
    for (const char* pass : {"ray_scene", "bake", "normal_depth", "ao", "blur", "bent_normal", "ao_lookup",
                             "shadow", "lit", "sky"}) {
        INFO("pass " << std::string(pass));
        CHECK(ever_kept.contains(pass));
    }
}

TEST_CASE("kept passes: what reads a change is computed again, and what comes before it is not") {
    using Change = std::function<void(Scene&, Camera&, FrameRequest&)>;
    const auto set = [](const char* name, double value) -> Change {
        return [=](Scene&, Camera&, FrameRequest& request) {
            request.settings.method = with_value(*request.method, request.settings.method, name, value);
        };
    };
    const Names all = {"normal_depth", "ao", "blur", "shadow", "lit", "sky"};
    const std::pair<Change, Names> cases[] = {
        {[](Scene&, Camera&, FrameRequest&) {}, all},
        {set("blur_iterations", 2), {"normal_depth", "ao", "shadow", "sky"}},
        {set("radius", 0.75), {"normal_depth", "shadow", "sky"}},
        {[](Scene&, Camera&, FrameRequest& r) {
             r.method = &find_method("luna"), r.settings = settings_of(*r.method);
         },
         {"normal_depth", "shadow", "sky"}},
        {[](Scene& s, Camera&, FrameRequest&) { s.lights = lights_at(s, 1); },
         {"normal_depth", "ao", "blur", "sky"}},
        {[](Scene& s, Camera&, FrameRequest&) { s.lights[1].diffuse.x += 0.1f; },
         {"normal_depth", "ao", "blur", "shadow", "sky"}},
        {[](Scene&, Camera& c, FrameRequest&) { c.eye.x += 0.1; }, {"shadow"}},
        {[](Scene&, Camera&, FrameRequest& r) { r.size.width += 1; }, {"shadow"}},
        {[](Scene&, Camera&, FrameRequest& r) { r.settings.buffers.depth_format = DepthFormat::d24; },
         {"shadow"}},
        {[](Scene&, Camera&, FrameRequest& r) { r.run.tile_size = 32; }, {"shadow"}},
        {[](Scene&, Camera&, FrameRequest& r) { r.run.threads = 2, r.run.lanes = 1; }, all},
        {[](Scene&, Camera&, FrameRequest& r) { r.run.kept = KeptWork::only(Skip::passes); }, {}},
    };
    std::size_t number = 0;
    for (const auto& [change, expected] : cases) {
        CAPTURE(number++);
        Scene scene = full_scene();
        Camera camera = scene.camera;
        FrameRequest request = request_for("xjun", {40, 24});
        WorkedFrame worked = worked_frame(scene, camera, request);
        CHECK(worked.unchanged.empty());
        change(scene, camera, request);
        worked = worked_frame(scene, camera, request, {}, std::move(worked));
        CHECK(unchanged(worked) == expected);
        // What was kept is not timed, and all else is.
        Names timed;
        for (const PassTime& pass : worked.frame.passes) timed.insert(pass.name);
        for (const std::string& pass : all) CHECK(timed.contains(pass) != expected.contains(pass));
    }
}

TEST_CASE(
    "kept passes: a frame of which every pass was kept left out those passes, and counts nothing beside") {
    const Scene scene = full_scene();
    const FrameRequest request = request_for("xjun", {40, 24});
    WorkedFrame worked = worked_frame(scene, scene.camera, request);
    const auto counted = [&] {
        std::size_t total = 0;
        for (const SkippedWork& work : worked.frame.skipped) total += work.of;
        return total;
    };
    CHECK(counted() > 0);
    const std::size_t tiles = worked.frame.tiles.raster.count();
    worked = worked_frame(scene, scene.camera, request, {}, std::move(worked));
    CHECK(worked.frame.skipped.size() == kSkipCount - 2);
    CHECK(counted() == 0);
    // What its pictures are made of can still be shown.
    CHECK(worked.frame.tiles.raster.count() == tiles);
}

TEST_CASE(
    "kept passes: vertices too far are counted once for a length, and the count is that of a frame from "
    "scratch") {
    Scene scene = full_scene();
    const float away = 0x1p18f;  // where a step is 1/64
    for (Mesh& mesh : scene.meshes) {
        for (glm::vec3& p : mesh.positions) p.x += away;
    }
    Camera camera = scene.camera;
    camera.eye.x += static_cast<double>(away), camera.target.x += static_cast<double>(away);
    FrameRequest request = request_for("xjun", {40, 24});
    const auto with_epsilon = [&](double epsilon) {
        request.settings.method = with_value(*request.method, request.settings.method, "epsilon", epsilon);
    };
    const auto far_of = [](const Frame& frame) {
        const auto far = std::find_if(
            frame.precision.begin(), frame.precision.end(),
            [](const PrecisionLoss& loss) { return loss.name == std::string("vertices_far_from_origin"); });
        REQUIRE(far != frame.precision.end());
        return far->count;
    };
    WorkedFrame worked;
    std::set<std::size_t> counts;
    for (const double epsilon : {0x1p-10, 0x1p-10, 0x1p-4, 0x1p-10}) {
        with_epsilon(epsilon);
        camera.eye.y += 0.125;
        worked = worked_frame(scene, camera, request, {}, std::move(worked));
        CHECK(worked.far_vertices.length == epsilon);
        CHECK(worked.far_vertices.count == far_of(worked.frame));
        CHECK(far_of(worked.frame) == far_of(render_frame(scene, camera, request)));
        counts.insert(far_of(worked.frame));
    }
    CHECK(counts.size() == 2);
    // A method without a tolerance, and one without AO, leave it as it is.
    request.method = &find_method("none");
    request.settings = settings_of(*request.method);
    worked = worked_frame(scene, camera, request, {}, std::move(worked));
    CHECK(worked.far_vertices.length == 0x1p-10);
}
