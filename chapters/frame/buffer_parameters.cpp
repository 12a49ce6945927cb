// The parameters of the buffers that the AO pass reads.
#include <utility>

#include "chapters/frame/frame_settings.h"
#include "chapters/frame/position_order.h"

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

Parameter<FrameSettings> depth_format() {
    Parameter<FrameSettings> p{
        "depth_format", "", "-", "how the depth buffer is stored", ParameterKind::choice, 0, 0, {}, {}, {}};
    for (const NamedDepth& depth : kDepths) {
        p.range += std::string(p.range.empty() ? "" : "|") + depth.name;
        p.choices.emplace_back(depth.name);
    }
    p.get = [](const FrameSettings& s) {
        for (std::size_t i = 0; i < std::size(kDepths); ++i) {
            if (s.buffers.depth_format == kDepths[i].format && s.reversed_z == kDepths[i].reversed_z)
                return static_cast<double>(i);
        }
        return -1.0;
    };
    p.set = [](FrameSettings& s, double value) {
        const NamedDepth& depth = kDepths[static_cast<std::size_t>(value)];
        s.buffers.depth_format = depth.format;
        s.reversed_z = depth.reversed_z;
    };
    return p;
}

}  // namespace

std::vector<Parameter<FrameSettings>> buffer_parameters() {
    using S = NormalDepthSettings;
    std::vector<Parameter<FrameSettings>> all = {depth_format()};
    const std::vector<Parameter<S>> of_first_pass = {
        buffer_format("buffer_format", "how normals and view depth are stored", &S::buffer_format),
        position_order("depth_position", "how the first pass multiplies positions; only the last bits differ",
                       &S::position_order),
        choice<S, NormalMatrix>(
            "normal_matrix", "what turns normals into view space; the other two bend them", &S::normal_matrix,
            {{"inverse_transpose", NormalMatrix::inverse_transpose},
             {"with_translation", NormalMatrix::with_translation},
             {"world", NormalMatrix::world}}),
        yes_no("depth_cutouts", "false: the first pass draws holes too, and background shows in them",
               &S::cutouts),
        choice<S, bool>("ao_normals", "mapped: bent by the materials' normal maps, before AO sees them",
                        &S::mapped_normals, {{"vertex", false}, {"mapped", true}})};
    for (Parameter<FrameSettings>& parameter : within<FrameSettings>(
             of_first_pass, [](auto& settings) -> auto& { return settings.buffers; }))
        all.push_back(std::move(parameter));
    return all;
}

}  // namespace crevice
