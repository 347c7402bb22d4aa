/* Points where the selected curves turn back or begin to bend the other way: knots as often as points lie on the curve for, so that the
 * shape stays. Curves with levels, and splines, keep what they were made from, and get none. */
#include "base/order.h"
#include "curve/curve.h"
#include "document/document.h"
#include "editor/edit/arrange.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/show/handles.h"
#include "editor/tables/commands.h"
#include "kinds/kinds.h"
#include <batten/measure.h>
#include <batten/refine.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double SAME = 1e-7; /* of the domain: a knot that near is at the place */

/* What is looked for, and how many points were added. */
typedef struct noding {
    bat_command_id at;
    int added;
} noding;

static size_t find_places(const bat_curve *curve, bat_command_id at, size_t room, double *u) {
    if (at == BAT_COMMAND_POINTS_INFLECTIONS) return bat_curve_inflections(curve, room, u);
    const size_t first = bat_curve_extremes(curve, 0, room, u);
    const size_t rest = room > first ? room - first : 0;
    return first + bat_curve_extremes(curve, 1, rest, rest ? u + first : NULL);
}

/* The place itself, or the knot that is there; at the seam the start of the domain. */
static double place_of(const bat_curve *curve, double u, double near) {
    const double *t = curve->knots, start = t[curve->degree], end = t[curve->spread];
    if (curve->closed && end - u <= near) u -= end - start;
    const int i = bat_span(curve, fmax(u, start), -1);
    return u - t[i] <= near ? t[i] : t[i + 1] - u <= near ? t[i + 1] : u;
}

/* The knots that put points on the curve at places; their number. At most as often as the degree for each. */
static size_t knots_for(const bat_curve *curve, size_t count, double *places, double *knots) {
    const double start = curve->knots[curve->degree], end = curve->knots[curve->spread];
    const double near = SAME * (end - start);
    size_t made = 0;
    for (size_t i = 0; i < count; i++) places[i] = place_of(curve, places[i], near);
    qsort(places, count, sizeof *places, bat_ascending); /* no ties that can be told apart */
    for (size_t i = 0; i < count; i++) {
        const double u = places[i];
        const bool inside = curve->closed || (u - start > near && end - u > near);
        if (!inside || (i > 0 && u - places[i - 1] <= near)) continue;
        for (int more = curve->degree - bat_knot_held(curve, u); more > 0; more--) knots[made++] = u;
    }
    return made;
}

static bat_status with_nodes(void *context, const bat_curve *curve, bat_curve **out) {
    noding *n = context;
    const size_t count = find_places(curve, n->at, 0, NULL);
    double *places = malloc((1 + (size_t)curve->degree) * (count + 1) * sizeof *places);
    if (!places) return BAT_MEMORY;
    (void)find_places(curve, n->at, count, places);
    double *knots = places + count;
    const size_t made = knots_for(curve, count, places, knots);
    for (size_t i = 0; i < made; i++) n->added += i == 0 || knots[i] != knots[i - 1];
    const bat_status status = made > 0 ? bat_curve_insert_knots(curve, (int)made, knots, out)
                                       : bat_curve_copy(curve, out);
    free(places);
    return status;
}

static bool is_possible(const bat_object *object) {
    if (!bat_object_is_made_of_curves(object) || bat_object_spline(object)) return false;
    for (int k = 0; k < bat_object_curve_count(object); k++)
        if (bat_object_shape(object, k)) return false;
    return true;
}

/* Replaces the object at the index, if that gets any. */
static bat_status node_object(bat_context *c, int index, noding *n) {
    const bat_object *object = bat_document_at(c->session->document, index);
    const int before = n->added;
    bat_object *after = NULL;
    if (!is_possible(object)) return BAT_OK;
    bat_status status = bat_object_with_each(object, with_nodes, n, &after);
    if (status == BAT_OK && n->added > before) status = bat_transaction_replace(c, index, after);
    bat_object_release(after);
    return status;
}

bat_status bat_command_points_at(bat_context *c, bat_command_id id) {
    int *members = NULL, count = 0, fit = 0;
    noding n = {id, 0};
    char number[16];
    bat_status status = bat_arrange_members(c, &members, &count);
    for (int i = 0; i < count && status == BAT_OK; i++)
        fit += is_possible(bat_document_at(c->session->document, members[i]));
    if (status == BAT_OK && fit > 0) status = bat_transaction_begin(c);
    const bool open = status == BAT_OK && fit > 0;
    for (int i = 0; i < count && open && status == BAT_OK; i++) status = node_object(c, members[i], &n);
    free(members);
    if (status == BAT_OK && n.added > 0)
        status = bat_transaction_commit(c, bat_command_at(id)->label, NULL);
    else if (open)
        bat_transaction_cancel(c);
    if (status != BAT_OK || n.added == 0)
        return bat_notice_refuse(c, status,
                                 status != BAT_OK && status != BAT_STATE ? BAT_STRING_COUNT
                                 : count == 0                            ? BAT_STRING_NOTICE_SELECT_FIRST
                                 : fit == 0                              ? BAT_STRING_NOTICE_SELECT_PLAIN
                                                                         : BAT_STRING_NOTICE_POINTS_THERE);
    snprintf(number, sizeof number, "%d", n.added);
    bat_notice_value(c, BAT_STRING_NOTICE_POINTS_ADDED, number);
    return BAT_OK;
}
