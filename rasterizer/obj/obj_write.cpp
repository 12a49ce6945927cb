#include "rasterizer/obj/obj_write.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

// Appends one line after the other.
struct WrittenObj {
    std::string text;

    void begin_line(const char* keyword) { text += keyword; }
    void end_line() { text += '\n'; }

    // One number of a line. `index` tells it from others when it is not finite, counted from 1 as in the
    // file.
    template <class Number>
    void add(const char* keyword, std::size_t index, Number value) {
        if (!std::isfinite(value))
            throw InputError("OBJ: `" + std::string(keyword) + "` " + std::to_string(index + 1) +
                             " holds a number that is not finite (" + shortest_text(value) +
                             "); leave its triangles out");
        text += ' ';
        text += shortest_text(value);
    }

    // "keyword 1 2 3"
    void add_values(const char* keyword, std::size_t index, std::initializer_list<float> values) {
        begin_line(keyword);
        for (const float value : values) add(keyword, index, value);
        end_line();
    }

    // "v x y z" or "v x y z r g b"
    void add_vertex(std::size_t index, const glm::vec3& p, const glm::dvec3& origin,
                    const glm::vec3* colour) {
        begin_line("v");
        for (int axis = 0; axis < 3; ++axis) {
            const double turned = axis == 2 ? -1 : 1;
            if (origin == glm::dvec3(0)) {
                add("v", index, static_cast<float>(turned) * p[axis]);
            } else {
                add("v", index, turned * (double{p[axis]} + origin[axis]));
            }
        }
        for (int i = 0; colour != nullptr && i < 3; ++i) add("v", index, (*colour)[i]);
        end_line();
    }

    // Position, texture coordinate and normal of one corner; they share their index.
    void add_corner(std::uint32_t vertex, bool with_texcoord, bool with_normal) {
        const std::string index = std::to_string(std::uint64_t{vertex} + 1);
        text += ' ';
        text += index;
        if (!with_texcoord && !with_normal) return;
        text += '/';
        if (with_texcoord) text += index;
        if (!with_normal) return;
        text += '/';
        text += index;
    }
};

void check_colours(const Mesh& mesh, std::size_t colours) {
    if (colours != 0 && colours != mesh.positions.size())
        throw InputError("OBJ: " + std::to_string(colours) + " colours for " +
                         std::to_string(mesh.positions.size()) + " vertices; give one a vertex");
}

void add_comment(WrittenObj& obj, std::string_view comment) {
    while (!comment.empty()) {
        const std::size_t end = std::min(comment.find('\n'), comment.size());
        obj.text += "# ";
        obj.text += comment.substr(0, end);
        obj.text += '\n';
        comment.remove_prefix(std::min(end + 1, comment.size()));
    }
}

}  // namespace

std::string obj_text(const Mesh& mesh, std::span<const glm::vec3> colours, std::string_view comment,
                     const glm::dvec3& origin) {
    check_colours(mesh, colours.size());
    WrittenObj obj;
    add_comment(obj, comment);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        obj.add_vertex(i, mesh.positions[i], origin, colours.empty() ? nullptr : &colours[i]);
    for (std::size_t i = 0; i < mesh.texcoords.size(); ++i)
        obj.add_values("vt", i, {mesh.texcoords[i].x, 1 - mesh.texcoords[i].y});
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
        obj.add_values("vn", i, {mesh.normals[i].x, mesh.normals[i].y, -mesh.normals[i].z});
    const bool with_texcoords = !mesh.texcoords.empty(), with_normals = !mesh.normals.empty();
    for (const auto& triangle : mesh.triangles) {
        obj.text += 'f';
        for (const std::size_t corner : {0u, 2u, 1u})
            obj.add_corner(triangle[corner], with_texcoords, with_normals);
        obj.text += '\n';
    }
    return std::move(obj.text);
}

void write_obj(const std::filesystem::path& path, const Mesh& mesh, std::span<const glm::vec3> colours,
               std::string_view comment, const glm::dvec3& origin) {
    write_file_atomically(path, obj_text(mesh, colours, comment, origin));
}

}  // namespace crevice
