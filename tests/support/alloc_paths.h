/*
 * Makes allocations fail by the calls that lead to them. Whoever makes the nth of a thousand allocations fail tries the
 * same few calls again and again, and misses those that are made once. Here the first allocation fails that is new: on
 * the stack is a call that has not yet seen this allocation fail.
 *
 *     do {
 *         set up
 *         alloc_fail_new(false);
 *         status = work();
 *         again = alloc_fail_reached();
 *         assert what holds when memory runs out, or, if not again, that the work is done
 *         tear down
 *     } while (again);
 *
 * What has failed stays known until the program ends: work that resembles earlier work costs one pass. Needs a stack
 * that can be read, so not for WebAssembly (tests/wasm/programs.cmake).
 */
#ifndef BATTEN_TESTS_ALLOC_PATHS_H
#define BATTEN_TESTS_ALLOC_PATHS_H

#include "support/alloc_fail.h"
#include "support/rounds.h"

#include <execinfo.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

enum { ALLOC_DEPTH = 64, ALLOC_CALLS = 1 << 20 };
static uint64_t alloc_known[ALLOC_CALLS]; /* calls, each with an allocation below it; 0: free */
static int alloc_known_count;
static bool alloc_rest_fails;
static unsigned alloc_passed; /* where fewer rounds do: of the new ones each third fails */
static void
    *alloc_failed[ALLOC_DEPTH]; /* the calls of the last that failed, the innermost first; for a debugger */

/* Whether it is the first of its kind. */
static inline bool alloc_learn(uint64_t key) {
    key = (key ^ key >> 29) * 0x9e3779b97f4a7c15u;
    key = (key ^ key >> 32) | 1;
    for (size_t i = key >> 20;; i++) {
        uint64_t *place = &alloc_known[i % ALLOC_CALLS];
        if (*place == key) return false;
        if (*place != 0) continue;
        assert_true(alloc_known_count++ < ALLOC_CALLS / 2);
        *place = key;
        return true;
    }
}

static bool alloc_is_new(void) {
    if (alloc_hit) return alloc_rest_fails;
    void *calls[ALLOC_DEPTH] = {NULL};
    const int depth = backtrace(calls, ALLOC_DEPTH), own = 4; /* this and what wraps malloc, if not inlined */
    uint64_t leaf = 0;
    bool found = false;
    for (int i = 0; i < depth; i++) {
        const uint64_t call = (uint64_t)(uintptr_t)calls[i];
        if (i < own) leaf = (leaf ^ call) * 0x9e3779b97f4a7c15u;
        if (i >= own) found |= alloc_learn(leaf ^ call);
    }
    if (!found || (FEWER && ++alloc_passed % 3)) return false;
    memcpy(alloc_failed, calls, sizeof calls);
    return true;
}

/* The next new allocation fails; with `rest` all that follow it, too, until alloc_fail_reached. */
static inline void alloc_fail_new(bool rest) {
    alloc_decides = alloc_is_new, alloc_rest_fails = rest;
    alloc_fail_at(-1);
}

#endif
