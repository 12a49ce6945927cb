#include "chapters/props/gtao_maps.h"

#include <algorithm>
#include <cmath>

#include "chapters/props/crops.h"

namespace crevice {

GtaoStrip over_samples(const JudgedView& view, const JudgedView& judged, const Truth& truth) {
    GtaoStrip strip;
    for (const std::string samples : {"4", "8", "18", "54"}) {
        const Words words = {"samples=" + samples};
        const std::string label = "samples = " + samples;
        const MethodLimit limit = judged.limit("gtao", words);
        const MapError error = judged.error(limit, truth);
        strip.noise.push_back(limit.noise);
        strip.errors.push_back(error.rmse);
        strip.rows.push_back(error_row("gtao, " + label, error, limit));
        strip.pictures.push_back(
            {"samples_" + samples, ao_picture(around_foot(view.map("gtao", words).raw.ao)), label});
    }
    return strip;
}

GtaoStrip over_radii(const JudgedView& view) {
    GtaoStrip strip;
    for (const std::string radius : {"0.25", "0.5", "1", "2"}) {
        const MethodMap map = view.map("gtao", {"radius=" + radius});
        strip.pictures.push_back({"radius_" + std::to_string(strip.pictures.size()),
                                  ao_picture(around_foot(map.denoised)), "radius " + radius});
    }
    return strip;
}

ErrorCauses error_causes(const JudgedView& view, const MethodLimit& method, const Truth& truth) {
    const AoQuestion& question = truth.question;
    const Truth even = view.truth({question.radius, question.fade_start, question.fade_end, false});
    const Truth of_depth = view.depth_truth(question);
    return {view.error(MethodLimit{question, even.image}, truth),
            view.error(MethodLimit{question, of_depth.image}, truth), view.error(method, of_depth)};
}

std::vector<std::vector<std::string>> error_cause_rows(const ErrorCauses& causes) {
    std::vector<std::vector<std::string>> rows = {
        error_row("weight: even rays instead of cosine-weighted ones", causes.weight),
        error_row("depth map: rays against it instead of the scene", causes.depth),
        error_row("steps: GTAO, cut, instead of these rays", causes.steps)};
    rows[0].push_back("HBAO");
    rows[1].push_back("both");
    rows[2].push_back("both");
    return rows;
}

Unevenness unevenness(const MethodMap& map) {
    const Image<float>& ao = map.raw.ao;
    Unevenness result;
    double squares = 0, count = 0;
    for (int y = ao.size.height * 9 / 10; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            const double off = 1 - static_cast<double>(ao.at(x, y));
            result.most = std::max(result.most, std::fabs(off));
            squares += off * off;
            count += 1;
        }
    }
    result.rms = std::sqrt(squares / std::max(count, 1.0));
    return result;
}

Image<float> cosine_to_normals(const AoInputs& inputs, const Image3& vectors) {
    Image<float> cosine(inputs.size(), 1.0f);
    for (int y = 0; y < cosine.size.height; ++y) {
        for (int x = 0; x < cosine.size.width; ++x) {
            if (!std::isfinite(inputs.view_depth.at(x, y))) continue;
            cosine.at(x, y) = dot(spread<float>(inputs.normal.at(x, y)), spread<float>(vectors.at(x, y)));
        }
    }
    return cosine;
}

}  // namespace crevice
