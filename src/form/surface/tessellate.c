/* Triangles of a surface: steps for chord and angle, vertices on a grid, triangles with area. */
#include "form/surface/tessellate.h"
#include "base/options.h"
#include "base/vec.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 3, FINER = 3 /* times at most in one round */, TRIANGLES = 1000000 };

static const double coarser = 1.25; /* factor of the tolerance while there are too many triangles */

static const bat_tessellate_options DEFAULTS = {.size = sizeof DEFAULTS};

void bat_tessellate_options_init(bat_tessellate_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

void bat_tessellation_free(bat_tessellation *t) {
    if (!t) return;
    free(t->stop[0]), free(t->at[0]);
    free(t->points), free(t->normals), free(t->triangles);
    free(t);
}

void bat_tessellation_mesh(const bat_tessellation *t, bat_mesh *out) {
    *out = (bat_mesh){.rows = t->count[0],
                      .columns = t->count[1],
                      .triangle_count = t->triangle_count,
                      .points = t->points,
                      .normals = t->normals,
                      .u = t->at[0],
                      .v = t->at[1],
                      .triangles = t->triangles};
}

/* ---- Vertices ---- */

static bat_status build_vertices(const bat_surface *surface, const bat_steps *steps, bat_tessellation **out) {
    bat_tessellation *t = calloc(1, sizeof *t);
    if (!t) return BAT_MEMORY;
    bat_status status = bat_stops_create(surface, steps, t);
    if (status == BAT_OK) {
        const size_t m = t->count[0], n = t->count[1], most = m > n ? m : n;
        size_t *all = malloc(most * sizeof *all);
        t->points = malloc(3 * m * n * sizeof *t->points);
        t->normals = malloc(3 * m * n * sizeof *t->normals);
        if (!all || !t->points || !t->normals) status = BAT_MEMORY;
        for (size_t i = 0; status == BAT_OK && i < most; i++) all[i] = i;
        if (status == BAT_OK) status = bat_tessellation_fill(t, surface, m, all, n, all);
        free(all);
    }
    if (status == BAT_OK)
        *out = t;
    else
        bat_tessellation_free(t);
    return status;
}

/* ---- Angles ---- */

static double between(const double *a, const double *b) {
    double square = 0;
    for (int c = 0; c < 3; c++) square += (a[c] - b[c]) * (a[c] - b[c]);
    return 2 * bat_asin(fmin(sqrt(square) / 2, 1));
}

static bool coincide(const double *a, const double *b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* The greatest angle across each span of a direction, into `most`. Vertices at one point do not count. */
static void angles_of(const bat_tessellation *t, int d, double *most) {
    const size_t n = t->count[1], stride = d == 0 ? n : 1, other = d == 0 ? 1 : n;
    for (size_t k = 0; k < t->count[d]; k++) {
        const bat_tile_stop *stop = &t->stop[d][k];
        const bool last = k + 1 == t->count[d];
        if (stop->joint || (last && !t->wraps[d])) continue;
        const size_t next = last ? 0 : k + 1;
        for (size_t l = 0; l < t->count[1 - d]; l++) {
            const size_t a = 3 * (k * stride + l * other), b = 3 * (next * stride + l * other);
            if (coincide(t->points + a, t->points + b)) continue;
            const double angle = between(t->normals + a, t->normals + b);
            if (angle > most[stop->span]) most[stop->span] = angle;
        }
    }
}

/* Of each span: its steps now and before they became more, and the angles then; before < 0: more of them gain nothing. */
typedef struct angling {
    double *most, *before;
    int *kept, *fewer;
} angling;

static bat_status begin_angling(const bat_steps *steps, angling *out) {
    const size_t spans = (size_t)(steps->spans[0] + steps->spans[1]);
    double *angles = calloc(2 * spans, sizeof *angles);
    int *counts = calloc(2 * spans, sizeof *counts);
    *out = (angling){angles, angles ? angles + spans : NULL, counts, counts ? counts + spans : NULL};
    return angles && counts ? BAT_OK : BAT_MEMORY;
}

static void end_angling(angling *a) { free(a->most), free(a->kept); }

/* Whether at least twice as many steps gained less than a tenth of what they gain where a surface bends evenly: it folds there. */
static bool gained_nothing(const angling *a, int span) {
    const double fewer = a->fewer[span], share = fewer / a->kept[span];
    return a->before[span] > 0 && 2 * fewer <= a->kept[span] &&
           a->most[span] > a->before[span] * (0.9 + 0.1 * share);
}

/* The steps that a span is given for its angle. */
static int steps_for(const bat_tessellate_options *options, angling *a, int span,
                     bat_tessellate_report *report) {
    const double too_much = a->most[span] / options->angle;
    if (!(too_much > 1 + 1e-9)) return a->kept[span];
    if (gained_nothing(a, span)) a->before[span] = -1;
    if (a->before[span] < 0) {
        report->limited = true;
        return a->kept[span];
    }
    const double count = ceil(a->kept[span] * fmin(too_much, FINER));
    if (count > BAT_STEPS_MAX) report->limited = true;
    a->before[span] = a->most[span], a->fewer[span] = a->kept[span];
    return (int)fmin(count, BAT_STEPS_MAX);
}

/* More steps in the spans with too great an angle; false: none, or too many triangles. */
static bool refine(const bat_tessellation *t, const bat_tessellate_options *options, bat_steps *steps,
                   angling *a, bat_tessellate_report *report) {
    const int spans = steps->spans[0] + steps->spans[1];
    bool refined = false;
    report->max_angle = 0;
    memcpy(a->kept, steps->count[0], (size_t)spans * sizeof *a->kept);
    memset(a->most, 0, (size_t)spans * sizeof *a->most);
    angles_of(t, 0, a->most);
    angles_of(t, 1, a->most + steps->spans[0]);
    for (int k = 0; k < spans; k++) {
        report->max_angle = fmax(report->max_angle, a->most[k]);
        steps->count[0][k] = steps_for(options, a, k, report);
        refined = refined || steps->count[0][k] != a->kept[k];
    }
    if (!refined || bat_steps_triangles(steps) <= (double)options->triangles_max) return refined;
    memcpy(steps->count[0], a->kept, (size_t)spans * sizeof *a->kept);
    report->limited = true;
    return false;
}

/* ---- Triangles ---- */

/* Twice the area is compared with the square of the longest side: narrower ones are no triangles. */
static bool has_area(const double *a, const double *b, const double *c) {
    const vec p = vec_load(a, 3), q = vec_load(b, 3), r = vec_load(c, 3);
    const vec x = vec_sub(q, p), y = vec_sub(r, p), z = vec_sub(r, q);
    const double longest = fmax(vec_norm(x), fmax(vec_norm(y), vec_norm(z)));
    if (!(longest > 0)) return false;
    const vec cross = vec_cross(vec_scale(x, 1 / longest), vec_scale(y, 1 / longest));
    return vec_norm(cross) > 1e-12;
}

static void put_triangle(bat_tessellation *t, size_t a, size_t b, size_t c) {
    if (!has_area(t->points + 3 * a, t->points + 3 * b, t->points + 3 * c)) return;
    int *to = t->triangles + 3 * t->triangle_count++;
    to[0] = (int)a, to[1] = (int)b, to[2] = (int)c;
}

static bat_status build_triangles(bat_tessellation *t) {
    const size_t m = t->count[0], n = t->count[1];
    t->triangles = malloc(6 * m * n * sizeof *t->triangles);
    if (!t->triangles) return BAT_MEMORY;
    for (size_t i = 0; i < m; i++) {
        if (t->stop[0][i].joint || (i + 1 == m && !t->wraps[0])) continue;
        for (size_t j = 0; j < n; j++) {
            if (t->stop[1][j].joint || (j + 1 == n && !t->wraps[1])) continue;
            const size_t k = i + 1 == m ? 0 : i + 1, l = j + 1 == n ? 0 : j + 1;
            put_triangle(t, i * n + j, k * n + j, k * n + l);
            put_triangle(t, i * n + j, k * n + l, i * n + l);
        }
    }
    return BAT_OK;
}

/* ---- The whole ---- */

static bat_status read_options(const bat_surface *surface, const bat_tessellate_options *given,
                               bat_tessellate_options *own) {
    *own = DEFAULTS;
    bat_status status = bat_options_read(given, sizeof *own, sizeof *own, own);
    if (status != BAT_OK) return status;
    if (!isfinite(own->tolerance) || !isfinite(own->angle)) return BAT_NUMBER;
    if (own->tolerance < 0 || own->angle < 0) return BAT_ARGUMENT;
    if (own->tolerance == 0) own->tolerance = 1e-3 * surface->size;
    own->tolerance = fmax(own->tolerance, 1e-16 * surface->size); /* no finer than the points themselves */
    if (own->angle == 0) own->angle = 0.25;
    if (own->triangles_max == 0) own->triangles_max = TRIANGLES;
    if (own->triangles_max > INT_MAX / 8) own->triangles_max = INT_MAX / 8;
    return BAT_OK;
}

/* Steps for the chord; while they give too many triangles, for a greater one. */
static bat_status first_steps(const bat_tessellate_options *options, bat_steps *steps, bool *limited) {
    const double most = (double)options->triangles_max;
    if (2.0 * steps->spans[0] * steps->spans[1] > most) return BAT_COUNT;
    double tolerance = options->tolerance;
    bat_steps_to_chord(steps, tolerance);
    while (bat_steps_triangles(steps) > most && tolerance < 1e200)
        bat_steps_to_chord(steps, tolerance = coarser * tolerance);
    *limited = tolerance > options->tolerance || bat_steps_chord(steps) > options->tolerance * (1 + 1e-6);
    return BAT_OK;
}

/* Vertices for the steps, and again for more of them while angles are too great. */
static bat_status settle_angles(const bat_surface *surface, const bat_tessellate_options *options,
                                bat_steps *steps, bat_tessellation **out, bat_tessellate_report *report) {
    angling a;
    bat_status status = begin_angling(steps, &a);
    bat_tessellation *t = NULL;
    for (int round = 0; status == BAT_OK; round++) {
        bat_tessellation_free(t);
        t = NULL;
        status = build_vertices(surface, steps, &t);
        if (status != BAT_OK || !refine(t, options, steps, &a, report)) break;
        if (round == ROUNDS) {
            const size_t spans = (size_t)(steps->spans[0] + steps->spans[1]);
            memcpy(steps->count[0], a.kept, spans * sizeof *a.kept);
            report->limited = true;
            break;
        }
    }
    end_angling(&a);
    if (status == BAT_OK) *out = t;
    return status;
}

static bat_status build(const bat_surface *surface, const bat_tessellate_options *options, bat_steps *steps,
                        bat_tessellation **out, bat_tessellate_report *report) {
    bat_status status = first_steps(options, steps, &report->limited);
    bat_tessellation *t = NULL;
    if (status == BAT_OK) status = settle_angles(surface, options, steps, &t, report);
    if (status == BAT_OK) status = build_triangles(t);
    report->max_error = bat_steps_chord(steps);
    if (status == BAT_OK)
        *out = t;
    else
        bat_tessellation_free(t);
    return status;
}

bat_status bat_surface_tessellate(const bat_surface *surface, const bat_tessellate_options *options,
                                  bat_tessellation **out, bat_tessellate_report *report) {
    if (!surface || !out) return BAT_ARGUMENT;
    bat_tessellate_options own;
    bat_tessellate_report found = {.max_angle = 0};
    bat_status status = read_options(surface, options, &own);
    if (status != BAT_OK) return status;
    bat_steps steps;
    status = bat_steps_create(surface, &steps);
    if (status != BAT_OK) return status;
    bat_tessellation *made = NULL;
    status = build(surface, &own, &steps, &made, &found);
    bat_steps_clear(&steps);
    if (status != BAT_OK) return status;
    *out = made;
    if (report) *report = found;
    return BAT_OK;
}
