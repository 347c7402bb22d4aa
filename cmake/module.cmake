# build/wasm/batten.wasm: the library and the glue of the browser shell (web/module) in one module.
file(GLOB MODULE_SOURCES CONFIGURE_DEPENDS web/module/*.c)
add_executable(batten_module $<TARGET_OBJECTS:batten_objects> ${MODULE_SOURCES})
target_include_directories(batten_module PRIVATE include src)
target_link_libraries(batten_module PRIVATE batten_options)
set_target_properties(batten_module PROPERTIES OUTPUT_NAME batten)
# Stack first: an overflow traps instead of writing over data; the default of 64 KB is too small.
target_link_options(batten_module PRIVATE -mexec-model=reactor -Wl,--strip-debug -Wl,--stack-first
  -Wl,-z,stack-size=1048576)

find_program(WASM_OPT wasm-opt)
if(WASM_OPT)
  add_custom_command(TARGET batten_module POST_BUILD VERBATIM
    COMMAND ${WASM_OPT} -O3 -g --enable-simd --enable-bulk-memory
            $<TARGET_FILE:batten_module> -o $<TARGET_FILE:batten_module>)
endif()
