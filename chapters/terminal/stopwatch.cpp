#include "chapters/terminal/stopwatch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

namespace crevice {

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

double median_deviation(const std::vector<double>& values) {
    const double centre = median(values);
    std::vector<double> deviations;
    for (const double value : values) deviations.push_back(std::fabs(value - centre));
    return median(deviations);
}

PassTime PassSamples::summary() const {
    return {name, median(wall_ms), median(cpu_ms), median_deviation(wall_ms),
            static_cast<int>(wall_ms.size())};
}

std::vector<PassTime> Stopwatch::summaries() const {
    std::vector<PassTime> times;
    for (const PassSamples& samples : samples_) {
        if (samples.name != "frame") times.push_back(samples.summary());
    }
    for (const PassSamples& samples : samples_) {
        if (samples.name == "frame") times.push_back(samples.summary());
    }
    return times;
}

void Stopwatch::add(const std::string& name, const Clocks& before, const Clocks& after) {
    auto at = std::find_if(samples_.begin(), samples_.end(),
                           [&](const PassSamples& samples) { return samples.name == name; });
    if (at == samples_.end()) at = samples_.insert(samples_.end(), {name, {}, {}});
    at->wall_ms.push_back(after.wall_ms - before.wall_ms);
    at->cpu_ms.push_back(after.cpu_ms - before.cpu_ms);
}

}  // namespace crevice
