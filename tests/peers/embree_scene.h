// The triangles of a RayScene in Embree, and rays through them in Embree's two ways.
//
// Embree builds with RTC_BUILD_QUALITY_HIGH, its fastest trees, and is asked for no more robustness than it
// has by itself, which is its fastest way too: unlike ours it may let a ray slip between two triangles.
// Packets are flagged incoherent: with eights of rays of one octant that is 1.2 (length 0.5) to 1.7 times
// (unbounded) as fast as flagged coherent, which keeps them together to the end.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <embree3/rtcore.h>

#include "rasterizer/base/run.h"
#include "ssao/rays/ray_triangle.h"

namespace crevice {

// Rays in groups of eight or fewer that start in one point.
struct GroupedRays {
    std::vector<Ray> rays;
    std::vector<std::uint32_t> group_first = {0};  // group g: rays [group_first[g], group_first[g + 1])

    std::size_t groups() const { return group_first.size() - 1; }
    // Adds the rays of one point.
    void add(std::span<const Ray> of_point);
};

// One a program: a device limits the threads of the whole program, ours too, to those it is given.
class EmbreeDevice {
 public:
    // Throws InputError.
    explicit EmbreeDevice(int threads);
    RTCDevice get() const { return device_.get(); }

 private:
    struct Release {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    };
    std::unique_ptr<RTCDeviceTy, Release> device_;
};

class EmbreeScene {
 public:
    // Builds on so many threads. Throws InputError with Embree's error code when it cannot.
    EmbreeScene(const EmbreeDevice& device, std::span<const Corners> triangles, int threads);

    // 1 for each ray that meets anything in (0, max_distance], else 0, on the threads of `run`: one ray after
    // the other, or each group as one packet.
    std::vector<std::uint8_t> occluded1(const GroupedRays& rays, float max_distance, const Run& run) const;
    std::vector<std::uint8_t> occluded8(const GroupedRays& rays, float max_distance, const Run& run) const;

 private:
    struct Release {
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    };
    std::unique_ptr<RTCSceneTy, Release> scene_;
};

}  // namespace crevice
