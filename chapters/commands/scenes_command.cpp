// `crevice scenes`
#include <iomanip>
#include <iostream>

#include "chapters/commands/commands.h"
#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"

namespace crevice {

namespace {

void print_scenes(std::ostream& out) {
    const auto print_row = [&](const char* name, const auto& triangles, const char* unit,
                               const char* purpose) {
        out << std::left << std::setw(18) << name << std::right << std::setw(10) << triangles << "  "
            << std::left << std::setw(22) << unit << purpose << "\n";
    };
    print_row("scene", "triangles", "unit", "purpose");
    for (const BuiltinScene& scene : builtin_scenes())
        print_row(scene.name, triangle_count(scene.make()), scene.unit, scene.purpose);
    out << "or the path of an OBJ file\n";
}

}  // namespace

Command add_scenes_command(CommandLine& program) {
    return {program.subcommand("scenes", "List the built-in scenes"), [] {
                print_scenes(std::cout);
                return static_cast<int>(ExitCode::done);
            }};
}

}  // namespace crevice
