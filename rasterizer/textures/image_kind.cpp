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
    Signature{0, "II\xbc"sv, "a JPEG XR picture"},
    Signature{8, "WEBP"sv, "a WebP picture"},
    Signature{8, "AVI "sv, "a film"},
    Signature{0, "8BPS"sv, "a Photoshop document (PSD)"},
    Signature{0, "\x76\x2f\x31\x01"sv, "an OpenEXR picture"},
    Signature{0, "\xabKTX 20\xbb"sv, "a KTX2 texture"},
    Signature{0, "\xabKTX 11\xbb"sv, "a KTX texture"},
    Signature{0, "DDS "sv, "a DDS texture"},
    Signature{0, "PVR\3"sv, "a PVR texture"},
    Signature{0, "\3RVP"sv, "a PVR texture"},
    Signature{0, "VTF\0"sv, "a VTF texture"},
    Signature{0, "sB"sv, "a Basis texture"},
    Signature{0, "\x13\xab\xa1\x5c"sv, "an ASTC texture"},
    Signature{0, "PKM "sv, "a PKM texture (ETC)"},
    Signature{4, "jP  "sv, "a JPEG 2000 picture"},
    Signature{0, "\xff\x4f\xff\x51"sv, "a JPEG 2000 picture"},
    Signature{0, "\xff\x0a"sv, "a JPEG XL picture"},
    Signature{4, "JXL "sv, "a JPEG XL picture"},
    Signature{4, "ftypavif"sv, "an AVIF picture"},
    Signature{4, "ftypheic"sv, "an HEIF picture"},
    Signature{4, "ftypheix"sv, "an HEIF picture"},
    Signature{4, "ftypmif1"sv, "an HEIF picture"},
    Signature{4, "ftyp"sv, "a film"},
    Signature{0, "\x1a\x45\xdf\xa3"sv, "a film"},
    Signature{0, "BPG\xfb"sv, "a BPG picture"},
    Signature{0, "FLIF"sv, "a FLIF picture"},
    Signature{0, "\x8aMNG\r\n\x1a\n"sv, "an MNG animation"},
    Signature{0, "\x8bJNG\r\n\x1a\n"sv, "a JNG picture"},
    Signature{0, "GIF8"sv, "a GIF picture"},
    Signature{0, "BM"sv, "a BMP picture"},
    Signature{0, "qoif"sv, "a QOI picture"},
    Signature{0, "\x01\xda"sv, "an SGI picture"},
    Signature{0, "\x59\xa6\x6a\x95"sv, "a Sun raster picture"},
    Signature{0, "SDPX"sv, "a DPX picture"},
    Signature{0, "XPDS"sv, "a DPX picture"},
    Signature{0, "\x80\x2a\x5f\xd7"sv, "a Cineon picture"},
    Signature{0, "FORM"sv, "an IFF picture"},
    Signature{0, "FOR4"sv, "an IFF picture"},
    Signature{0, "icns"sv, "an icon of macOS (ICNS)"},
    Signature{40, " EMF"sv, "an EMF drawing"},
    Signature{0, "\xd7\xcd\xc6\x9a"sv, "a WMF drawing"},
    Signature{0, "#?RADIANCE"sv, "a Radiance picture (HDR)"},
    Signature{0, "#?RGBE"sv, "a Radiance picture (HDR)"},
    Signature{0, "gimp xcf"sv, "a GIMP document (XCF)"},
    Signature{0, "BLENDER"sv, "a Blender document"},
    Signature{0, "glTF"sv, "a glTF scene"},
    Signature{0, "Kaydara FBX"sv, "an FBX scene"},
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

// A PNM, or the PFM, which holds floats.
std::string kind_of_netpbm(std::string_view bytes) {
    if (bytes.size() < 3 || bytes[0] != 'P' || !is_white(bytes[2])) return {};
    if (bytes[1] >= '1' && bytes[1] <= '7') return "a PNM picture";
    return bytes[1] == 'F' || bytes[1] == 'f' ? "a PFM picture" : "";
}

// The directory of an ICO or CUR: zeros, 1 or 2, and the count of its pictures, where a TGA has none of
// these.
std::string kind_of_icon(std::string_view bytes) {
    const bool directory = bytes.size() > 9 && bytes[0] == '\0' && bytes[1] == '\0' && bytes[3] == '\0' &&
                           (bytes[4] != '\0' || bytes[5] != '\0') && bytes[9] == '\0';
    if (!directory || (bytes[2] != 1 && bytes[2] != 2)) return {};
    return bytes[2] == 1 ? "a Windows icon (ICO)" : "a Windows cursor (CUR)";
}

// A manufacturer's number, a version, run-length coding, the bits of a pixel.
bool is_pcx(std::string_view bytes) {
    constexpr std::string_view kVersions = "\0\2\3\4\5"sv, kBits = "\1\2\4\x08"sv;
    return bytes.size() > 3 && bytes[0] == '\x0a' && kVersions.find(bytes[1]) != std::string_view::npos &&
           bytes[2] == 1 && kBits.find(bytes[3]) != std::string_view::npos;
}

// UTF-8 of the start of a text, as far as it is ASCII; texts in UTF-16 begin with a byte order mark or a `<`.
std::string start_of_text(std::string_view bytes) {
    constexpr std::size_t kMostLookedAt = 1024;
    std::string start(bytes.substr(0, kMostLookedAt));
    const bool wide = start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF") ||
                      start.starts_with("<\0"sv) || start.starts_with("\0<"sv);
    if (wide) std::erase(start, '\0');
    for (const std::string_view mark : {"\xEF\xBB\xBF"sv, "\xFF\xFE"sv, "\xFE\xFF"sv}) {
        if (start.starts_with(mark)) start.erase(0, mark.size());
    }
    return start;
}

bool is_text(std::string_view bytes) {
    return std::all_of(bytes.begin(), bytes.end(),
                       [](char c) { return is_white(c) || static_cast<unsigned char>(c) >= 0x20; });
}

std::string kind_of_text(std::string_view bytes) {
    std::string start = start_of_text(bytes);
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
    if (is_pcx(bytes)) return "a PCX picture";
    for (std::string kind : {kind_of_netpbm(bytes), kind_of_icon(bytes)}) {
        if (!kind.empty()) return kind;
    }
    return kind_of_text(bytes);
}

}  // namespace crevice
