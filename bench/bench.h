/* The table of kernels: each rows_*.c supplies some of its rows. */
#ifndef BATTEN_BENCH_H
#define BATTEN_BENCH_H

typedef struct bench_row {
    const char *name;
    const char *unit;
    double scale; /* 1e9: ns, 1e6: us */
    double per;   /* items in one call */
    int variant;  /* passed to begin */
    void *(*begin)(int variant);
    void (*run)(void *context);
    void (*end)(void *context);
    void (*note)(void *context, char *out, int room); /* facts to report after the last run; may be NULL */
} bench_row;

extern const bench_row bench_rows_eval[], bench_rows_shape[], bench_rows_levels[], bench_rows_editor[],
    bench_rows_surface[], bench_rows_wires[], bench_rows_made[],
    bench_rows_moves[]; /* each ends with a row without a name */

#endif
