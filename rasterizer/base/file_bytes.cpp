#include "rasterizer/base/file_bytes.h"

#include <fstream>
#include <system_error>

#include "rasterizer/base/error.h"

namespace crevice {

std::string read_file(const std::filesystem::path& path, std::uintmax_t max_bytes) {
    namespace fs = std::filesystem;
    const std::string name = path.string();
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) {
        throw InputError(name + ": there is no such file; check the path");
    }
    if (error) throw InputError(name + ": cannot be read (" + error.message() + "); check the path");
    if (status.type() == fs::file_type::directory) {
        throw InputError(name + ": is a directory; give the path of a file in it");
    }
    if (status.type() != fs::file_type::regular) {
        throw InputError(name + ": is not a regular file; give the path of one");
    }
    const std::uintmax_t length = fs::file_size(path, error);
    if (error) throw InputError(name + ": cannot be read (" + error.message() + "); check the path");
    if (length > max_bytes) {
        throw InputError(name + ": the file is too large (" + std::to_string(length) + " bytes, at most " +
                         std::to_string(max_bytes) + "); split or simplify it");
    }
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw InputError(name + ": cannot be opened; check its permissions");
    std::string bytes(static_cast<std::size_t>(length), '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(length));
    if (static_cast<std::uintmax_t>(stream.gcount()) != length) {
        throw InputError(name + ": reading stopped early (after " + std::to_string(stream.gcount()) + " of " +
                         std::to_string(length) + " bytes); check the disk");
    }
    return bytes;
}

}  // namespace crevice
