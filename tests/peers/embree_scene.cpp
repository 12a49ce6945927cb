#include "tests/peers/embree_scene.h"

#include <algorithm>
#include <cstring>
#include <string>

#include <tbb/task_arena.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"

namespace crevice {

namespace {

constexpr std::size_t kPacket = 8;
// Packets, or eights of rays, are handed out in pieces of this many.
constexpr std::size_t kPiece = 128;

// Calls body(first, end) for pieces of `count` items, on all threads.
template <class Body>
void for_pieces(std::size_t count, std::size_t piece_size, const Run& run, const Body& body) {
    parallel_for(static_cast<int>((count + piece_size - 1) / piece_size), run, [&](int piece) {
        const std::size_t first = static_cast<std::size_t>(piece) * piece_size;
        body(first, std::min(first + piece_size, count));
    });
}

RTCIntersectContext ray_context() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    return context;
}

RTCRay embree_ray(const Ray& ray, float max_distance) {
    RTCRay result{};
    result.org_x = ray.origin.x;
    result.org_y = ray.origin.y;
    result.org_z = ray.origin.z;
    result.dir_x = ray.direction.x;
    result.dir_y = ray.direction.y;
    result.dir_z = ray.direction.z;
    result.tfar = max_distance;
    result.mask = ~0u;
    return result;
}

void set_lane(RTCRay8& packet, std::size_t lane, const Ray& ray, float max_distance) {
    packet.org_x[lane] = ray.origin.x;
    packet.org_y[lane] = ray.origin.y;
    packet.org_z[lane] = ray.origin.z;
    packet.dir_x[lane] = ray.direction.x;
    packet.dir_y[lane] = ray.direction.y;
    packet.dir_z[lane] = ray.direction.z;
    packet.tnear[lane] = 0;
    packet.tfar[lane] = max_distance;
    packet.time[lane] = 0;
    packet.mask[lane] = ~0u;
    packet.id[lane] = 0;
    packet.flags[lane] = 0;
}

[[noreturn]] void fail(RTCDevice device, const char* what) {
    throw InputError("Embree: " + std::string(what) + " failed (error " +
                     std::to_string(static_cast<int>(rtcGetDeviceError(device))) +
                     "); check that libembree3-3 is installed whole");
}

}  // namespace

void GroupedRays::add(std::span<const Ray> of_point) {
    for (std::size_t i = 0; i < of_point.size(); i += kPacket) {
        const auto group = of_point.subspan(i, std::min(kPacket, of_point.size() - i));
        rays.insert(rays.end(), group.begin(), group.end());
        group_first.push_back(static_cast<std::uint32_t>(rays.size()));
    }
}

EmbreeDevice::EmbreeDevice(int threads)
    : device_(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())) {
    if (device_ == nullptr) fail(nullptr, "rtcNewDevice");
}

EmbreeScene::EmbreeScene(const EmbreeDevice& device, std::span<const Corners> triangles, int threads)
    : scene_(rtcNewScene(device.get())) {
    rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
    const RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    // Three vertices of its own for each triangle: the very floats that ours has.
    const std::size_t count = triangles.size();
    if (count > 0) {
        void* const vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                       sizeof(glm::vec3), 3 * count);
        auto* const indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count));
        if (vertices == nullptr || indices == nullptr) fail(device.get(), "rtcSetNewGeometryBuffer");
        std::memcpy(vertices, triangles.data(), triangles.size_bytes());
        for (std::uint32_t i = 0; i < 3 * count; ++i) indices[i] = i;
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
    tbb::task_arena(threads).execute([&] { rtcJoinCommitScene(scene_.get()); });
    if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE) fail(device.get(), "rtcJoinCommitScene");
}

std::vector<std::uint8_t> EmbreeScene::occluded1(const GroupedRays& rays, float max_distance,
                                                 const Run& run) const {
    std::vector<std::uint8_t> hits(rays.rays.size());
    for_pieces(rays.rays.size(), kPiece * kPacket, run, [&](std::size_t first, std::size_t end) {
        RTCIntersectContext context = ray_context();
        for (std::size_t i = first; i < end; ++i) {
            RTCRay ray = embree_ray(rays.rays[i], max_distance);
            rtcOccluded1(scene_.get(), &context, &ray);
            hits[i] = ray.tfar < 0;  // -inf: something was met
        }
    });
    return hits;
}

std::vector<std::uint8_t> EmbreeScene::occluded8(const GroupedRays& rays, float max_distance,
                                                 const Run& run) const {
    std::vector<std::uint8_t> hits(rays.rays.size());
    for_pieces(rays.groups(), kPiece, run, [&](std::size_t first, std::size_t end) {
        RTCIntersectContext context = ray_context();
        RTCRay8 packet;
        alignas(32) int valid[kPacket];
        for (std::size_t group = first; group < end; ++group) {
            const std::size_t start = rays.group_first[group], count = rays.group_first[group + 1] - start;
            for (std::size_t lane = 0; lane < kPacket; ++lane) {
                valid[lane] = lane < count ? -1 : 0;
                set_lane(packet, lane, rays.rays[start + std::min(lane, count - 1)], max_distance);
            }
            rtcOccluded8(valid, scene_.get(), &context, &packet);
            for (std::size_t lane = 0; lane < count; ++lane) hits[start + lane] = packet.tfar[lane] < 0;
        }
    });
    return hits;
}

}  // namespace crevice
