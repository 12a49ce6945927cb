// Whether the tables that a benchmark writes are as their schema has them, in JSON and in CSV.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace crevice {

// The first thing that is wrong with a report, and with its tables as `csv_of(table)` files; empty where nothing is. `schema`
// is the name of a file in schemas/.
std::string wrong_in_report(const std::filesystem::path& json, const std::string& schema,
                            const std::function<std::string(const std::string& table)>& csv_of);
// Of the files that `crevice bench` and `crevice stability` write.
std::string wrong_in_bench(const std::filesystem::path& directory, const std::string& name,
                           const std::string& schema = "bench.schema.json");

}  // namespace crevice
