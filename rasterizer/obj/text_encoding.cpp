#include "rasterizer/obj/text_encoding.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "rasterizer/base/error.h"

namespace crevice {
namespace {

enum class ByteOrder { little, big };

constexpr std::uint32_t kReplacement = 0xfffd;  // stands for half of a surrogate pair

void append_utf8(std::string& text, std::uint32_t code) {
    const auto put = [&text](std::uint32_t byte) { text.push_back(static_cast<char>(byte)); };
    if (code < 0x80) return put(code);
    if (code < 0x800) {
        put(0xc0 | code >> 6);
    } else {
        if (code < 0x10000) {
            put(0xe0 | code >> 12);
        } else {
            put(0xf0 | code >> 18);
            put(0x80 | (code >> 12 & 0x3f));
        }
        put(0x80 | (code >> 6 & 0x3f));
    }
    put(0x80 | (code & 0x3f));
}

std::string utf8_from_utf16(std::string_view bytes, ByteOrder order, const std::string& name) {
    if (bytes.size() % 2 != 0) {
        throw InputError(name + ": the text is UTF-16 cut short (" + std::to_string(bytes.size()) +
                         " bytes); save it again, as UTF-8");
    }
    const auto unit = [&](std::size_t at) {
        const auto first = static_cast<unsigned char>(bytes[at]),
                   second = static_cast<unsigned char>(bytes[at + 1]);
        return order == ByteOrder::little ? first | std::uint32_t{second} << 8
                                          : second | std::uint32_t{first} << 8;
    };
    std::string text;
    text.reserve(bytes.size() / 2);
    for (std::size_t at = 0; at < bytes.size(); at += 2) {
        const std::uint32_t code = unit(at);
        const bool surrogate = code >= 0xd800 && code < 0xe000, leads = surrogate && code < 0xdc00;
        const std::uint32_t next = leads && at + 2 < bytes.size() ? unit(at + 2) : 0;
        if (next >= 0xdc00 && next < 0xe000) {
            append_utf8(text, 0x10000 + ((code - 0xd800) << 10) + (next - 0xdc00));
            at += 2;
        } else {
            append_utf8(text, surrogate ? kReplacement : code);
        }
    }
    return text;
}

// Whether of the first letters one byte of each pair is mostly zero, and the other one almost never. Letters
// outside Latin-1, as in a comment, have no zero byte; a foreign letter whose other byte is zero is rare.
bool looks_like_utf16(std::string_view bytes, ByteOrder order) {
    constexpr std::size_t kLeast = 4, kMost = 65536;  // letters
    const std::size_t letters = std::min(bytes.size() / 2, kMost);
    const std::size_t high = order == ByteOrder::little ? 1 : 0;
    std::size_t high_zeros = 0, low_zeros = 0;
    for (std::size_t letter = 0; letter < letters; ++letter) {
        high_zeros += bytes[2 * letter + high] == '\0' ? 1 : 0;
        low_zeros += bytes[2 * letter + 1 - high] == '\0' ? 1 : 0;
    }
    return letters >= kLeast && high_zeros > letters / 2 && low_zeros <= letters / 16;
}

}  // namespace

std::string utf8_text(std::string bytes, const std::string& name) {
    using namespace std::string_view_literals;
    const std::string_view view = bytes;
    if (view.starts_with("\xEF\xBB\xBF"sv)) return bytes.substr(3);
    if (view.starts_with("\xFF\xFE\0\0"sv) || view.starts_with("\0\0\xFE\xFF"sv)) {
        throw InputError(name + ": the text is UTF-32 (its byte order mark says so); save it as UTF-8");
    }
    if (view.starts_with("\xFF\xFE"sv)) return utf8_from_utf16(view.substr(2), ByteOrder::little, name);
    if (view.starts_with("\xFE\xFF"sv)) return utf8_from_utf16(view.substr(2), ByteOrder::big, name);
    for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
        if (looks_like_utf16(view, order)) return utf8_from_utf16(view, order, name);
    }
    return bytes;
}

}  // namespace crevice
