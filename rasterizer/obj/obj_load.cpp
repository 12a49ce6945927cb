#include "rasterizer/obj/obj_load.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <span>
#include <system_error>
#include <utility>

#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/memory.h"
#include "rasterizer/obj/alike_warnings.h"
#include "rasterizer/obj/ear_clip.h"
#include "rasterizer/obj/mtl_texture.h"
#include "rasterizer/obj/obj_materials.h"
#include "rasterizer/obj/obj_mesh.h"
#include "rasterizer/obj/obj_text.h"
#include "rasterizer/obj/obj_triangles.h"
#include "rasterizer/obj/text_encoding.h"
#include "rasterizer/obj/text_pieces.h"

namespace crevice {
namespace {

// What a tally counts, what is wrong with it, and what was done about it.
struct Finding {
    Tally tally;
    std::string kind, what, done;
};

std::string warning_of(const std::string& path, const Finding& finding) {
    const std::size_t count = finding.tally.count;
    return path + ":" + std::to_string(finding.tally.first_line) + ": " + finding.what + " (" +
           std::to_string(count) + " " + finding.kind + (count == 1 ? "" : "s, the first here") + "); " +
           finding.done;
}

// Sharp edges at every hundredth face or more: scans and curved models have fewer.
bool is_worth_telling(const Tally& smoothed_faces, std::size_t faces_in_file) {
    return 100 * smoothed_faces.count >= faces_in_file;
}

std::vector<std::string> warnings_of(const ObjReport& report, const std::string& path,
                                     std::size_t faces_in_file) {
    const std::string too_many = "more than " + std::to_string(kMaxFaceCorners) + " corners";
    std::vector<Finding> findings = {
        {report.too_few_corners, "face", "fewer than three corners", "dropped"},
        {report.too_many_corners, "face", too_many, "dropped"},
        {report.missing_vertices, "face", "a vertex index that the file has no vertex for", "dropped"},
        {report.not_finite, "face", "a vertex that is not a finite number", "dropped"},
        {report.zero_area, "face", "all corners on one line", "dropped"},
        {report.self_intersecting, "face", "the outline crosses itself", "triangulated all the same"},
        {report.reversed, "face", "wound against its own normals", "turned round"},
        {report.replaced_normals, "corner", "a normal that is zero or not finite", "the face's normal used"},
        {report.missing_normals, "corner", "a normal index that the file has no normal for", "one generated"},
        {report.missing_texcoords, "corner", "a texture index without a finite coordinate", "(0, 0) used"},
        {report.far_texcoords, "corner",
         "a texture coordinate beyond " + shortest_text(kMostTextureCopies) +
             ", where floats lose their place in the texture",
         "subtract whole numbers from those of a part, drawn as they are"},
        {is_worth_telling(report.smoothed_faces, faces_in_file) ? report.smoothed_faces : Tally(), "face",
         "without `vn` and `s` normals are smoothed, here across sharp edges",
         "--crease 30 keeps those sharp, 0 makes every face flat"},
        {report.absent_texcoords, "face", "a textured material without texture coordinates", "(0, 0) used"},
    };
    for (const IgnoredStatement& ignored : report.ignored_statements) {
        findings.push_back({ignored.lines, "line", "`" + ignored.keyword + "` is not drawn here", "ignored"});
    }
    std::vector<std::string> warnings;
    for (const Finding& finding : findings) {
        if (finding.tally.count > 0) warnings.push_back(warning_of(path, finding));
    }
    if (report.dropped_faces == faces_in_file) {
        warnings.push_back(path + ": there is nothing to draw (" + std::to_string(faces_in_file) +
                           (faces_in_file == 1 ? " face in the file, which is not usable)"
                                               : " faces in the file, none of them usable)") +
                           "; the scene is empty");
    }
    return warnings;
}

bool is_textured(const Material& material) {
    return material.texture != nullptr || material.normal_map != nullptr;
}

// Faces whose material shows a picture, and that do not say which part of it.
Tally faces_without_texcoords(const ObjText& text, const ObjMaterials& materials) {
    Tally tally;
    for (const ObjFace& face : text.faces.faces) {
        if (face.material < 0) continue;
        const int material = materials.of_use[static_cast<std::size_t>(face.material)];
        if (!is_textured(materials.materials[static_cast<std::size_t>(material)])) continue;
        const auto corners = std::span(text.faces.corners).subspan(face.first_corner, face.corner_count);
        const bool absent = std::any_of(corners.begin(), corners.end(),
                                        [](const ObjCorner& c) { return c.texcoord == kAbsentIndex; });
        if (absent) tally.add(face.line);
    }
    return tally;
}

glm::vec3 unit(glm::dvec3 v) { return glm::vec3(v / std::sqrt(glm::dot(v, v))); }

// The lights of Luna's scene.
void add_light(Scene& scene) {
    scene.lighting = LightingModel::blinn_schlick;
    scene.ambient_light = {0.4f, 0.4f, 0.6f};
    scene.lights[0].direction = unit({1, -1, 1});
    scene.lights[0].diffuse = {0.4f, 0.4f, 0.5f};
    scene.lights[1].direction = unit({-1, -1, 1});
    scene.lights[1].diffuse = glm::vec3(0.1f);
    scene.lights[2].direction = unit({0, -1, -1});
    scene.lights[2].diffuse = glm::vec3(0);
}

// Makes of the default material one that adds nothing to vertex colours: white, without highlights.
void show_vertex_colours_alone(Material& material) {
    material.diffuse = material.ambient = glm::vec3(1);
    material.specular = glm::vec3(0);
}

// Notes the time since the last step ended.
class StepTimer {
 public:
    explicit StepTimer(std::vector<LoadStep>& steps) : steps_(steps) {}
    void finish(const char* name) {
        const Clock::time_point now = Clock::now();
        steps_.push_back({name, std::chrono::duration<double, std::milli>(now - started_).count()});
        started_ = now;
    }

