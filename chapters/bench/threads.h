// What a second thread gives.
#pragma once

#include "chapters/notebook/table.h"

namespace crevice {

inline constexpr double kTwoThreadAim = 1.9;  // times as fast as one, at least

// Frames of `columns` at 1280x720 by one thread and by two, in turns: medians, the median of the paired
// ratios with its interval, and whether the aim is met. Without rows where the machine has one thread only.
Table thread_table();

}  // namespace crevice
