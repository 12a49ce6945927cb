#include "chapters/terminal/debugger.h"

#include <fstream>
#include <string>

namespace crevice {

bool debugger_attached() {
    std::ifstream status("/proc/self/status");
    if (!status) return true;
    const std::string key = "TracerPid:";
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(key)) return std::stoi(line.substr(key.size())) != 0;
    }
    return true;
}

bool can_be_stepped() {
#if defined(__OPTIMIZE__)
    return false;
#else
    return true;
#endif
}

}  // namespace crevice
