// Which chapter a program is that chapter_main.cpp is the main function of. Compiled once for each of them; all else is theirs
// in common.
#pragma once

namespace crevice {

// NN_topic.
const char* own_chapter();

}  // namespace crevice