 private:
    using Clock = std::chrono::steady_clock;
    std::vector<LoadStep>& steps_;
    Clock::time_point started_ = Clock::now();
};

// Text, indices, triangles and mesh of a file take at least this many bytes for each of its own.
constexpr std::uintmax_t kMemoryPerByte = 8;

void check_memory(const std::filesystem::path& path) {
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (error || bytes > kMaxObjBytes || bytes <= memory_bytes() / kMemoryPerByte) return;
    throw InputError(path.string() + ": the file is too large for this machine's memory (" +
                     std::to_string(bytes) + " bytes need " + std::to_string(kMemoryPerByte) +
                     " times as many, " + std::to_string(memory_bytes()) +
                     " are there); split or simplify it");
}

// As `s off` before the first face does.
void shade_flat(ObjFaces& faces) {
    for (ObjFace& face : faces.faces) face.smoothing = kFlatShaded;
}

ObjText read_text(std::string_view bytes, const std::string& name, const ObjOptions& options,
                  const Run& run) {
    const std::vector<TextPiece> pieces = text_pieces(bytes, options.piece_bytes, run);
    ObjText text = read_obj_text(pieces, name, run);
    text.vertices.recentre(pieces, name, text.faces, text.report.warnings, run);
    return text;
}

LoadedObj loaded_from(const std::filesystem::path& path, const ObjOptions& options, const Run& run) {
    const std::string name = path.string();
    LoadedObj loaded;
    StepTimer timer(loaded.steps);
    check_memory(path);
    std::string bytes = read_file(path, kMaxObjBytes);
    if (bytes.empty()) throw InputError(name + ": the file is empty; give an OBJ with vertices and faces");
    bytes = utf8_text(std::move(bytes), name);
    timer.finish("read the file");
    ObjText text = read_text(bytes, name, options, run);
    bytes = {};
    if (options.crease_angle_rad == 0) shade_flat(text.faces);
    timer.finish("numbers and faces");
    ObjTriangles triangles = triangulate_obj(text, run);
    timer.finish("triangles");
    ObjMaterials materials =
        load_obj_materials(path, text.libraries, text.materials,
                           {.surfaces = options.want_textures, .outside = options.outside_files, .run = run});
    if (!text.vertices.colours.empty()) show_vertex_colours_alone(materials.materials.back());
    timer.finish("materials and textures");
    const auto any = [&](const auto& has) {
        return std::any_of(materials.materials.begin(), materials.materials.end(), has);
    };
    const bool normal_maps = any([](const Material& m) { return m.normal_map != nullptr; });
    const bool textured = any(is_textured);
    ObjMesh built = build_obj_mesh(text, triangles, {materials.of_use, materials.texcoord_maps, normal_maps},
                                   options.want_unused_texcoords || textured, options.crease_angle_rad, run);
    timer.finish("vertices and normals");

    ObjReport& report = loaded.report = std::move(text.report);
    report.add_tallies(triangles.report);
    if (textured) {
        report.absent_texcoords = faces_without_texcoords(text, materials);
    } else {
        report.far_texcoords = {};
    }
    report.generated_normals = built.generated_normals;
    report.smoothed_faces = built.smoothed_faces;
    const std::size_t skipped = report.too_few_corners.count + report.too_many_corners.count;
    report.dropped_faces =
        skipped + report.missing_vertices.count + report.not_finite.count + report.zero_area.count;
    const std::vector<std::string> found = warnings_of(report, name, skipped + text.faces.faces.size());
    report.warnings.insert(report.warnings.end(), found.begin(), found.end());
    report.warnings.insert(report.warnings.end(), materials.warnings.begin(), materials.warnings.end());
    report.warnings = few_of_each_kind(report.warnings);

    Scene& scene = loaded.scene;
    scene.name = path.stem().string();
    scene.meshes.push_back(std::move(built.mesh));
    scene.instances.push_back({});
    scene.materials = std::move(materials.materials);
    scene.two_sided = true;
    scene.origin = {text.vertices.origin.x, text.vertices.origin.y, -text.vertices.origin.z};
    add_light(scene);
    const Bounds bounds = world_bounds(scene);
    scene.camera = framing_camera(scene);
    scene.length_unit = length_unit_of(bounds);
    return loaded;
}

}  // namespace

LoadedObj load_obj(const std::filesystem::path& path, const ObjOptions& options, const Run& run) {
    try {
        return loaded_from(path, options, run);
    } catch (const std::bad_alloc&) {
        throw InputError(path.string() + ": there is not enough memory for the scene; give a smaller one");
    }
}

}  // namespace crevice
