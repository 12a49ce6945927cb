#include "chapters/images/exr.h"

#include "rasterizer/base/error.h"

#ifdef CREVICE_OPENEXR
#include <algorithm>
#include <cstring>

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>

#include "chapters/images/exr_slice.h"
#include "chapters/terminal/number_text.h"
#endif

namespace crevice {

#ifdef CREVICE_OPENEXR

namespace {

class ByteWriter : public Imf::OStream {
 public:
    ByteWriter() : OStream("memory") {}

    void write(const char* from, int count) override {
        const auto n = static_cast<std::size_t>(count);
        if (at_ + n > bytes.size()) bytes.resize(at_ + n);
        std::memcpy(bytes.data() + at_, from, n);
        at_ += n;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t at) override { at_ = static_cast<std::size_t>(at); }

    std::string bytes;

 private:
    std::size_t at_ = 0;
};

// All parts of a file share the picture's window; a smaller map lies in its upper left.
Imf::Header header_of(Size size, Size picture) {
    const Imath::V2i last(size.width - 1, size.height - 1);
    Imf::Header header(picture.width, picture.height, Imath::Box2i({0, 0}, last));
    header.compression() = Imf::ZIP_COMPRESSION;
    return header;
}

}  // namespace

void require_openexr() {}

std::string exr_bytes(std::span<const ExrChannel> channels) {
    std::vector<Size> sizes;
    for (const ExrChannel& channel : channels) {
        const auto same = [&](Size size) { return size == channel.plane->size; };
        if (std::ranges::none_of(sizes, same)) sizes.push_back(channel.plane->size);
    }
    Size picture;
    for (const Size& size : sizes)
        picture = {std::max(picture.width, size.width), std::max(picture.height, size.height)};
    std::vector<Imf::Header> headers;
    for (const Size& size : sizes) {
        Imf::Header header = header_of(size, picture);
        for (const ExrChannel& channel : channels) {
            if (channel.plane->size == size) header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
        }
        if (sizes.size() > 1) {
            header.setName("part_" + size_text(size));
            header.setType(Imf::SCANLINEIMAGE);
        }
        headers.push_back(header);
    }
    ByteWriter bytes;
    const auto write_part = [&](auto&& output, Size size) {
        Imf::FrameBuffer buffer;
        for (const ExrChannel& channel : channels) {
            if (channel.plane->size == size) buffer.insert(channel.name, exr_slice(*channel.plane, {0, 0}));
        }
        output.setFrameBuffer(buffer);
        output.writePixels(size.height);
    };
    if (headers.size() == 1) {
        write_part(Imf::OutputFile(bytes, headers[0]), sizes[0]);
    } else {
        Imf::MultiPartOutputFile file(bytes, headers.data(), static_cast<int>(headers.size()));
        for (std::size_t i = 0; i < headers.size(); ++i)
            write_part(Imf::OutputPart(file, static_cast<int>(i)), sizes[i]);
    }
    return std::move(bytes.bytes);
}

#else

void require_openexr() {
    throw UsageError("EXR: this program was built without OpenEXR; install libopenexr-dev and build again");
}

std::string exr_bytes(std::span<const ExrChannel>) {
    require_openexr();
    return {};
}

#endif

}  // namespace crevice
