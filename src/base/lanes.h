/* Internal to the kernel: hints for loops that compilers should vectorise. Contraction is off everywhere, so
 * every instruction set gives the same bits. */
#ifndef BATTEN_BASE_LANES_H
#define BATTEN_BASE_LANES_H

#include <stddef.h> /* defines __GLIBC__ (through features.h) where glibc is used */
#include <stdlib.h>

/* Compiles a function for several instruction sets; the loader chooses one. */
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) &&                 \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && defined(__OPTIMIZE__)
#define BAT_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define BAT_CLONES
#endif

/* For function bodies that become fast when degree and dimension are compile-time constants. */
#if defined(__GNUC__) && !defined(BAT_NO_INLINE)
#define BAT_INLINE static inline __attribute__((always_inline))
#else
#define BAT_INLINE static inline
#endif

#endif
