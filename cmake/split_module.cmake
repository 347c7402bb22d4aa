# Splits a linked module in two: functions that FIRST does not list go to <name>-later.wasm, which the shell fetches when the
# page is there. FIRST is recorded (tests/web/first_part.mjs); the linker's MAP gives the functions.
# Both parts are then optimised for size; x.wasm.named is a module that still has its function names. Imports between
# the parts are named by the digest of the whole, so parts of different builds do not fit. FLAGS: for binaryen's tools.
# cmake -DMODULE=x.wasm -DMAP=x.map -DFIRST=first.txt -DOPT=wasm-opt -DSPLIT=wasm-split -DFLAGS=... -P split_module.cmake
cmake_minimum_required(VERSION 3.23)
string(REPLACE " " ";" flags "${FLAGS}")
string(REGEX REPLACE "\\.wasm$" "-later.wasm" later_module ${MODULE})
file(STRINGS ${FIRST} lines REGEX "^[a-z]")
foreach(line ${lines})
  string(REPLACE " " ";" names ${line})
  list(POP_FRONT names file)
  foreach(name ${names})
    set(first_${file}:${name} ON)
  endforeach()
endforeach()

# The functions of the code section in order. If several files have a function `up`, the tools call the second
# up.1, the third up.2 and so on. What the shell calls, and what the linker makes, stays.
file(STRINGS ${MAP} lines REGEX " CODE$| DATA$|:\\([A-Za-z_0-9.]+\\)$")
set(code OFF)
set(moved)
foreach(line ${lines})
  if(line MATCHES " (CODE|DATA)$")
    string(COMPARE EQUAL ${CMAKE_MATCH_1} CODE code)
  elseif(code AND line MATCHES "([^ ]+):\\(([A-Za-z_0-9.]+)\\)$")
    set(file ${CMAKE_MATCH_1})
    set(name ${CMAKE_MATCH_2})
    set(called ${name})
    if(DEFINED times_${name})
      string(APPEND called .${times_${name}})
      math(EXPR times_${name} "${times_${name}} + 1")
    else()
      set(times_${name} 1)
    endif()
    string(REGEX REPLACE "^.*/(src|web)/(.*)\\.c\\.obj$" "\\2" file ${file})
    string(REGEX REPLACE "^.*/(lib[a-z_0-9.-]+)\\.a\\((.*)\\)$" "\\1/\\2" file ${file})
    if(NOT DEFINED first_${file}:${name} AND NOT file MATCHES "^module/|^<internal>|crt1")
      list(APPEND moved ${called})
    endif()
  endif()
endforeach()
list(JOIN moved "\n" text)
file(WRITE ${MODULE}.later "${text}\n")

function(tool)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET ERROR_VARIABLE said)
endfunction()
# Split before optimising: a function that has been inlined can no longer be moved.
file(SHA256 ${MODULE} build)
string(SUBSTRING ${build} 0 12 build)
file(RENAME ${MODULE} ${MODULE}.whole)
tool(${SPLIT} -g --split ${MODULE}.whole --placeholdermap --import-namespace=${build} --placeholder-namespace=${build}
  --split-funcs=@${MODULE}.later -o1 ${MODULE} -o2 ${later_module} ${flags})
foreach(part ${MODULE} ${later_module})
  tool(${OPT} -Oz --converge --low-memory-unused -g --strip-producers ${flags} ${part} -o ${part}.named)
  tool(${OPT} --strip-debug ${flags} ${part}.named -o ${part})
endforeach()
