#include "chapters/bench/machine.h"
#include "chapters/terminal/number_text.h"

#include <fstream>
#include <sstream>
#include <string>
#include <thread>

namespace crevice {

namespace {

// What stands after "NAME" and a colon in a file of such lines; empty when there is no such line.
std::string line_after(const char* path, const std::string& name) {
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line)) {
        if (!line.starts_with(name)) continue;
        const std::size_t value = line.find_first_not_of(": \t", name.size());
        if (value != std::string::npos) return line.substr(value);
    }
    return "";
}

}  // namespace

std::string compiler_name() {
#if defined(__clang__)
    const std::string name = "Clang " __clang_version__;
#else
    const std::string name = "GCC " __VERSION__;
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    const char* const how = ", sanitized";
#elif defined(__OPTIMIZE__)
    const char* const how = ", optimised";
#else
    const char* const how = ", not optimised";
#endif
    return name + how;
}

Machine machine_of(const Run& run) {
    const std::string model = line_after("/proc/cpuinfo", "model name");
    return {model.empty() ? "unknown" : model, static_cast<int>(std::thread::hardware_concurrency()),
            compiler_name(), isa_name(isa_of(run)), lane_count(run)};
}

Facts machine_facts(const Run& run) {
    const Machine machine = machine_of(run);
    return {{"cpu", machine.cpu + ", " + counted(machine.cores, "thread")},
            {"compiler", machine.compiler},
            {"threads", std::to_string(thread_count(run))},
            {"lanes", std::to_string(machine.lanes)},
            {"isa", machine.isa}};
}

std::string busy_note(const PassTime& frame, int threads) {
    constexpr double kShortest_ms = 5, kLeastShare = 0.8;
    const double share = frame.cpu_ms / (frame.wall_ms * threads);
    if (frame.wall_ms < kShortest_ms || share >= kLeastShare) return "";
    return "Perhaps other programs ran: our frames had " + std::to_string(static_cast<int>(100 * share)) +
           " % of the processors they could use. Ratios of pairs hold better than times; repeat on a quiet "
           "machine.";
}

double peak_memory_bytes() {
    std::istringstream line(line_after("/proc/self/status", "VmHWM"));
    double kibibytes = 0;
    line >> kibibytes;
    return kibibytes * 1024;
}

}  // namespace crevice
