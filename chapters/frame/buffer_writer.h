// Buffers as files: NAME.npy with the exact floats, NAME.png to look at, and what passes.json says of them.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include <nlohmann/json.hpp>

#include "chapters/notebook/picture.h"

namespace crevice {

class BufferWriter {
 public:
    BufferWriter(std::filesystem::path out, std::ostream& told) : out_(std::move(out)), told_(told) {}

    // Writes both files and tells the picture's mapping. Throws OutputError.
    void write(const std::string& name, const Image<float>& buffer, const Picture& picture);
    void write(const std::string& name, const Image3& buffer, const Picture& picture);

    // "NAME": {"shape", "min", "max", "mean", "nan", "inf", "hash"}, in the order of writing.
    const nlohmann::ordered_json& described() const { return described_; }

 private:
    void describe(const std::string& name, const Picture& picture, int components, const std::string& hash);

    std::filesystem::path out_;
    std::ostream& told_;
    nlohmann::ordered_json described_ = nlohmann::ordered_json::object();
};

}  // namespace crevice
