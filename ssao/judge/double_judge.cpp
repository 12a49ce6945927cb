#include "ssao/judge/double_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "rasterizer/scene/normal_matrix.h"

namespace crevice {

namespace {

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

}  // namespace

DoubleJudge::DoubleJudge(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry)
    : scene_(scene), camera_(camera), geometry_(geometry) {
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(camera.up, forward));
    view_from_relative_ = glm::transpose(glm::dmat3(right, glm::cross(forward, right), forward));
    const double half_height = camera.projection == Projection::perspective ? std::tan(0.5 * camera.fov_y_rad)
                                                                            : 0.5 * camera.ortho_height;
    half_ = {half_height * geometry.size.width / geometry.size.height, half_height};
}

glm::dvec3 DoubleJudge::position(const Instance& instance, std::size_t number) const {
    const glm::vec3& p = scene_.meshes[static_cast<std::size_t>(instance.mesh)].positions[number];
    const glm::dvec3 relative =
        glm::dvec3(glm::dmat4(instance.world_from_object) * glm::dvec4(p, 1)) - camera_.eye;
    return view_from_relative_ * relative;
}

DoubleJudge::Corner DoubleJudge::corner_of(const ScreenTriangle& t, std::size_t i) const {
    const Instance& instance = scene_.instances[t.instance];
    const std::size_t number = t.vertex[i] - geometry_.vertices.first_vertex[t.instance];
    const glm::vec3& n = scene_.meshes[static_cast<std::size_t>(instance.mesh)].normals[number];
    const glm::dmat3 turn =
        normal_matrix(view_from_relative_ * glm::dmat3(glm::dmat4(instance.world_from_object)));
    return {position(instance, number), unit_or_zero(turn * glm::dvec3(n))};
}

DoubleJudge::Sight DoubleJudge::sight(int x, int y) const {
    const double u = (2 * x + 1.0) / geometry_.size.width - 1, v = 1 - (2 * y + 1.0) / geometry_.size.height;
    const glm::dvec3 across(u * half_.x, v * half_.y, 0), ahead(0, 0, 1);
    if (camera_.projection == Projection::orthographic) return {across, ahead};
    return {glm::dvec3(0), across + ahead};
}

JudgedPixel DoubleJudge::at(const GBuffer& g, int x, int y) const {
    const std::int32_t number = g.triangle.at(x, y);
    if (number < 0) return {};
    const ScreenTriangle& t = *geometry_.triangle(number).triangle;
    const Corner corner[] = {corner_of(t, 0), corner_of(t, 1), corner_of(t, 2)};
    const glm::dvec3 along_1 = corner[1].position - corner[0].position,
                     along_2 = corner[2].position - corner[0].position;
    const glm::dvec3 doubled = glm::cross(along_1, along_2), face = glm::normalize(doubled);
    const Sight ray = sight(x, y);
    JudgedPixel pixel;
    pixel.surface = true;
    pixel.view_depth = glm::dot(face, corner[0].position - ray.from) / glm::dot(face, ray.along);
    pixel.slant = std::fabs(glm::dot(face, glm::normalize(ray.along)));
    for (const Corner& c : corner) pixel.reach = std::fmax(pixel.reach, glm::length(c.position));

    const glm::dvec3 from_corner = ray.from + pixel.view_depth * ray.along - corner[0].position;
    const double area = glm::dot(doubled, face);
    const double share_1 = glm::dot(glm::cross(from_corner, along_2), face) / area,
                 share_2 = glm::dot(glm::cross(along_1, from_corner), face) / area;
    pixel.normal = unit_or_zero(corner[0].normal + share_1 * (corner[1].normal - corner[0].normal) +
                                share_2 * (corner[2].normal - corner[0].normal));
    if (t.back_facing && glm::dot(pixel.normal, ray.along) > 0) pixel.normal = -pixel.normal;
    return pixel;
}

double DoubleJudge::depth_a() const {
    const double n = camera_.near_plane, f = camera_.far_plane;
    const bool from_far = (camera_.projection == Projection::perspective) != camera_.reversed_z;
    return (from_far ? f : -n) / (f - n);
}

double DoubleJudge::depth_b() const {
    const double n = camera_.near_plane, f = camera_.far_plane, grows = camera_.reversed_z ? -1 : 1;
    return (camera_.projection == Projection::perspective ? -grows * n * f : grows) / (f - n);
}

double DoubleJudge::ndc_depth(double view_depth) const {
    return depth_a() +
           depth_b() * (camera_.projection == Projection::perspective ? 1 / view_depth : view_depth);
}

JudgedVertex DoubleJudge::vertex(const Instance& instance, std::size_t number) const {
    const glm::dvec3 p = position(instance, number);
    const double w = camera_.projection == Projection::perspective ? p.z : 1;
    return {(p.x / (w * half_.x) + 1) * 0.5 * geometry_.size.width,
            (1 - p.y / (w * half_.y)) * 0.5 * geometry_.size.height, w};
}

DoubleGBuffer double_gbuffer(const DoubleJudge& judge, const GBuffer& g) {
    const Size size = g.view_depth.size;
    const Image<double> zero(size, 0.0);
    DoubleGBuffer result{Image<double>(size, std::numeric_limits<double>::infinity()),
                         Image<double>(size, judge.cleared_depth()),
                         {zero, zero, zero},
                         judge.depth_a(),
                         judge.depth_b()};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const JudgedPixel pixel = judge.at(g, x, y);
            if (!pixel.surface) continue;
            result.view_depth.at(x, y) = pixel.view_depth;
            result.ndc_depth.at(x, y) = judge.ndc_depth(pixel.view_depth);
            for (int i = 0; i < 3; ++i) result.normal[static_cast<std::size_t>(i)].at(x, y) = pixel.normal[i];
        }
    }
    return result;
}

}  // namespace crevice
