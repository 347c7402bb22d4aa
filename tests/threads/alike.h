/* One job on many threads at once, all of which must arrive at the digest of a single thread, and the digests of what
 * calls make. Under ThreadSanitizer (tree tsan) no job may race. To be included first. */
#ifndef BATTEN_TESTS_ALIKE_H
#define BATTEN_TESTS_ALIKE_H

#define _POSIX_C_SOURCE 200809L /* barriers */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <pthread.h>
#include <batten/batten.h>
#include "document/digest.h"

/* The sanitizer sees by the order of calls what may race, so two rounds tell it as much as many. */
enum { THREADS = 8, ROUNDS = 2 };

/* ---- running ---- */

typedef uint64_t job(const void *shared, int seed);

typedef struct crew {
    pthread_barrier_t start;
    job *work;
    const void *shared;
    int seeds; /* how many different ones there are */
} crew;

typedef struct hand {
    crew *crew;
    int number;
    uint64_t found[ROUNDS];
} hand;

static inline void *labour(void *context) {
    hand *h = context;
    pthread_barrier_wait(&h->crew->start);
    for (int i = 0; i < ROUNDS; i++)
        h->found[i] = h->crew->work(h->crew->shared, (h->number + i) % h->crew->seeds);
    return NULL;
}

/* The same job on all threads at once, each round with another seed. */
static inline void assert_alike(job *work, const void *shared, int seeds) {
    crew all = {.work = work, .shared = shared, .seeds = seeds};
    hand hands[THREADS];
    pthread_t threads[THREADS];
    assert_int_equal(pthread_barrier_init(&all.start, NULL, THREADS), 0);
    for (int i = 0; i < THREADS; i++) {
        hands[i] = (hand){.crew = &all, .number = i};
        assert_int_equal(pthread_create(&threads[i], NULL, labour, &hands[i]), 0);
    }
    for (int i = 0; i < THREADS; i++) assert_int_equal(pthread_join(threads[i], NULL), 0);
    pthread_barrier_destroy(&all.start);
    for (int i = 0; i < THREADS; i++)
        for (int k = 0; k < ROUNDS; k++) assert_true(hands[i].found[k] == work(shared, (i + k) % seeds));
}

/* ---- digests of results ---- */

static inline uint64_t add(uint64_t digest, uint64_t number) { return bat_digest_number(digest, number); }

static inline uint64_t add_doubles(uint64_t digest, const double *numbers, int count) {
    for (int i = 0; i < count; i++) digest = bat_digest_double(digest, numbers[i]);
    return digest;
}

/* What a call has made, and its status; frees it. */
static inline uint64_t add_curve(uint64_t digest, bat_status status, bat_curve **made) {
    digest = add(digest, (uint64_t)status);
    if (*made) digest = bat_digest_curve(digest, *made);
    bat_curve_free(*made);
    *made = NULL;
    return digest;
}

static inline uint64_t add_text(uint64_t digest, bat_status status, char **text, const size_t *size) {
    digest = add(digest, (uint64_t)status);
    if (*text) digest = bat_digest_bytes(digest, *text, *size);
    bat_free(*text);
    *text = NULL;
    return digest;
}

static inline uint64_t add_shape(uint64_t digest, bat_status status, bat_shape **made) {
    char *text = NULL;
    size_t size = 0;
    digest = add(digest, (uint64_t)status);
    if (*made) digest = add_text(digest, bat_shape_write(*made, &text, &size), &text, &size);
    bat_shape_free(*made);
    *made = NULL;
    return digest;
}

#endif
