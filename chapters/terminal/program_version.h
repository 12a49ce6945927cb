// Which program this is.
#pragma once

#include <string>

namespace crevice {

struct ProgramVersion {
    std::string number;  // "0.1.0"
    std::string commit;  // 12 hex digits, with "-changed" where the sources were; "unknown" outside a repository
};
// Written at build time by cmake/program_version.cmake.
ProgramVersion program_version();

// "0.1.0 (commit 0123456789ab)"
inline std::string version_text(const ProgramVersion& version) {
    return version.number + " (commit " + version.commit + ")";
}

}  // namespace crevice
