#include "rasterizer/scene/tangents.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

struct TexturedMesh {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> texcoords;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    std::vector<glm::vec4> tangents() const {
        return vertex_tangents(positions, normals, texcoords, triangles);
    }
};

// A square that faces the eye at -z: corners upper left, upper right, lower left, lower right.
TexturedMesh square() {
    return {{{0, 1, 0}, {1, 1, 0}, {0, 0, 0}, {1, 0, 0}},
            std::vector<glm::vec3>(4, {0, 0, -1}),
            {{0, 0}, {1, 0}, {0, 1}, {1, 1}},
            {{0, 1, 2}, {1, 3, 2}}};
}

// Latitudes and longitudes, u around the axis y, v from pole to pole; the seam has its own vertices.
TexturedMesh sphere() {
    constexpr int columns = 24, rows = 12;
    TexturedMesh mesh;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const double u = static_cast<double>(column) / columns, v = static_cast<double>(row) / rows;
            const SineCosine around = sine_cosine(2 * kPi * u), down = sine_cosine(kPi * v);
            const glm::vec3 n = glm::dvec3(down.sine * around.cosine, down.cosine, down.sine * around.sine);
            mesh.positions.push_back(3.0f * n + 1.0f);
            mesh.normals.push_back(n);
            mesh.texcoords.emplace_back(u, v);
        }
    }
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t a = row * (columns + 1) + column, below = a + columns + 1;
            mesh.triangles.push_back({a, a + 1, below});
            mesh.triangles.push_back({a + 1, below + 1, below});
        }
    }
    return mesh;
}

void check_frames(const TexturedMesh& mesh) {
    const std::vector<glm::vec4> tangents = mesh.tangents();
    REQUIRE(tangents.size() == mesh.positions.size());
    for (std::size_t v = 0; v < tangents.size(); ++v) {
        CAPTURE(v);
        const glm::vec3 t(tangents[v]);
        CHECK(std::abs(glm::length(t) - 1) < 1e-6f);
        CHECK(std::abs(glm::dot(t, mesh.normals[v])) < 1e-6f);
        CHECK(std::abs(tangents[v].w) == 1);
    }
}

}  // namespace

TEST_CASE("tangents: of a square as painted, turned and mirrored") {
    TexturedMesh mesh = square();
    for (const glm::vec4& tangent : mesh.tangents()) CHECK(tangent == glm::vec4(1, 0, 0, 1));
    for (glm::vec2& uv : mesh.texcoords) uv = {uv.y, -uv.x};  // a quarter turn: u runs down
    for (const glm::vec4& tangent : mesh.tangents()) CHECK(tangent == glm::vec4(0, -1, 0, 1));
    mesh = square();
    for (glm::vec2& uv : mesh.texcoords) uv.x = 5 - 3 * uv.x;
    for (const glm::vec4& tangent : mesh.tangents()) CHECK(tangent == glm::vec4(-1, 0, 0, -1));
    mesh = square();
    for (glm::vec2& uv : mesh.texcoords) uv.y = -uv.y;
    for (const glm::vec4& tangent : mesh.tangents()) CHECK(tangent == glm::vec4(1, 0, 0, -1));
}

TEST_CASE("tangents: follow u where u and v are not at right angles, and lean with the vertex normal") {
    TexturedMesh mesh = square();
    for (glm::vec2& uv : mesh.texcoords) uv.y += 2 * uv.x;  // v = const runs diagonally
    const glm::vec3 along_u = glm::normalize(glm::vec3(1, 2, 0));
    for (const glm::vec4& tangent : mesh.tangents()) CHECK(glm::length(glm::vec3(tangent) - along_u) < 1e-6f);
    mesh = square();
    mesh.normals.assign(4, glm::vec3(-0.6f, 0, -0.8f));
    check_frames(mesh);
    for (const glm::vec4& tangent : mesh.tangents())
        CHECK(glm::length(glm::vec3(tangent) - glm::vec3(0.8f, 0, -0.6f)) < 1e-6f);
}

