# Everything that must give the same result natively and as WebAssembly: the test programs, the examples, the fuzz
# targets and the readers. PROGRAMS lists those that have a main. Included by both builds.
set(here ${CMAKE_CURRENT_LIST_DIR})
file(GLOB_RECURSE UNITS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/test_*.c)
file(GLOB EXAMPLES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/*.c)
file(GLOB FUZZERS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/fuzz/fuzz_*.c)
list(APPEND UNITS ${EXAMPLES} ${PROJECT_SOURCE_DIR}/tests/curve/fit_strokes.c
  ${PROJECT_SOURCE_DIR}/tests/format/write_documents.c)
# Excluded: programs driven by a Python script (tests/cli, tests/gestures, driver_curve.c, svg_again.c), and those that
# need threads, expat, native struct sizes or the calls on the stack, which WebAssembly does not have, or that make
# solves fail.
set(NATIVE_ONLY test_svg_file test_svg_view test_options)
set(PROGRAMS)
set(declared)
set(programs)
foreach(source ${UNITS})
  get_filename_component(name ${source} NAME_WE)
  file(STRINGS ${source} native REGEX "support/(alloc_paths|solve_fail)\\.h" LIMIT_COUNT 1)
  if(source MATCHES "/threads/" OR name IN_LIST NATIVE_ONLY OR native)
    list(REMOVE_ITEM UNITS ${source})
    continue()
  endif()
  list(APPEND PROGRAMS ${name})
  set(every "-include;${here}/every.h")
  if(name STREQUAL "test_real") # compares with libm
    set(every)
  endif()
  set_source_files_properties(${source} PROPERTIES
    COMPILE_DEFINITIONS "main=unit_${name}"
    COMPILE_OPTIONS "${every};-Wno-missing-prototypes")
  file(STRINGS ${source} takes_words REGEX "^int main\\(int" LIMIT_COUNT 1)
  if(takes_words)
    string(APPEND declared "int unit_${name}(int count, char **words);\n")
    string(APPEND programs "    {\"${name}\", unit_${name}},\n")
  else()
    string(APPEND declared "int unit_${name}(void);\nstatic int call_${name}(int count, char **words) {
    (void)count, (void)words;\n    return unit_${name}();\n}\n")
    string(APPEND programs "    {\"${name}\", call_${name}},\n")
  endif()
endforeach()
set(readers)
foreach(source ${FUZZERS})
  get_filename_component(name ${source} NAME_WE)
  set_source_files_properties(${source} PROPERTIES COMPILE_DEFINITIONS LLVMFuzzerTestOneInput=${name}
    COMPILE_OPTIONS -Wno-missing-prototypes)
  string(APPEND declared "int ${name}(const uint8_t *data, size_t size);\n")
  string(APPEND readers "    {\"${name}\", ${name}},\n")
endforeach()
file(CONFIGURE OUTPUT units_list.c CONTENT "#include \"wasm/units.h\"\n
${declared}
const unit_program unit_programs[] = {\n${programs}    {NULL, NULL},\n};
const unit_reader unit_readers[] = {\n${readers}    {\"svg\", read_svg},\n    {\"journal\", read_journal},
    {\"text\", read_text},\n    {NULL, NULL},\n};\n" @ONLY)

# The functions that witness.c observes, and those that tests/support/alloc_fail.h makes fail.
file(STRINGS ${here}/witness.c wraps REGEX "^WRAP\\(")
list(TRANSFORM wraps REPLACE "^WRAP\\([^,]*, ([a-z_]+),.*" "-Wl,--wrap=\\1")

# Adds all of these to a target.
function(use_programs target)
  target_sources(${target} PRIVATE units.c readers.c witness.c ${here}/../support/alloc_fail.c
    ${CMAKE_CURRENT_BINARY_DIR}/units_list.c ${UNITS} ${FUZZERS})
  target_compile_definitions(${target} PRIVATE BATTEN_BITS_COMPARED)
  target_include_directories(${target} BEFORE PRIVATE ${here}/cmocka ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
  target_link_options(${target} PRIVATE ${wraps} -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=free)
endfunction()
