#include "chapters/frame/view_json.h"

#include <stdexcept>

#include "chapters/terminal/json_number.h"
#include "rasterizer/lanes/approx_math.h"
#include "ssao/needs.h"

namespace crevice {

using Json = nlohmann::ordered_json;

namespace {

// GLM keeps columns.
template <class Matrix>
Json rows_json(const Matrix& m) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row)
        rows.push_back(
            {json_number(m[0][row]), json_number(m[1][row]), json_number(m[2][row]), json_number(m[3][row])});
    return rows;
}

// In double, about the scene's own origin: floats would lose an eye that stands far from it.
glm::dmat4 view_from_own_world(const SceneArgument& argument, const Camera& camera, Size size) {
    glm::dmat4 view(camera_matrices(camera, size).view_from_relative);
    const glm::dvec4 eye(camera.eye + argument.scene.origin, 1);
    const glm::dvec4 moved = view * eye;
    view[3] = glm::dvec4(0.0 - moved.x, 0.0 - moved.y, 0.0 - moved.z, 1);
    return view;
}

constexpr const char* kUnitVectors = "unit vectors: x right, y up, z away from the eye";
constexpr const char* kAccessibility = "accessibility: 1 open, 0 closed";

}  // namespace

Json camera_json(const SceneArgument& argument, const Camera& camera) {
    const glm::dvec3 up =
        argument.from_obj ? glm::dvec3(camera.up.x, camera.up.y, 0.0 - camera.up.z) : camera.up;
    const bool ortho = camera.projection == Projection::orthographic;
    return {{"eye", json_numbers(own_coordinates(argument, camera.eye))},
            {"target", json_numbers(own_coordinates(argument, camera.target))},
            {"up", json_numbers(up)},
            {"projection", ortho ? "orthographic" : "perspective"},
            {"fov_y", camera.fov_y_rad * (180 / kPi)},
            {"ortho", ortho ? Json(camera.ortho_height) : Json()},
            {"near", camera.near_plane},
            {"far", camera.far_plane}};
}

Json matrices_json(const SceneArgument& argument, const Camera& camera, Size size) {
    return {
        {"convention",
         std::string("row by row, for column vectors: p_clip = projection * view * p_world; world and view "
                     "are left-handed, view looks along +z; ") +
             (argument.from_obj ? "world is the file's coordinates with z negated"
                                : "world is the scene's coordinates")},
        {"view", rows_json(view_from_own_world(argument, camera, size))},
        {"projection", rows_json(camera_matrices(camera, size).clip_from_view)}};
}

Json depth_json(const Camera& camera, Size size) {
    const CameraMatrices m = camera_matrices(camera, size);
    const bool perspective = camera.projection == Projection::perspective;
    return {{"near", camera.reversed_z ? 1 : 0},
            {"far", camera.reversed_z ? 0 : 1},
            {"convention", perspective ? "ndc_depth = a + b / view_depth" : "ndc_depth = a + b * view_depth"},
            {"a", json_number(m.depth_a)},
            {"b", json_number(m.depth_b)}};
}

Json convention_json(const std::string& buffer, const Camera& camera) {
    if (buffer == "normal" || buffer == kBentNormal)
        return {{"space", "view"}, {"values", kUnitVectors}, {"background", {0, 0, 0}}};
    if (buffer == "view_depth")
        return {{"space", "view"},
                {"values", "z, scene units, positive in front of the eye"},
                {"background", "inf"}};
    if (buffer == "ndc_depth")
        return {{"space", "ndc"},
                {"values", std::string("z / w in [0, 1], near at ") + (camera.reversed_z ? "1" : "0")},
                {"background", camera.reversed_z ? 0 : 1}};
    if (buffer == "ao_raw" || buffer == "ao_blurred")
        return {{"space", "picture"}, {"values", kAccessibility}, {"background", 1}};
    if (buffer == "lit")
        return {{"space", "linear"},
                {"values", "RGB proportional to light; the PNG holds it through the sRGB curve"},
                {"background", nullptr}};
    throw std::logic_error("no convention is known of the buffer " + buffer);
}

Json samples_json(const Method& method, const MethodSettings& settings) {
    if (!method.offsets) return nullptr;
    const SampleOffsets offsets = method.offsets(settings.ao);
    Json vectors = Json::array();
    for (const glm::vec3& v : offsets.vectors) vectors.push_back(json_numbers(v));
    return {{"space", offsets.space}, {"unit", "radius"}, {"offsets", vectors}};
}

}  // namespace crevice
