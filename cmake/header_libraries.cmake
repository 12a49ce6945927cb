# The libraries that are nothing but headers, for builds that run on another machine than this. They get a directory of
# their own, because /usr/include as a whole holds the headers of this machine.

set(header_directory ${PROJECT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${header_directory})
foreach(name glm CLI nlohmann doctest stb tiny_obj_loader.h)
    if(NOT EXISTS /usr/include/${name})
        message(FATAL_ERROR "/usr/include/${name} was not found; ${missing_advice}")
    endif()
    file(CREATE_LINK /usr/include/${name} ${header_directory}/${name} SYMBOLIC)
endforeach()
foreach(target glm::glm CLI11::CLI11 nlohmann_json::nlohmann_json doctest::doctest)
    add_library(${target} INTERFACE IMPORTED)
    target_include_directories(${target} SYSTEM INTERFACE ${header_directory})
endforeach()
set(STB_INCLUDE_DIR ${header_directory})
set(TINYOBJLOADER_INCLUDE_DIR ${header_directory})
