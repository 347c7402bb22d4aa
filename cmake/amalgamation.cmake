# The target `amalgamation`: the whole library as two files, amalgamation/batten.c and batten.h in the build folder.
find_package(Python3 COMPONENTS Interpreter QUIET)
if(Python3_FOUND AND PROJECT_IS_TOP_LEVEL)
  set(made ${PROJECT_BINARY_DIR}/amalgamation)
  file(GLOB_RECURSE inputs CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/* ${PROJECT_SOURCE_DIR}/include/*)
  add_custom_command(OUTPUT ${made}/batten.c ${made}/batten.h VERBATIM
    DEPENDS ${inputs} ${CMAKE_CURRENT_LIST_DIR}/amalgamate.py
    COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/amalgamate.py ${PROJECT_SOURCE_DIR} ${made})
  add_custom_target(amalgamation DEPENDS ${made}/batten.c ${made}/batten.h)
endif()
