#include "chapters/frame.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "ssao/shade.h"

namespace crevice {

namespace {

struct Clocks {
    double wall_ms, cpu_ms;
};

Clocks clocks() {
    timespec cpu{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
    const auto wall = std::chrono::steady_clock::now().time_since_epoch();
    return {std::chrono::duration<double, std::milli>(wall).count(),
            static_cast<double>(cpu.tv_sec) * 1e3 + static_cast<double>(cpu.tv_nsec) * 1e-6};
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

// The times of one pass over all repeats.
struct Samples {
    std::string name;
    std::vector<double> wall_ms, cpu_ms;

    PassTime summary() const {
        PassTime time{name, median(wall_ms), median(cpu_ms), 0, static_cast<int>(wall_ms.size())};
        std::vector<double> deviations;
        for (const double ms : wall_ms) deviations.push_back(std::fabs(ms - time.wall_ms));
        time.wall_ms_mad = median(deviations);
        return time;
    }
};

class Stopwatch {
 public:
    // Runs one pass and adds its time to the samples of that name.
    template <class Pass>
    void time(const std::string& name, const Pass& pass) {
        const Clocks before = clocks();
        pass();
        const Clocks after = clocks();
        auto at =
            std::find_if(samples_.begin(), samples_.end(), [&](const Samples& s) { return s.name == name; });
        if (at == samples_.end()) at = samples_.insert(samples_.end(), {name, {}, {}});
        at->wall_ms.push_back(after.wall_ms - before.wall_ms);
        at->cpu_ms.push_back(after.cpu_ms - before.cpu_ms);
    }

    std::vector<PassTime> summaries() const {
        std::vector<PassTime> times;
        for (const Samples& samples : samples_) {
            if (samples.name != "frame") times.push_back(samples.summary());
        }
        for (const Samples& samples : samples_) {
            if (samples.name == "frame") times.push_back(samples.summary());
        }
        return times;
    }

 private:
    std::vector<Samples> samples_;
};

}  // namespace

Frame render_frame(const Scene& scene, const Camera& camera, const FrameRequest& request) {
    const MethodSettings& settings = request.settings;
    const Method& method = *request.method;
    const Needs needs = needs_of(scene, request.wanted, method.computes_ao, settings.blur.iterations,
                                 !request.run.leaves_out(Skip::passes));
    Frame frame;
    frame.camera = camera;
    frame.camera.reversed_z = settings.reversed_z;
    frame.left_out = needs.left_out;

    Stopwatch stopwatch;
    for (int repeat = 0; repeat < request.repeats; ++repeat) {
        stopwatch.time("frame", [&] {
            ScreenGeometry geometry;
            AoInputs inputs;
            stopwatch.time("normal_depth", [&] {
                GeometrySettings geometry_with = geometry_settings(settings.buffers);
                geometry_with.with_normals = needs.normals;
                geometry = screen_geometry(scene, frame.camera, request.size, geometry_with, request.run);
                NormalDepthSettings buffers = settings.buffers;
                buffers.with_material = needs.lit && scene.materials.size() > 1;
                frame.gbuffer = normal_depth(geometry, frame.camera.reversed_z, buffers, request.run);
            });
            if (needs.ao) {
                stopwatch.time("ao", [&] {
                    inputs = ao_inputs(frame.gbuffer, frame.camera, method.fetch(settings.ao), request.run);
                    frame.ao_raw = luna_occlusion(inputs, settings.ao, request.run);
                });
            }
            if (needs.blur) {
                stopwatch.time("blur", [&] {
                    BlurSettings blur = settings.blur;
                    blur.format = settings.ao.format;
                    frame.ao_blurred = bilateral_blur(frame.ao_raw, inputs, blur, request.run);
                });
            }
            if (needs.lit) {
                stopwatch.time("lit", [&] {
                    const Image<float>& ao = needs.blur ? frame.ao_blurred : frame.ao_raw;
                    frame.lit = shade(scene, frame.camera, geometry, frame.gbuffer, ao, request.run);
                });
            }
        });
    }
    frame.passes = stopwatch.summaries();
    // Buffers that were asked for but had nothing to compute: everything is open.
    const Size ao_size = ao_map_size(request.size, settings.ao.ao_scale);
    if (frame.ao_raw.empty() && request.wanted.contains("ao_raw")) frame.ao_raw = Image<float>(ao_size, 1.0f);
    if (frame.ao_blurred.empty() && request.wanted.contains("ao_blurred")) {
        frame.ao_blurred = frame.ao_raw.empty() ? Image<float>(ao_size, 1.0f) : frame.ao_raw;
    }
    return frame;
}

}  // namespace crevice
