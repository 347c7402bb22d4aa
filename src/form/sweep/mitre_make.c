#include "form/sweep/mitre_make.h"
#include "curve/frames/turn.h"
#include "curve/frames/walk.h"
#include "form/sweep/sweep.h"

#include <batten/measure.h>
#include <math.h>
#include <stdlib.h>

static const double corner = 1e-6;   /* radians: a path that turns more at a knot has a corner there */
static const double straight = 1e-9; /* of the path's size: how far a line may be from straight */
static const double back = 1e-6;     /* 1 + cosine: a path that turns more turns back */

/* ---- the path ---- */

/* Whether the path turns at the start of a stored span. */
static bool turns_at(const bat_curve *path, int span) {
    const int p = path->degree;
    return span >= 2 * p - 1 && path->knots[span] == path->knots[span - p + 1] &&
           (path->closed || path->knots[span] > path->knots[p]) && bat_curve_corner_at(path, span, corner);
}

static vec place(const bat_curve *path, double u, vec *way) {
    double jet[6];
    bat_curve_eval(path, u, 1, jet);
    if (way) *way = vec_load(jet + 3, 3);
    return vec_load(jet, 3);
}

/* Whether a span lies on the line from `start` along `way`, and goes that way: it does at more places than its degree. */
static bool is_on(const bat_curve *path, int span, vec start, vec way, double within) {
    const double low = path->knots[span], high = path->knots[span + 1];
    const int count = 2 * path->degree + 1;
    for (int i = 0; i < count; i++) {
        vec forward;
        const vec at = place(path, low + (high - low) * (i + 0.5) / count, &forward);
        if (!(vec_norm(vec_reject(vec_sub(at, start), way)) <= within) || vec_dot(forward, way) < 0)
            return false;
    }
    return true;
}

/* What is being looked for. */
typedef struct search {
    const bat_curve *path;
    int *spans;  /* that are not empty, ascending */
    bool *turns; /* at the start of each */
    int count;
    double within;
    bat_mitres *out;
} search;

/* The stretch of spans first to last around span k, which ends at corners or where the path bends. False: k itself bends. */
static bool stretch_of(const search *s, int k, int *first, int *last) {
    const vec way = vec_unit(bat_frame_tangent(s->path, s->spans[k], false));
    const vec start = place(s->path, s->path->knots[s->spans[k]], NULL);
    *first = *last = k;
    if (!is_on(s->path, s->spans[k], start, way, s->within)) return false;
    while (*first > 0 && !s->turns[*first] && is_on(s->path, s->spans[*first - 1], start, way, s->within))
        --*first;
    while (*last + 1 < s->count && !s->turns[*last + 1] &&
           is_on(s->path, s->spans[*last + 1], start, way, s->within))
        ++*last;
    return true;
}

static bool begins_in_corner(const search *s, int k) { return s->turns[k]; }
static bool ends_in_corner(const search *s, int k) {
    return k + 1 < s->count ? s->turns[k + 1] : s->path->closed && s->turns[0];
}

static void add(const search *s, int first, int last) {
    bat_straight *line = &s->out->lines[s->out->count++];
    const double *knots = s->path->knots;
    const bool open = !s->path->closed;
    *line = (bat_straight){.from = knots[s->spans[first]], .to = knots[s->spans[last] + 1]};
    line->start = place(s->path, line->from, NULL);
    line->way = vec_unit(bat_frame_tangent(s->path, s->spans[first], false));
    /* The end of the last span, whose knot may be the start of the next, or of the whole. */
    const vec end = place(
        s->path, line->to == knots[s->path->spread] && !open ? knots[s->path->degree] : line->to, NULL);
    line->length = vec_dot(vec_sub(end, line->start), line->way);
    line->soft[0] = !begins_in_corner(s, first) && !(open && first == 0);
    line->soft[1] = !ends_in_corner(s, last) && !(open && last + 1 == s->count);
}

