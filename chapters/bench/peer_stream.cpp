#include "chapters/bench/peer_stream.h"

#include <cstring>
#include <type_traits>

#include "rasterizer/base/error.h"

namespace crevice {

namespace {

// The stream: the frame, then each list as its length and its elements.
class StreamWriter {
 public:
    template <class T>
    void value(const T& one) {
        elements(&one, 1);
    }
    template <class T>
    void list(const std::vector<T>& all) {
        value(std::uint64_t{all.size()});
        elements(all.data(), all.size());
    }
    std::string bytes;

 private:
    template <class T>
    void elements(const T* first, std::size_t count) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes.append(reinterpret_cast<const char*>(first), count * sizeof(T));
    }
};

class StreamReader {
 public:
    explicit StreamReader(std::string_view bytes) : left_(bytes) {}

    template <class T>
    void value(T& one) {
        std::memcpy(&one, take(sizeof(T), 1).data(), sizeof(T));
    }
    template <class T>
    void list(std::vector<T>& all) {
        std::uint64_t count = 0;
        value(count);
        const std::string_view bytes = take(sizeof(T), count);
        all.resize(count);
        if (count > 0) std::memcpy(all.data(), bytes.data(), bytes.size());
    }
    bool at_end() const { return left_.empty(); }

 private:
    std::string_view take(std::size_t element, std::uint64_t count) {
        if (count > left_.size() / element) {
            throw InputError("scene stream: " + std::to_string(left_.size()) + " bytes left, too few for " +
                             std::to_string(count) + " elements; both programs must be of one build");
        }
        const std::string_view taken = left_.substr(0, element * count);
        left_.remove_prefix(taken.size());
        return taken;
    }

    std::string_view left_;
};

// Each part of a scene but its textures, in the order of the stream.
template <class Stream, class Scene>
void pass_parts(Stream& stream, Scene& scene) {
    stream.value(scene.frame);
    stream.list(scene.numbers);
    stream.list(scene.blur_weights);
    stream.list(scene.samples);
    stream.list(scene.noise);
    stream.list(scene.random_map);
    stream.list(scene.vertices);
    stream.list(scene.surface_vertices);
    stream.list(scene.indices);
    stream.list(scene.draws);
    stream.list(scene.sky);
}
template <class Stream, class Texture>
void pass_texture(Stream& stream, Texture& texture) {
    for (auto* number : {&texture.width, &texture.height, &texture.levels, &texture.probes, &texture.clamps_u,
                         &texture.clamps_v})
        stream.value(*number);
    stream.list(texture.texels);
}

}  // namespace

std::vector<std::string> peer_passes(const PeerFrame& frame) {
    std::vector<std::string> passes = {"normal_depth", "ao", "blur"};
    if (frame.shadow.side > 0) passes.push_back("shadow");
    if (frame.lit != 0) passes.push_back("lit");
    if (frame.sky_side > 0) passes.push_back("sky");
    passes.push_back("frame");
    return passes;
}

std::string stream_bytes(const PeerScene& scene) {
    StreamWriter writer;
    pass_parts(writer, scene);
    writer.value(std::uint64_t{scene.textures.size()});
    for (const PeerTexture& texture : scene.textures) pass_texture(writer, texture);
    return std::move(writer.bytes);
}

PeerScene scene_from_stream(std::string_view bytes) {
    StreamReader reader(bytes);
    PeerScene scene;
    pass_parts(reader, scene);
    std::uint64_t textures = 0;
    reader.value(textures);
    for (; textures > 0; --textures) pass_texture(reader, scene.textures.emplace_back());
    if (!reader.at_end()) {
        throw InputError("scene stream: bytes are left over; both programs must be of one build");
    }
    return scene;
}

}  // namespace crevice
