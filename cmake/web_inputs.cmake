# WEB_INPUTS and WEB_LIST: the files of the page, as cmake/embed_web.cmake takes them; BATTEN_ESBUILD, or "".
file(GLOB_RECURSE WEB_INPUTS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/web/*.html ${PROJECT_SOURCE_DIR}/web/*.js
  ${PROJECT_SOURCE_DIR}/web/*.css ${PROJECT_SOURCE_DIR}/web/*.svg ${PROJECT_SOURCE_DIR}/web/*.png
  ${PROJECT_SOURCE_DIR}/web/*.webmanifest)
list(APPEND WEB_INPUTS ${PROJECT_SOURCE_DIR}/examples/car.svg) # which an empty page offers
find_program(BATTEN_ESBUILD esbuild) # Debian's package; without it the files are embedded unchanged
if(NOT BATTEN_ESBUILD)
  set(BATTEN_ESBUILD "")
endif()
list(JOIN WEB_INPUTS "|" WEB_LIST)
