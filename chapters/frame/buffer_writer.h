// Buffers as files: NAME.npy with the exact floats and NAME.png to look at, or all of them in one frame.exr; and what
// passes.json says of them.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "chapters/images/exr.h"
#include "chapters/notebook/picture.h"

namespace crevice {

enum class BufferFiles {
    npy,  // NAME.npy and NAME.png
    exr,  // frame.exr alone, each buffer a layer of float32: NAME.X .Y .Z, lit.R .G .B, NAME.Z of depths, ao.raw, ao.blurred
};

class BufferWriter {
 public:
    BufferWriter(std::filesystem::path out, BufferFiles files, std::ostream& told)
        : out_(std::move(out)), files_(files), told_(told) {}

    // Writes both files and tells the picture's mapping, or keeps the buffer, which must outlive finish(). Throws
    // OutputError.
    void write(const std::string& name, const Image<float>& buffer, const Picture& picture);
    void write(const std::string& name, const Image3& buffer, const Picture& picture);
    // To be called last: writes frame.exr where that is asked for. Throws OutputError.
    void finish();

    // "NAME": {"shape", "min", "max", "mean", "nan", "inf", "hash"}, in the order of writing.
    const nlohmann::ordered_json& described() const { return described_; }

 private:
    void describe(const std::string& name, const Picture& picture, int components, const std::string& hash);

    std::filesystem::path out_;
    BufferFiles files_;
    std::ostream& told_;
    std::vector<ExrChannel> kept_;
    nlohmann::ordered_json described_ = nlohmann::ordered_json::object();
};

}  // namespace crevice
