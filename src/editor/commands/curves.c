/* Commands that cut and join the selected curves. */
#include "document/kind.h"
#include "editor/tables/commands.h"
#include "editor/edit/arrange.h"
#include "editor/edit/curves_of.h"
#include "editor/edit/profile.h"
#include "base/vec.h"
#include "editor/choice/choice.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/tables.h"
#include "editor/tools/keyed/range.h"
#include "editor/tools/select.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "hands/levels/shape.h"
#include "kinds/kinds.h"
#include "base/real.h"
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void end_point(const bat_curve *curve, int end, double out[3]) {
    double domain[2];
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[end], 0, out);
}

static double distance(int dimension, const double *a, const double *b) {
    double sum = 0;
    for (int k = 0; k < dimension; k++) sum = bat_hypot(sum, a[k] - b[k]);
    return sum;
}

/* Extends the curve to a point by a straight line unless it ends there already. Takes ownership of the curve. */
static bat_status lead_to(bat_curve *curve, const double *to, bat_curve **out) {
    int dimension = bat_curve_dimension(curve);
    double points[6];
    end_point(curve, 1, points);
    memcpy(points + dimension, to, (size_t)dimension * sizeof *to);
    if (distance(dimension, points, to) <= 1e-9 * bat_curve_size(curve)) {
        *out = curve;
        return BAT_OK;
    }
    bat_curve *line = NULL;
    bat_status status = bat_curve_create(dimension, 1, false, 2, points, 4, (double[]){0, 0, 1, 1}, &line);
    if (status == BAT_OK) status = bat_curve_join(curve, line, 0, 1e-9 * bat_curve_size(curve), out, NULL);
    bat_curve_free(line);
    bat_curve_free(curve);
    return status;
}

static bat_status closed(const bat_curve *curve, bat_curve **out) {
    if (bat_curve_is_closed(curve)) return BAT_STATE;
    bat_curve *copy = NULL, *whole = NULL;
    double start[3];
    bat_status status = bat_curve_copy(curve, &copy);
    if (status != BAT_OK) return status;
    end_point(curve, 0, start);
    status = lead_to(copy, start, &whole);
    if (status != BAT_OK) return status;
    status = bat_curve_close(whole, 2e-9 * bat_curve_size(whole), out);
    bat_curve_free(whole);
    return status;
}

static bat_status opened(const bat_curve *curve, bat_curve **out) {
    double domain[2];
    if (!bat_curve_is_closed(curve)) return BAT_STATE;
    bat_curve_domain(curve, domain);
    return bat_curve_open_at(curve, domain[0], out);
}

static bat_status reversed(const bat_curve *curve, bat_curve **out) { return bat_curve_reverse(curve, out); }

/* Its first view: the curve as it is seen from straight above. */
static bat_status flattened(const bat_curve *curve, bat_curve **out) {
    if (bat_curve_dimension(curve) == 2) return BAT_STATE;
    return bat_curve_to_dimension(curve, 2, out);
}

/* A function that makes one curve from another; those for which it returns BAT_STATE stay. */
typedef bat_status curve_maker(const bat_curve *curve, bat_curve **out);
/* One that makes an object from another by it. */
typedef bat_status object_maker(const bat_object *object, curve_maker *make, bat_object **out);

/* The function, and how many curves it has changed. */
typedef struct making {
    curve_maker *make;
    int changed;
} making;

static bat_status make_one(void *context, const bat_curve *curve, bat_curve **out) {
    making *way = context;
    bat_status status = way->make(curve, out);
    way->changed += status == BAT_OK;
    return status == BAT_STATE ? bat_curve_copy(curve, out) : status;
}

/* The object with `make` applied to each of its curves. BAT_STATE: all of them stay. */
static bat_status made_over(const bat_object *object, curve_maker *make, bat_object **out) {
    making way = {make, 0};
    if (!bat_object_is_made_of_curves(object)) return BAT_STATE;
    bat_status status = bat_object_with_each(object, make_one, &way, out);
    if (status != BAT_OK || way.changed) return status;
    bat_object_release(*out);
    *out = NULL;
    return BAT_STATE;
}

