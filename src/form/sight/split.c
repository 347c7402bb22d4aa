/* Where visibility can change along strands: crossings in the image, folds and cusps. */
#include "form/sight/strand.h"

#include <math.h>
#include <stdlib.h>

enum { HALVINGS = 40, COVER = 6 };
static const double cell = 16, touching = 0.02; /* pixels */

/* ---- crossings ---- */

typedef struct entry {
    size_t strand, bead;
    long next;
    int x, y;
} entry;

typedef struct grid {
    entry *entries;
    size_t count, room, mask;
    long *heads;
} grid;

static bool occludes(const bat_strand *strand) {
    return strand->kind == BAT_LINE_EDGE || strand->kind == BAT_LINE_SILHOUETTE ||
           strand->kind == BAT_LINE_INTERSECTION;
}

static size_t slot(const grid *g, int x, int y) {
    return ((size_t)(unsigned)x * 73856093u ^ (size_t)(unsigned)y * 19349663u) & g->mask;
}

/* The cells of a segment's box, or false when it is far too large. */
static bool cells_of(const bat_bead *a, int from[2], int to[2]) {
    for (int d = 0; d < 2; d++) {
        const double low = fmin(a[0].pixel[d], a[1].pixel[d]) / cell,
                     high = fmax(a[0].pixel[d], a[1].pixel[d]) / cell;
        if (!(low > -1e8 && high < 1e8) || high - low > COVER) return false;
        from[d] = (int)floor(low), to[d] = (int)floor(high);
    }
    return true;
}

static bool put(grid *g, size_t strand, size_t bead, int x, int y) {
    if (g->count == g->room) {
        const size_t room = 2 * g->room + 1024;
        entry *more = realloc(g->entries, room * sizeof *more);
        if (!more) return false;
        g->entries = more, g->room = room;
    }
    g->entries[g->count++] = (entry){strand, bead, -1, x, y};
    return true;
}

static bat_status fill(const bat_sight_scene *s, grid *g) {
    for (size_t i = 0; i < s->count; i++) {
        const bat_strand *strand = &s->strands[i];
        for (size_t k = 0; k + 1 < strand->count && occludes(strand); k++) {
            int from[2], to[2];
            if (!cells_of(&strand->beads[k], from, to)) continue;
            for (int x = from[0]; x <= to[0]; x++)
                for (int y = from[1]; y <= to[1]; y++)
                    if (!put(g, i, k, x, y)) return BAT_MEMORY;
        }
    }
    for (g->mask = 1023; g->mask < g->count; g->mask = 2 * g->mask + 1) {
    }
    g->heads = malloc((g->mask + 1) * sizeof *g->heads);
    if (!g->heads) return BAT_MEMORY;
    for (size_t i = 0; i <= g->mask; i++) g->heads[i] = -1;
    for (size_t i = 0; i < g->count; i++) {
        long *head = &g->heads[slot(g, g->entries[i].x, g->entries[i].y)];
        g->entries[i].next = *head, *head = (long)i;
    }
    return BAT_OK;
}

/* Where segment a crosses b in the image, when b is not behind it. */
static bool crosses(const bat_sight_scene *s, const bat_bead *a, const bat_bead *b, double *place) {
    const double ax = a[1].pixel[0] - a[0].pixel[0], ay = a[1].pixel[1] - a[0].pixel[1];
    const double bx = b[1].pixel[0] - b[0].pixel[0], by = b[1].pixel[1] - b[0].pixel[1];
    const double x = b[0].pixel[0] - a[0].pixel[0], y = b[0].pixel[1] - a[0].pixel[1],
                 det = ax * by - ay * bx;
    const double f = (x * by - y * bx) / det, g = (x * ay - y * ax) / det;
    const double past_a = touching / bat_hypot(ax, ay),
                 past_b = touching / bat_hypot(bx, by); /* ends may meet */
    if (!(f >= -past_a && f <= 1 + past_a && g >= -past_b && g <= 1 + past_b)) return false;
    const double mine = a[0].depth + f * (a[1].depth - a[0].depth),
                 its = b[0].depth + g * (b[1].depth - b[0].depth);
    *place = f;
    return its <= mine + 4 * bat_gaze_pixel(&s->gaze, a[0].at);
}

