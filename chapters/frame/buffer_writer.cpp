#include "chapters/frame/buffer_writer.h"

#include <iostream>

#include "chapters/frame/frame_json.h"
#include "rasterizer/base/image_io.h"

namespace crevice {

void BufferWriter::write(const std::string& name, const Image<float>& buffer, const Picture& picture) {
    write_npy(out_ / (name + ".npy"), buffer);
    describe(name, picture, 1, content_hash(buffer));
}

void BufferWriter::write(const std::string& name, const Image3& buffer, const Picture& picture) {
    write_npy(out_ / (name + ".npy"), buffer);
    describe(name, picture, 3, content_hash(buffer));
}

void BufferWriter::describe(const std::string& name, const Picture& picture, int components,
                            const std::string& hash) {
    const std::filesystem::path path = out_ / (name + ".png");
    write_picture(path, picture);
    described_[name] = statistics_json(picture.size, components, picture.statistics);
    described_[name]["hash"] = hash;
    told_ << path.string() << ": " << picture.mapping << "\n";
}

}  // namespace crevice