TEST_CASE("tangents: how a square is cut makes no difference") {
    // The middle vertex of two fans: one of four triangles, one whose right half is cut into four more.
    TexturedMesh mesh{{{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {-1, -1, 0.5f}, {-1, 1, 0.5f}},
                      std::vector<glm::vec3>(5, {0, 0, -1}),
                      {{0, 0}, {1, -1}, {1, 1}, {-1, 1}, {-1, -0.5f}},
                      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}};
    const glm::vec4 coarse = mesh.tangents()[0];
    for (const float y : {0.5f, 0.0f, -0.5f}) {
        mesh.positions.push_back({1, y, 0});
        mesh.normals.push_back({0, 0, -1});
        mesh.texcoords.push_back({1, -y});
    }
    mesh.triangles = {{0, 1, 5}, {0, 5, 6}, {0, 6, 7}, {0, 7, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
    CHECK(glm::length(mesh.tangents()[0] - coarse) < 1e-6f);
    CHECK(glm::length(coarse - glm::vec4(1, 0, 0, 1)) > 0.01f);  // the fan is no plane mapping
}

TEST_CASE("tangents: a mirror line belongs to the side with more angle, the plain one if equal") {
    // Two squares side by side; u runs away from the line between them on both.
    TexturedMesh mesh{{{-1, 1, 0}, {0, 1, 0}, {1, 1, 0}, {-1, 0, 0}, {0, 0, 0}, {1, 0, 0}},
                      std::vector<glm::vec3>(6, {0, 0, -1}),
                      {{1, 0}, {0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 1}},
                      {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}}};
    std::vector<glm::vec4> tangents = mesh.tangents();
    for (const std::size_t left : {0u, 3u}) CHECK(tangents[left] == glm::vec4(-1, 0, 0, -1));
    for (const std::size_t right : {1u, 2u, 4u, 5u}) CHECK(tangents[right] == glm::vec4(1, 0, 0, 1));
    mesh.positions[2] = {0.2f, 0.1f, 0};  // the right half is folded up: less angle at the top of the line
    tangents = mesh.tangents();
    CHECK(tangents[1] == glm::vec4(-1, 0, 0, -1));
}

TEST_CASE("tangents: of a sphere point east, at right angles to the normal") {
    const TexturedMesh mesh = sphere();
    check_frames(mesh);
    const std::vector<glm::vec4> tangents = mesh.tangents();
    for (std::size_t v = 0; v < tangents.size(); ++v) {
        const glm::vec3 n = mesh.normals[v];
        if (std::abs(n.y) > 0.99f) continue;
        CAPTURE(v);
        CHECK(tangents[v].w == 1);  // u runs to the right for who looks at it
        CHECK(glm::dot(glm::vec3(tangents[v]), glm::normalize(glm::vec3(-n.z, 0, n.x))) >
              0.98f);  // at the seam only one side has a say
    }
}

TEST_CASE("tangents: any one at right angles where nothing gives a direction, never NaN") {
    for (const glm::vec3 n : {glm::vec3(0, 0, -1), {1, 0, 0}, {0, -1, 0}, {0.6f, 0, 0.8f}}) {
        for (const glm::vec2 step : {glm::vec2(0), {1, 0}, {0.1f, 0.3f}, {kNan, 1}, {1e38f, 1e38f}}) {
            CAPTURE(n.x);
            CAPTURE(step.x);
            TexturedMesh mesh = square();
            mesh.normals.assign(4, n);
            for (std::size_t v = 0; v < 4; ++v) mesh.texcoords[v] = static_cast<float>(v) * step;
            check_frames(mesh);
            for (const glm::vec4& tangent : mesh.tangents()) CHECK(tangent.w == 1);
        }
    }
    TexturedMesh mesh = square();
    mesh.normals.assign(4, glm::vec3(1, 0, 0));  // along u
    check_frames(mesh);
    mesh = square();
    mesh.positions.assign(4, glm::vec3(7));
    check_frames(mesh);
    mesh = square();
    mesh.triangles.clear();
    check_frames(mesh);
    for (const glm::vec3 odd : {glm::vec3(0), glm::vec3(kNan)}) {
        mesh = square();
        mesh.normals.assign(4, odd);
        for (const glm::vec4& tangent : mesh.tangents())
            CHECK(std::abs(glm::length(glm::vec3(tangent)) - 1) < 1e-6f);
    }
    CHECK(vertex_tangents({}, {}, {}, {}).empty());
}

TEST_CASE("tangents: a triangle without area in the texture leaves the others alone") {
    TexturedMesh mesh = square();
    const std::vector<glm::vec4> alone = mesh.tangents();
    mesh.triangles.push_back({0, 0, 3});
    mesh.triangles.push_back({0, 1, 1});
    CHECK(mesh.tangents() == alone);
}

TEST_CASE("tangents: positions and texcoords times a power of two give the same bits") {
    const TexturedMesh mesh = sphere();
    const std::vector<glm::vec4> tangents = mesh.tangents();
    for (const int k : {-20, -3, 5, 20}) {
        CAPTURE(k);
        TexturedMesh scaled = mesh;
        for (glm::vec3& p : scaled.positions) p *= std::ldexp(1.0f, k);
        CHECK(scaled.tangents() == tangents);
        for (glm::vec2& uv : scaled.texcoords) uv *= std::ldexp(1.0f, -k);
        CHECK(scaled.tangents() == tangents);
    }
}

TEST_CASE("tangents: one normal and one texcoord a vertex, or an error") {
    TexturedMesh mesh = square();
    mesh.texcoords.pop_back();
    CHECK_THROWS_WITH_AS(mesh.tangents(), doctest::Contains("3 texture coordinates"), UsageError);
}