static bat_status split_segment(const bat_sight_scene *s, const grid *g, size_t i, size_t k) {
    bat_strand *strand = &s->strands[i];
    int from[2], to[2];
    bat_status status = BAT_OK;
    if (!cells_of(&strand->beads[k], from, to)) return BAT_OK;
    for (int x = from[0]; x <= to[0]; x++)
        for (int y = from[1]; y <= to[1]; y++)
            for (long at = g->heads[slot(g, x, y)]; at >= 0 && status == BAT_OK; at = g->entries[at].next) {
                const entry *e = &g->entries[at];
                double place;
                if (e->x != x || e->y != y || (e->strand == i && e->bead + 1 >= k && e->bead <= k + 1))
                    continue;
                if (crosses(s, &strand->beads[k], &s->strands[e->strand].beads[e->bead], &place))
                    status = bat_strand_split(strand, (double)k + place, false);
            }
    return status;
}

static bat_status split_crossings(bat_sight_scene *s) {
    grid g = {.entries = NULL};
    bat_status status = fill(s, &g);
    for (size_t i = 0; i < s->count && status == BAT_OK; i++)
        for (size_t k = 0; k + 1 < s->strands[i].count && status == BAT_OK; k++)
            status = split_segment(s, &g, i, k);
    free(g.entries);
    free(g.heads);
    return status;
}

/* ---- folds ---- */

/* The silhouettes of a surface are split where they come nearest to a fold. */
static bat_status split_silhouettes(bat_sight_scene *s, const bat_surface *surface, const bat_bead *fold) {
    bat_status status = BAT_OK;
    for (size_t i = 0; i < s->count && status == BAT_OK; i++) {
        bat_strand *strand = &s->strands[i];
        double least = bat_gaze_pixel(&s->gaze, fold->at), best = -1; /* within a pixel */
        if (strand->kind != BAT_LINE_SILHOUETTE || strand->side[0] != surface) continue;
        for (size_t k = 0; k + 1 < strand->count; k++) {
            const vec a = strand->beads[k].at, way = vec_sub(strand->beads[k + 1].at, a);
            const double square = vec_dot(way, way);
            const double f = square > 0 ? fmin(fmax(vec_dot(vec_sub(fold->at, a), way) / square, 0), 1) : 0;
            const double far = vec_norm(vec_sub(fold->at, vec_add(a, vec_scale(way, f))));
            if (far < least) least = far, best = (double)k + f;
        }
        if (best >= 0) status = bat_strand_split(strand, best, false);
    }
    return status;
}

static double facing(const bat_sight_scene *s, const bat_strand *strand, int side, const bat_bead *bead) {
    return bat_strand_facing(s, strand->side[side], bead->uv + 2 * side, NULL);
}

static bat_status split_fold(bat_sight_scene *s, size_t i, int side, size_t k, bool first) {
    const bat_strand *strand = &s->strands[i];
    double low = (double)k, high = (double)k + 1;
    bat_bead bead = strand->beads[k];
    for (int n = 0; n < HALVINGS; n++) {
        const double middle = 0.5 * (low + high);
        bat_strand_locate(s, strand, middle, &bead);
        if ((facing(s, strand, side, &bead) > 0) == first)
            low = middle;
        else
            high = middle;
    }
    bat_status status = bat_strand_split(&s->strands[i], 0.5 * (low + high), false);
    return status == BAT_OK && occludes(strand) ? split_silhouettes(s, strand->side[side], &bead) : status;
}

