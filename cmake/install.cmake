# Installed: headers, both libraries, the CMake package (batten::batten, batten::shared) and batten.pc; also, if built,
# libbatten-svg (batten::svg, batten::svg_shared) and batten-svg.pc.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS batten batten_shared EXPORT batten-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
set(BATTEN_NOT_INSTALLED PATTERN svg_read.h EXCLUDE)
if(TARGET batten_svg)
  set(BATTEN_NOT_INSTALLED)
  install(TARGETS batten_svg batten_svg_shared EXPORT batten-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
install(DIRECTORY include/batten DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h" ${BATTEN_NOT_INSTALLED})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(BATTEN_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/batten)
install(EXPORT batten-targets NAMESPACE batten:: DESTINATION ${BATTEN_CMAKE_DIR})
file(WRITE ${CMAKE_BINARY_DIR}/cmake/batten-config.cmake
  "include(\${CMAKE_CURRENT_LIST_DIR}/batten-targets.cmake)\n")
write_basic_package_version_file(${CMAKE_BINARY_DIR}/cmake/batten-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/cmake/batten-config.cmake ${CMAKE_BINARY_DIR}/cmake/batten-config-version.cmake
  DESTINATION ${BATTEN_CMAKE_DIR})

# Relocatable: paths in batten.pc are relative to its own folder.
file(RELATIVE_PATH BATTEN_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" BATTEN_PC_PREFIX ${BATTEN_PC_PREFIX})
set(packages batten)
if(TARGET batten_svg)
  list(APPEND packages batten-svg)
endif()
foreach(package ${packages})
  configure_file(${CMAKE_CURRENT_LIST_DIR}/${package}.pc.in ${CMAKE_BINARY_DIR}/cmake/${package}.pc @ONLY)
  install(FILES ${CMAKE_BINARY_DIR}/cmake/${package}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
