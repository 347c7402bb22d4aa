/* Path data of a subpath that was edited: segments that nobody has touched keep their text. */
#include "format/svg/cubics.h"
#include "format/svg/write/patch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of the curve's size: how far points may be apart that are the same but for rounding; and how far those of a curve may be from
 * where the data have them, as a reader merges nodes. */
static const double ROUNDING = 1e-12, MERGED = 2e-4;

typedef struct matching {
    const bat_svg_subtext *was;
    bat_svg_cubics old, now;
    int *first; /* of each old cubic: the segment that it begins with; the end of them all */
    int *of;    /* of each cubic: the old one whose text it keeps; -1: it is new */
    bool closed;
} matching;

static double distance(const double *p, const double *q) {
    return fmax(fabs(p[0] - q[0]), fabs(p[1] - q[1]));
}

/* Finds the segments of each old cubic: where nodes were merged, there are several. */
static bool find_segments(matching *t) {
    const double *points = t->was->points, near = MERGED * t->old.extent;
    const int count = t->was->count;
    int at = 0;
    for (int i = 0; i < t->old.count; i++) {
        const double *end = bat_svg_cubic(&t->old, i) + 6;
        t->first[i] = at++;
        while (at <= count && !(distance(end, points + (ptrdiff_t)6 * at) <= near)) at++;
        while (at < count &&
               distance(end, points + (ptrdiff_t)6 * (at + 1)) < distance(end, points + (ptrdiff_t)6 * at))
            at++;
        if (at > count) return false;
    }
    t->first[t->old.count] = at;
    return at == count;
}

static bool is_same(const matching *t, int i, int k) {
    const double *p = bat_svg_cubic(&t->old, i), *q = bat_svg_cubic(&t->now, k);
    for (int c = 0; c < 8; c++)
        if (!(fabs(p[c] - q[c]) <= ROUNDING * t->old.extent)) return false;
    return true;
}

/* What begins and what ends the curve, and where their numbers agree what is between. */
static void match(matching *t) {
    const int m = t->old.count, n = t->now.count, less = m < n ? m : n;
    int head = 0, tail = 0;
    while (head < less && is_same(t, head, head)) head++;
    while (tail < less - head && is_same(t, m - 1 - tail, n - 1 - tail)) tail++;
    for (int k = 0; k < n; k++) {
        t->of[k] = -1;
        if (k >= head && k >= n - tail)
            t->of[k] = m - (n - k);
        else if (k < head || (m == n && is_same(t, k, k)))
            t->of[k] = k;
    }
}

static bool follows(const matching *t, int k) {
    return k > 0 && t->of[k] > 0 && t->of[k - 1] == t->of[k] - 1;
}

/* Whether the end of an old cubic lies within an arc, whose text is one. */
static bool is_within(const matching *t, int old) {
    const bat_svg_segment *next = t->was->segments + t->first[old + 1];
    return old + 1 < t->old.count && next[-1].from == next->from;
}

/* An arc is kept as a whole; what continues the handle of another segment goes with it; and an end is only an end. */
static void drop_parts(matching *t) {
    const int n = t->now.count;
    for (int k = n - 1; k >= 0; k--)
        if (t->of[k] >= 0 && is_within(t, t->of[k]) && !(k + 1 < n && follows(t, k + 1))) t->of[k] = -1;
    for (int k = 0; k < n; k++) {
        const int old = t->of[k];
        if (old < 0) continue;
        const bat_svg_segment *s = t->was->segments;
        const bool begins = k == 0 && old == 0,
                   continues = (old > 0 && is_within(t, old - 1)) || strchr("sStT", s[t->first[old]].command);
        if ((continues && !begins && !follows(t, k)) ||
            (strchr("zZ", s[t->first[old + 1] - 1].command) && k < n - 1))
            t->of[k] = -1;
    }
}

/* Where cubic k begins: where the text says, if one beside it is kept. */
static void find_joint(const matching *t, int k, double out[2]) {
    const int n = t->now.count, *of = t->of;
    const int next = k < n       ? of[k]
                     : t->closed ? of[0]
                                 : -1,
              last = k > 0       ? of[k - 1]
                     : t->closed ? of[n - 1]
                                 : -1;
    if (next >= 0 || last >= 0)
        memcpy(out, t->was->points + (ptrdiff_t)6 * t->first[next >= 0 ? next : last + 1], 2 * sizeof *out);
    else if (k < n || t->closed)
        bat_svg_round(&t->now, bat_svg_cubic(&t->now, k < n ? k : 0), out);
    else
        bat_svg_round(&t->now, bat_svg_cubic(&t->now, n - 1) + (ptrdiff_t)3 * t->now.dimension, out);
}

/* stands: all that is before it in the data has been written. */
static void keep(const matching *t, int k, bool stands, bat_text *out) {
    const bat_svg_segment *s = t->was->segments + t->first[t->of[k]],
                          *last = t->was->segments + t->first[t->of[k] + 1] - 1;
    const size_t from = follows(t, k) ? s[-1].to : s->from; /* of an arc it has been written before */
    if (s->implied && !stands && !follows(t, k)) bat_text_add(out, &s->command, 1);
    if (last->to > from) bat_text_add(out, t->was->data + from, last->to - from);
}

static bool ends_itself(const matching *t) {
    return t->of[t->now.count - 1] >= 0 && strchr("zZ", t->was->segments[t->was->count - 1].command);
}

static void write(const matching *t, bat_text *out) {
    const bool stands = t->of[0] == 0 && t->was->from != SIZE_MAX;
    double start[2], from[2], end[2];
    find_joint(t, 0, start);
    if (stands)
        bat_text_add(out, t->was->data + t->was->from, t->was->segments[0].from - t->was->from);
    else {
        bat_text_string(out, "M");
        bat_svg_write_pair(out, start);
    }
    memcpy(from, start, sizeof from);
    for (int k = 0; k < t->now.count; k++) {
        const bool last = t->closed && k == t->now.count - 1;
        find_joint(t, k + 1, end);
        if (t->of[k] >= 0)
            keep(t, k, stands && k == 0, out);
        else if (!(last && bat_svg_is_closing(&t->now, k, from, start)))
            bat_svg_write_cubic(out, &t->now, k, end);
        memcpy(from, end, sizeof from);
    }
    if (t->closed && !ends_itself(t)) bat_text_string(out, "Z");
}

bat_status bat_svg_patch_segments(bat_text *out, const bat_svg_subtext *was, const bat_curve *before,
                                  const bat_curve *now, const double m[6], double precision, bool *done) {
    matching t = {.was = was, .closed = bat_curve_is_closed(now)};
    *done = false;
    if (bat_curve_degree(now) > 3 || bat_curve_dimension(now) != 2 || t.closed != was->closed) return BAT_OK;
    bat_status status = bat_svg_cubics_make(before, m, 0, &t.old);
    if (status == BAT_OK) status = bat_svg_cubics_make(now, m, precision, &t.now);
    if (status == BAT_OK) {
        t.first = malloc(((size_t)t.old.count + 1) * sizeof *t.first);
        t.of = malloc((size_t)t.now.count * sizeof *t.of);
        if (!t.first || !t.of) status = BAT_MEMORY;
    }
    if (status == BAT_OK && find_segments(&t)) {
        match(&t);
        drop_parts(&t);
        for (int k = 0; k < t.now.count; k++) *done = *done || t.of[k] >= 0;
        if (*done) write(&t, out);
    }
    free(t.first);
    free(t.of);
    bat_svg_cubics_free(&t.old);
    bat_svg_cubics_free(&t.now);
    return status;
}
