#include "chapters/bench/peer_session.h"

#include <cmath>
#include <cstring>
#include <sstream>

#include "rasterizer/base/error.h"

namespace crevice {

namespace {

ChildCommand peer_command(const std::filesystem::path& program, int threads, double patience_s) {
    std::error_code ignored;
    if (!std::filesystem::exists(program, ignored)) {
        throw InputError(
            program.string() +
            ": the peer was not built; install libegl-dev libgl-dev libegl-mesa0 libgl1-mesa-dri "
            "and run ./crevice.sh test, which builds it");
    }
    // llvmpipe draws in its caller's thread when told to use none of its own.
    const std::string own_threads = std::to_string(threads == 1 ? 0 : threads);
    return {program,
            {},
            {"LIBGL_ALWAYS_SOFTWARE=1", "GALLIUM_DRIVER=llvmpipe", "LP_NUM_THREADS=" + own_threads},
            patience_s};
}

[[noreturn]] void fail_nonsense(const std::string& program, const std::string& line) {
    throw InputError(program + ": not an answer (" + line.substr(0, 60) + "); build both programs anew");
}

// One after the other out of the bytes of an answer.
class FloatReader {
 public:
    explicit FloatReader(const std::string& bytes) : at_(bytes.data()) {}

    float next() {
        float value;
        std::memcpy(&value, at_, sizeof value);
        at_ += sizeof value;
        return value;
    }
    Image<float> image(Size size) {
        Image<float> result(size, 0.0f);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) result.at(x, y) = next();
        }
        return result;
    }
    // Three of four components, and the fourth.
    std::pair<Image3, Image<float>> image4(Size size) {
        std::pair<Image3, Image<float>> result{Image3(size, glm::vec3(0)), Image<float>(size, 0.0f)};
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const float r = next(), g = next(), b = next();
                result.first.set(x, y, {r, g, b});
                result.second.at(x, y) = next();
            }
        }
        return result;
    }

 private:
    const char* at_;
};

std::size_t pixels(Size size) {
    return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

}  // namespace

std::filesystem::path peer_program() { return own_program().parent_path() / "gl_ssao_peer"; }

PeerSession::PeerSession(const std::filesystem::path& program, int threads, double patience_s)
    : program_(program.string()), child_(peer_command(program, threads, patience_s)) {}

std::string PeerSession::load(const PeerScene& scene) {
    frame_ = scene.frame;
    const std::string bytes = stream_bytes(scene);
    child_.send("scene " + std::to_string(bytes.size()) + "\n");
    child_.send(bytes);
    const std::string line = child_.read_line(), ready = "ready ";
    if (!line.starts_with(ready)) fail_nonsense(program_, line);
    return line.substr(ready.size());
}

std::vector<PassClock> PeerSession::frame() {
    child_.send("frame\n");
    const std::string line = child_.read_line();
    std::istringstream numbers(line);
    std::vector<PassClock> times(passes().size());
    PassClock& whole = times.back();
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
        if (!(numbers >> times[i].wall_ms >> times[i].cpu_ms)) fail_nonsense(program_, line);
        whole.wall_ms += times[i].wall_ms;
        whole.cpu_ms += times[i].cpu_ms;
    }
    std::string more;
    if (numbers >> more || !std::isfinite(whole.wall_ms) || !(whole.wall_ms > 0))
        fail_nonsense(program_, line);
    return times;
}

PeerBuffers PeerSession::buffers() {
    child_.send("buffers\n");
    const Size picture{frame_.width, frame_.height}, ao_size{frame_.ao_width, frame_.ao_height},
        shadow{frame_.shadow.side, frame_.shadow.side};
    const bool lit = frame_.lit != 0;
    const std::size_t values =
        (4 + 1 + (lit ? 8 : 0)) * pixels(picture) + 2 * pixels(ao_size) + pixels(shadow);
    const std::string bytes = child_.read_bytes(values * sizeof(float));
    FloatReader reader(bytes);
    PeerBuffers result;
    std::tie(result.normal, result.view_depth) = reader.image4(picture);
    result.ndc_depth = reader.image(picture);
    result.ao_raw = reader.image(ao_size);
    result.ao_blurred = reader.image(ao_size);
    if (shadow.width > 0) result.shadow = reader.image(shadow);
    if (!lit) return result;
    result.lit = reader.image4(picture).first;
    result.lit_trilinear = reader.image4(picture).first;
    return result;
}

}  // namespace crevice
