/* A relief as a value: creation, access, copy, and the poles of its base. */
#include "form/relief/relief.h"

#include <stdlib.h>
#include <string.h>

static void level_free(bat_relief_level *level) {
    free(level->details);
    free(level->source);
    free(level->frames);
    bat_surface_free(level->surface);
}

void bat_relief_free(bat_relief *relief) {
    if (!relief) return;
    for (int i = 0; i < relief->count; i++) level_free(&relief->levels[i]);
    bat_surface_free(relief->base);
    free(relief);
}

/* Arrays for a surface, which the level takes over on success; details are zero. */
static bat_status level_allocate(bat_relief_level *level, bat_surface *surface) {
    const size_t n = bat_relief_points(surface);
    *level = (bat_relief_level){.gain = 1, .surface = surface};
    level->details = calloc(3 * n, sizeof *level->details);
    level->source = malloc(n * sizeof *level->source);
    level->frames = calloc(n, sizeof *level->frames);
    if (level->details && level->source && level->frames) return BAT_OK;
    level->surface = NULL;
    level_free(level);
    return BAT_MEMORY;
}

static bat_status level_copy(const bat_relief_level *from, bat_relief_level *to) {
    bat_surface *surface = NULL;
    bat_status status = bat_surface_copy(from->surface, &surface);
    if (status == BAT_OK) status = level_allocate(to, surface);
    if (status != BAT_OK) {
        bat_surface_free(surface);
        return status;
    }
    const size_t n = bat_relief_points(surface);
    to->gain = from->gain, to->muted = from->muted;
    memcpy(to->details, from->details, 3 * n * sizeof *to->details);
    memcpy(to->source, from->source, n * sizeof *to->source);
    memcpy(to->frames, from->frames, n * sizeof *to->frames);
    return BAT_OK;
}

bat_status bat_relief_copy(const bat_relief *relief, bat_relief **out) {
    if (!relief || !out) return BAT_ARGUMENT;
    bat_relief *copy = calloc(1, sizeof *copy);
    if (!copy) return BAT_MEMORY;
    memcpy(copy->pole, relief->pole, sizeof copy->pole);
    bat_status status = bat_surface_copy(relief->base, &copy->base);
    for (int i = 0; i < relief->count && status == BAT_OK; i++) {
        status = level_copy(&relief->levels[i], &copy->levels[i]);
        copy->count += status == BAT_OK;
    }
    if (status != BAT_OK) {
        bat_relief_free(copy);
        return status;
    }
    *out = copy;
    return BAT_OK;
}

void bat_relief_adopt(bat_relief *relief, bat_relief *edited) {
    const bat_relief old = *relief;
    *relief = *edited;
    *edited = old;
    bat_relief_free(edited);
}

/* Edges that are poles, those with a corner in common as one. */
static void find_poles(bat_relief *relief) {
    for (int e = 0; e < BAT_EDGES; e++) relief->pole[e] = bat_edge_is_point(relief->base, e, 0) ? e : -1;
    for (int round = 0; round < 2; round++)
        for (int a = 0; a < 2; a++)
            for (int b = 2; b < BAT_EDGES; b++)
                if (relief->pole[a] >= 0 && relief->pole[b] >= 0) {
                    const int least = relief->pole[a] < relief->pole[b] ? relief->pole[a] : relief->pole[b];
                    relief->pole[a] = relief->pole[b] = least;
                }
}

/* ---- making ---- */

bat_status bat_relief_create(const bat_surface *base, bat_relief **out) {
    if (!base || !out) return BAT_ARGUMENT;
    bat_relief *relief = calloc(1, sizeof *relief);
    bat_status status = relief ? bat_surface_copy(base, &relief->base) : BAT_MEMORY;
    if (status != BAT_OK) {
        bat_relief_free(relief);
        return status;
    }
    find_poles(relief);
    *out = relief;
    return BAT_OK;
}

/* The knots to insert, ascending: one in the middle of every span. Returns how many. */
static int middles(const bat_curve *axis, double *out) {
    int n = 0;
    for (int i = axis->degree; i < axis->spread; i++) {
        const double a = axis->knots[i], b = axis->knots[i + 1], m = a + (b - a) / 2;
        if (m > a && m < b) out[n++] = m;
    }
    return n;
}

static bat_status refined(const bat_surface *below, int d, int count, const double *knots,
                          bat_surface **out) {
    if (knots) return bat_surface_refine(below, (bat_direction)d, count, knots, out);
    double *inserted = malloc(((size_t)below->axis[d].spread + 1) * sizeof *inserted);
    if (!inserted) return BAT_MEMORY;
    bat_status status = bat_surface_insert_knots(below, (bat_direction)d, middles(&below->axis[d], inserted),
                                                 inserted, out);
    free(inserted);
    return status;
}

