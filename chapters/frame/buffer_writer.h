// Buffers as files: NAME.npy with the exact floats and NAME.png to look at, or all of them in one frame.exr; and what
// passes.json says of them.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "chapters/images/exr.h"
#include "chapters/notebook/picture.h"
#include "rasterizer/base/run.h"

namespace crevice {

enum class BufferFiles {
    npy,  // NAME.npy and NAME.png
    exr,  // frame.exr alone, each buffer a layer of float32: NAME.X .Y .Z, lit.R .G .B, NAME.Z of depths, ao.raw, ao.blurred
};

class BufferWriter {
 public:
    BufferWriter(std::filesystem::path out, BufferFiles files, std::ostream& told)
        : out_(std::move(out)), files_(files), told_(told) {}

    // Takes note of a buffer, which must outlive finish(), and of what makes a picture of it.
    void add(const std::string& name, const Image<float>& buffer, std::function<Picture()> picture);
    void add(const std::string& name, const Image3& buffer, std::function<Picture()> picture);
    // To be called last, and once: makes the pictures and writes the files, a buffer a thread, and tells the pictures'
    // mappings in the order of adding. No thread holds more than one picture at a time. Throws OutputError.
    void finish(const Run& run);

    // After finish(): "NAME": {"shape", "min", "max", "mean", "nan", "inf", "hash"}, in the order of adding.
    const nlohmann::ordered_json& described() const { return described_; }

 private:
    // What is said of a buffer.
    struct Said {
        std::string mapping;
        nlohmann::ordered_json description;
    };
    struct Added {
        std::string name;
        std::vector<ExrChannel> channels;
        std::function<void(const std::filesystem::path&)> write_npy;
        std::function<std::string()> hash;
        std::function<Picture()> picture;
    };
    Said written(const Added& buffer, const Run& run) const;

    std::filesystem::path out_;
    BufferFiles files_;
    std::ostream& told_;
    std::vector<Added> added_;
    nlohmann::ordered_json described_ = nlohmann::ordered_json::object();
};

}  // namespace crevice
