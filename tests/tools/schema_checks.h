// Whether a JSON document is as a schema has it: of JSON Schema 2020-12 what schemas/ uses, and nothing else.
#pragma once

#include <string>
#include <utility>

#include <nlohmann/json.hpp>

namespace crevice {

class SchemaChecks {
 public:
    explicit SchemaChecks(nlohmann::json schema) : schema_(std::move(schema)) {}

    // The first thing that is not as the schema has it, with its place; empty where all is.
    std::string against(const nlohmann::json& document) const { return wrong(document, schema_, ""); }

 private:
    // The first thing in `value`, at `place` of the document, that is not as this part of the schema has it.
    std::string wrong(const nlohmann::json& value, const nlohmann::json& schema,
                      const std::string& place) const;
    std::string wrong_member(const nlohmann::json& value, const nlohmann::json& schema,
                             const std::string& place) const;
    std::string wrong_item(const nlohmann::json& value, const nlohmann::json& schema,
                           const std::string& place) const;

    nlohmann::json schema_;
};

// Of schemas/NAME.
SchemaChecks stored_schema(const std::string& name);

}  // namespace crevice