/* Whether the number of rows or columns can grow to what the knots ask for. */
static bool too_many(const bat_surface *below, const int knot_count[2], const double *const knots[2]) {
    double total = 1;
    for (int d = 0; d < 2; d++) {
        const bat_curve *axis = &below->axis[d];
        total *= knots[d] ? knot_count[d] : axis->count + axis->spread - axis->degree;
    }
    return total > BAT_POINTS_MAX;
}

bat_status bat_relief_push(bat_relief *relief, const int knot_count[2], const double *const knots[2]) {
    if (relief->count == BAT_RELIEF_LEVELS) return BAT_COUNT;
    const bat_surface *below = bat_relief_at(relief, relief->count);
    if (too_many(below, knot_count, knots)) return BAT_COUNT;
    bat_surface *tall = NULL, *fine = NULL;
    bat_status status = refined(below, 0, knots[0] ? knot_count[0] : 0, knots[0], &tall);
    if (status == BAT_OK) status = refined(tall, 1, knots[1] ? knot_count[1] : 0, knots[1], &fine);
    bat_surface_free(tall);
    /* An unclamped end that was trimmed would be no refinement. */
    for (int d = 0; d < 2 && status == BAT_OK; d++) {
        double a[2], b[2];
        bat_surface_domain(below, (bat_direction)d, a);
        bat_surface_domain(fine, (bat_direction)d, b);
        if (a[0] != b[0] || a[1] != b[1]) status = BAT_KNOTS;
    }
    if (status == BAT_OK) status = level_allocate(&relief->levels[relief->count], fine);
    if (status != BAT_OK) {
        bat_surface_free(fine);
        return status;
    }
    const size_t n = bat_relief_points(fine);
    for (size_t i = 0; i < n; i++) relief->levels[relief->count].source[i] = relief->count;
    relief->count++;
    return BAT_OK;
}

void bat_relief_pop(bat_relief *relief) { level_free(&relief->levels[--relief->count]); }

/* Takes what is given, and builds the newest level. */
static bat_status fill(bat_relief *relief, const double *details, const int *source) {
    const int j = relief->count;
    bat_relief_level *level = &relief->levels[j - 1];
    const size_t n = bat_relief_points(level->surface);
    for (size_t i = 0; source && i < n; i++) {
        level->source[i] = source[i];
        if (source[i] < 0 || source[i] >= j) return BAT_ARGUMENT;
    }
    for (size_t i = 0; details && i < 3 * n; i++) {
        level->details[i] = details[i];
        if (!(fabs(details[i]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    }
    bat_pole_mean(level->surface, relief->pole, level->details);
    bat_status status = bat_relief_frames(relief, j, level->frames);
    return status == BAT_OK ? bat_relief_build(relief, j) : status;
}

bat_status bat_relief_add_level(bat_relief *relief, const int knot_count[2], const double *u_knots,
                                const double *v_knots, const double *details, const int *source) {
    if (!relief || ((u_knots || v_knots) && !knot_count)) return BAT_ARGUMENT;
    const int none[2] = {0, 0};
    const double *const knots[2] = {u_knots, v_knots};
    bat_status status = bat_relief_push(relief, knot_count ? knot_count : none, knots);
    if (status != BAT_OK) return status;
    status = fill(relief, details, source);
    if (status != BAT_OK) bat_relief_pop(relief);
    return status;
}

int bat_relief_levels(const bat_relief *relief) { return relief->count; }
const bat_surface *bat_relief_surface(const bat_relief *relief, int level) {
    return level >= 0 && level <= relief->count ? bat_relief_at(relief, level) : NULL;
}

/* What a level is that does not exist: it shows nothing. */
static const bat_relief_level none = {0};
static const bat_relief_level *level_of(const bat_relief *relief, int level) {
    return level >= 1 && level <= relief->count ? &relief->levels[level - 1] : &none;
}

const double *bat_relief_details(const bat_relief *relief, int level) {
    return level_of(relief, level)->details;
}
const int *bat_relief_source(const bat_relief *relief, int level) { return level_of(relief, level)->source; }
double bat_relief_gain(const bat_relief *relief, int level) { return level_of(relief, level)->gain; }
bool bat_relief_is_muted(const bat_relief *relief, int level) { return level_of(relief, level)->muted; }
