// Ctrl-C for work that has something to say when it is cut short.
#pragma once

namespace crevice {

// While one of these lives, the first Ctrl-C is only noted; the second one ends the program as always. One at a time.
class Interruption {
 public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    bool asked() const;
};

// What a program ends with that was interrupted and did less than it was asked to: 128 + SIGINT, as shells have it.
inline constexpr int kInterrupted = 130;

}  // namespace crevice
