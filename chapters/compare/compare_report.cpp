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

std::vector<std::pair<std::string, std::string>> rows_of(const ComparedPair& pair) {
    auto rows = error_rows(*pair.error);
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
