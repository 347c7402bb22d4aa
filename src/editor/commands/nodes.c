/* Points where the selected curves turn back or begin to bend the other way: knots as often as points lie on the curve for, so that the
 * shape stays. Curves with levels, and splines, keep what they were made from, and get none. */
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

/* The curve with a point on it at u; NULL in *out: there is one. */
static bat_status with_node(const bat_curve *curve, double u, bat_curve **out) {
    double domain[2], knot;
    const int degree = bat_curve_degree(curve);
    bat_curve_domain(curve, domain);
    const double period = domain[1] - domain[0], near = SAME * period;
    *out = NULL;
    if (bat_curve_is_closed(curve) && domain[1] - u <= near) u -= period; /* the seam */
    if (bat_knot_near(curve, u, &knot) && fabs(knot - u) <= near) u = knot;
    const int more = degree - bat_knot_held(curve, u);
    const bool inside = bat_curve_is_closed(curve) || (u - domain[0] > near && domain[1] - u > near);
    return more > 0 && inside ? bat_curve_insert_knot(curve, u, more, out) : BAT_OK;
}

static bat_status with_nodes(void *context, const bat_curve *curve, bat_curve **out) {
    noding *n = context;
    const size_t count = find_places(curve, n->at, 0, NULL);
    double *u = malloc((count + 1) * sizeof *u);
    bat_curve *made = NULL;
    bat_status status = u ? bat_curve_copy(curve, &made) : BAT_MEMORY;
    if (u) (void)find_places(curve, n->at, count, u);
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        bat_curve *more;
        status = with_node(made, u[i], &more);
        if (status != BAT_OK || !more) continue;
        bat_curve_free(made);
        made = more, n->added++;
    }
    free(u);
    if (status == BAT_OK)
        *out = made;
    else
        bat_curve_free(made);
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
