/* The tangents tool: a spline that is its own mirror image stays so, as each of its points has another that mirrors it. */
#include "editor/edit/symmetry.h"
#include "editor/session/context.h"
#include "editor/tools/tangents/draft.h"
#include "editor/tools/tangents/state.h"
#include "editor/view/stage.h"
#include "base/real.h"
#include <batten/bezier.h>
#include <math.h>

/* The point that mirrors another when points i and sum - i do; -1: past an end. */
static int partner(const bat_draft *draft, int sum, int point) {
    const int other = sum - point;
    if (!draft->closed) return other >= 0 && other < draft->count ? other : -1;
    return (other % draft->count + draft->count) % draft->count;
}

/* Whether all points of the draft mirror each other so, to a pixel. */
static bool pairs_up(const bat_draft *draft, const bat_mirror *mirror, int sum, double within) {
    for (int i = 0; i < draft->count; i++) {
        const int j = partner(draft, sum, i);
        double at[2];
        if (j < 0) return false;
        bat_mirror_point(mirror, draft->points + 2 * i, at);
        if (!(bat_hypot(at[0] - draft->points[2 * j], at[1] - draft->points[2 * j + 1]) <= within))
            return false;
    }
    return true;
}

/* Finds which points of the draft mirror each other; when they do not all, the mirror is off. */
static void find_pairs(bat_context *c, bat_splining *s) {
    const int last = s->draft.count - 1;
    for (int sum = s->draft.closed ? 0 : last; s->mirror.on && sum <= last; sum++)
        if (pairs_up(&s->draft, &s->mirror, sum, bat_stage_pixel(c->stage))) {
            s->pair_sum = sum;
            return;
        }
    s->mirror.on = false;
}

void bat_splining_pair(bat_context *c) {
    bat_splining *s = bat_splining_of(c);
    const bat_curve *curve = bat_object_curve(bat_splining_object(c), 0);
    s->mirror = s->draft.dimension == 2 ? bat_symmetry(c) : (bat_mirror){0};
    if (s->mirror.on && !bat_mirror_twins(&s->mirror, curve, curve, bat_stage_pixel(c->stage)))
        s->mirror.on = false;
    find_pairs(c, s);
}

int bat_splining_twin_segment(bat_context *c, int segment) {
    const bat_splining *s = bat_splining_of(c);
    const bat_joint *joints = bat_splining_joints(c);
    if (!joints || !s->mirror.on || bat_splining_is_even(c)) return -1; /* its pieces lie around points */
    for (int i = 0; i < s->draft.count; i++)
        if (joints[i].dropped) return -1; /* segments are numbered without these */
    return (s->pair_sum - segment - 1 + s->draft.count) % s->draft.count;
}

bat_status bat_splining_insert_twin(bat_context *c, const bat_spline *longer, int segment, double t,
                                    const bat_tangents_options *options, int *index) {
    bat_splining *s = bat_splining_of(c);
    const int twin = bat_splining_twin_segment(c, segment);
    if (twin < 0 || (twin == segment && t == 0.5)) {
        const bat_status status = bat_draft_load(&s->draft, longer);
        find_pairs(c, s);
        return status;
    }
    const bool before = twin < segment || (twin == segment && t > 0.5);
    const double at = twin != segment ? 1 - t : before ? (1 - t) / t : (1 - 2 * t) / (1 - t);
    bat_spline both;
    void *block = NULL;
    int other = 0;
    bat_status status = bat_tangents_insert(longer, before ? twin : twin + 1, at, options, &both, &block,
                                            &other, NULL);
    if (status != BAT_OK) return status;
    if (other <= *index) ++*index;
    status = bat_draft_load(&s->draft, &both);
    bat_free(block);
    find_pairs(c, s);
    return status;
}

int bat_splining_partner(const bat_splining *s, int point) {
    return s->mirror.on ? partner(&s->draft, s->pair_sum, point) : -1;
}

void bat_splining_follow(bat_splining *s, int point) {
    const int other = bat_splining_partner(s, point);
    const double *a = s->mirror.along;
    if (other < 0) return;
    double *at = s->draft.points + 2 * point, *t = s->draft.tangents + 2 * point,
           *tension = s->draft.tension + 2 * point;
    const double along = t[0] * a[0] + t[1] * a[1];
    if (other == point) { /* it stays on the axis, and the curve crosses that at a right angle */
        bat_mirror_place(&s->mirror, bat_mirror_along(&s->mirror, at), at);
        for (int k = 0; k < 2; k++) t[k] -= along * a[k];
        tension[0] = tension[1] = tension[s->press.part == BAT_PART_LEFT ? 0 : 1];
        return;
    }
    bat_mirror_point(&s->mirror, at, s->draft.points + 2 * other);
    for (int k = 0; k < 2; k++) {
        s->draft.tangents[2 * other + k] = t[k] - 2 * along * a[k];
        s->draft.tension[2 * other + k] = tension[1 - k];
    }
}
