# Installed: headers, the libraries (one of the two kinds when BUILD_SHARED_LIBS is set), the CMake package
# (batten::batten, batten::shared) and batten.pc; also, if built, libbatten-svg (batten::svg, batten::svg_shared) and
# batten-svg.pc.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

function(install_libraries static shared)
  set(targets)
  if("static" IN_LIST BATTEN_KINDS)
    list(APPEND targets ${static})
  endif()
  if("shared" IN_LIST BATTEN_KINDS)
    list(APPEND targets ${shared})
  endif()
  install(TARGETS ${targets} EXPORT batten-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endfunction()
install_libraries(batten batten_shared)
set(BATTEN_NOT_INSTALLED PATTERN svg_read.h EXCLUDE)
if(TARGET batten_svg)
  set(BATTEN_NOT_INSTALLED)
  install_libraries(batten_svg batten_svg_shared)
endif()
install(DIRECTORY include/batten DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp" ${BATTEN_NOT_INSTALLED})
install(FILES ${PROJECT_BINARY_DIR}/include/batten/names.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/batten)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(BATTEN_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/batten)
install(EXPORT batten-targets NAMESPACE batten:: DESTINATION ${BATTEN_CMAKE_DIR})
# Where one kind alone is installed, batten::batten and batten::svg are of that kind.
file(WRITE ${PROJECT_BINARY_DIR}/cmake/batten-config.cmake "include(\${CMAKE_CURRENT_LIST_DIR}/batten-targets.cmake)
foreach(pair batten:shared svg:svg_shared)
  string(REPLACE : \";batten::\" pair batten::\${pair})
  list(GET pair 0 either)
  list(GET pair 1 shared)
  if(TARGET \${shared} AND NOT TARGET \${either})
    add_library(\${either} ALIAS \${shared})
  endif()
endforeach()
")
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/batten-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cmake/batten-config.cmake ${PROJECT_BINARY_DIR}/cmake/batten-config-version.cmake
  DESTINATION ${BATTEN_CMAKE_DIR})

# Relocatable: paths in batten.pc are relative to its own folder.
file(RELATIVE_PATH BATTEN_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" BATTEN_PC_PREFIX ${BATTEN_PC_PREFIX})
set(packages batten)
if(TARGET batten_svg)
  list(APPEND packages batten-svg)
endif()
foreach(package ${packages})
  configure_file(${CMAKE_CURRENT_LIST_DIR}/${package}.pc.in ${PROJECT_BINARY_DIR}/cmake/${package}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/cmake/${package}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