/* The same with the curves seen from straight above; those with levels keep them. */
static bat_status flattened_over(const bat_object *object, curve_maker *make, bat_object **out) {
    const bat_status status = made_over(object, make, out);
    return status == BAT_OK ? bat_object_keep_levels(object, 2, out) : status;
}

/* The same with its widths along it turned round. */
static bat_status reversed_over(const bat_object *object, curve_maker *make, bat_object **out) {
    bat_object *turned = NULL;
    bat_status status = made_over(object, make, &turned);
    if (status != BAT_OK) return status;
    status = bat_profile_stretch(turned, 1, 0, out);
    bat_object_release(turned);
    return status;
}

static bat_status finish(bat_context *c, bat_status status, bool changed, bat_string label,
                         bat_string otherwise) {
    if (status == BAT_OK && changed) return bat_transaction_commit(c, label, NULL);
    bat_transaction_cancel(c);
    if (status == BAT_OK) {
        bat_notice(c, c->choice->selection.count ? otherwise : BAT_STRING_NOTICE_SELECT_FIRST);
        return BAT_STATE;
    }
    bat_notice_failure(c, status);
    return status;
}

static bat_status each_by(bat_context *c, object_maker *over, curve_maker *make, bat_string label,
                          bat_string otherwise) {
    int *members = NULL, count = 0;
    bool changed = false;
    bat_status status = bat_arrange_members(c, &members, &count);
    if (status == BAT_STATE) status = BAT_OK;
    if (status == BAT_OK) status = bat_transaction_begin(c);
    for (int i = 0; i < count && status == BAT_OK; i++) {
        bat_object *after = NULL;
        status = over(bat_document_at(c->session->document, members[i]), make, &after);
        if (status == BAT_STATE) {
            status = BAT_OK;
            continue;
        }
        if (status == BAT_OK) status = bat_transaction_replace(c, members[i], after);
        bat_object_release(after);
        changed = status == BAT_OK;
    }
    free(members);
    return finish(c, status, changed, label, otherwise);
}

static bat_status each(bat_context *c, curve_maker *make, bat_string label, bat_string otherwise) {
    return each_by(c, made_over, make, label, otherwise);
}

bat_status bat_command_curve_close(bat_context *c, bat_command_id id) {
    (void)id;
    return each(c, closed, BAT_STRING_STEP_CLOSE_CURVE, BAT_STRING_NOTICE_SELECT_OPEN);
}
bat_status bat_command_curve_open(bat_context *c, bat_command_id id) {
    (void)id;
    return each(c, opened, BAT_STRING_STEP_OPEN, BAT_STRING_NOTICE_SELECT_CLOSED);
}
bat_status bat_command_to_page(bat_context *c, bat_command_id id) {
    (void)id;
    return each_by(c, flattened_over, flattened, BAT_STRING_STEP_TO_PAGE, BAT_STRING_NOTICE_SELECT_SPACE);
}
bat_status bat_command_curve_reverse(bat_context *c, bat_command_id id) {
    (void)id;
    return each_by(c, reversed_over, reversed, BAT_STRING_STEP_REVERSE, BAT_STRING_NOTICE_SELECT_FIRST);
}

/* ---- join ---- */

typedef struct open_curve {
    int object, curve; /* indices */
} open_curve;

/* The selected open planar curves; at most `room` are written. */
static int find_open(const bat_context *c, const int *members, int count, open_curve *out, int room) {
    int found = 0;
    for (int i = 0; i < count; i++) {
        const bat_object *object = bat_document_at(c->session->document, members[i]);
        for (int j = 0; j < bat_object_curve_count(object); j++) {
            const bat_curve *curve = bat_object_curve(object, j);
            if (bat_curve_is_closed(curve) || bat_curve_dimension(curve) != 2) continue;
            if (found < room) out[found] = (open_curve){members[i], j};
            found++;
        }
    }
    return found;
}