/* BAT_UNSUPPORTED: beside a corner the path bends. */
static bat_status find_lines(const search *s) {
    for (int k = 0; k < s->count; k++) {
        int first, last;
        if (!begins_in_corner(s, k) && !ends_in_corner(s, k)) continue;
        if (!stretch_of(s, k, &first, &last)) return BAT_UNSUPPORTED;
        const bat_mitres *out = s->out;
        const bool there = out->count > 0 &&
                           out->lines[out->count - 1].from == s->path->knots[s->spans[first]];
        if (!there) add(s, first, last);
    }
    return BAT_OK;
}

/* ---- the cuts ---- */

/* By how much a vector across t0 is cut off by the plane that halves the corner, along t0. */
static vec cut(vec across, vec t0, vec t1) {
    return vec_scale(t0, -vec_dot(across, t1) / (1 + vec_dot(t0, t1)));
}

/* Behind the corner a and b are those of the jet; before it the least turn takes what they are there to these. Both are cut
 * at the same points. */
static void cut_both(const bat_sweep_jet *j, vec t0, vec t1, bat_mitre *before, bat_mitre *behind) {
    behind->a = cut(j->a, vec_scale(t1, -1), vec_scale(t0, -1));
    behind->b = cut(j->b, vec_scale(t1, -1), vec_scale(t0, -1));
    before->a = vec_sub(vec_add(j->a, behind->a), bat_turn_least(j->a, t1, t0));
    before->b = vec_sub(vec_add(j->b, behind->b), bat_turn_least(j->b, t1, t0));
}

/* Each corner lies between two stretches that follow on each other, the seam's between the last and the first. */
static bat_status cut_lines(const bat_sweep *sweep, bat_mitres *m) {
    for (int i = 0; i < m->count; i++) {
        bat_straight *line = &m->lines[i], *next = &m->lines[(i + 1) % m->count];
        const bool seam = line->to == sweep->domain[1];
        if (line->soft[1] || (seam && !sweep->path->closed)) continue;
        if (next->from != (seam ? sweep->domain[0] : line->to)) return BAT_UNSUPPORTED;
        if (!(1 + vec_dot(line->way, next->way) > back)) return BAT_UNSUPPORTED;
        bat_sweep_jet j;
        bat_mitre unused;
        bat_sweep_jet_at(sweep, line->to, &j); /* there are no mitres as yet */
        cut_both(&j, line->way, next->way, &line->end[1], seam ? &m->last : &next->end[0]);
        if (!seam) continue;
        m->seam = true;
        bat_sweep_jet_at(sweep, sweep->domain[0], &j);
        cut_both(&j, line->way, next->way, &unused, &next->end[0]);
    }
    return BAT_OK;
}

/* ---- making them ---- */

/* The spans that are not empty, and where the path turns. Returns how many corners there are; -1: no memory. */
static int survey(search *s) {
    const bat_curve *path = s->path;
    int corners = 0;
    s->spans = malloc((size_t)path->spread * sizeof *s->spans);
    s->turns = malloc((size_t)path->spread * sizeof *s->turns);
    if (!s->spans || !s->turns) return -1;
    for (int i = path->degree; i < path->spread; i++) {
        if (path->knots[i] == path->knots[i + 1]) continue;
        s->turns[s->count] = turns_at(path, i);
        corners += s->turns[s->count];
        s->spans[s->count++] = i;
    }
    return corners;
}

bat_status bat_mitres_create(bat_sweep *sweep) {
    search s = {.path = sweep->path};
    bat_mitres found = {0};
    const int corners = survey(&s);
    bat_status status = corners < 0 ? BAT_MEMORY : BAT_OK;
    if (corners > 0 && sweep->rule == BAT_FRAMES_FRENET) status = BAT_UNSUPPORTED;
    if (status == BAT_OK && corners > 0 && sweep->rule == BAT_FRAMES_RMF) {
        s.out = &found;
        s.within = straight * bat_curve_size(sweep->path);
        found.lines = calloc((size_t)s.count, sizeof *found.lines);
        status = found.lines ? find_lines(&s) : BAT_MEMORY;
        if (status == BAT_OK) status = cut_lines(sweep, &found);
    }
    free(s.spans), free(s.turns);
    if (status == BAT_OK)
        sweep->mitres = found;
    else
        bat_mitres_clear(&found);
    return status;
}
