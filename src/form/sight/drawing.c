/* The lines that are seen of a scene: each stretch becomes Bezier segments. */
#include "curve/fit.h"
#include "form/sight/strand.h"
#include <batten/bezier.h>
#include <batten/fit.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SURFACES_MAX = 1000 };
static const double tolerance = 0.05; /* of fits, pixels */
static const double spacing = 1.5;    /* of points that are fitted, pixels */

typedef struct run {
    bat_seen_line line;
    double *points; /* owned */
} run;

struct bat_line_drawing {
    run *runs;
    size_t count, room;
    bool whole;
};

/* ---- stretches ---- */

/* Adds the points of a stretch, in pixels; returns how many. out may be NULL. */
static size_t points_of(const bat_sight_scene *s, const bat_strand *strand, const bat_seen_stretch *r,
                        double *out) {
    size_t count = 0;
    bat_bead a, b;
    bat_strand_locate(s, strand, r->from, &a);
    if (out) memcpy(out, a.pixel, sizeof a.pixel);
    count++;
    for (double k = floor(r->from) + 1; a.depth > 0; k++) {
        const double to = fmin(k, r->to);
        bat_strand_locate(s, strand, to, &b);
        const double wide = bat_hypot(b.pixel[0] - a.pixel[0], b.pixel[1] - a.pixel[1]);
        const double parts = fmin(fmax(ceil(wide / spacing), 1), 64);
        for (double n = 1; n <= parts && wide > 1e-7; n++, count++)
            for (int d = 0; d < 2 && out; d++)
                out[2 * count + (size_t)d] = n == parts ? b.pixel[d]
                                                        : a.pixel[d] + (b.pixel[d] - a.pixel[d]) * n / parts;
        a = b;
        if (to >= r->to) break;
    }
    return count;
}

static bat_status segments_of(size_t count, const double *points, int *segments, double **out) {
    bat_curve *curve = NULL;
    double *cubics = NULL;
    bat_fit_options options;
    bat_fit_options_init(&options, sizeof options);
    options.tolerance = tolerance, options.hold_ends = true;
    bat_status status = bat_fit_plain(2, count, points, &options, &curve, NULL);
    if (status == BAT_TOLERANCE) status = BAT_OK;
    if (status == BAT_OK) status = bat_curve_to_cubics(curve, 1e-3, segments, &cubics);
    bat_curve_free(curve);
    if (status != BAT_OK) return status;
    double *joined = malloc(((size_t)*segments * 6 + 2) * sizeof *joined);
    if (joined) { /* shared ends once */
        memcpy(joined, cubics, 2 * sizeof *joined);
        for (int i = 0; i < *segments; i++)
            memcpy(joined + 2 + 6 * i, cubics + 8 * i + 2, 6 * sizeof *joined);
    }
    bat_free(cubics);
    *out = joined;
    return joined ? BAT_OK : BAT_MEMORY;
}

static bat_status add_run(bat_line_drawing *drawing, const bat_strand *strand, bool hidden, int segments,
                          double *points) {
    if (drawing->count == drawing->room) {
        const size_t room = 2 * drawing->room + 32;
        run *more = realloc(drawing->runs, room * sizeof *more);
        if (!more) {
            free(points);
            return BAT_MEMORY;
        }
        drawing->runs = more, drawing->room = room;
    }
    drawing->runs[drawing->count++] = (run){{strand->kind, strand->source, hidden, segments, points}, points};
    return BAT_OK;
}

/* A piece of a stretch within the window and around it. */
static bat_status draw_near(const bat_sight_scene *s, const bat_strand *strand, const bat_seen_stretch *r,
                            bat_line_drawing *drawing) {
    const size_t count = points_of(s, strand, r, NULL);
    if (count < 2) return BAT_OK;
    double *points = malloc(2 * count * sizeof *points), *out = NULL;
    int segments = 0;
    if (!points) return BAT_MEMORY;
    points_of(s, strand, r, points);
    bat_status status = segments_of(count, points, &segments, &out);
    free(points);
    if (status == BAT_COUNT) return BAT_OK; /* it is a point */
    return status == BAT_OK ? add_run(drawing, strand, r->hidden, segments, out) : status;
}

/* A piece beyond it: straight from bead to bead, since a fit could lead into the window. */
static bat_status draw_far(const bat_sight_scene *s, const bat_strand *strand, const bat_seen_stretch *r,
                           bat_line_drawing *drawing) {
    const double first = floor(r->from) + 1, last = ceil(r->to);
    const int segments = (int)(last - first) + 1;
    double *points = malloc(((size_t)segments * 6 + 2) * sizeof *points);
    bat_bead a, b;
    if (!points) return BAT_MEMORY;
    bat_strand_locate(s, strand, r->from, &a);
    memcpy(points, a.pixel, sizeof a.pixel);
    for (int i = 0; i < segments; i++, a = b) {
        bat_strand_locate(s, strand, fmin(first + i, r->to), &b);
        for (int k = 1; k <= 3; k++)
            for (int d = 0; d < 2; d++)
                points[6 * i + 2 * k + d] = a.pixel[d] + (b.pixel[d] - a.pixel[d]) * k / 3;
    }
    return add_run(drawing, strand, r->hidden, segments, points);
}

/* Whether bead k and the next one are beyond the window. */
static bool is_far(const bat_sight_scene *s, const bat_strand *strand, size_t k) {
    return bat_sight_beyond(s, &strand->beads[k], &strand->beads[k + 1]) > 0;
}

