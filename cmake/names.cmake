# The target batten_names: batten/names.h in the build folder, the names in the table of commands.
# As a script: cmake -DTABLE=commands.def -DOUT=names.h -P names.cmake
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(made ${PROJECT_BINARY_DIR}/include/batten/names.h)
  set(table ${PROJECT_SOURCE_DIR}/src/editor/tables/commands.def)
  add_custom_command(OUTPUT ${made} VERBATIM DEPENDS ${table} ${CMAKE_CURRENT_LIST_FILE}
    COMMAND ${CMAKE_COMMAND} -DTABLE=${table} -DOUT=${made} -P ${CMAKE_CURRENT_LIST_FILE})
  add_custom_target(batten_names DEPENDS ${made})
  return()
endif()

# lists(MACRO COLUMNS PATTERN HOW ROWS...): one macro that calls X for each row of the table.
function(list_rows macro columns pattern how)
  string(APPEND text "\n/* ROW(${columns}) */\n#define ${macro}(ROW)")
  foreach(row ${ARGN})
    if(row MATCHES "${pattern}")
      string(CONFIGURE "${how}" entry @ONLY)
      string(APPEND text " \\\n    ROW(${entry})")
    endif()
  endforeach()
  set(text "${text}\n" PARENT_SCOPE)
endfunction()

file(STRINGS ${TABLE} rows REGEX "^(COMMAND|HELD|PROPERTY|NUMBER|TOOL)\\(")
set(text "/*
 * Batten: what bat_editor_command, _set, _get and _enter know by name. Made from the table of commands.
 * Each list is a macro that calls the macro ROW for every row: a host makes its menus, panels or constants of it.
 */
#ifndef BATTEN_NAMES_H
#define BATTEN_NAMES_H
")
set(quoted "(\"[^\"]*\")")
list_rows(BAT_EACH_COMMAND "id, name, default keys" "^(COMMAND|HELD)\\(([A-Z0-9_]+), ${quoted}, ${quoted}"
  "@CMAKE_MATCH_2@, @CMAKE_MATCH_3@, @CMAKE_MATCH_4@" ${rows})
list_rows(BAT_EACH_PROPERTY "id, name, default, lowest, highest"
  "^PROPERTY\\(([A-Z0-9_]+), ${quoted}, [A-Z]+, ([^,]+), ([^,]+), ([^,]+)"
  "@CMAKE_MATCH_1@, @CMAKE_MATCH_2@, @CMAKE_MATCH_3@, @CMAKE_MATCH_4@, @CMAKE_MATCH_5@" ${rows})
list_rows(BAT_EACH_NUMBER "id, name" "^NUMBER\\(([A-Z0-9_]+), ${quoted}" "@CMAKE_MATCH_1@, @CMAKE_MATCH_2@" ${rows})
list_rows(BAT_EACH_TOOL "id, name" "^TOOL\\(([A-Z0-9_]+), ${quoted}" "@CMAKE_MATCH_1@, @CMAKE_MATCH_2@" ${rows})
file(WRITE ${OUT} "${text}\n#endif\n")
