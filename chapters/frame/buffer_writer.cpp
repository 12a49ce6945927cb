#include "chapters/frame/buffer_writer.h"

#include <iostream>

#include "chapters/frame/frame_json.h"
#include "rasterizer/base/image_io.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

// Depths are z; the maps of AO are the parts of one layer.
std::string channel_of(const std::string& buffer) {
    const std::string ao = "ao_";
    return buffer.starts_with(ao) ? "ao." + buffer.substr(ao.size()) : buffer + ".Z";
}

}  // namespace

void BufferWriter::write(const std::string& name, const Image<float>& buffer, const Picture& picture) {
    if (files_ == BufferFiles::exr) {
        kept_.push_back({channel_of(name), &buffer});
    } else {
        write_npy(out_ / (name + ".npy"), buffer);
    }
    describe(name, picture, 1, content_hash(buffer));
}

void BufferWriter::write(const std::string& name, const Image3& buffer, const Picture& picture) {
    if (files_ == BufferFiles::exr) {
        const std::string letters = name == "lit" ? "RGB" : "XYZ";
        const Image<float>* const planes[] = {&buffer.x, &buffer.y, &buffer.z};
        for (std::size_t i = 0; i < letters.size(); ++i)
            kept_.push_back({name + "." + letters[i], planes[i]});
    } else {
        write_npy(out_ / (name + ".npy"), buffer);
    }
    describe(name, picture, 3, content_hash(buffer));
}

void BufferWriter::finish() {
    if (files_ != BufferFiles::exr || kept_.empty()) return;
    const std::filesystem::path path = out_ / "frame.exr";
    write_file_atomically(path, exr_bytes(kept_));
    told_ << path.string() << ":";
    for (const ExrChannel& channel : kept_) told_ << " " << channel.name;
    told_ << ", float32\n";
    kept_.clear();
}

void BufferWriter::describe(const std::string& name, const Picture& picture, int components,
                            const std::string& hash) {
    described_[name] = statistics_json(picture.size, components, picture.statistics);
    described_[name]["hash"] = hash;
    if (files_ == BufferFiles::exr) return;
    const std::filesystem::path path = out_ / (name + ".png");
    write_picture(path, picture);
    told_ << path.string() << ": " << picture.mapping << "\n";
}

}  // namespace crevice
