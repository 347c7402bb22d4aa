# BATTEN_FACE: the type face of the page and its licence, which belongs to it, or nothing. The face is cut out of Debian's
# Inter (fonts-inter-variable) by face.py, which needs python3-fonttools and python3-brotli. Without these the page
# has the system's face.
find_program(BATTEN_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH) # the one of Debian, with its packages
find_file(BATTEN_INTER NAMES Inter-roman.var.ttf InterVariable.ttf NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH
  PATHS /usr/share/fonts/truetype/inter-vf /usr/share/fonts/truetype/inter /usr/share/fonts/opentype/inter)
if(BATTEN_PYTHON AND BATTEN_INTER AND NOT BATTEN_FONTTOOLS)
  execute_process(COMMAND ${BATTEN_PYTHON} -c "import brotli, fontTools.varLib.instancer" RESULT_VARIABLE failed ERROR_QUIET)
  if(NOT failed)
    set(BATTEN_FONTTOOLS ON CACHE INTERNAL "fonttools writes WOFF2")
  endif()
endif()
set(BATTEN_FACE)
if(BATTEN_FONTTOOLS AND EXISTS ${BATTEN_INTER})
  set(BATTEN_FACE ${CMAKE_CURRENT_BINARY_DIR}/inter.woff2 ${PROJECT_SOURCE_DIR}/web/fonts/OFL.txt)
  add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/inter.woff2 VERBATIM COMMENT "The type face of the page"
    DEPENDS ${BATTEN_INTER} ${CMAKE_CURRENT_LIST_DIR}/face.py
    COMMAND ${BATTEN_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/face.py ${BATTEN_INTER} ${CMAKE_CURRENT_BINARY_DIR}/inter.woff2)
else()
  message(STATUS "Without fonts-inter-variable, fonttools and brotli for Python the page has the system's face")
endif()
list(JOIN BATTEN_FACE "|" FACE_LIST)
