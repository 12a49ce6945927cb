// A progress bar with the time left, for work of more than a second. On stderr, and only when that is a
// terminal.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>

namespace crevice {

// "truth  [###...]  50%  0:12 left" for `done` of `total` steps after `elapsed_s` seconds; no time before the
// first step.
std::string progress_line(const std::string& label, long long done, long long total, double elapsed_s);

class Progress {
 public:
    // `wanted` false: nothing is shown, because another bar is.
    Progress(std::string label, long long total_steps, bool wanted = true);
    ~Progress();  // clears the line
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // May be called from any thread. Redraws at most ten times a second.
    void advance(long long steps = 1);

 private:
    using Clock = std::chrono::steady_clock;

    const std::string label_;
    const long long total_;
    const bool shown_;
    const Clock::time_point start_ = Clock::now();
    std::atomic<long long> done_ = 0;
    std::mutex drawing_;
    Clock::time_point last_drawn_;
    bool drawn_ = false;
};

}  // namespace crevice
