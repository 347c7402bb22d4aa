# words.<language>.json beside the module: all strings of one language, generated from the table by the preprocessor.
# The page fetches them on demand; the module contains only English, without the explanations.
# To add a language: a column of strings.def, its name here and below, and a choice of the property "language".
set(LANGUAGES en ko)

foreach(language ${LANGUAGES})
  set(words ${CMAKE_BINARY_DIR}/words.${language}.json)
  add_custom_command(OUTPUT ${words} VERBATIM
    DEPENDS ${PROJECT_SOURCE_DIR}/src/editor/tables/strings.def ${PROJECT_SOURCE_DIR}/src/editor/tables/words.in
    COMMAND ${CMAKE_C_COMPILER} -E -P -x c -I${PROJECT_SOURCE_DIR}/src "-DTEXT(id,key,en,ko)=key:${language}," "-DWORDS(key,words)=key:words,"
            -o ${words} ${PROJECT_SOURCE_DIR}/src/editor/tables/words.in)
  list(APPEND WORDS ${words})
endforeach()
add_custom_target(words ALL DEPENDS ${WORDS})
set_source_files_properties(src/editor/tables/tables.c PROPERTIES COMPILE_DEFINITIONS BAT_HELP_APART)
