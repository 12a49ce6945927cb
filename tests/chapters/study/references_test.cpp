#include "chapters/study/references.h"

#include <cmath>
#include <fstream>
#include <memory>

#include <doctest/doctest.h>
#include <iostream>
#include <sstream>
#include <vector>

#include "chapters/study/reference_cache.h"
#include "rasterizer/base/image_io.h"
#include "tests/tools/scratch_directory.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/still_life.h"
#include "tests/tools/tutorial_settings.h"

using namespace crevice;

namespace {

ReferenceRequest request_of(const char* method = "xjun") {
    ReferenceRequest request;
    request.size = {40, 24};
    request.method = &find_method(method);
    request.settings = defaults_of(*request.method);
    request.rays.rays = 16;
    request.rays.radius = ao_of(request.settings).radius;
    request.limit_seeds = 8;
    return request;
}

bool same(const ReferenceImage& a, const ReferenceImage& b) {
    return content_hash(a.mean) == content_hash(b.mean) && content_hash(a.error) == content_hash(b.error) &&
           content_hash(a.half[0]) == content_hash(b.half[0]) &&
           content_hash(a.half[1]) == content_hash(b.half[1]);
}

std::size_t files_in(const std::filesystem::path& directory) {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(directory)) ++count;
    return count;
}

}  // namespace

TEST_CASE("references: the bits that were stored are found, and only for the same question") {
    const Scene scene = still_life();
    const ScratchDirectory scratch;
    ReferenceRequest request = request_of();
    const References fresh = make_references(scene, scene.camera, request);
    CHECK(scratch.empty());
    request.cache = scratch.path();
    const References stored = make_references(scene, scene.camera, request);
    CHECK(!stored.hard.from_cache);
    const References found = make_references(scene, scene.camera, request);
    const Reference References::*const all[] = {&References::hard, &References::soft, &References::screen,
                                                &References::limit};
    for (const auto reference : all) {
        CHECK((found.*reference).from_cache);
        CHECK(same((found.*reference).image, (fresh.*reference).image));
        CHECK((found.*reference).mean == (fresh.*reference).mean);
        CHECK((found.*reference).mean_error == (fresh.*reference).mean_error);
    }
    const auto asks_anew = [&](ReferenceRequest changed, const Scene& of, const Camera& camera) {
        changed.cache = scratch.path();
        const References again = make_references(of, camera, changed);
        return !again.hard.from_cache && !again.screen.from_cache;
    };
    ReferenceRequest changed = request;
    changed.rays.radius = 0.75f;
    CHECK(asks_anew(changed, scene, scene.camera));
    changed = request;
    changed.rays.rays = 24;
    CHECK(asks_anew(changed, scene, scene.camera));
    changed = request;
    changed.rays.weight = RayWeight::uniform;
    CHECK(asks_anew(changed, scene, scene.camera));
    changed = request;
    changed.rays.seed = 2;
    CHECK(asks_anew(changed, scene, scene.camera));
    changed = request;
    ao_of(changed.settings).fade_end = 1.5f;
    CHECK(asks_anew(changed, scene, scene.camera));
    Camera camera = scene.camera;
    camera.eye.x += 0.25;
    CHECK(asks_anew(request, scene, camera));
    Scene moved = scene;
    moved.meshes[2].positions[0].y += 0.125f;
    CHECK(asks_anew(request, moved, scene.camera));
    // Only the limit knows of epsilon.
    changed = request;
    ao_of(changed.settings).epsilon = 0.125f;
    const References other = make_references(scene, scene.camera, changed);
    CHECK(other.soft.from_cache);
    CHECK(!other.limit.from_cache);
}

// A wall, and before it a card that only rays meet, because the near plane cuts it off; its alpha is `alpha` everywhere.
Scene wall_behind_card(float alpha) {
    Mesh card = facing_quad({0, 0, 3.5f}, 4);
    card.parts[0].material = 1;
    Scene scene = scene_of({card, facing_quad({0, 0, 4}, 20)});
    scene.camera.near_plane = 3.8;
    scene.materials.emplace_back();
    scene.materials[1].alpha_cutoff = 0.5f;
    scene.materials[1].texture = std::make_shared<Texture>(
        build_texture(Image3({2, 2}, glm::vec3(0.5f)), Image<float>({2, 2}, alpha)));
    return scene;
}

TEST_CASE("references: another hole is another scene to rays, though the picture shows the same") {
    const ScratchDirectory scratch;
    ReferenceRequest request = request_of();
    request.method = &find_method("ray_cast");
    request.settings = defaults_of(*request.method);
    request.rays.radius = 1;
    request.cache = scratch.path();
    for (const float alpha : {1.0f, 0.0f}) {
        CAPTURE(alpha);
        const Scene scene = wall_behind_card(alpha);
        const References made = make_references(scene, scene.camera, request);
        CHECK(!made.hard.from_cache);
        CHECK(!made.limit.from_cache);
        // Behind the card nearly every direction is closed; without it the wall is open.
        CHECK((alpha > 0 ? made.hard.mean < 0.4 : made.hard.mean == 1));
    }
}

TEST_CASE(
    "references: a damaged file in the cache is made anew; a cache that cannot be written is no failure") {
    const Scene scene = still_life();
    const ScratchDirectory scratch;
    ReferenceRequest request = request_of();
    request.cache = scratch / "cache";
    const References stored = make_references(scene, scene.camera, request);
    // hard, soft, hard and soft of the screen, limit; four images and a checksum each.
    CHECK(files_in(*request.cache) == 25);
    for (const auto& entry : std::filesystem::directory_iterator(*request.cache)) {
        const auto size = std::filesystem::file_size(entry.path());
        std::filesystem::resize_file(entry.path(), size - 5);
    }
    const References again = make_references(scene, scene.camera, request);
    CHECK(!again.hard.from_cache);
    CHECK(!again.limit.from_cache);
    CHECK(same(again.soft.image, stored.soft.image));
    CHECK(make_references(scene, scene.camera, request).soft.from_cache);

    std::ofstream(scratch / "file") << "in the way";
    request.cache = scratch / "file" / "cache";
    CHECK(same(make_references(scene, scene.camera, request).soft.image, stored.soft.image));
}

