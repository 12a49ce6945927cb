// `crevice params`
#include <iostream>
#include <memory>

#include "chapters/commands/commands.h"
#include "chapters/frame/frame_settings.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

namespace crevice {

Command add_params_command(CommandLine& program) {
    const auto method = std::make_shared<std::string>();
    CommandLine params =
        program.subcommand("params", "List a method's parameters: range, unit, default, effect");
    params.required("METHOD", *method, "a method (crevice methods)");
    return {params, [method] {
                named_as({{"method", "METHOD"}}, [&] { print_parameters(std::cout, find_method(*method)); });
                return static_cast<int>(ExitCode::done);
            }};
}

}  // namespace crevice
