#include "chapters/notebook/table.h"

#include <algorithm>
#include <ostream>

#include <nlohmann/json.hpp>

#include "chapters/terminal/json_text.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/output_directory.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

using Json = nlohmann::ordered_json;

std::string shown(const TableValue& cell) {
    return cell.kind == TableValue::Kind::number ? decimal_text(cell.number, cell.decimals) : cell.text;
}

std::string csv_word(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

Json json_value(const TableValue& cell) {
    switch (cell.kind) {
        case TableValue::Kind::nothing: return nullptr;
        case TableValue::Kind::text: return cell.text;
        case TableValue::Kind::number: return cell.number;
    }
    return nullptr;
}

std::string padded(const std::string& text, std::size_t width, bool to_the_right) {
    const std::string spaces(width - std::min(width, text.size()), ' ');
    return to_the_right ? spaces + text : text + spaces;
}

}  // namespace

std::string table_text(const Table& table) {
    std::vector<std::size_t> widths;
    std::vector<bool> numbers(table.columns.size(), false);
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        widths.push_back(table.columns[c].size());
        for (const std::vector<TableValue>& row : table.rows) {
            widths[c] = std::max(widths[c], shown(row[c]).size());
            numbers[c] = numbers[c] || row[c].kind == TableValue::Kind::number;
        }
    }
    std::string text;
    const auto add_line = [&](const auto& word_of) {
        std::string line;
        for (std::size_t c = 0; c < widths.size(); ++c) {
            line += (c == 0 ? "" : "  ") + padded(word_of(c), widths[c], numbers[c]);
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    };
    add_line([&](std::size_t c) { return table.columns[c]; });
    for (const std::vector<TableValue>& row : table.rows)
        add_line([&](std::size_t c) { return shown(row[c]); });
    return text;
}

std::string facts_text(const Facts& facts) {
    std::size_t width = 0;
    for (const auto& [name, value] : facts) width = std::max(width, name.size());
    std::string text;
    for (const auto& [name, value] : facts) text += padded(name, width, false) + "  " + value + "\n";
    return text;
}

std::string csv_text(const Table& table) {
    std::string text;
    for (const std::string& column : table.columns) text += (text.empty() ? "" : ",") + csv_word(column);
    text += "\n";
    for (const std::vector<TableValue>& row : table.rows) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            const bool is_number = row[c].kind == TableValue::Kind::number;
            text += (c == 0 ? "" : ",") + (is_number ? shortest_text(row[c].number) : csv_word(row[c].text));
        }
        text += "\n";
    }
    return text;
}

std::string json_text(const BenchReport& report) {
    Json facts = Json::object(), tables = Json::object();
    for (const auto& [name, value] : report.facts) facts[name] = value;
    for (const Table& table : report.tables) {
        Json rows = Json::array();
        for (const std::vector<TableValue>& row : table.rows) {
            Json object = Json::object();
            for (std::size_t c = 0; c < row.size(); ++c) object[table.columns[c]] = json_value(row[c]);
            rows.push_back(std::move(object));
        }
        tables[table.name] = std::move(rows);
    }
    // Words of others, such as a renderer's, may hold anything.
    return json_text(Json{{"facts", facts}, {"tables", tables}});
}

void write_report(const BenchReport& report, const std::filesystem::path& directory, std::ostream& out) {
    try_output_directory(directory);
    const auto write = [&](const std::string& name, const std::string& text) {
        write_file_atomically(directory / name, text);
        out << (directory / name).string() << "\n";
    };
    for (const Table& table : report.tables) write("bench_" + table.name + ".csv", csv_text(table));
    write("bench_" + report.name + ".json", json_text(report));
}

}  // namespace crevice