static bat_status draw_stretch(const bat_sight_scene *s, const bat_strand *strand, const bat_seen_stretch *r,
                               bat_line_drawing *drawing) {
    const size_t last = strand->count - 2;
    bat_seen_stretch piece = *r;
    bat_status status = BAT_OK;
    for (size_t k = (size_t)r->from; k <= last && (double)k < r->to && status == BAT_OK; k++) {
        const bool beyond = is_far(s, strand, k), end = k == last || !((double)(k + 1) < r->to);
        if (!end && is_far(s, strand, k + 1) == beyond) continue;
        piece.to = end ? r->to : (double)(k + 1);
        status = (beyond ? draw_far : draw_near)(s, strand, &piece, drawing);
        piece.from = piece.to;
    }
    return status;
}

static bat_status draw_strand(const bat_sight_scene *s, const bat_strand *strand, bat_line_drawing *drawing) {
    bat_seen_stretch *stretches = NULL;
    size_t count = 0;
    bat_status status = bat_strand_stretches(s, strand, &stretches, &count);
    for (size_t i = 0; i < count && status == BAT_OK; i++)
        status = draw_stretch(s, strand, &stretches[i], drawing);
    free(stretches);
    return status;
}

/* ---- the whole ---- */

/* Depths below a thousandth of the farthest corner's are not drawn. */
static double near_of(const bat_sight_scene *s) {
    double far = 0;
    for (size_t i = 0; i < s->scene->surface_count; i++)
        for (int k = 0; k < 8 && s->finders[i]; k++) {
            const bat_box *box = &s->finders[i]->whole;
            const vec corner = {k & 1 ? box->high[0] : box->low[0], k & 2 ? box->high[1] : box->low[1],
                                k & 4 ? box->high[2] : box->low[2]};
            far = fmax(far, vec_dot(vec_sub(corner, s->gaze.eye), s->gaze.ahead));
        }
    for (size_t i = 0; i < s->scene->curve_count; i++)
        for (int k = 0; k < s->scene->curves[i]->spread; k++) {
            const bat_curve *c = s->scene->curves[i];
            const vec p = vec_load(c->points + k * c->dimension, c->dimension);
            far = fmax(far, vec_dot(vec_sub(p, s->gaze.eye), s->gaze.ahead));
        }
    return s->gaze.focus > 0 ? 1e-3 * far : -INFINITY;
}

static bat_status check(const bat_viewpoint *view, const bat_line_scene *scene, bat_gaze *gaze) {
    if ((scene->surface_count > 0 && !scene->surfaces) || (scene->curve_count > 0 && !scene->curves))
        return BAT_ARGUMENT;
    for (size_t i = 0; i < scene->surface_count; i++)
        if (!scene->surfaces[i]) return BAT_ARGUMENT;
    for (size_t i = 0; i < scene->curve_count; i++)
        if (!scene->curves[i]) return BAT_ARGUMENT;
    if (scene->surface_count > SURFACES_MAX) return BAT_COUNT;
    return bat_gaze_of(view, gaze);
}

bat_status bat_sight_open(bat_sight_scene *s, const bat_viewpoint *view, const bat_line_scene *scene) {
    *s = (bat_sight_scene){.scene = scene, .whole = true};
    bat_status status = check(view, scene, &s->gaze);
    if (status != BAT_OK) return status;
    s->finders = calloc(scene->surface_count + 1, sizeof *s->finders);
    if (!s->finders) return BAT_MEMORY;
    for (size_t i = 0; i < scene->surface_count && status == BAT_OK; i++)
        status = bat_surface_finder_create(scene->surfaces[i], &s->finders[i]);
    if (status == BAT_OK) s->near = near_of(s);
    if (status == BAT_OK) status = bat_strands_make(s);
    if (status == BAT_OK) status = bat_strands_split(s);
    if (status != BAT_OK) bat_sight_close(s);
    return status;
}

void bat_sight_close(bat_sight_scene *s) {
    for (size_t i = 0; i < s->scene->surface_count && s->finders; i++) bat_surface_finder_free(s->finders[i]);
    free(s->finders);
    s->finders = NULL;
    bat_strands_free(s);
}

bat_status bat_line_drawing_create(const bat_viewpoint *view, const bat_line_scene *scene,
                                   bat_line_drawing **out) {
    bat_sight_scene s;
    if (!view || !scene || !out) return BAT_ARGUMENT;
    bat_status status = bat_sight_open(&s, view, scene);
    if (status != BAT_OK) return status;
    bat_line_drawing *drawing = calloc(1, sizeof *drawing);
    if (!drawing) status = BAT_MEMORY;
    for (size_t i = 0; i < s.count && status == BAT_OK; i++) status = draw_strand(&s, &s.strands[i], drawing);
    if (status == BAT_OK) drawing->whole = s.whole;
    bat_sight_close(&s);
    if (status == BAT_OK)
        *out = drawing;
    else
        bat_line_drawing_free(drawing);
    return status;
}

void bat_line_drawing_free(bat_line_drawing *drawing) {
    for (size_t i = 0; drawing && i < drawing->count; i++) free(drawing->runs[i].points);
    if (drawing) free(drawing->runs);
    free(drawing);
}

size_t bat_line_drawing_count(const bat_line_drawing *drawing) { return drawing->count; }
void bat_line_drawing_at(const bat_line_drawing *drawing, size_t i, bat_seen_line *out) {
    if (i < drawing->count)
        *out = drawing->runs[i].line;
    else
        *out = (bat_seen_line){0};
}
bool bat_line_drawing_is_whole(const bat_line_drawing *drawing) { return drawing->whole; }
