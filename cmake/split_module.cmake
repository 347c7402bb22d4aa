# Splits a linked module in two: what stands in the source files that LATER lists goes to <name>-later.wasm, which the
# shell fetches when somebody is there. Functions are told by the linker's MAP; of those whose name several files use
# none is moved, nor are those with a ! before their name. Both parts are then made small. What they import from each
# other is named by the digest of the whole: parts of two builds do not fit together. FLAGS: of the tools of binaryen.
# cmake -DMODULE=x.wasm -DMAP=x.map -DLATER=later.txt -DOPT=wasm-opt -DSPLIT=wasm-split -DFLAGS=... -P split_module.cmake
cmake_minimum_required(VERSION 3.23)
string(REPLACE " " ";" flags "${FLAGS}")
string(REGEX REPLACE "\\.wasm$" "-later.wasm" later_module ${MODULE})
file(STRINGS ${LATER} later REGEX "^[a-z]")
file(STRINGS ${LATER} kept REGEX "^!")
list(TRANSFORM kept REPLACE "^!" "")

file(STRINGS ${MAP} lines REGEX "src/[a-z_/]+\\.c\\.obj:\\([A-Za-z_0-9]+\\)")
set(seen)
set(twice)
set(moved)
foreach(line ${lines})
  string(REGEX MATCH "src/([a-z_0-9/]+)\\.c\\.obj:\\(([A-Za-z_0-9]+)\\)" found "${line}")
  set(file ${CMAKE_MATCH_1})
  set(name ${CMAKE_MATCH_2})
  if(name IN_LIST seen)
    list(APPEND twice ${name})
  endif()
  list(APPEND seen ${name})
  if(file IN_LIST later)
    list(APPEND moved ${name})
  endif()
endforeach()
list(REMOVE_ITEM moved ${twice} ${kept} "")
list(JOIN moved "\n" text)
file(WRITE ${MODULE}.later "${text}\n")

function(tool)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET ERROR_VARIABLE said)
endfunction()
tool(${OPT} -Oz --converge --low-memory-unused -g ${flags} ${MODULE} -o ${MODULE}.whole)
file(SHA256 ${MODULE}.whole build)
string(SUBSTRING ${build} 0 12 build)
tool(${SPLIT} --split ${MODULE}.whole --placeholdermap --import-namespace=${build} --placeholder-namespace=${build}
  --split-funcs=@${MODULE}.later -o1 ${MODULE} -o2 ${later_module} ${flags})
foreach(part ${MODULE} ${later_module})
  tool(${OPT} -Oz --strip-producers --strip-debug ${flags} ${part} -o ${part})
endforeach()
