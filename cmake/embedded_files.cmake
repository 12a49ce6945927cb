# Writes the source file that makes files a part of the program (chapters/notebook/embedded_files.h).
#
#     embed_files(OUT NAME PATH NAME PATH ...)
#
# NAME is what embedded_file() finds a file by, PATH where it lies.
function(embed_files out)
    set(blocks "")
    set(entries "")
    set(paths "")
    set(number 0)
    set(words ${ARGN})
    while(words)
        list(POP_FRONT words name path)
        list(APPEND paths ${path})
        string(APPEND blocks "    \"crevice_file_${number}: .incbin \\\"${path}\\\"\\n\"\n"
                             "    \"crevice_file_${number}_end: .byte 0\\n\"\n")
        string(APPEND declarations "extern const char crevice_file_${number}[], crevice_file_${number}_end[];\n")
        string(APPEND entries "    {\"${name}\", crevice_file_${number}, crevice_file_${number}_end},\n")
        math(EXPR number "${number} + 1")
    endwhile()
    file(CONFIGURE OUTPUT ${out} @ONLY CONTENT [[
// Made by cmake/embedded_files.cmake.
#include "chapters/notebook/embedded_files.h"

asm(".pushsection .rodata\n"
@blocks@    ".popsection\n");

extern "C" {
@declarations@}

namespace crevice {

std::optional<std::string_view> embedded_file(std::string_view path) {
    static constexpr struct {
        std::string_view name;
        const char *begin, *end;
    } kFiles[] = {
@entries@    };
    for (const auto& file : kFiles) {
        if (file.name == path) return std::string_view(file.begin, static_cast<std::size_t>(file.end - file.begin));
    }
    return std::nullopt;
}

}  // namespace crevice
]])
    set_source_files_properties(${out} PROPERTIES OBJECT_DEPENDS "${paths}" SKIP_PRECOMPILE_HEADERS ON)
endfunction()
