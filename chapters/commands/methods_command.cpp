// `crevice methods`
#include <iostream>

#include "chapters/commands/commands.h"
#include "chapters/frame/frame_settings.h"
#include "rasterizer/base/error.h"

namespace crevice {

Command add_methods_command(CommandLine& program) {
    return {program.subcommand("methods", "List the ambient-occlusion methods"), [] {
                print_methods(std::cout);
                return static_cast<int>(ExitCode::done);
            }};
}

}  // namespace crevice
