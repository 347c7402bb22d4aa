#include "editor/commands/blend_edges.h"
#include "curve/curve.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/session/session.h"
#include "form/sweep/sections.h"
#include <math.h>

enum { SIDES = 4, MEASURED = 16, LINES = 5 };

static const bat_surface *surface_of(const bat_object *object) { return bat_object_surface(object); }

/* The line of an edge; of a curve, in space. BAT_STATE: the surface has no such edge. */
static bat_status line_of(const bat_object *object, bat_side side, bat_curve **out) {
    const bat_surface *s = surface_of(object);
    const bat_direction across = side == BAT_SIDE_U0 || side == BAT_SIDE_U1 ? BAT_U : BAT_V;
    double domain[2];
    if (!s) return bat_curve_to_dimension(bat_object_curve(object, 0), 3, out);
    if (bat_surface_is_closed(s, across)) return BAT_STATE;
    bat_surface_domain(s, across, domain);
    return bat_surface_isocurve(s, across, domain[side == BAT_SIDE_U1 || side == BAT_SIDE_V1], out);
}

/* Infinite: one is closed, the other open. */
static double gap(const bat_curve *a, const bat_curve *b) {
    if (bat_curve_is_closed(a) != bat_curve_is_closed(b)) return INFINITY;
    return fmin(bat_sections_apart(a, b, MEASURED, false), bat_sections_apart(a, b, MEASURED, true));
}

bool bat_edge_pair_find(int count, bat_object *const *objects, bat_edge_pair *out) {
    if (count != 2 || !(surface_of(objects[0]) || surface_of(objects[1]))) return false;
    const int first = surface_of(objects[0]) ? 0 : 1;
    const bat_object *const both[2] = {objects[first], objects[1 - first]};
    if (!surface_of(both[1]) && !bat_object_is_one_curve(both[1])) return false;
    bat_curve *line[2][SIDES] = {{NULL}};
    for (int k = 0; k < 2; k++)
        for (int side = 0; side < (surface_of(both[k]) ? SIDES : 1); side++)
            if (line_of(both[k], (bat_side)side, &line[k][side]) != BAT_OK) line[k][side] = NULL;
    double least = INFINITY;
    for (int i = 0; i < SIDES * SIDES; i++) {
        const bat_curve *a = line[0][i % SIDES], *b = line[1][i / SIDES];
        const double far = a && b ? gap(a, b) : INFINITY;
        if (far < least)
            least = far,
            *out = (bat_edge_pair){{both[0], both[1]}, {(bat_side)(i % SIDES), (bat_side)(i / SIDES)}};
    }
    for (int i = 0; i < 2 * SIDES; i++) bat_curve_free(line[i / SIDES][i % SIDES]);
    return least < INFINITY;
}

bat_status bat_edge_pair_blend(const bat_edge_pair *pair, const bat_blend_options *options,
                               bat_surface **out) {
    const bat_surface *a = surface_of(pair->object[0]), *b = surface_of(pair->object[1]);
    return b ? bat_surface_blend(a, pair->side[0], b, pair->side[1], options, out)
             : bat_surface_blend_curve(a, pair->side[0], bat_object_curve(pair->object[1], 0), options, out);
}

bat_status bat_edge_pair_match(const bat_edge_pair *pair, int continuity, double tension, bat_surface **out) {
    const bat_surface *b = surface_of(pair->object[1]);
    if (!b || bat_object_relief(pair->object[0])) return BAT_SINGULAR;
    return bat_surface_match(surface_of(pair->object[0]), pair->side[0], b, pair->side[1], continuity,
                             tension, out, NULL);
}

bat_status bat_edge_pair_show(bat_tuning *tuning, const bat_surface *made, bool matched) {
    const bat_side side = tuning->edges.side[0];
    const bat_direction along = matched && (side == BAT_SIDE_U0 || side == BAT_SIDE_U1) ? BAT_V : BAT_U;
    bat_status status = BAT_OK;
    double domain[2], ends[2];
    bat_surface_domain(made, along, domain);
    for (int i = 0; i < LINES && status == BAT_OK; i++) {
        bat_curve *line = NULL;
        status = bat_surface_isocurve(made, along, domain[0] + (domain[1] - domain[0]) * i / (LINES - 1),
                                      &line);
        if (status == BAT_OK && i == LINES / 2) {
            bat_curve_domain(line, ends);
            for (int end = 0; end < 2; end++) bat_curve_eval(line, ends[end], 0, tuning->place[end]);
        }
        if (status == BAT_OK) status = bat_tuning_add(tuning, line);
    }
    return status;
}

bat_status bat_edge_pair_object(const bat_edge_pair *pair, const bat_surface *made, bat_object **out) {
    const bat_object *like = pair->object[0];
    bat_object *object = NULL;
    bat_status status = bat_object_create_surface(bat_object_id(like), "", bat_object_style(like), made,
                                                  &object);
    if (status == BAT_OK) status = bat_object_with_parent(object, bat_object_parent(like), out);
    bat_object_release(object);
    return status;
}

bool bat_edge_pair_fits(const bat_context *c, bool both) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    int surfaces = 0, curves = 0;
    for (size_t i = 0; i < (size_t)selection->count && selection->count == 2; i++) {
        const int at = bat_document_find(document, selection->ids[i]);
        const bat_object *object = at < 0 ? NULL : bat_document_at(document, at);
        surfaces += object && surface_of(object),
            curves += object && !surface_of(object) && bat_object_is_one_curve(object);
    }
    return surfaces > both && surfaces + curves == 2;
}
