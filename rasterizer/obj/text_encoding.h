// OBJ and MTL files in the encodings that editors save text in.
#pragma once

#include <string>

namespace crevice {

// The text of a file's bytes as UTF-8, without a byte order mark. UTF-16 of either byte order is converted;
// it is known by its byte order mark, and without one by the zero byte that half of every ASCII letter then
// is, of which most of such files consist. Anything else, such as Latin-1, is passed on as it is. Throws
// InputError naming the file when the text is UTF-32 or half a UTF-16 code is left at its end.
std::string utf8_text(std::string bytes, const std::string& name);

}  // namespace crevice