static bat_status split_folds(bat_sight_scene *s, size_t i) {
    bat_status status = BAT_OK;
    for (int side = 0; side < 2; side++) {
        const bat_strand *strand = &s->strands[i];
        if (!strand->side[side] || strand->kind == BAT_LINE_SILHOUETTE || strand->count < 2) continue;
        bool before = facing(s, strand, side, &strand->beads[0]) > 0;
        for (size_t k = 0; k + 1 < strand->count && status == BAT_OK; k++) {
            const bool after = facing(s, strand, side, &s->strands[i].beads[k + 1]) > 0;
            if (after != before) status = split_fold(s, i, side, k, before);
            before = after;
        }
    }
    return status;
}

/* ---- cusps: the image turns back ---- */

static bat_status split_cusps(bat_strand *strand) {
    bat_status status = BAT_OK;
    for (size_t k = 1; k + 1 < strand->count && strand->kind == BAT_LINE_SILHOUETTE && status == BAT_OK;
         k++) {
        const double *a = strand->beads[k - 1].pixel, *b = strand->beads[k].pixel,
                     *c = strand->beads[k + 1].pixel;
        const double way = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]);
        if (way < 0) status = bat_strand_split(strand, (double)k, true);
    }
    return status;
}

/* ---- where a strand leaves the window: far off, crossings are not looked for ---- */

static bat_status split_leaving(const bat_sight_scene *s, bat_strand *strand) {
    bat_status status = BAT_OK;
    bool before = false;
    for (size_t k = 0; k + 1 < strand->count && status == BAT_OK; k++) {
        const bool beyond = bat_sight_beyond(s, &strand->beads[k], &strand->beads[k + 1]) > 0;
        if (k > 0 && beyond != before) status = bat_strand_split(strand, (double)k, false);
        before = beyond;
    }
    return status;
}

/* ---- all ---- */

static int by_place(const void *a, const void *b) {
    const bat_split *p = a, *q = b;
    if (p->place != q->place) return p->place < q->place ? -1 : 1;
    return (int)p->corner - (int)q->corner; /* equal ones are alike */
}

static void pixel_at(const bat_strand *strand, double place, double out[2]) {
    const size_t k = (size_t)fmin(floor(place), (double)(strand->count - 2));
    const double *a = strand->beads[k].pixel, *b = strand->beads[k + 1].pixel, f = place - (double)k;
    for (int d = 0; d < 2; d++) out[d] = a[d] + f * (b[d] - a[d]);
}

/* How long a strand is seen to be between two places, or more than touching. */
static double seen_length(const bat_strand *strand, double from, double to) {
    double at[2], next[2], length = 0;
    pixel_at(strand, from, at);
    while (from < to && length <= touching) {
        from = fmin(floor(from) + 1, to);
        pixel_at(strand, from, next);
        length += bat_hypot(next[0] - at[0], next[1] - at[1]);
        at[0] = next[0], at[1] = next[1];
    }
    return length;
}

/* In order, and those that are one joined: between which no length is seen. */
static void sort(bat_strand *strand) {
    size_t kept = 0;
    double length = 0; /* from the last that is kept */
    if (strand->split_count == 0) return;
    qsort(strand->splits, strand->split_count, sizeof *strand->splits, by_place); /* no ties */
    for (size_t i = 1; i < strand->split_count; i++) {
        const bat_split next = strand->splits[i];
        bat_split *last = &strand->splits[kept];
        length += seen_length(strand, strand->splits[i - 1].place, next.place);
        if (next.place - last->place > 1e-6 && length > touching)
            strand->splits[++kept] = next, length = 0;
        else if (next.corner && !last->corner)
            *last = next, length = 0;
    }
    strand->split_count = kept + 1;
}

bat_status bat_strands_split(bat_sight_scene *s) {
    bat_status status = split_crossings(s);
    for (size_t i = 0; i < s->count && status == BAT_OK; i++) {
        status = split_folds(s, i);
        if (status == BAT_OK) status = split_cusps(&s->strands[i]);
        if (status == BAT_OK) status = split_leaving(s, &s->strands[i]);
    }
    for (size_t i = 0; i < s->count; i++) sort(&s->strands[i]);
    return status;
}
