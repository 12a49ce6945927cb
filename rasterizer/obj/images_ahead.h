// Pictures that are wanted soon, decoded a few at a time on all threads.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "rasterizer/base/run.h"
#include "rasterizer/textures/image_file.h"

namespace crevice {

struct DecodedFile {
    DecodedImage image;
    int exif_orientation = 1;         // exif_orientation.h
    std::optional<float> gamma = {};  // png_chunks.h
};

class ImagesAhead {
 public:
    explicit ImagesAhead(const Run& run) : run_(run) {}

    // That a picture will be taken, behind those that are expected already. One that is expected is so once.
    void expect(const std::filesystem::path& path, TextureEncoding encoding);

    // The picture in the file, whether it was expected or not. Decodes the next expected ones with it; those before
    // it are expected no longer. Throws InputError as decode_image does.
    DecodedFile take(const std::filesystem::path& path, TextureEncoding encoding, std::int64_t most_pixels);

 private:
    struct Expected {
        std::filesystem::path path;
        TextureEncoding encoding;
        bool tried = false;
        std::optional<DecodedFile> decoded = {};  // nothing where it could not be
    };
    void decode_next();

    Run run_;
    std::vector<Expected> expected_;
    std::set<std::pair<std::filesystem::path, TextureEncoding>> known_;
    std::size_t next_ = 0;  // those before it are taken, or passed over
};

}  // namespace crevice
