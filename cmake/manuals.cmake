# Writes crevice.1 and a manual for each of its commands, such as crevice-render.1, as its --help tells of them:
#   cmake -D CREVICE=PROGRAM -D HELP2MAN=PROGRAM -D VERSION=N -D OUTPUT=DIRECTORY -P manuals.cmake
execute_process(COMMAND ${CREVICE} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE ";" "," help "${help}")  # what CMake takes for the end of an element
string(REGEX MATCH "^[^:]*: ([^\n.]+)" first_line "${help}")
set(about ${CMAKE_MATCH_1})
string(REGEX REPLACE "^.*\nSubcommands:\n" "" list "${help}")
string(REGEX MATCHALL "  [a-z]+  [^\n]+" commands "${list}")
file(REMOVE_RECURSE ${OUTPUT})
file(MAKE_DIRECTORY ${OUTPUT})

# What a manual is of, and the line beside its name.
function(write_manual words summary)
    string(REPLACE " " "-" name "${words}")
    execute_process(
        COMMAND ${HELP2MAN} --no-info --version-string=${VERSION} --name=${summary}
            --output=${OUTPUT}/${name}.1 "${words}"
        COMMAND_ERROR_IS_FATAL ANY)
    # help2man takes the words for a program's name; `man` looks for the file's.
    file(READ ${OUTPUT}/${name}.1 manual)
    string(TOUPPER ${name} title)
    string(REGEX REPLACE "(\n\\.TH )[A-Z]+" "\\1${title}" manual "${manual}")
    string(REPLACE "\n.SH NAME\n${words}" "\n.SH NAME\n${name}" manual "${manual}")
    file(WRITE ${OUTPUT}/${name}.1 "${manual}")
endfunction()

cmake_path(GET CREVICE PARENT_PATH folder)
set(ENV{PATH} "${folder}:$ENV{PATH}")
write_manual(crevice "${about}")
foreach(line IN LISTS commands)
    string(REGEX MATCH "^  ([a-z]+) +(.*)$" line "${line}")
    write_manual("crevice ${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}")
endforeach()
