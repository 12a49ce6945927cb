#include "chapters/images/exr.h"

#ifdef CREVICE_OPENEXR
#include <algorithm>
#include <cstring>
#include <map>
#include <new>
#include <set>

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>

#include "chapters/images/exr_slice.h"
#include "rasterizer/base/error.h"
#endif

namespace crevice {

#ifdef CREVICE_OPENEXR

namespace {

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

// Of "normal.X": "normal" and "X". Where the last part is no single letter, as of ao.raw, it names an image of its own.
struct ChannelName {
    std::string layer, letter;
};

ChannelName channel_name(const std::string& channel, const std::string& part) {
    const std::size_t point = channel.rfind('.');
    const std::string layer = point == std::string::npos ? part : channel.substr(0, point),
                      last = point == std::string::npos ? channel : channel.substr(point + 1);
    if (last.size() == 1) return {layer, last};
    return {layer.empty() ? last : layer + "_" + last, ""};
}

using PlanesByLetter = std::map<std::string, Image<float>>;

// Which of a layer's letters are one image, each group in its order: colours, vectors, and every other letter by itself.
std::vector<std::vector<std::string>> groups_of_letters(const PlanesByLetter& planes) {
    std::vector<std::vector<std::string>> groups;
    std::set<std::string> left;
    for (const auto& [letter, plane] : planes) left.insert(letter);
    for (const char* const family : {"RGB", "XYZ", "UV"}) {
        std::vector<std::string> group;
        for (const char* letter = family; *letter != '\0'; ++letter) {
            if (left.erase(std::string(1, *letter)) > 0) group.push_back(std::string(1, *letter));
        }
        if (!group.empty()) groups.push_back(std::move(group));
    }
    for (const std::string& letter : left) groups.push_back({letter});
    return groups;
}

// The first group has the layer's name and its alpha, others their letters behind it.
void add_layers(const std::string& name, PlanesByLetter planes, std::vector<ExrLayer>& layers) {
    Image<float> alpha;
    if (planes.size() > 1 && planes.contains("A")) {
        alpha = std::move(planes["A"]);
        planes.erase("A");
    }
    bool first = true;
    for (const std::vector<std::string>& group : groups_of_letters(planes)) {
        ExrLayer layer{
            name, {}, {}, std::string("RGB").find(group[0]) != std::string::npos && !group[0].empty()};
        std::string letters;
        for (const std::string& letter : group) {
            layer.planes.push_back(std::move(planes[letter]));
            letters += letter;
        }
        if (first) {
            layer.alpha = std::move(alpha);
        } else {
            layer.name += (name.empty() ? "" : ".") + letters;
        }
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
    std::vector<ChannelName> names;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        const std::string named = std::string(" (channel ") + channel.name() + ")";
        if (channel.channel().type == Imf::UINT) throw InputError("it holds whole numbers" + named);
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
            throw InputError("it holds fewer values than pixels" + named);
        values += static_cast<long long>(size.width) * size.height;
        if (values >= kMaxImageValues) throw InputError("it holds 2^30 values or more");
        names.push_back(channel_name(channel.name(), part));
    }
    Imf::InputPart input(file, number);
    // The last line stands last in most files: what is cut short is found before memory is taken.
    const auto read_into = [&](std::vector<Image<float>>& planes, Imath::V2i first, int top, int bottom) {
        Imf::FrameBuffer buffer;
        std::size_t i = 0;
        for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
            buffer.insert(channel.name(), exr_slice(planes[i++], first));
        input.setFrameBuffer(buffer);
        input.readPixels(top, bottom);
    };
    const bool tiled = header.hasTileDescription();
    if (!tiled) {
        std::vector<Image<float>> line(names.size(), Image<float>({size.width, 1}, 0.0f));
        read_into(line, {window.min.x, window.max.y}, window.max.y, window.max.y);
    }
    std::vector<Image<float>> planes(names.size(), Image<float>(size, 0.0f));
    read_into(planes, window.min, window.min.y, window.max.y);
    std::vector<std::string> order;
    std::map<std::string, PlanesByLetter> by_layer;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!by_layer.contains(names[i].layer)) order.push_back(names[i].layer);
        by_layer[names[i].layer][names[i].letter] = std::move(planes[i]);
    }
    for (const std::string& layer : order) add_layers(layer, std::move(by_layer[layer]), layers);
}

}  // namespace

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

std::vector<ExrLayer> exr_layers(const std::string&, const std::string&) {
    require_openexr();
    return {};
}

#endif

}  // namespace crevice
