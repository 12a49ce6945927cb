#include "rasterizer/textures/image_kind.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace crevice {
namespace {

using namespace std::string_view_literals;

struct Signature {
    std::size_t at;
    std::string_view bytes;
    const char* kind;
};

constexpr std::array kSignatures = {
    Signature{0, "II*\0"sv, "a TIFF picture"},
    Signature{0, "MM\0*"sv, "a TIFF picture"},
    Signature{0, "II+\0"sv, "a BigTIFF picture"},
    Signature{0, "MM\0+"sv, "a BigTIFF picture"},
    Signature{8, "WEBP"sv, "a WebP picture"},
    Signature{0, "8BPS"sv, "a Photoshop document (PSD)"},
    Signature{0, "\x76\x2f\x31\x01"sv, "an OpenEXR picture"},
    Signature{0, "\xabKTX 20\xbb"sv, "a KTX2 texture"},
    Signature{0, "\xabKTX 11\xbb"sv, "a KTX texture"},
    Signature{0, "DDS "sv, "a DDS texture"},
    Signature{0, "PVR\3"sv, "a PVR texture"},
    Signature{0, "\3RVP"sv, "a PVR texture"},
    Signature{0, "VTF\0"sv, "a VTF texture"},
    Signature{0, "sB"sv, "a Basis texture"},
    Signature{4, "jP  "sv, "a JPEG 2000 picture"},
    Signature{0, "\xff\x4f\xff\x51"sv, "a JPEG 2000 picture"},
    Signature{0, "\xff\x0a"sv, "a JPEG XL picture"},
    Signature{4, "JXL "sv, "a JPEG XL picture"},
    Signature{4, "ftypavif"sv, "an AVIF picture"},
    Signature{4, "ftypheic"sv, "an HEIF picture"},
    Signature{4, "ftypheix"sv, "an HEIF picture"},
    Signature{4, "ftypmif1"sv, "an HEIF picture"},
    Signature{4, "ftyp"sv, "a film"},
    Signature{0, "GIF8"sv, "a GIF picture"},
    Signature{0, "BM"sv, "a BMP picture"},
    Signature{0, "qoif"sv, "a QOI picture"},
    Signature{0, "#?RADIANCE"sv, "a Radiance picture (HDR)"},
    Signature{0, "#?RGBE"sv, "a Radiance picture (HDR)"},
    Signature{0, "gimp xcf"sv, "a GIMP document (XCF)"},
    Signature{0, "BLENDER"sv, "a Blender document"},
    Signature{0, "%PDF"sv, "a PDF document"},
    Signature{0, "%!PS"sv, "a PostScript document"},
    Signature{0, "\x93NUMPY"sv, "a NumPy array"},
    Signature{0, "PK\3\4"sv, "a ZIP archive"},
    Signature{0, "\x1f\x8b"sv, "a gzip archive"},
    Signature{0, "7z\xbc\xaf\x27\x1c"sv, "a 7z archive"},
    Signature{0, "Rar!"sv, "a RAR archive"},
};

// Of text, in small letters; the earlier wins.
constexpr std::array kTextMarks = {
    Signature{0, "version https://git-lfs"sv,
              "a Git LFS pointer, which `git lfs pull` replaces by the picture"},
    Signature{0, "<svg"sv, "an SVG drawing"},
    Signature{0, "<!doctype html"sv, "an HTML page"},
    Signature{0, "<html"sv, "an HTML page"},
};

bool is_white(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

char small_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_pnm(std::string_view bytes) {
    return bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '7' && is_white(bytes[2]);
}

bool is_text(std::string_view bytes) {
    return std::all_of(bytes.begin(), bytes.end(),
                       [](char c) { return is_white(c) || static_cast<unsigned char>(c) >= 0x20; });
}

std::string kind_of_text(std::string_view bytes) {
    constexpr std::size_t kMostLookedAt = 1024;
    std::string start(bytes.substr(0, kMostLookedAt));
    if (start.starts_with("\xEF\xBB\xBF")) start.erase(0, 3);
    if (!is_text(start)) return {};
    start.erase(
        0, static_cast<std::size_t>(std::find_if_not(start.begin(), start.end(), is_white) - start.begin()));
    std::transform(start.begin(), start.end(), start.begin(), small_letter);
    const bool markup = start.starts_with('<');
    for (const Signature& mark : kTextMarks) {
        if (markup ? start.find(mark.bytes) != std::string::npos : start.starts_with(mark.bytes))
            return mark.kind;
    }
    return markup ? "an XML document" : "text";
}

}  // namespace

std::string unread_kind(std::string_view bytes) {
    if (bytes.empty()) return "an empty file";
    for (const Signature& s : kSignatures) {
        if (bytes.size() >= s.at && bytes.substr(s.at).starts_with(s.bytes)) return s.kind;
    }
    if (is_pnm(bytes)) return "a PNM picture";
    return kind_of_text(bytes);
}

}  // namespace crevice
