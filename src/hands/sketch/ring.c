/* The target of a stroke that closes upon itself (docs/math sketch 5.4). */
#include "hands/sketch/path.h"
#include "hands/sketch/plan.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double corner_chord = 8, corner_turn = BAT_PI / 4;

/* Which part of the stroke goes round: it stays where it began, and an end that overlaps is cut back to where it passes
 * the start. */
typedef struct ring {
    double from, to, gap;
    double give[2];     /* of the start and of the end, for the bridge */
    bool meets, corner; /* the ends all but meet; in a corner */
    double tip[BAT_DIMENSION_MAX];
} ring;

/* Whether the ends lie on two lines that turn sharply where they meet. Hands close ovals at an angle, too: a corner turns by
 * as much near its tip as farther off. */
static bool meets_in_corner(const bat_clean *stroke, const ring *r) {
    const double chord = fmin(fmax(corner_chord, 2 * r->gap), 0.1 * stroke->length);
    if (!r->meets || r->gap > 0.5 * chord) return false;
    double turn[2], a[BAT_DIMENSION_MAX], b[BAT_DIMENSION_MAX];
    for (int i = 0; i < 2; i++) {
        const double c = chord * (i + 1);
        bat_clean_at(stroke, r->to - c, a);
        bat_clean_at(stroke, r->from + c, b);
        turn[i] = bat_path_turn(a, r->tip, b, (size_t)stroke->dimension);
    }
    return turn[0] > corner_turn && turn[0] > 0.65 * turn[1];
}

static void find_ring(const bat_plan *plan, ring *r) {
    const bat_clean *stroke = plan->stroke;
    const size_t m = (size_t)plan->dimension;
    const double L = stroke->length, *start = stroke->points;
    *r = (ring){.to = L, .gap = INFINITY};
    for (size_t i = stroke->count; i-- > 0 && stroke->arc[i] >= 0.8 * L;) {
        const double d = bat_path_distance(stroke->points + i * m, start, m);
        if (d < r->gap) r->gap = d, r->to = stroke->arc[i];
    }
    /* Ends that all but meet give way to the bridge; ends far apart stay where the pen put them. */
    r->meets = r->gap <= fmax(15, 0.04 * L);
    memcpy(r->tip, start, m * sizeof *start);
    r->corner = plan->keep_corners && meets_in_corner(stroke, r);
    if (r->corner) return;
    if (!r->meets) {
        r->to = L;
        r->gap = bat_path_distance(stroke->points + (stroke->count - 1) * m, start, m);
    } else {
        r->give[0] = fmin(3, 0.01 * L), r->give[1] = fmin(fmax(12, 3 * r->gap), 0.15 * L);
    }
    r->from += r->give[0], r->to -= r->give[1];
}

typedef struct corner_list {
    size_t *index, count; /* samples of the target */
} corner_list;

/* The stroke's samples with from < arc < to; beside the tip they are moved to it. */
static bat_status add_stretch(bat_plan *plan, const ring *r, double from, double to, corner_list *corners) {
    const bat_clean *stroke = plan->stroke;
    const size_t m = (size_t)plan->dimension;
    const double reach = fmax(8, 4 * r->gap);
    double end[2][BAT_DIMENSION_MAX];
    bat_clean_at(stroke, r->from, end[0]);
    bat_clean_at(stroke, r->to, end[1]);
    for (size_t i = 0, corner = 0; i < stroke->count; i++) {
        const bool is_corner = corner < stroke->corner_count && stroke->corners[corner] == i;
        corner += is_corner;
        if (stroke->arc[i] <= from || stroke->arc[i] >= to) continue;
        const bool late = stroke->arc[i] > 0.5 * (r->from + r->to);
        const double f = (late ? r->to - stroke->arc[i] : stroke->arc[i] - r->from) / reach;
        const double fade = r->corner && f < 1 ? (1 - f) * (1 - f) * (1 + 2 * f) : 0;
        double x[BAT_DIMENSION_MAX];
        for (size_t c = 0; c < m; c++) x[c] = stroke->points[i * m + c] + fade * (r->tip[c] - end[late][c]);
        if (is_corner) corners->index[corners->count++] = plan->target.count;
        const bat_status status = bat_target_add(&plan->target, plan->dimension, x, plan->tolerance);
        if (status != BAT_OK) return status;
        plan->target.last = plan->target.count - 1;
    }
    return BAT_OK;
}

