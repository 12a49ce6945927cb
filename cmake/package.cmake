# What a user of the program gets: the command, its manual pages where help2man is installed, completion for three shells;
# and all of it, the libraries apart, as Debian packages: cmake --build --preset demo --target package.
install(TARGETS crevice COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE COMPONENT program RENAME copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/crevice)

set(made ${PROJECT_BINARY_DIR}/for_users)
set(completions ${made}/crevice.bash ${made}/_crevice ${made}/crevice.fish)
add_custom_command(OUTPUT ${completions} DEPENDS crevice
    COMMAND ${CMAKE_COMMAND} -E make_directory ${made}
    COMMAND crevice completion bash > ${made}/crevice.bash
    COMMAND crevice completion zsh > ${made}/_crevice
    COMMAND crevice completion fish > ${made}/crevice.fish)
set(for_users ${completions})
install(FILES ${made}/crevice.bash COMPONENT program RENAME crevice DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${made}/_crevice COMPONENT program DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${made}/crevice.fish COMPONENT program DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

find_program(HELP2MAN help2man)
if(HELP2MAN)
    set(manuals ${made}/manuals)
    add_custom_command(OUTPUT ${manuals}/crevice.1 DEPENDS crevice ${PROJECT_SOURCE_DIR}/cmake/manuals.cmake
        COMMAND ${CMAKE_COMMAND} -D CREVICE=$<TARGET_FILE:crevice> -D HELP2MAN=${HELP2MAN} -D VERSION=${PROJECT_VERSION}
            -D OUTPUT=${manuals} -P ${PROJECT_SOURCE_DIR}/cmake/manuals.cmake VERBATIM)
    list(APPEND for_users ${manuals}/crevice.1)
    install(DIRECTORY ${manuals}/ COMPONENT program DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()
add_custom_target(for_users ALL DEPENDS ${for_users})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME crevice)
set(CPACK_PACKAGE_CONTACT "The Crevice project <crevice@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGE_DESCRIPTION "Crevice draws scenes on the CPU, step by step as the tutorials on screen-space ambient occlusion do,
writes every buffer, and compares every method with rays.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME crevice)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libcrevice-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libglm-dev, libtbb-dev, libtinyobjloader-dev, zlib1g-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
include(CPack)
