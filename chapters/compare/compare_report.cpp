#include "chapters/compare/compare_report.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include <nlohmann/json.hpp>

#include "chapters/notebook/html.h"
#include "chapters/terminal/json_text.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

using Json = nlohmann::ordered_json;

// Where any component differs most, the first in row order: what to ask `crevice probe` about. A NaN, or an infinity that
// only one has, differs more than any number.
PixelPosition worst_pixel(const Planes& a, const Planes& b) {
    PixelPosition worst;
    double most = -1;
    const Size size = a[0].size;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            for (std::size_t c = 0; c < a.size(); ++c) {
                const double va = a[c].at(x, y), vb = b[c].at(x, y);
                const double apart = va == vb ? 0 : std::isfinite(va - vb) ? std::fabs(va - vb) : HUGE_VAL;
                if (apart <= most) continue;
                most = apart;
                worst = {x, y};
            }
        }
    }
    return worst;
}

std::vector<std::pair<std::string, std::string>> rows_of(const ComparedPair& pair) {
    auto rows = error_rows(*pair.error);
    if (!pair.error->identical()) {
        const PixelPosition at = worst_pixel(pair.entry->a, pair.entry->b);
        rows.push_back({"worst pixel", std::to_string(at.x) + " " + std::to_string(at.y)});
    }
    if (!std::isnan(pair.flip)) rows.push_back({"FLIP", significant_text(pair.flip, 6)});
    return rows;
}

Json json_of(const CompareLimits& limits) {
    Json json = Json::object();
    if (limits.max_abs) json["max_abs"] = *limits.max_abs;
    if (limits.rmse) json["rmse"] = *limits.rmse;
    if (limits.flip) json["flip"] = *limits.flip;
    if (limits.ssim) json["ssim"] = *limits.ssim;
    if (limits.max_pixels) json["max_pixels"] = *limits.max_pixels;
    return json;
}

Json json_of(const ComparedPair& pair) {
    Json json = {{"name", pair.entry->title()}, {"passed", pair.passed()}, {"failures", pair.failures}};
    if (pair.limits.any()) json["limits"] = json_of(pair.limits);
    if (!pair.error) return json;
    const Planes& planes = pair.entry->a;
    json["shape"] = {planes[0].size.height, planes[0].size.width, planes.size()};
    const ImageError& error = *pair.error;
    json["rmse"] = error.rmse;
    json["mae"] = error.mae;
    json["bias"] = error.bias;
    json["max_abs"] = error.max_abs;
    json["p99"] = error.p99;
    json["ssim"] = error.ssim;
    if (!std::isnan(pair.flip)) json["flip"] = pair.flip;
    json["pixels"] = error.pixels;
    json["differing_pixels"] = error.differing_pixels;
    json["nan_or_inf"] = error.nan_or_inf;
    if (!error.identical()) {
        const PixelPosition at = worst_pixel(planes, pair.entry->b);
        json["worst_pixel"] = {at.x, at.y};
    }
    return json;
}

std::string joined(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += (text.empty() ? "" : "; ") + sentence;
    return text;
}

}  // namespace

std::string ComparedPair::verdict() const {
    if (!error) return entry->note;
    if (error->identical()) return "identical";
    if (!limits.any()) return "differs";
    return passed() ? "within its limits" : "beyond its limits (" + joined(failures) + ")";
}

void print_pair(std::ostream& out, const ComparedPair& pair) {
    out << pair.entry->title() << ": " << pair.verdict() << "\n";
    if (!pair.error) return;
    for (const auto& [name, value] : rows_of(pair))
        out << "  " << name << std::string(18 - name.size(), ' ') << value << "\n";
}

std::string json_report(const std::string& a, const std::string& b, std::span<const ComparedPair> pairs) {
    Json all = Json::array();
    for (const ComparedPair& pair : pairs) all.push_back(json_of(pair));
    const auto failed = std::ranges::count_if(pairs, [](const ComparedPair& pair) { return !pair.passed(); });
    return json_text(Json{{"a", a}, {"b", b}, {"failed", failed}, {"pairs", all}});
}

std::string junit_report(std::span<const ComparedPair> pairs) {
    const auto failed = std::ranges::count_if(pairs, [](const ComparedPair& pair) { return !pair.passed(); });
    std::string xml =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n<testsuite name=\"crevice compare\" "
        "tests=\"" +
        std::to_string(pairs.size()) + "\" failures=\"" + std::to_string(failed) + "\">\n";
    for (const ComparedPair& pair : pairs) {
        xml += "<testcase classname=\"crevice.compare\" name=\"" + escape_html(pair.entry->title()) + "\"";
        if (pair.passed()) {
            xml += "/>\n";
            continue;
        }
        xml += ">\n<failure message=\"" + escape_html(joined(pair.failures)) + "\">";
        if (pair.error) {
            for (const auto& [name, value] : rows_of(pair)) xml += escape_html(name + " " + value + "\n");
        }
        xml += "</failure>\n</testcase>\n";
    }
    return xml + "</testsuite>\n</testsuites>\n";
}

}  // namespace crevice
