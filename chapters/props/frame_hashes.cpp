#include "chapters/props/frame_hashes.h"

#include <sstream>

#include "chapters/frame/frame_settings.h"
#include "chapters/notebook/embedded_files.h"
#include "rasterizer/base/image_summary.h"

namespace crevice {

FrameRequest xjun_request(Size size) {
    FrameRequest request;
    request.size = size;
    request.method = &find_method("xjun");
    request.settings = settings_of(*request.method);
    return request;
}

std::string hash_named(const Frame& frame, const std::string& buffer) {
    if (buffer == "normal") return content_hash(frame.gbuffer.normal);
    if (buffer == "view_depth") return content_hash(frame.gbuffer.view_depth);
    if (buffer == "ndc_depth") return content_hash(ndc_depth(frame.gbuffer.depth));
    if (buffer == "ao_raw") return content_hash(frame.ao_raw);
    return content_hash(buffer == "ao_blurred" ? frame.ao_blurred : Image<float>{});
}

std::string hashes_of(const Frame& frame) {
    std::string all = content_hash(frame.lit);
    for (const char* buffer : {"normal", "view_depth", "ndc_depth", "ao_raw", "ao_blurred"})
        all += hash_named(frame, buffer);
    return all;
}

std::string recorded_hash(const std::string& wanted) {
    std::istringstream file(std::string(embedded_file("tests/golden/hashes.txt").value_or("")));
    for (std::string scene, buffer, hash; file >> scene >> buffer >> hash;) {
        if (scene == "columns" && buffer == wanted) return hash;
    }
    return "none";
}

std::vector<KernelForm> forms_of_this_machine() {
    std::vector<KernelForm> forms = {{"one pixel at a time", {.lanes = 1}}};
    for (const Isa isa : kEveryIsa) {
        if (isa_available(isa))
            forms.push_back({std::to_string(lanes_of(isa)) + " lanes, " + isa_name(isa), {.isa = isa}});
    }
    return forms;
}

}  // namespace crevice
