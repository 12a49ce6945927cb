// The parameters of the buffers that the AO pass reads.
#include "chapters/frame/parameter_kinds.h"

namespace crevice {

namespace {

// The depth format and the direction of z go together.
struct NamedDepth {
    const char* name;
    DepthFormat format;
    bool reversed_z;
};
constexpr NamedDepth kDepths[] = {{"d16", DepthFormat::d16, false},
                                  {"d24", DepthFormat::d24, false},
                                  {"d32f", DepthFormat::d32f, false},
                                  {"d32f_reversed", DepthFormat::d32f, true}};

Parameter depth_format() {
    const char* const name = "depth_format";
    const char* const range = "d16|d24|d32f|d32f_reversed";
    const auto set = [=](MethodSettings& s, const std::string& word) {
        for (const NamedDepth& depth : kDepths) {
            if (word != depth.name) continue;
            s.buffers.depth_format = depth.format;
            s.reversed_z = depth.reversed_z;
            return;
        }
        throw_no_such_choice(name, word, range);
    };
    const auto get = [](const MethodSettings& s) -> std::string {
        for (const NamedDepth& depth : kDepths) {
            if (s.buffers.depth_format == depth.format && s.reversed_z == depth.reversed_z) return depth.name;
        }
        return "custom";
    };
    return {name, range, "-", "how the depth buffer is stored", set, get};
}

}  // namespace

std::vector<Parameter> buffer_parameters() {
    using S = MethodSettings;
    return {
        depth_format(),
        choice<BufferFormat>(
            "buffer_format", kFormatRange, "how normals and view depth are stored",
            [](S& s) -> BufferFormat& { return s.buffers.buffer_format; }, format_choices()),
        position_order("depth_position", "how the first pass multiplies positions; only the last bits differ",
                       [](S& s) -> PositionOrder& { return s.buffers.position_order; }),
        choice<NormalMatrix>("normal_matrix", "inverse_transpose|with_translation|world",
                             "what turns normals into view space; the other two bend them",
                             [](S& s) -> NormalMatrix& { return s.buffers.normal_matrix; },
                             {{"inverse_transpose", NormalMatrix::inverse_transpose},
                              {"with_translation", NormalMatrix::with_translation},
                              {"world", NormalMatrix::world}}),
        yes_no("depth_cutouts", "false: the first pass draws holes too, and background shows in them",
               [](S& s) -> bool& { return s.buffers.cutouts; }),
        choice<bool>(
            "ao_normals", "vertex|mapped", "mapped: bent by the materials' normal maps, before AO sees them",
            [](S& s) -> bool& { return s.buffers.mapped_normals; }, {{"vertex", false}, {"mapped", true}})};
}

}  // namespace crevice
