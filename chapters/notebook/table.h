// What a benchmark found: facts and tables, on the terminal, as CSV and as JSON.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace crevice {

// Text, a number, or nothing. Files hold the whole number; `decimals` is for the eye.
struct TableValue {
    enum class Kind { nothing, text, number };

    Kind kind = Kind::nothing;
    std::string text;
    double number = 0;
    int decimals = 2;

    TableValue() = default;
    TableValue(const char* words) : kind(Kind::text), text(words) {}
    TableValue(std::string words) : kind(Kind::text), text(std::move(words)) {}
    TableValue(double value, int shown_decimals = 2)
        : kind(Kind::number), number(value), decimals(shown_decimals) {}
};

struct Table {
    std::string name;                  // of its file: bench_NAME.csv
    std::vector<std::string> columns;  // what and unit, as words joined by _
    std::vector<std::vector<TableValue>> rows;
};

using Facts = std::vector<std::pair<std::string, std::string>>;

struct BenchReport {
    std::string name;  // of its file: bench_NAME.json
    Facts facts;
    std::vector<Table> tables;
};

// Columns aligned: words to the left, numbers to the right.
std::string table_text(const Table& table);
std::string facts_text(const Facts& facts);
// RFC 4180 with a header line; numbers read back as the same double.
std::string csv_text(const Table& table);
// {"facts": {...}, "tables": {NAME: [{COLUMN: value, ...}, ...], ...}}
std::string json_text(const BenchReport& report);

// DIR/bench_NAME.csv of every table and DIR/bench_NAME.json, each named on `out`. Throws OutputError.
void write_report(const BenchReport& report, const std::filesystem::path& directory, std::ostream& out);

}  // namespace crevice
