# The target batten_ids: made/editor/tables/ids.h in the build folder, the enums of strings.def and commands.def. It is written
# anew only when an id comes or goes, so that another word, key or range compiles nothing but what shows it.
# As a script: cmake -DSTRINGS=strings.def -DCOMMANDS=commands.def -DOUT=ids.h -P ids.cmake
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(BATTEN_MADE ${PROJECT_BINARY_DIR}/made)
  set(tables ${PROJECT_SOURCE_DIR}/src/editor/tables)
  add_custom_command(OUTPUT ${BATTEN_MADE}/editor/tables/ids.h VERBATIM
    DEPENDS ${tables}/strings.def ${tables}/commands.def ${CMAKE_CURRENT_LIST_FILE}
    COMMAND ${CMAKE_COMMAND} -DSTRINGS=${tables}/strings.def -DCOMMANDS=${tables}/commands.def
            -DOUT=${BATTEN_MADE}/editor/tables/ids.h -P ${CMAKE_CURRENT_LIST_FILE})
  add_custom_target(batten_ids DEPENDS ${BATTEN_MADE}/editor/tables/ids.h)
  target_include_directories(batten_options INTERFACE ${BATTEN_MADE})
  return()
endif()

# enumerate(TYPE COUNT TABLE MACROS ENTRY): an enum with an entry for each row of the table that begins with one of the macros
# (a regular expression); COUNT is its last. ENTRY is text in which MACRO and ID stand for those of the row.
function(enumerate type count table macros entry)
  file(READ ${table} rows)
  string(REGEX MATCHALL "\n(${macros})\\([A-Z0-9_]+" rows "${rows}")
  string(APPEND text "\ntypedef enum ${type} {\n")
  foreach(row IN LISTS rows)
    string(REGEX MATCH "([A-Z]+)\\((.*)" row "${row}")
    string(REPLACE MACRO ${CMAKE_MATCH_1} one "${entry}")
    string(REPLACE ID ${CMAKE_MATCH_2} one "${one}")
    if(CMAKE_MATCH_1 MATCHES "SECTION|SUBJECT") # a heading has the number of the first row below it
      string(REGEX REPLACE "^ *([A-Z0-9_]+)," "    \\1, \\1_AGAIN = \\1 - 1," one "${one}")
    endif()
    string(APPEND text "${one}\n")
  endforeach()
  set(text "${text}    ${count}\n} ${type};\n" PARENT_SCOPE)
endfunction()

set(text "/* Made by cmake/ids.cmake from strings.def and commands.def. */
#ifndef BATTEN_EDITOR_TABLES_IDS_H
#define BATTEN_EDITOR_TABLES_IDS_H
")
enumerate(bat_string BAT_STRING_COUNT ${STRINGS} "TEXT|HELP|LATE" "    BAT_STRING_ID,")
enumerate(bat_command_id BAT_COMMAND_COUNT ${COMMANDS} "COMMAND|HELD|SECTION" "    BAT_MACRO_ID,")
string(REPLACE BAT_HELD_ BAT_COMMAND_ text "${text}")
enumerate(bat_property_id BAT_PROPERTY_COUNT ${COMMANDS} "PROPERTY|SUBJECT" "    BAT_MACRO_ID,")
enumerate(bat_number_id BAT_NUMBER_COUNT ${COMMANDS} NUMBER "    BAT_NUMBER_ID,")
enumerate(bat_tool_id BAT_TOOL_COUNT ${COMMANDS} TOOL "    BAT_TOOL_ID,")
enumerate(bat_mode_id BAT_MODE_COUNT ${COMMANDS} MODE "    BAT_MODE_ID,")
string(APPEND text "\n#endif\n")

if(EXISTS ${OUT})
  file(READ ${OUT} before)
endif()
if(NOT "${before}" STREQUAL "${text}")
  file(WRITE ${OUT} "${text}")
endif()