/* Joins the nearest two ends, reversing either curve if necessary: a's end is extended to b's start. */
static bat_status joined(const bat_curve *a, const bat_curve *b, bat_curve **out) {
    double best = INFINITY, p[3], q[3];
    int turn_a = 0, turn_b = 0;
    for (int i = 1; i >= 0; i--)
        for (int j = 0; j < 2; j++) {
            end_point(a, i, p);
            end_point(b, j, q);
            if (distance(2, p, q) < best) {
                best = distance(2, p, q);
                turn_a = i == 0;
                turn_b = j == 1;
            }
        }
    bat_curve *first = NULL, *second = NULL, *whole = NULL;
    bat_status status = turn_a ? bat_curve_reverse(a, &first) : bat_curve_copy(a, &first);
    if (status == BAT_OK) status = turn_b ? bat_curve_reverse(b, &second) : bat_curve_copy(b, &second);
    if (status == BAT_OK) {
        end_point(second, 0, q);
        bat_curve *led = first;
        first = NULL;
        status = lead_to(led, q, &whole);
    }
    if (status == BAT_OK)
        status = bat_curve_join(whole, second, 0, 2e-9 * (bat_curve_size(whole) + bat_curve_size(second)),
                                out, NULL);
    bat_curve_free(first);
    bat_curve_free(second);
    bat_curve_free(whole);
    return status;
}

/* Whether the part was turned round so that it begins the whole (end 0) or ends it (end 1). */
static bool is_turned(const bat_curve *whole, const bat_curve *part, int end) {
    double at[3], same[3], other[3];
    end_point(whole, end, at);
    end_point(part, end, same);
    end_point(part, 1 - end, other);
    return distance(2, at, other) < distance(2, at, same);
}

/* Which share of the whole's length its first part has. */
static double ends_at(const bat_curve *part, const bat_curve *whole) {
    double own[2], all[2];
    bat_curve_domain(part, own);
    bat_curve_domain(whole, all);
    return bat_curve_length(part, own[0], own[1], 1e-6) /
           fmax(bat_curve_length(whole, all[0], all[1], 1e-6), 1e-300);
}

static bat_status join_two(bat_context *c, const open_curve two[2]) {
    const bat_document *document = c->session->document;
    bat_curve *curve = NULL;
    bat_object *after = NULL, *rest = NULL;
    bat_status status = joined(bat_object_curve(bat_document_at(document, two[0].object), two[0].curve),
                               bat_object_curve(bat_document_at(document, two[1].object), two[1].curve),
                               &curve);
    if (status != BAT_OK) return status;
    const bat_object *a = bat_document_at(document, two[0].object),
                     *b = bat_document_at(document, two[1].object);
    const double share = ends_at(bat_object_curve(a, two[0].curve), curve);
    const bool turn_a = is_turned(curve, bat_object_curve(a, two[0].curve), 0),
               turn_b = is_turned(curve, bat_object_curve(b, two[1].curve), 1);
    status = bat_object_with_curve(a, two[0].curve, curve, &after);
    if (status == BAT_OK && bat_object_curve_count(a) == 1)
        status = bat_profile_join(&after, a, turn_a, b, turn_b, share);
    if (status != BAT_OK) {
        bat_object_release(after);
        return status;
    }
    if (two[0].object == two[1].object) { /* the second comes after the first in the same object */
        status = bat_without_curve(after, two[1].curve, &rest);
        if (status == BAT_OK) status = bat_transaction_replace(c, two[0].object, rest);
    } else {
        status = bat_transaction_replace(c, two[0].object, after);
        if (status == BAT_OK)
            status = bat_without_curve(bat_document_at(document, two[1].object), two[1].curve, &rest);
        if (status == BAT_OK)
            status = rest ? bat_transaction_replace(c, two[1].object, rest)
                          : bat_transaction_remove(c, two[1].object);
    }
    bat_object_release(after);
    bat_object_release(rest);
    return status;
}

/* Joins two open curves into one; closes a single one. */
bat_status bat_command_curve_join(bat_context *c, bat_command_id id) {
    int *members = NULL, count = 0, found;
    open_curve two[2];
    bat_status status = bat_arrange_members(c, &members, &count);
    found = status == BAT_OK ? find_open(c, members, count, two, 2) : 0;
    free(members);
    if (found == 1) return bat_command_curve_close(c, id);
    if (status == BAT_STATE) status = BAT_OK;
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK && found == 2) status = join_two(c, two);
    return finish(c, status, found == 2, BAT_STRING_STEP_JOIN, BAT_STRING_NOTICE_SELECT_TWO_OPEN);
}

