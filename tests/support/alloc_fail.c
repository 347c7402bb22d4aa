#include "support/alloc_fail.h"

#include <stddef.h>

long alloc_countdown, alloc_blocks;
bool alloc_hit, (*alloc_decides)(void);

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *memory, size_t size);
void __real_free(void *memory);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *memory, size_t size);
void __wrap_free(void *memory);

static bool fails_now(void) {
    if (alloc_countdown < 0) return alloc_decides() && (alloc_hit = true);
    if (alloc_countdown == 0 || --alloc_countdown > 0) return false;
    return alloc_hit = true;
}

void *__wrap_malloc(size_t size) {
    void *memory = fails_now() ? NULL : __real_malloc(size);
    alloc_blocks += memory != NULL;
    return memory;
}

void *__wrap_calloc(size_t count, size_t size) {
    void *memory = fails_now() ? NULL : __real_calloc(count, size);
    alloc_blocks += memory != NULL;
    return memory;
}

void *__wrap_realloc(void *memory, size_t size) {
    if (fails_now()) return NULL;
    void *moved = __real_realloc(memory, size);
    alloc_blocks += memory == NULL && moved != NULL;
    return moved;
}

void __wrap_free(void *memory) {
    alloc_blocks -= memory != NULL;
    __real_free(memory);
}
