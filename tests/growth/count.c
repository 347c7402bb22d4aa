/* What is counted: blocks, and what libc does for long. */
#include "growth.h"

#include <stddef.h>

uint64_t growth_work;

void __sanitizer_cov_trace_pc(void);
void __sanitizer_cov_trace_pc(void) { growth_work++; }

#define WRAP(type, name, parameters, arguments, size)                                                        \
    type __real_##name parameters;                                                                           \
    type __wrap_##name parameters;                                                                           \
    type __wrap_##name parameters {                                                                          \
        growth_work += (size) / 8;                                                                           \
        return __real_##name arguments;                                                                      \
    }

WRAP(void *, memcpy, (void *to, const void *from, size_t n), (to, from, n), n)
WRAP(void *, memmove, (void *to, const void *from, size_t n), (to, from, n), n)
WRAP(void *, memset, (void *to, int value, size_t n), (to, value, n), n)
WRAP(int, memcmp, (const void *a, const void *b, size_t n), (a, b, n), n)
WRAP(void *, calloc, (size_t count, size_t n), (count, n), count *n)
WRAP(void *, realloc, (void *from, size_t n), (from, n), n)

/* What a search passes over is known when it is over. */
size_t __real_strlen(const char *text);
size_t __wrap_strlen(const char *text);
size_t __wrap_strlen(const char *text) {
    size_t size = __real_strlen(text);
    growth_work += size / 8;
    return size;
}

void *__real_memchr(const void *from, int value, size_t n);
void *__wrap_memchr(const void *from, int value, size_t n);
void *__wrap_memchr(const void *from, int value, size_t n) {
    char *found = __real_memchr(from, value, n);
    growth_work += (found ? (size_t)(found - (const char *)from) : n) / 8;
    return found;
}

char *__real_strchr(const char *text, int value);
char *__wrap_strchr(const char *text, int value);
char *__wrap_strchr(const char *text, int value) {
    char *found = __real_strchr(text, value);
    growth_work += (found ? (size_t)(found - text) : __real_strlen(text)) / 8;
    return found;
}

char *__real_strstr(const char *text, const char *part);
char *__wrap_strstr(const char *text, const char *part);
char *__wrap_strstr(const char *text, const char *part) {
    char *found = __real_strstr(text, part);
    growth_work += (found ? (size_t)(found - text) : __real_strlen(text)) / 8;
    return found;
}

static size_t alike(const char *a, const char *b, size_t n) {
    size_t i = 0;
    while (i < n && a[i] && a[i] == b[i]) i++;
    return i;
}
int __real_strcmp(const char *a, const char *b);
int __wrap_strcmp(const char *a, const char *b);
int __wrap_strcmp(const char *a, const char *b) {
    growth_work += alike(a, b, SIZE_MAX) / 8;
    return __real_strcmp(a, b);
}
int __real_strncmp(const char *a, const char *b, size_t n);
int __wrap_strncmp(const char *a, const char *b, size_t n);
int __wrap_strncmp(const char *a, const char *b, size_t n) {
    growth_work += alike(a, b, n) / 8;
    return __real_strncmp(a, b, n);
}
