// JSON documents as texts.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace crevice {

// On lines of its own. Names of files may hold any bytes: what is no UTF-8 becomes U+FFFD.
template <class Json>
std::string json_text(const Json& document) {
    return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace crevice
