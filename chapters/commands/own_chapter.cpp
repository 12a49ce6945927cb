#include "chapters/commands/own_chapter.h"

namespace crevice {

// The target of the build that the program is made by says it.
const char* own_chapter() { return CREVICE_OWN_CHAPTER; }

}  // namespace crevice
