#include "tests/tools/schema_checks.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>

namespace crevice {

namespace {

using Json = nlohmann::json;

bool is_of(const Json& value, const std::string& type) {
    if (type == "number") return value.is_number();
    if (type == "integer") return value.is_number_integer();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "null") return value.is_null();
    if (type == "array") return value.is_array();
    return type == "object" && value.is_object();
}

std::string wrong_type(const Json& value, const Json& type, const std::string& place) {
    const Json types = type.is_array() ? type : Json::array({type});
    const bool fits = std::any_of(types.begin(), types.end(), [&](const Json& t) { return is_of(value, t); });
    return fits ? "" : place + ": " + value.dump() + " is no " + type.dump();
}

// What names of this form are to be; null where the schema has no such form.
const Json* matching(const Json& schema, const std::string& name) {
    if (!schema.contains("patternProperties")) return nullptr;
    for (const auto& [form, member] : schema["patternProperties"].items()) {
        if (std::regex_search(name, std::regex(form))) return &member;
    }
    return nullptr;
}

}  // namespace

std::string SchemaChecks::wrong(const Json& value, const Json& schema, const std::string& place) const {
    static const std::set<std::string> known = {"$schema",  "$ref",     "title",      "description",
                                                "type",     "enum",     "properties", "items",
                                                "required", "minItems", "maxItems",   "additionalProperties",
                                                "minimum",  "maximum",  "$defs",      "patternProperties"};
    for (const auto& [word, ignored] : schema.items()) {
        if (!known.contains(word)) return "the schema says more than this test knows: " + word;
    }
    if (schema.contains("$ref"))
        return wrong(value, schema_.at(Json::json_pointer(schema["$ref"].get<std::string>().substr(1))),
                     place);
    if (schema.contains("type")) {
        const std::string found = wrong_type(value, schema["type"], place);
        if (!found.empty()) return found;
    }
    if (schema.contains("enum") &&
        std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end())
        return place + ": " + value.dump() + " is none of " + schema["enum"].dump();
    if (value.is_number() && (value.get<double>() < schema.value("minimum", value.get<double>()) ||
                              value.get<double>() > schema.value("maximum", value.get<double>())))
        return place + ": " + value.dump() + " is out of range";
    if (value.is_object()) return wrong_member(value, schema, place);
    if (value.is_array()) return wrong_item(value, schema, place);
    return "";
}

std::string SchemaChecks::wrong_member(const Json& value, const Json& schema,
                                       const std::string& place) const {
    for (const Json& name : schema.value("required", Json::array())) {
        if (!value.contains(name.get<std::string>())) return place + ": has no " + name.dump();
    }
    const Json properties = schema.value("properties", Json::object());
    const Json others = schema.value("additionalProperties", Json(true));
    for (const auto& [name, member] : value.items()) {
        const std::string there = place + "/" + name;
        if (properties.contains(name)) {
            const std::string found = wrong(member, properties[name], there);
            if (!found.empty()) return found;
        } else if (const Json* pattern = matching(schema, name)) {
            const std::string found = wrong(member, *pattern, there);
            if (!found.empty()) return found;
        } else if (others.is_object()) {
            const std::string found = wrong(member, others, there);
            if (!found.empty()) return found;
        } else if (!others.get<bool>()) {
            return there + ": not in the schema";
        }
    }
    return "";
}

std::string SchemaChecks::wrong_item(const Json& value, const Json& schema, const std::string& place) const {
    if (value.size() < schema.value("minItems", std::size_t{0}) ||
        value.size() > schema.value("maxItems", value.size()))
        return place + ": holds " + std::to_string(value.size()) + " items";
    if (!schema.contains("items")) return "";
    for (std::size_t i = 0; i < value.size(); ++i) {
        const std::string found = wrong(value[i], schema["items"], place + "/" + std::to_string(i));
        if (!found.empty()) return found;
    }
    return "";
}

SchemaChecks stored_schema(const std::string& name) {
    std::ifstream stream(CREVICE_SCHEMA_DIR "/" + name);
    return SchemaChecks(Json::parse(stream));
}

}  // namespace crevice