/* ---- split ---- */

/* *object, which is released, with the widths of a stretch; of several curves each keeps all of them. */
static bat_status narrow(bat_object **object, double from, double to) {
    bat_object *made = NULL;
    const bat_status status = bat_profile_stretch(*object, from, to, &made);
    if (status != BAT_OK) return status;
    bat_object_release(*object);
    *object = made;
    return BAT_OK;
}

/* The share of the length before u. */
static double share_of(const bat_curve *curve, double u) {
    double domain[2];
    bat_curve_domain(curve, domain);
    const double whole = bat_curve_length(curve, domain[0], domain[1], 1e-6);
    return whole > 0 ? fmin(bat_curve_length(curve, domain[0], u, 1e-6) / whole, 1) : 0;
}

/* Splits into two pieces: the first stays in the object, the second becomes an object in front of it (index + 1). */
static bat_status split_at(bat_context *c, int index, int curve, double u) {
    const bat_object *object = bat_document_at(c->session->document, index);
    const bat_curve *whole = bat_object_curve(object, curve);
    bat_curve *left = NULL, *right = NULL;
    bat_object *after = NULL, *other = NULL, *placed = NULL;
    bat_status status = bat_curve_is_closed(whole) ? bat_curve_open_at(whole, u, &left)
                                                   : bat_curve_split(whole, u, &left, &right);
    if (status != BAT_OK) return status;
    if (right) {
        status = bat_object_with_curves(object, 1, &right, &other);
        if (status == BAT_OK)
            status = bat_object_with_id(other, bat_document_new_id(c->session->document), &placed);
    }
    if (status == BAT_OK) {
        status = bat_object_with_curve(object, curve, left, &after);
    } else {
        bat_curve_free(left);
    }
    const double share = share_of(whole, u);
    if (status == BAT_OK && placed && share > 0 && share < 1) {
        status = narrow(&placed, share, 1);
        if (status == BAT_OK && bat_object_curve_count(object) == 1) status = narrow(&after, 0, share);
    }
    if (status == BAT_OK) status = bat_transaction_replace(c, index, after);
    if (status == BAT_OK && placed) status = bat_transaction_insert(c, index + 1, placed);
    bat_object_release(after);
    bat_object_release(other);
    bat_object_release(placed);
    return status;
}

bat_status bat_command_curve_split(bat_context *c, bat_command_id id) {
    (void)id;
    bat_selecting *s = bat_selecting_of(c);
    const bat_curve *ranged = bat_range_curve(c);
    if (ranged) {
        bat_curve_eval(ranged, bat_range_of(c)->u[bat_range_of(c)->end], 0, s->point);
        s->has_point = true;
    }
    bat_near best = {.distance = s->has_point ? 24 * bat_stage_pixel(c->stage) : -1};
    int *members = NULL, count = 0, index = -1, which = 0;
    bat_status status = bat_arrange_members(c, &members, &count);
    if (status == BAT_STATE) status = BAT_OK;
    for (int i = 0; i < count; i++) {
        const bat_object *object = bat_document_at(c->session->document, members[i]);
        for (int j = 0; j < bat_object_curve_count(object); j++) {
            bat_near near;
            const bat_curve *curve = bat_object_curve(object, j);
            if (bat_curve_dimension(curve) != 2) continue;
            if (bat_curve_nearest(curve, s->point, &near) == BAT_OK && near.distance <= best.distance) {
                best = near;
                index = members[i];
                which = j;
            }
        }
    }
    free(members);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK && index >= 0) {
        double domain[2];
        const bat_curve *curve = bat_object_curve(bat_document_at(c->session->document, index), which);
        bat_curve_domain(curve, domain);
        if (!bat_curve_is_closed(curve) && !(best.u > domain[0] && best.u < domain[1]))
            index = -1; /* there is nothing beyond an end */
        else
            status = split_at(c, index, which, best.u);
    }
    return finish(c, status, index >= 0, BAT_STRING_STEP_SPLIT, BAT_STRING_NOTICE_SPLIT_WHERE);
}
