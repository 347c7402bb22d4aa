# batten_test(name COMMAND ... [LABELS ...] [ONLY_ALL reason] [FIXTURES ...] [PROPERTIES ...]): a test of this tree. Its name begins with
# BATTEN_TEST_PREFIX, so that the tests of several trees can be run as one list. ONLY_ALL: ./test leaves it out, for the
# reason given; ./test all runs it. FIXTURES: those that it requires. PROPERTIES: as set_tests_properties takes them.
set(BATTEN_TEST_PREFIX "" CACHE STRING "What the names of this tree's tests begin with")
set(BATTEN_TEST_ENVIRONMENT "ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1:quarantine_size_mb=32:malloc_context_size=12" "UBSAN_OPTIONS=print_stacktrace=1"
  "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/leaks.txt:print_suppressions=0")
function(batten_test name)
  cmake_parse_arguments(the "" "ONLY_ALL" "COMMAND;LABELS;FIXTURES;PROPERTIES" ${ARGN})
  set(name ${BATTEN_TEST_PREFIX}${name})
  if(the_ONLY_ALL)
    list(APPEND the_LABELS all)
  endif()
  add_test(NAME ${name} COMMAND ${the_COMMAND})
  set_tests_properties(${name} PROPERTIES TIMEOUT ${BATTEN_HANG} LABELS "${the_LABELS}" ENVIRONMENT "${BATTEN_TEST_ENVIRONMENT}")
  if(the_FIXTURES)
    set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED "${the_FIXTURES}")
  endif()
  if(the_PROPERTIES)
    set_tests_properties(${name} PROPERTIES ${the_PROPERTIES})
  endif()
endfunction()

# batten_labels(FILE OUT): what the head of a test's source says: "label: slow", or "label: all (reason)", which leaves it to
# ./test all. OUT becomes arguments for batten_test.
function(batten_labels file out)
  file(READ ${file} head LIMIT 2000)
  set(labels LABELS fast)
  if(head MATCHES "label: all \\(([^)]*)\\)")
    set(labels LABELS slow ONLY_ALL "${CMAKE_MATCH_1}")
  elseif(head MATCHES "label: slow")
    set(labels LABELS slow)
  endif()
  set(${out} ${labels} PARENT_SCOPE)
endfunction()
