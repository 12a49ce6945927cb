#include "chapters/terminal/progress.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include <unistd.h>

namespace crevice {

namespace {

constexpr int kBarWidth = 24;
constexpr auto kRedrawInterval = std::chrono::milliseconds(100);
constexpr const char* kClearLine = "\r\033[K";

}  // namespace

std::string progress_line(const std::string& label, long long done, long long total, double elapsed_s) {
    const double part =
        total > 0 ? std::min(1.0, static_cast<double>(done) / static_cast<double>(total)) : 1.0;
    const int filled = static_cast<int>(part * kBarWidth);
    std::string line = label + "  [" + std::string(static_cast<std::size_t>(filled), '#') +
                       std::string(static_cast<std::size_t>(kBarWidth - filled), '.') + "]";
    char text[48];
    std::snprintf(text, sizeof text, "  %3d%%", static_cast<int>(part * 100));
    line += text;
    if (part > 0) {
        const long long left_s = static_cast<long long>(elapsed_s * (1 - part) / part + 0.5);
        std::snprintf(text, sizeof text, "  %lld:%02lld left", left_s / 60, left_s % 60);
        line += text;
    }
    return line;
}

Progress::Progress(std::string label, long long total_steps, bool wanted)
    : label_(std::move(label)),
      total_(total_steps),
      shown_(wanted && isatty(STDERR_FILENO) == 1),
      last_drawn_(start_) {}

Progress::~Progress() {
    if (drawn_) std::fputs(kClearLine, stderr);
}

void Progress::advance(long long steps) {
    const long long done = done_.fetch_add(steps) + steps;
    if (!shown_) return;
    const std::unique_lock lock(drawing_, std::try_to_lock);
    if (!lock) return;
    const Clock::time_point now = Clock::now();
    if (now - last_drawn_ < kRedrawInterval) return;
    last_drawn_ = now;
    drawn_ = true;
    const double elapsed_s = std::chrono::duration<double>(now - start_).count();
    std::fputs((kClearLine + progress_line(label_, done, total_, elapsed_s)).c_str(), stderr);
}

}  // namespace crevice
