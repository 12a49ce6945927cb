// JSON documents as texts, and texts as JSON. In one .cpp, because both take long to compile.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace crevice {

// On lines of its own. Names of files may hold any bytes: what is no UTF-8 becomes U+FFFD.
std::string json_text(const nlohmann::ordered_json& document);
// The same on one line, that does not end.
std::string json_line(const nlohmann::ordered_json& document);

// Throws nlohmann::json::exception for what is no JSON.
nlohmann::ordered_json json_from_text(const std::string& text);

}  // namespace crevice
