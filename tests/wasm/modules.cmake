# In the WASM tree, not part of its default build:
# parity.wasm, the vectors of parity.c; units.wasm, everything in programs.cmake. Both are linked with the objects of
# the shell's module; units.wasm is optimised by the same tool too.
add_module(parity_module parity $<TARGET_OBJECTS:batten_objects> parity.c parity_module.c)
target_include_directories(parity_module PRIVATE ${PROJECT_SOURCE_DIR}/tests)

# The tables including their help texts, which the shell fetches separately.
set(tables src/editor/tables/tables.c)
add_module(units_module units "$<FILTER:$<TARGET_OBJECTS:batten_objects>,EXCLUDE,${tables}>"
  ${PROJECT_SOURCE_DIR}/${tables} host.c)
use_programs(units_module)
target_link_libraries(units_module PRIVATE -lc-printscan-long-double)
add_custom_command(TARGET units_module POST_BUILD VERBATIM
  COMMAND ${WASM_OPT} -Os --low-memory-unused -g ${WASM_FEATURES} $<TARGET_FILE:units_module> -o $<TARGET_FILE:units_module>)
# bench.wasm, the rows of the benchmarks on surfaces: bench/module.mjs times it.
add_module(bench_module bench $<TARGET_OBJECTS:batten_objects> ${PROJECT_SOURCE_DIR}/bench/module.c
  ${PROJECT_SOURCE_DIR}/bench/rows_surface.c)
set_target_properties(parity_module units_module bench_module PROPERTIES EXCLUDE_FROM_ALL ON)
