// What a frame takes over from the one before it: every pass that reads nothing but what that one read, too. What it
// found is the same then, to the last bit (tests/chapters/frame/kept_passes_test.cpp).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "chapters/frame/frame_settings.h"
#include "rasterizer/scene/scene.h"
#include "ssao/needs.h"

namespace crevice {

// All that a frame is made of, but for the shapes, materials and textures of its scene, in the groups that passes read.
struct FrameInputs {
    struct View {  // of the first pass, and so of all
        Camera camera;
        Size size;
        NormalDepthSettings buffers;  // with_material and all
        bool with_normals = true;
        int tile_size = 0;
        KeptWork kept;
        bool operator==(const View&) const = default;
    };
    struct Map {
        const Method* method = nullptr;
        std::vector<double> settings;  // by the method's parameters
        bool has_history = false;
        bool operator==(const Map&) const = default;
    };
    struct Light {
        std::array<DirectionalLight, 3> lights;
        std::optional<PointLight> point_light;
        glm::vec3 ambient_light = glm::vec3(0), sky = glm::vec3(0);
        LightingModel lighting = LightingModel::blinn_schlick;
        ShadeSettings drawing;
        AmbientSettings ambient;
        LightSpace space = LightSpace::view;
        bool operator==(const Light&) const = default;
    };

    View view;
    Map map;
    std::vector<double> denoiser;  // by its parameters
    AoLookup lookup = AoLookup::exact;
    Light light;
    std::shared_ptr<const CubeMap> sky_cube;
    const SceneShadow* shadow = nullptr;
    Needs needs;  // the passes that run of these
};

// Passes by what they make. False as well where a frame has no use for one.
struct KeptPasses {
    bool normal_depth = false, ao = false, blur = false, bent_normals = false, ao_lookup = false,
         shadow = false, lit = false;
    bool sky = false;  // of a picture that is lit anew
    bool bake = false;
    bool precision = false;  // the account of it
};

// Whether its AO map is brought to the picture's size before the light reads it.
bool looks_up(const FrameInputs& inputs);

// `before` are the inputs of another frame of the same scene, its lights aside.
KeptPasses kept_passes(const FrameInputs& before, const FrameInputs& now);

// Of each of them, why it need not run.
inline constexpr const char* kWhyUnchanged = "all that it reads is as it was in the frame before";

// Their names, as passes are timed by.
std::vector<std::string> names_of(const KeptPasses& kept, const Needs& needs);

}  // namespace crevice
