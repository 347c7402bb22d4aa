/* Inside the library: frames side by side, in rows of coordinates, so that loops over them become vector code. */
#ifndef BATTEN_CURVE_FRAMES_ROWS_H
#define BATTEN_CURVE_FRAMES_ROWS_H

#include "base/vec.h"

#include <stdbool.h>

enum {
    BAT_FRAME_ROOM = 64, /* samples of a run at most */
    BAT_FRAME_PLANE = BAT_FRAME_ROOM +
                      8, /* from one coordinate to the next: spans ahead share their rows (ahead.h) */
};

/* Three rows of coordinates: x in [0, PLANE), y behind it, then z. */
typedef double bat_rows[3 * BAT_FRAME_PLANE];

static inline vec bat_rows_get(const double *rows, int i) {
    return (vec){rows[i], rows[BAT_FRAME_PLANE + i], rows[2 * BAT_FRAME_PLANE + i]};
}
static inline void bat_rows_put(double *rows, int i, vec v) {
    rows[i] = v.x, rows[BAT_FRAME_PLANE + i] = v.y, rows[2 * BAT_FRAME_PLANE + i] = v.z;
}

/* One double reflection for each i: s0 at (x0, t0) goes to s1 at (x1, t1). False where neither it nor a moderate least
 * rotation exists. */
bool bat_rows_reflect(int count, const double *x0, const double *t0, const double *s0, const double *x1,
                      const double *t1, double *s1);
/* Some unit vector e at right angles to each t. */
void bat_rows_normals(int count, const double *t, double *e);
/* s1[i] against e[i + next], as a complex number: the turn from one sample to the next. */
void bat_rows_measure(int count, int next, const double *t, const double *e, const double *s1, double *re,
                      double *im);
/* The running product of the turns from sample 0 on, each sample `next` behind the one before: re and im become the
 * angles of the frames against their e. s: the frame at sample 0. */
void bat_rows_multiply(int count, int next, vec s, const double *t, const double *e, double *re, double *im);
/* s = re e + im t x e. */
void bat_rows_spread(int count, const double *t, const double *e, const double *re, const double *im,
                     double *s);
static inline vec bat_rows_spread_at(int i, const double *t, const double *e, const double *re,
                                     const double *im) {
    vec first = bat_rows_get(e, i);
    return vec_add(vec_scale(first, re[i]), vec_scale(vec_cross(bat_rows_get(t, i), first), im[i]));
}

#endif
