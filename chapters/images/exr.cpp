#include "chapters/images/exr.h"

#include "rasterizer/base/error.h"

#ifdef CREVICE_OPENEXR
#include <algorithm>
#include <cstring>
#include <map>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>

#include "chapters/terminal/number_text.h"
#endif

namespace crevice {

#ifdef CREVICE_OPENEXR

namespace {

constexpr long long kMostValues = 1LL << 30;
constexpr int kLongestSide =
    1 << 17;  // what OpenEXR is to believe of a header, before anything of its size is allocated

class ByteReader : public Imf::IStream {
 public:
    ByteReader(const std::string& bytes, const std::string& name) : IStream(name.c_str()), bytes_(bytes) {}

    bool read(char* to, int count) override {
        const auto wanted = static_cast<std::uint64_t>(count);
        if (at_ > bytes_.size() || wanted > bytes_.size() - at_) throw InputError("cut short");
        std::memcpy(to, bytes_.data() + at_, wanted);
        at_ += wanted;
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t at) override { at_ = at; }

 private:
    const std::string& bytes_;
    std::uint64_t at_ = 0;
};

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

// Where OpenEXR finds the value of pixel (0, 0) of a window that begins at `first`.
Imf::Slice slice_of(const Image<float>& plane, Imath::V2i first) {
    const auto row = static_cast<std::ptrdiff_t>(sizeof(float)) * plane.stride;
    // It counts pixels from the origin of its window's coordinates.
    const std::uintptr_t base =
        reinterpret_cast<std::uintptr_t>(plane.pixels.data()) -
        static_cast<std::uintptr_t>(first.y * row + first.x * std::ptrdiff_t{sizeof(float)});
    return Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(base), sizeof(float),
                      static_cast<std::size_t>(row));
}

// What is known of a channel before its values are read.
struct FoundChannel {
    std::string layer, letter;  // of "normal.X": "normal" and "X"
    Image<float> plane;
};

FoundChannel found_channel(const std::string& channel, const std::string& part) {
    const std::size_t point = channel.rfind('.');
    const std::string layer = point == std::string::npos ? part : channel.substr(0, point),
                      last = point == std::string::npos ? channel : channel.substr(point + 1);
    if (last.size() == 1) return {layer, last, {}};
    // No component: an image of its own, such as ao.raw.
    return {layer.empty() ? last : layer + "_" + last, "", {}};
}

// The letters that belong together, in their order.
constexpr const char* kFamilies[] = {"RGB", "XYZ", "UV"};

// One layer's channels, by letter, as layers of letters that belong together.
void add_layers(const std::string& name, std::map<std::string, Image<float>> channels,
                std::vector<ExrLayer>& layers) {
    Image<float> alpha;
    if (channels.size() > 1 && channels.contains("A")) {
        alpha = std::move(channels["A"]);
        channels.erase("A");
    }
    bool first = true;
    for (int family = 0; family <= 3; ++family) {
        ExrLayer layer{name, {}, {}, family == 0};
        std::string letters;
        const auto take = [&](const std::string& letter) {
            const auto found = channels.find(letter);
            if (found == channels.end()) return;
            layer.planes.push_back(std::move(found->second));
            letters += letter;
            channels.erase(found);
        };
        for (const char* letter = family < 3 ? kFamilies[family] : ""; *letter != '\0'; ++letter)
            take(std::string(1, *letter));
        // What is left belongs to nothing: one layer each.
        while (family == 3 && !channels.empty()) {
            take(std::string(channels.begin()->first));
            layers.push_back({first ? name : name + (name.empty() ? "" : ".") + letters,
                              std::move(layer.planes), first ? std::move(alpha) : Image<float>(), false});
            layer.planes.clear();
            letters.clear();
            first = false;
        }
        if (layer.planes.empty()) continue;
        if (!first) layer.name += (name.empty() ? "" : ".") + letters;
        if (first) layer.alpha = std::move(alpha);
        first = false;
        layers.push_back(std::move(layer));
    }
}

// One part's channels. Throws InputError without the file's name.
void read_part(Imf::MultiPartInputFile& file, int number, long long& values, std::vector<ExrLayer>& layers) {
    const Imf::Header& header = file.header(number);
    if (header.hasType() && Imf::isDeepData(header.type())) throw InputError("it holds deep pixels");
    const Imath::Box2i window = header.dataWindow();
    const Size size{window.max.x - window.min.x + 1, window.max.y - window.min.y + 1};
    const std::string part = file.parts() > 1 && header.hasName() ? header.name() : "";
    std::vector<FoundChannel> found;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        const std::string named = std::string(" (channel ") + channel.name() + ")";
        if (channel.channel().type == Imf::UINT) throw InputError("it holds whole numbers" + named);
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
            throw InputError("it holds fewer values than pixels" + named);
        values += static_cast<long long>(size.width) * size.height;
        if (values > kMostValues) throw InputError("it holds more than 2^30 values");
        found.push_back(found_channel(channel.name(), part));
    }
    Imf::InputPart input(file, number);
    // The last line stands last in most files: what is cut short is found before memory is taken.
    const auto read_into = [&](std::vector<Image<float>>& planes, Imath::V2i first, int top, int bottom) {
        Imf::FrameBuffer buffer;
        std::size_t i = 0;
        for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
            buffer.insert(channel.name(), slice_of(planes[i++], first));
        input.setFrameBuffer(buffer);
        input.readPixels(top, bottom);
    };
    const bool tiled = header.hasTileDescription();
    if (!tiled) {
        std::vector<Image<float>> line(found.size(), Image<float>({size.width, 1}, 0.0f));
        read_into(line, {window.min.x, window.max.y}, window.max.y, window.max.y);
    }
    std::vector<Image<float>> planes(found.size(), Image<float>(size, 0.0f));
    read_into(planes, window.min, window.min.y, window.max.y);
    std::vector<std::string> order;
    std::map<std::string, std::map<std::string, Image<float>>> by_layer;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!by_layer.contains(found[i].layer)) order.push_back(found[i].layer);
        by_layer[found[i].layer][found[i].letter] = std::move(planes[i]);
    }
    for (const std::string& layer : order) add_layers(layer, std::move(by_layer[layer]), layers);
}

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
            if (channel.plane->size == size) buffer.insert(channel.name, slice_of(*channel.plane, {0, 0}));
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

std::vector<ExrLayer> exr_layers(const std::string& bytes, const std::string& name) {
    Imf::Header::setMaxImageSize(kLongestSide, kLongestSide);
    try {
        ByteReader reader(bytes, name);
        Imf::MultiPartInputFile file(reader, 0, false);
        std::vector<ExrLayer> layers;
        long long values = 0;
        for (int part = 0; part < file.parts(); ++part) read_part(file, part, values, layers);
        if (layers.empty()) throw InputError("it holds no channel");
        return layers;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        std::string what = error.what();
        std::ranges::replace(what, '\n', ' ');
        throw InputError(name + ": not an EXR that can be compared (" + what +
                         "); give one of float or half channels, in lines or tiles");
    }
}

#else

void require_openexr() {
    throw UsageError("EXR: this program was built without OpenEXR; install libopenexr-dev and build again");
}

std::string exr_bytes(std::span<const ExrChannel>) {
    require_openexr();
    return {};
}

std::vector<ExrLayer> exr_layers(const std::string&, const std::string&) {
    require_openexr();
    return {};
}

#endif

}  // namespace crevice
