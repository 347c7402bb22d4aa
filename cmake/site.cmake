# The target site: a folder, site in the build tree, that any static host serves under any path. site_page makes the
# editor with its service worker, the drawings to begin with and the race of fits; site_manual the manual, for which
# pandoc is needed. Neither is part of the default build. The two libraries of the race come from npm.
set(BATTEN_SITE ${CMAKE_BINARY_DIR}/site)
find_program(BATTEN_NPM npm)
find_program(BATTEN_PANDOC pandoc)

if(NOT BATTEN_MODULE OR NOT BATTEN_NPM OR NOT BATTEN_PYTHON)
  message(STATUS "Without the editor's module, npm and Python there is no target site")
  return()
endif()

set(PEERS_FOLDER ${CMAKE_BINARY_DIR}/site_npm)
set(PEER_FILES ${PEERS_FOLDER}/fit-curve.js ${PEERS_FOLDER}/fit-curve.LICENSE.txt ${PEERS_FOLDER}/paper-core.min.js
  ${PEERS_FOLDER}/paper.LICENSE.txt)
set(from ${PEERS_FOLDER}/node_modules)
add_custom_command(OUTPUT ${PEER_FILES} VERBATIM COMMENT "The two other libraries of the race, from npm"
  DEPENDS ${PROJECT_SOURCE_DIR}/tools/site/package.json ${PROJECT_SOURCE_DIR}/tools/site/package-lock.json
  COMMAND ${CMAKE_COMMAND} -E make_directory ${PEERS_FOLDER}
  COMMAND ${CMAKE_COMMAND} -E copy ${PROJECT_SOURCE_DIR}/tools/site/package.json
    ${PROJECT_SOURCE_DIR}/tools/site/package-lock.json ${PEERS_FOLDER}
  COMMAND ${BATTEN_NPM} ci --prefix ${PEERS_FOLDER} --ignore-scripts --no-audit --no-fund --loglevel=error
  COMMAND ${CMAKE_COMMAND} -E copy ${from}/fit-curve/lib/fit-curve.js ${PEERS_FOLDER}/fit-curve.js
  COMMAND ${CMAKE_COMMAND} -E copy ${from}/fit-curve/LICENSE ${PEERS_FOLDER}/fit-curve.LICENSE.txt
  COMMAND ${CMAKE_COMMAND} -E copy ${from}/paper/dist/paper-core.min.js ${PEERS_FOLDER}/paper-core.min.js
  COMMAND ${CMAKE_COMMAND} -E copy ${from}/paper/LICENSE.txt ${PEERS_FOLDER}/paper.LICENSE.txt)

file(GLOB DEMO_FILES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/demos/*.journal)
list(APPEND DEMO_FILES ${PROJECT_SOURCE_DIR}/examples/car.svg ${PROJECT_SOURCE_DIR}/docs/pictures/car.journal
  ${PROJECT_SOURCE_DIR}/examples/silhouette/sketch.journal)
list(JOIN DEMO_FILES "|" DEMO_LIST)
list(JOIN PEER_FILES "|" PEER_LIST)
set(SITE_WORDS ${PROJECT_SOURCE_DIR}/web/site/front.json ${PROJECT_SOURCE_DIR}/web/site/race.json ${PROJECT_SOURCE_DIR}/web/site/study.json)
list(JOIN SITE_WORDS "|" SITE_WORDS_LIST)
set(SITE_HEAD ${PROJECT_SOURCE_DIR}/web/site/head.txt)
add_custom_command(OUTPUT ${BATTEN_SITE}/index.html VERBATIM COMMENT "The editor for a static host"
  DEPENDS ${WEB_INPUTS} ${BATTEN_FACE} ${BATTEN_MODULE} ${BATTEN_WORDS} ${PEER_FILES} ${DEMO_FILES} ${SITE_HEAD} ${SITE_WORDS}
    ${PROJECT_SOURCE_DIR}/cmake/embed_web.cmake
  COMMAND ${CMAKE_COMMAND} "-DFILES=${WEB_LIST}|${SITE_WORDS_LIST}" "-DMINIFY=${BATTEN_ESBUILD}" "-DMODULE=${MODULE_LIST}"
    "-DWORDS=${WORDS_LIST}" "-DFACE=${FACE_LIST}" -DROOT=${PROJECT_SOURCE_DIR}/web -DOUT=${CMAKE_BINARY_DIR}/site_page -DFOLDER=${BATTEN_SITE}
    -DHEAD=${SITE_HEAD} "-DDEMOS=${DEMO_LIST}" "-DPEERS=${PEER_LIST}"
    -DPAGES=${PROJECT_SOURCE_DIR}/web/site/race.html -P ${PROJECT_SOURCE_DIR}/cmake/embed_web.cmake
  COMMAND ${CMAKE_COMMAND} -E copy ${PROJECT_SOURCE_DIR}/LICENSE ${BATTEN_SITE}/LICENSE.txt
  COMMAND ${CMAKE_COMMAND} -E touch ${BATTEN_SITE}/.nojekyll ${BATTEN_SITE}/index.html)
add_custom_target(site_page DEPENDS ${BATTEN_SITE}/index.html)

if(NOT BATTEN_PANDOC)
  message(STATUS "Without pandoc there is no target site_manual")
  return()
endif()
add_custom_target(site_manual VERBATIM COMMENT "The manual"
  COMMAND ${BATTEN_PYTHON} ${PROJECT_SOURCE_DIR}/tools/site/manual.py $<TARGET_FILE:batten_program> ${BATTEN_SITE}/manual)
add_custom_target(site DEPENDS site_page site_manual)
