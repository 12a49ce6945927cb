#include "tests/tools/report_checks.h"

#include <fstream>

#include "tests/tools/schema_checks.h"

namespace crevice {

std::string wrong_in_report(const std::filesystem::path& json, const std::string& schema,
                            const std::function<std::string(const std::string& table)>& csv_of) {
    std::ifstream stream(json);
    const nlohmann::ordered_json report = nlohmann::ordered_json::parse(stream);
    const std::string found = stored_schema(schema).against(nlohmann::json(report));
    if (!found.empty()) return found;
    for (const auto& [name, rows] : report["tables"].items()) {
        std::ifstream csv(csv_of(name));
        std::string header, line;
        if (!std::getline(csv, header)) return name + ": no table " + csv_of(name);
        std::size_t lines = 0;
        while (std::getline(csv, line)) ++lines;
        if (lines != rows.size())
            return name + ": " + std::to_string(lines) + " lines for the rows of the JSON";
        if (rows.empty()) continue;
        std::string columns;
        for (const auto& [column, ignored] : rows[0].items())
            columns += (columns.empty() ? "" : ",") + column;
        if (columns != header) return name + ": columns " + header + ", in the JSON " + columns;
    }
    return "";
}

std::string wrong_in_bench(const std::filesystem::path& directory, const std::string& name,
                           const std::string& schema) {
    return wrong_in_report(directory / ("bench_" + name + ".json"), schema, [&](const std::string& table) {
        return (directory / ("bench_" + table + ".csv")).string();
    });
}

}  // namespace crevice
