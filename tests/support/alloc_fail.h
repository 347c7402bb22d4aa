/*
 * Makes the Nth allocation fail. A test program that includes this is linked with --wrap for malloc, calloc
 * and realloc (tests/CMakeLists.txt does so when it finds the name of this file in the source), which reaches
 * into the static library. Include it in one file of a program.
 *
 *     for (int n = 1; ; n++) {
 *         alloc_fail_at(n);
 *         status = work();
 *         if (!alloc_fail_reached()) break;   // work needs fewer than n allocations: done
 *         assert status == BAT_MEMORY, outputs untouched
 *     }
 *     assert status == BAT_OK
 *
 * alloc_live() counts the blocks that the program holds: if it is the same before and after, nothing leaked.
 */
#ifndef BATTEN_TESTS_ALLOC_FAIL_H
#define BATTEN_TESTS_ALLOC_FAIL_H

#include <stdbool.h>
#include <stddef.h>

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *memory, size_t size);
void __real_free(void *memory);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *memory, size_t size);
void __wrap_free(void *memory);

#ifdef BATTEN_ONE_MODULE /* many programs in one: only tests/wasm/units.c defines the state and the functions */
#define ALLOC_STATE extern
#else
#define ALLOC_STATE
#endif
ALLOC_STATE long alloc_countdown; /* 0: none fails; -1: alloc_paths.h decides */
ALLOC_STATE bool alloc_hit;
ALLOC_STATE long alloc_blocks;

/* Makes the nth allocation from now on fail, once; 0 switches this off. */
static inline void alloc_fail_at(long n) { alloc_countdown = n, alloc_hit = false; }

/* Whether that allocation has failed. Also switches it off. */
static inline bool alloc_fail_reached(void) {
    alloc_countdown = 0;
    return alloc_hit;
}

static inline long alloc_live(void) { return alloc_blocks; }

#ifndef BATTEN_ONE_MODULE
#ifndef ALLOC_DECIDES
#define ALLOC_DECIDES() false
#endif
static inline bool alloc_fails_now(void) {
    if (alloc_countdown < 0) return ALLOC_DECIDES() && (alloc_hit = true);
    if (alloc_countdown == 0 || --alloc_countdown > 0) return false;
    return alloc_hit = true;
}

void *__wrap_malloc(size_t size) {
    void *memory = alloc_fails_now() ? NULL : __real_malloc(size);
    alloc_blocks += memory != NULL;
    return memory;
}

void *__wrap_calloc(size_t count, size_t size) {
    void *memory = alloc_fails_now() ? NULL : __real_calloc(count, size);
    alloc_blocks += memory != NULL;
    return memory;
}

void *__wrap_realloc(void *memory, size_t size) {
    if (alloc_fails_now()) return NULL;
    void *moved = __real_realloc(memory, size);
    alloc_blocks += memory == NULL && moved != NULL;
    return moved;
}

void __wrap_free(void *memory) {
    alloc_blocks -= memory != NULL;
    __real_free(memory);
}
#endif

#endif
