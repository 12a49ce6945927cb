// passes.json is as its schema has it, for every method and every preset; and the schema of limits.json takes what
// `crevice compare` takes.
#include <fstream>
#include <iostream>

#include <doctest/doctest.h>

#include "chapters/commands/render.h"
#include "chapters/compare/compare_limits.h"
#include "chapters/frame/presets.h"
#include "rasterizer/base/error.h"
#include "tests/tools/schema_checks.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;
using nlohmann::json;

namespace {

SchemaChecks schema_named(const std::string& name) {
    std::ifstream stream(CREVICE_SCHEMA_DIR "/" + name);
    return SchemaChecks(json::parse(stream));
}

// passes.json of a small frame.
json passes_of(const std::string& scene, const std::string& method, const std::vector<std::string>& params,
               const CameraFlags& camera = {}) {
    const ScratchDirectory scratch;
    RenderOptions options;
    options.scene = scene;
    options.camera = camera;
    options.params = params;
    options.request.size = {32, 18};
    options.request.method = &find_method(method);
    if (options.request.method->bent_normals) options.request.wanted.insert(kBentNormal);
    const PreparedRender prepared = prepared_render(options);
    write_frame(options, prepared, scratch.path(),
                render_frame(prepared.argument.scene, prepared.camera, prepared.request));
    std::ifstream stream(scratch / "passes.json");
    return json::parse(stream);
}

}  // namespace

TEST_CASE("passes schema: every method's passes.json is as the schema has it") {
    const SchemaChecks schema = schema_named("passes.schema.json");
    for (const Method& method : ao_methods()) {
        CAPTURE(std::string(method.name));
        const json told = passes_of("wall_corner", method.name, {});
        CHECK(schema.against(told) == "");
        CHECK(told["buffers"].size() >= 6);
        CHECK(told["samples"].is_object() == (method.offsets != nullptr));
        CHECK(told["seed"].is_null() == !value_of(method, defaults_of(method), "seed"));
    }
    CameraFlags ortho;
    ortho.ortho = "4";
    const json reversed = passes_of("wall_corner", "xjun", {"depth_format=d32f_reversed"}, ortho);
    CHECK(schema.against(reversed) == "");
    CHECK(reversed["depth"]["near"] == 1);
    CHECK(reversed["camera"]["projection"] == "orthographic");
}

TEST_CASE("passes schema: every preset's passes.json is as the schema has it") {
    const SchemaChecks schema = schema_named("passes.schema.json");
    for (const Preset& preset : presets()) {
        CAPTURE(std::string(preset.name));
        CHECK(schema.against(passes_of(preset.scene, preset.method, preset.words)) == "");
    }
}

TEST_CASE("passes schema: what it must refuse it does refuse") {
    const SchemaChecks schema = schema_named("passes.schema.json");
    const json whole = passes_of("wall_corner", "xjun", {});
    const auto spoilt = [&](const char* place, const json& by) {
        json document = whole;
        document[json::json_pointer(place)] = by;
        return schema.against(document);
    };
    CHECK(spoilt("/camera/eye", json::array({1, 2})) == "/camera/eye: holds 2 items");
    CHECK(spoilt("/matrices/view/0/0", "1") == "/matrices/view/0/0: \"1\" is no \"number\"");
    CHECK(spoilt("/buffers/lit/space", "srgb").starts_with("/buffers/lit/space: \"srgb\" is none of"));
    CHECK(spoilt("/buffers/ao_raw/nan", -1) == "/buffers/ao_raw/nan: -1 is out of range");
    CHECK(spoilt("/more", 1) == "/more: not in the schema");
    json document = whole;
    document.erase("seed");
    CHECK(schema.against(document) == ": has no \"seed\"");
}

TEST_CASE("limits schema: it takes what compare takes, and nothing else") {
    const SchemaChecks schema = schema_named("limits.schema.json");
    const auto compare_takes = [](const json& document) {
        try {
            limits_from_text(document.dump(), "limits.json", {});
            return true;
        } catch (const InputError&) {
            return false;
        }
    };
    const std::pair<const char*, bool> documents[] = {
        {R"({})", true},
        {R"({"limits": {}, "default": {}})", true},
        {R"({"limits": {"ao_raw": {"max_abs": 1e-6}, "lit": {"flip": 0.02, "max_pixels": 40}},
             "default": {"rmse": 0.001, "ssim": -1}})",
         true},
        {R"([])", false},
        {R"({"limit": {}})", false},
        {R"({"limits": []})", false},
        {R"({"default": 3})", false},
        {R"({"default": {"rmse": -1}})", false},
        {R"({"default": {"rmse": "0.1"}})", false},
        {R"({"default": {"flip": 1.5}})", false},
        {R"({"default": {"ssim": -1.5}})", false},
        {R"({"default": {"max_pixels": 1.5}})", false},
        {R"({"default": {"max_pixels": -1}})", false},
        {R"({"default": {"mse": 1}})", false},
        {R"({"limits": {"lit": {"psnr": 30}}})", false},
    };
    for (const auto& [text, good] : documents) {
        CAPTURE(std::string(text));
        const json document = json::parse(text);
        CHECK((schema.against(document) == "") == good);
        CHECK(compare_takes(document) == good);
    }
}
