// The time that named passes take: wall and CPU clock, medians over many runs, and how far the runs spread.
#pragma once

#include <string>
#include <vector>

namespace crevice {

struct Clocks {
    double wall_ms, cpu_ms;  // since some fixed moment; cpu over all threads of the process
};

// The readings now. A function of its own for `crevice bench --instructions`, which counts the instructions
// from one call to the next.
[[gnu::noinline]] Clocks clocks();

// The value in the middle; of an even number of values the mean of the two. `values` is not empty.
double median(std::vector<double> values);
// Median absolute deviation from the median.
double median_deviation(const std::vector<double>& values);

struct PassTime {
    std::string name;
    double wall_ms = 0, cpu_ms = 0;  // medians; cpu over all threads of the process
    double wall_ms_mad = 0;          // median absolute deviation of the wall time
    int runs = 0;
};

// The times of one pass over all runs.
struct PassSamples {
    std::string name;
    std::vector<double> wall_ms, cpu_ms;

    PassTime summary() const;
};

class Stopwatch {
 public:
    // Runs one pass and adds its time to the samples of that name.
    template <class Pass>
    void time(const std::string& name, const Pass& pass) {
        const Clocks before = clocks();
        pass();
        add(name, before, clocks());
    }

    // Each pass in the order in which it first ended.
    const std::vector<PassSamples>& samples() const { return samples_; }
    // The same, and last the frame.
    std::vector<PassTime> summaries() const;

 private:
    void add(const std::string& name, const Clocks& before, const Clocks& after);

    std::vector<PassSamples> samples_;
};

}  // namespace crevice
