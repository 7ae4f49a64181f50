# Packages: their contents besides the files of cmake --install, and the settings of cpack.
#
# cmake --workflow --preset package makes tcbsample_*.deb, libtcb-spline-dev_*.deb, and an archive with the program as
# one static file, which runs on any Linux.

# The time of this version is used in the changelog and for the files in packages, so that each build makes the same
# bytes.
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  set(ENV{SOURCE_DATE_EPOCH} 1795651200)
endif()
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)

set(contact "the tcbsample authors") # as in LICENSE; there is no address

# Debian's documents of a package: manual and changes compressed, without times, and the licence as "copyright".
set(documents ${PROJECT_BINARY_DIR}/documents)
file(WRITE ${documents}/changelog.Debian
"tcbsample (${PROJECT_VERSION}-1) unstable; urgency=medium

  * This version; its changes are in changelog.gz.

 -- ${contact}  ${date}

tcbsample (0.2.0-1) unstable; urgency=medium

  * Rotations, fits, pieces, pictures and packages.

 -- ${contact}  Mon, 23 Nov 2026 00:00:00 +0000

tcbsample (0.1.0-1) unstable; urgency=medium

  * First version.

 -- ${contact}  Sun, 01 Nov 2026 00:00:00 +0000
")
configure_file(CHANGELOG.md ${documents}/changelog COPYONLY)
foreach(document changelog changelog.Debian)
  execute_process(COMMAND gzip -9nkf ${documents}/${document} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
foreach(page ${pages})
  cmake_path(ABSOLUTE_PATH page)
  cmake_path(GET page FILENAME name)
  set(compressed ${documents}/${name}.gz)
  add_custom_command(OUTPUT ${compressed} COMMAND gzip -9nc ${page} > ${compressed} DEPENDS ${page} VERBATIM)
  list(APPEND compressed_pages ${compressed})
  string(REGEX MATCH ".$" section ${name})
  install(FILES ${compressed} DESTINATION ${CMAKE_INSTALL_MANDIR}/man${section} COMPONENT program)
endforeach()
add_custom_target(compressed_manual ALL DEPENDS ${compressed_pages})
foreach(component program library)
  set(folder ${CMAKE_INSTALL_DATADIR}/doc/tcbsample)
  if(component STREQUAL library)
    set(folder ${CMAKE_INSTALL_DATADIR}/doc/libtcb-spline-dev)
  endif()
  install(FILES ${documents}/changelog.gz ${documents}/changelog.Debian.gz DESTINATION ${folder} COMPONENT ${component})
  install(FILES LICENSE DESTINATION ${folder} RENAME copyright COMPONENT ${component})
endforeach()

# The archive: the static program, its manual, its completions and the licence in one folder.
string(TOLOWER ${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR} system)
set(archive tcbsample-${PROJECT_VERSION}-${system})
add_executable(tcbsample_static src/main.cpp)
target_link_libraries(tcbsample_static PRIVATE tcbsample_hot tcbsample_cold)
target_link_options(tcbsample_static PRIVATE -static-pie)
set_target_properties(tcbsample_static PROPERTIES OUTPUT_NAME tcbsample RUNTIME_OUTPUT_DIRECTORY static)
install(TARGETS tcbsample_static DESTINATION ${archive} COMPONENT archive EXCLUDE_FROM_ALL)
install(FILES ${pages} LICENSE README.md CHANGELOG.md ${completions} DESTINATION ${archive}
        COMPONENT archive EXCLUDE_FROM_ALL)

set(CPACK_PACKAGE_NAME tcbsample)
set(CPACK_PACKAGE_VENDOR "${contact}")
set(CPACK_PACKAGE_CONTACT "${contact}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Kochanek-Bartels (TCB) curves through keyframes")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME tcbsample)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Reads keyframes with tension, continuity and bias as CSV, JSON or JSON Lines,
and prints samples of the curve through them: at equal steps of time or of arc
length, or as sparsely as a tolerance allows.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libtcb-spline-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "Curves with tension, continuity and bias, their derivatives, arc lengths and
segments, for any number of channels and any scalar type, in headers for C++20
that need the standard library only.")
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_ARCHIVE_ARCHIVE_FILE_NAME ${archive})
set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY OFF)

# Which components go into which kind of package.
file(WRITE ${documents}/components.cmake "set(ENV{SOURCE_DATE_EPOCH} $ENV{SOURCE_DATE_EPOCH})\n" [[
if(CPACK_GENERATOR STREQUAL "TGZ")
  set(CPACK_COMPONENTS_ALL archive)
  set(CPACK_PACKAGING_INSTALL_PREFIX "")
else()
  set(CPACK_COMPONENTS_ALL program library)
endif()
]])
set(CPACK_PROJECT_CONFIG_FILE ${documents}/components.cmake)
include(CPack)
