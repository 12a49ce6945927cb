#include "chapters/terminal/json_text.h"

namespace crevice {

using Json = nlohmann::ordered_json;

std::string json_text(const Json& document) {
    return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string json_line(const Json& document) {
    return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json json_from_text(const std::string& text) { return Json::parse(text); }

}  // namespace crevice
