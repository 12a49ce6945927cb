#include "chapters/frame/buffer_writer.h"

#include <exception>
#include <iostream>

#include "chapters/frame/frame_json.h"
#include "rasterizer/base/image_io.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

// Depths are z; the maps of AO are the parts of one layer.
std::string channel_of(const std::string& buffer) {
    const std::string ao = "ao_";
    return buffer.starts_with(ao) ? "ao." + buffer.substr(ao.size()) : buffer + ".Z";
}

}  // namespace

void BufferWriter::add(const std::string& name, const Image<float>& buffer,
                       std::function<Picture()> picture) {
    added_.push_back({name,
                      {{channel_of(name), &buffer}},
                      [&buffer](const std::filesystem::path& path) { write_npy(path, buffer); },
                      [&buffer] { return content_hash(buffer); },
                      std::move(picture)});
}

void BufferWriter::add(const std::string& name, const Image3& buffer, std::function<Picture()> picture) {
    const std::string letters = name == "lit" ? "RGB" : "XYZ";
    const Image<float>* const planes[] = {&buffer.x, &buffer.y, &buffer.z};
    std::vector<ExrChannel> channels;
    for (std::size_t i = 0; i < letters.size(); ++i) channels.push_back({name + "." + letters[i], planes[i]});
    added_.push_back({name, std::move(channels),
                      [&buffer](const std::filesystem::path& path) { write_npy(path, buffer); },
                      [&buffer] { return content_hash(buffer); }, std::move(picture)});
}

BufferWriter::Said BufferWriter::written(const Added& buffer, const Run& run) const {
    const Picture picture = buffer.picture();
    if (files_ == BufferFiles::npy) {
        buffer.write_npy(out_ / (buffer.name + ".npy"));
        write_picture(out_ / (buffer.name + ".png"), picture, run);
    }
    return {picture.mapping,
            statistics_json(picture.size, static_cast<int>(buffer.channels.size()), picture.statistics)};
}

void BufferWriter::finish(const Run& run) {
    std::vector<Said> said(added_.size());
    std::vector<std::string> hashes(added_.size());
    std::vector<std::exception_ptr> failures(added_.size());
    // A buffer's hash takes about as long as its files, and no two threads can share it.
    parallel_for(static_cast<int>(2 * added_.size()), run, [&](int i) {
        const auto at = static_cast<std::size_t>(i) / 2;
        if (i % 2 == 0) {
            hashes[at] = added_[at].hash();
            return;
        }
        try {
            said[at] = written(added_[at], run);
        } catch (...) {
            failures[at] = std::current_exception();
        }
    });
    std::vector<ExrChannel> channels;
    for (std::size_t i = 0; i < added_.size(); ++i) {
        if (failures[i]) std::rethrow_exception(failures[i]);
        const std::string& name = added_[i].name;
        described_[name] = std::move(said[i].description);
        described_[name]["hash"] = hashes[i];
        channels.insert(channels.end(), added_[i].channels.begin(), added_[i].channels.end());
        if (files_ == BufferFiles::npy)
            told_ << (out_ / (name + ".png")).string() << ": " << said[i].mapping << "\n";
    }
    if (files_ != BufferFiles::exr || channels.empty()) return;
    const std::filesystem::path path = out_ / "frame.exr";
    write_file_atomically(path, exr_bytes(channels));
    told_ << path.string() << ":";
    for (const ExrChannel& channel : channels) told_ << " " << channel.name;
    told_ << ", float32\n";
}

}  // namespace crevice
