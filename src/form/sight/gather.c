/* The strands of a scene: edges, parameter lines, curves, silhouettes, intersections. */
#include "form/sight/strand.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LINES = 63, DEPTH_LEAST = 2, DEPTH_MOST = 30 };
static const double chord = 3e-3, longest = 6; /* pixels */
static const double far_off = 0.05,
                    apart = 0.5; /* more of these, as shares of the distance from what is seen */

static bat_status begin(bat_sight_scene *s, const bat_strand *like, bat_strand **out) {
    if (s->count == s->room) {
        const size_t room = 2 * s->room + 16;
        bat_strand *more = realloc(s->strands, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        s->strands = more, s->room = room;
    }
    s->strands[s->count] = *like;
    *out = &s->strands[s->count++];
    return BAT_OK;
}

static bat_status add(bat_strand *strand, const bat_bead *bead) {
    if (strand->count == strand->room) {
        const size_t room = 2 * strand->room + 32;
        bat_bead *more = realloc(strand->beads, room * sizeof *more);
        if (!more) return BAT_MEMORY;
        strand->beads = more, strand->room = room;
    }
    strand->beads[strand->count++] = *bead;
    return BAT_OK;
}

static void see(const bat_sight_scene *s, bat_bead *bead) {
    double at[3], out[3];
    vec_store(bead->at, at);
    bat_gaze_image(&s->gaze, at, out);
    bead->pixel[0] = out[0], bead->pixel[1] = out[1], bead->depth = out[2];
}

/* ---- along curves ---- */

static bat_bead on_curve(const bat_sight_scene *s, const bat_strand *strand, double t) {
    double p[3];
    bat_bead bead = {.t = t};
    bat_curve_eval(strand->curve, t, 0, p);
    bead.at = vec_load(p, strand->curve->dimension);
    if (strand->side[0]) bead.uv[strand->direction] = strand->fixed, bead.uv[1 - strand->direction] = t;
    see(s, &bead);
    return bead;
}

static double off_chord(const bat_bead *a, const bat_bead *m, const bat_bead *b) {
    const double x = b->pixel[0] - a->pixel[0], y = b->pixel[1] - a->pixel[1];
    const double p = m->pixel[0] - a->pixel[0], q = m->pixel[1] - a->pixel[1], square = x * x + y * y;
    const double f = square > 0 ? fmin(fmax((x * p + y * q) / square, 0), 1) : 0;
    return bat_hypot(p - f * x, q - f * y);
}

static bat_status refine(const bat_sight_scene *s, bat_strand *strand, const bat_bead *a, const bat_bead *b,
                         int depth) {
    const bat_bead middle = on_curve(s, strand, 0.5 * (a->t + b->t));
    const bool seen = a->depth > s->near || b->depth > s->near || middle.depth > s->near;
    const double wide = bat_hypot(b->pixel[0] - a->pixel[0], b->pixel[1] - a->pixel[1]);
    const double beyond = fmin(bat_sight_beyond(s, a, &middle), bat_sight_beyond(s, &middle, b));
    if (depth < DEPTH_LEAST ||
        (depth < DEPTH_MOST && seen &&
         (wide > longest + apart * beyond || off_chord(a, &middle, b) > chord + far_off * beyond))) {
        bat_status status = refine(s, strand, a, &middle, depth + 1);
        return status == BAT_OK ? refine(s, strand, &middle, b, depth + 1) : status;
    }
    return add(strand, b);
}

/* Takes the curve over. A strand that is a point is left out. */
static bat_status add_curve(bat_sight_scene *s, const bat_strand *like) {
    bat_strand *strand;
    bat_status status = begin(s, like, &strand);
    if (status != BAT_OK) {
        bat_curve_free(like->curve);
        return status;
    }
    const bat_curve *c = strand->curve;
    bat_bead from = on_curve(s, strand, c->knots[c->degree]);
    status = add(strand, &from);
    for (int i = c->degree; i < c->spread && status == BAT_OK; i++) {
        if (!(c->knots[i] < c->knots[i + 1])) continue;
        /* the end of a closed curve is its start */
        bat_bead to = on_curve(s, strand, c->knots[i + 1]);
        status = refine(s, strand, &from, &to, 0);
        if (bat_knot_multiplicity(c, c->knots[i + 1]) >= c->degree && status == BAT_OK && c->degree > 0)
            status = bat_strand_split(strand, (double)(strand->count - 1), true);
        from = to;
    }
    return status;
}

static bat_status add_line(bat_sight_scene *s, size_t source, int direction, double at, bat_line_kind kind) {
    const bat_surface *surface = s->scene->surfaces[source];
    bat_strand like = {
        .kind = kind, .source = source, .side = {surface, NULL}, .direction = direction, .fixed = at};
    bat_status status = bat_surface_isocurve(surface, (bat_direction)direction, at, &like.curve);
    if (status != BAT_OK) return status;
    if (bat_curve_size(like.curve) > 1e-9 * surface->size) return add_curve(s, &like);
    bat_curve_free(like.curve);
    return BAT_OK;
}

/* Edges of open directions, and lines at knots. */
static bat_status add_lines(bat_sight_scene *s, size_t source) {
    bat_status status = BAT_OK;
    for (int d = 0; d < 2; d++) {
        const bat_curve *axis = &s->scene->surfaces[source]->axis[d];
        const double *knots = axis->knots;
        long inner = 0, seen = 0;
        for (int i = axis->degree + 1; i < axis->spread; i++) inner += knots[i] > knots[i - 1];
        const long most = inner < LINES ? inner : LINES;
        for (int i = axis->degree; i <= axis->spread && status == BAT_OK; i++) {
            const bool end = i == axis->degree || i == axis->spread;
            if (end && (!axis->closed || i == axis->degree))
                status = add_line(s, source, d, knots[i], axis->closed ? BAT_LINE_PARAMETER : BAT_LINE_EDGE);
            if (end || !(knots[i] > knots[i - 1]) || !(knots[i] < knots[axis->spread])) continue;
            seen++; /* of too many, an even choice */
            if (seen * most / inner > (seen - 1) * most / inner)
                status = add_line(s, source, d, knots[i], BAT_LINE_PARAMETER);
        }
    }
    return status;
}

/* ---- along tracks ---- */

/* Adds a bead of a track, and before it as many as keep beads from being far apart. */
static bat_status add_bead(const bat_sight_scene *s, bat_strand *strand, const bat_bead *bead) {
    bat_status status = BAT_OK;
    if (strand->count > 0) {
        bat_bead ends[2] = {strand->beads[strand->count - 1], *bead}, inner;
        bat_strand piece = *strand;
        piece.beads = ends, piece.count = 2;
        const double wide = bat_hypot(ends[1].pixel[0] - ends[0].pixel[0],
                                      ends[1].pixel[1] - ends[0].pixel[1]);
        const double beyond = bat_sight_beyond(s, &ends[0], bead);
        const double parts = beyond > 0 ? 0 : fmin(floor(wide / (2 * longest)), 100);
        for (double k = 1; k <= parts && status == BAT_OK; k++) {
            bat_strand_locate(s, &piece, k / (parts + 1), &inner);
            status = add(strand, &inner);
        }
    }
    return status == BAT_OK ? add(strand, bead) : status;
}

static bat_status add_tracks(bat_sight_scene *s, const bat_tracks *tracks, const bat_strand *like) {
    bat_status status = BAT_OK;
    for (size_t i = 0; i < bat_tracks_count(tracks) && status == BAT_OK; i++) {
        const bat_track_point *p;
        const size_t count = bat_tracks_points(tracks, i, &p);
        bat_strand *strand;
        status = begin(s, like, &strand);
        for (size_t k = 0; k < count && status == BAT_OK; k++) {
            bat_bead bead = {.uv = {p[k].uv[0], p[k].uv[1], p[k].other_uv[0], p[k].other_uv[1]}};
            bead.at = vec_load(p[k].point, 3);
            see(s, &bead);
            status = add_bead(s, strand, &bead);
        }
    }
    if (bat_tracks_is_given_up(tracks)) s->whole = false;
    return status;
}

static bat_status add_silhouettes(bat_sight_scene *s, size_t source) {
    const bat_silhouette silhouette = {s->scene->surfaces[source], s->gaze};
    const bat_strand like = {
        .kind = BAT_LINE_SILHOUETTE, .source = source, .side = {silhouette.surface, NULL}};
    bat_tracks *tracks = NULL;
    bat_status status = bat_silhouettes_trace(&silhouette, &tracks);
    if (status == BAT_OK) status = add_tracks(s, tracks, &like);
    bat_tracks_free(tracks);
    return status;
}

static bool boxes_meet(const bat_box *a, const bat_box *b) {
    for (int c = 0; c < 3; c++)
        if (a->low[c] > b->high[c] || b->low[c] > a->high[c]) return false;
    return true;
}

/* The length of a pixel at the scene's nearest corner, at least. */
static double pixel_length(const bat_sight_scene *s, const bat_box *box) {
    double least = INFINITY;
    for (int k = 0; k < 8; k++) {
        const vec corner = {k & 1 ? box->high[0] : box->low[0], k & 2 ? box->high[1] : box->low[1],
                            k & 4 ? box->high[2] : box->low[2]};
        const double one = bat_gaze_pixel(&s->gaze, corner);
        if (one > 0) least = fmin(least, one);
    }
    return least < INFINITY ? least : 0;
}

static bat_status add_intersections(bat_sight_scene *s, size_t i) {
    bat_status status = BAT_OK;
    for (size_t k = 0; k < i && status == BAT_OK; k++) {
        if (!boxes_meet(&s->finders[k]->whole, &s->finders[i]->whole)) continue;
        const bat_surface *a = s->scene->surfaces[k], *b = s->scene->surfaces[i];
        const bat_strand like = {.kind = BAT_LINE_INTERSECTION, .source = k, .side = {a, b}};
        bat_intersect_options options = bat_intersect_defaults();
        bat_tracks *tracks = NULL;
        const double size = fmin(a->size, b->size);
        options.chord = fmin(fmax(chord * pixel_length(s, &s->finders[i]->whole), 1e-8 * size), 1e-3 * size);
        status = bat_surface_intersect(a, b, &options, &tracks);
        if (status == BAT_OK) status = add_tracks(s, tracks, &like);
        bat_tracks_free(tracks);
    }
    return status;
}

/* ---- all ---- */

static bat_status add_curves(bat_sight_scene *s) {
    bat_status status = BAT_OK;
    for (size_t i = 0; i < s->scene->curve_count && status == BAT_OK; i++) {
        bat_strand like = {.kind = BAT_LINE_CURVE, .source = i};
        status = bat_curve_copy(s->scene->curves[i], &like.curve);
        if (status == BAT_OK) status = add_curve(s, &like);
    }
    return status;
}

/* Cuts strands where they come nearer to the eye than may be drawn. */
static bat_status clip(bat_sight_scene *s) {
    bat_status status = BAT_OK;
    for (size_t i = 0, all = s->count; i < all && status == BAT_OK; i++) {
        bat_strand *from = &s->strands[i];
        size_t kept = 0;
        while (kept < from->count && from->beads[kept].depth > s->near) kept++;
        if (kept == from->count) continue;
        const bat_bead *beads = from->beads;
        const size_t count = from->count;
        for (size_t k = kept; k < count && status == BAT_OK; k++) {
            if (!(beads[k].depth > s->near)) continue;
            bat_strand like = s->strands[i], *piece;
            like.beads = NULL, like.splits = NULL, like.curve = NULL;
            like.count = like.room = like.split_count = like.split_room = 0;
            if (s->strands[i].curve) status = bat_curve_copy(s->strands[i].curve, &like.curve);
            if (status == BAT_OK) status = begin(s, &like, &piece);
            for (; k < count && beads[k].depth > s->near && status == BAT_OK; k++)
                status = add(piece, &beads[k]);
        }
        s->strands[i].count = kept;
        s->strands[i].split_count = 0;
    }
    return status;
}

bat_status bat_strands_make(bat_sight_scene *s) {
    bat_status status = add_curves(s);
    for (size_t i = 0; i < s->scene->surface_count && status == BAT_OK; i++) {
        status = add_lines(s, i);
        if (status == BAT_OK) status = add_silhouettes(s, i);
        if (status == BAT_OK) status = add_intersections(s, i);
    }
    return status == BAT_OK && s->gaze.focus > 0 ? clip(s) : status;
}