TEST_CASE("references: a bit that flips in the cache is found, said and mended") {
    const Scene scene = still_life();
    const ScratchDirectory scratch;
    ReferenceRequest request = request_of();
    request.cache = scratch.path();
    const References stored = make_references(scene, scene.camera, request);
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(scratch.path()))
        files.push_back(entry.path());
    for (const std::filesystem::path& file : files) {
        CAPTURE(file.string());
        // The last byte but three: of a float the lowest bits, of a checksum one of its digits.
        std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
        stream.seekg(-4, std::ios::end);
        const int byte = stream.get();
        stream.seekp(-4, std::ios::end);
        stream.put(static_cast<char>(byte ^ 1));
        stream.close();
        std::ostringstream said;
        std::streambuf* const before = std::cerr.rdbuf(said.rdbuf());
        const References again = make_references(scene, scene.camera, request);
        std::cerr.rdbuf(before);
        CHECK(said.str().find("this reference in the cache is damaged") != std::string::npos);
        CHECK(same(again.hard.image, stored.hard.image));
        CHECK(same(again.screen.image, stored.screen.image));
        CHECK(same(again.limit.image, stored.limit.image));
    }
    const References last = make_references(scene, scene.camera, request);
    CHECK((last.hard.from_cache && last.soft.from_cache && last.limit.from_cache));
}

TEST_CASE("references: rays are doubled until the error that was asked for") {
    const Scene scene = still_life();
    ReferenceRequest request = request_of();
    const References few = make_references(scene, scene.camera, request);
    request.wanted_error = few.hard.mean_error / 3;
    const References many = make_references(scene, scene.camera, request);
    CHECK(many.hard.mean_error <= request.wanted_error);
    CHECK(many.soft.mean_error <= request.wanted_error);
    CHECK(many.screen.mean_error <= request.wanted_error);
    CHECK(many.hard.rays > few.hard.rays);
    CHECK(many.hard.rays % 16 == 0);
    request.rays.rays = static_cast<int>(many.hard.rays / 2);
    request.wanted_error = 0;
    const References half = make_references(scene, scene.camera, request);
    CHECK(std::max(half.hard.mean_error, half.soft.mean_error) > few.hard.mean_error / 3);
}

TEST_CASE("references: what is said to be cast is what was cast, a multiple of the replicates") {
    const Scene scene = still_life();
    ReferenceRequest request = request_of();
    request.rays.rays = kReplicates;
    request.limit_seeds = kReplicates;
    const References whole = make_references(scene, scene.camera, request);
    request.rays.rays = 1;
    request.limit_seeds = kReplicates - 1;
    const References rounded = make_references(scene, scene.camera, request);
    CHECK(rounded.hard.rays == kReplicates);
    CHECK(rounded.limit.rays == kReplicates);
    CHECK(same(rounded.hard.image, whole.hard.image));
    CHECK(same(rounded.limit.image, whole.limit.image));
}

TEST_CASE("references: what they say of the mean is the mean of their pixels that show a surface") {
    const Scene scene = still_life();
    const References r = make_references(scene, scene.camera, request_of("luna"));
    double sum = 0, error = 0;
    for (const std::int32_t pixel : r.points.pixel) {
        sum += r.soft.image.mean.at(pixel % 40, pixel / 40);
        error += r.soft.image.error.at(pixel % 40, pixel / 40);
    }
    const double count = static_cast<double>(r.points.pixel.size());
    CHECK(r.soft.mean == doctest::Approx(sum / count));
    CHECK(r.soft.mean_error == doctest::Approx(error / count));
    // Softer occluders never close more.
    for (std::size_t i = 0; i < r.soft.image.mean.pixels.size(); ++i)
        CHECK(r.soft.image.mean.pixels[i] >= r.hard.image.mean.pixels[i]);
    CHECK(r.hard.mean < 0.99);
}

TEST_CASE("references of a scene without triangles: everything open, nothing uncertain") {
    Scene scene = scene_of({});
    ReferenceRequest request = request_of();
    const References r = make_references(scene, scene.camera, request);
    CHECK(r.points.points.empty());
    for (const Reference* reference : {&r.hard, &r.soft, &r.screen, &r.limit}) {
        CHECK(reference->mean == 1);
        CHECK(reference->mean_error == 0);
        for (const float a : reference->image.mean.pixels) CHECK(a == 1);
    }
}

TEST_CASE("content keys: every byte counts, in its place; images without the padding of their rows") {
    const auto hex = [](auto... values) {
        ContentKey key;
        (key.add(values), ...);
        return key.hex();
    };
    CHECK(hex('a') == "af63dc4c8601ec8c");  // FNV-1a's published test vectors
    CHECK(hex('f', 'o', 'o', 'b', 'a', 'r') == "85944171f73967e8");
    CHECK(hex(1, 2) != hex(2, 1));
    CHECK(hex(0.0f) != hex(-0.0f));
    Image<float> image({3, 2}, 1);
    ContentKey first, second;
    first.add_image(image);
    image.pixels[3] = 7;  // padding
    second.add_image(image);
    CHECK(first.hex() == second.hex());
}