/* The middle of the longest stretch between corners. */
static double calmest(const bat_clean *stroke, const ring *r) {
    double last = r->from, longest = 0, found = last;
    for (size_t i = 0; i <= stroke->corner_count; i++) {
        const double next = i < stroke->corner_count ? fmin(stroke->arc[stroke->corners[i]], r->to) : r->to;
        if (next - last > longest) longest = next - last, found = 0.5 * (last + next);
        last = fmax(next, r->from);
    }
    return found;
}

/* Once round from there, over the corner at the stroke's ends. */
static bat_status add_cornered(bat_plan *plan, const ring *r, corner_list *corners) {
    const double middle = calmest(plan->stroke, r);
    bat_status status = add_stretch(plan, r, middle, r->to, corners);
    if (status != BAT_OK) return status;
    const size_t had = plan->target.count;
    status = bat_target_add(&plan->target, plan->dimension, r->tip, plan->tolerance);
    if (status == BAT_OK && plan->target.count > had) corners->index[corners->count++] = had;
    return status == BAT_OK ? add_stretch(plan, r, r->from, middle + 1e-9, corners) : status;
}

static bat_status add_bridge(bat_plan *plan, const ring *r, corner_list *corners) {
    const bat_clean *stroke = plan->stroke;
    const double step = stroke->length / (double)(stroke->count - 1);
    const size_t m = (size_t)plan->dimension;
    const size_t count =
        (size_t)fmin(fmax(ceil((r->give[0] + r->give[1] + r->gap) / fmin(step, 2)), 12), 4096) + 1;
    bat_plan_frame a, b;
    bat_stroke_frame(stroke, r->to, 0, &a);
    bat_stroke_frame(stroke, r->from, 0, &b);
    double *points = malloc(count * m * sizeof *points);
    bat_status status = points ? add_stretch(plan, r, r->from, r->to, corners) : BAT_MEMORY;
    if (status == BAT_OK) {
        bat_bridge(plan->dimension, &a, &b, count, points);
        for (size_t i = 0; i < count && status == BAT_OK; i++)
            status = bat_target_add(&plan->target, plan->dimension, points + i * m, 2 * plan->tolerance);
    }
    free(points);
    return status;
}

bat_status bat_plan_ring(bat_plan *plan) {
    bat_target *t = &plan->target;
    ring r;
    find_ring(plan, &r);
    t->count = t->first = 0;
    t->rate = plan->speed;
    corner_list corners = {malloc((plan->stroke->corner_count + 2) * sizeof *corners.index), 0};
    if (!corners.index) return BAT_MEMORY;
    bat_status status = r.corner ? add_cornered(plan, &r, &corners) : add_bridge(plan, &r, &corners);
    if (status == BAT_OK && t->count > 0) {
        double first[BAT_DIMENSION_MAX]; /* apart: the samples move when their room grows */
        memcpy(first, t->x, (size_t)plan->dimension * sizeof *first);
        status = bat_target_add(t, plan->dimension, first, plan->tolerance);
    }
    if (status == BAT_OK && t->count > 1) {
        bat_target_speed(t, plan->dimension, 0, t->count - 1, 1, 1, 1);
        t->end = t->w[--t->count]; /* the first sample again */
        status = bat_plan_fix_corners(plan, corners.index, corners.count);
    }
    free(corners.index);
    return status;
}
