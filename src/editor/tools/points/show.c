/* The points tool: how the curve, its points and its knots are shown. */
#include "editor/tools/points/state.h"
#include "curve/curve.h"
#include "editor/edit/curves_of.h"
#include "editor/input/input.h"
#include "editor/scene/path.h"
#include "editor/session/session.h"
#include "editor/show/overlay.h"
#include "editor/view/stage.h"
#include "editor/view/unit.h"
#include <batten/measure.h>

static const float STRETCH_WIDTH = 4, HIGHLIGHT_WIDTH = 3;

static bool same(const bat_handle *a, const bat_handle *b) {
    return a->kind == b->kind && a->object == b->object && a->curve == b->curve && a->index == b->index &&
           a->u == b->u;
}

/* The stretch that a drag at u changes: the support of the basis functions at u. */
static void show_support(bat_overlay *list, const bat_curve *curve, double u) {
    double range[2];
    bat_knots_reached(curve, u, range);
    bat_overlay_item(list, BAT_ROLE_STRETCH, BAT_ITEM_STROKED, STRETCH_WIDTH);
    bat_overlay_stretch(list, curve, range[0], range[1]);
}

static void show_length(const bat_context *c, const bat_pointing *p, bat_overlay *list,
                        const bat_curve *curve) {
    double at[2], length = bat_curve_length(curve, p->stretch[0], p->stretch[1], 1e-6);
    char text[64];
    bat_unit_write(c, length, text);
    const bat_handle middle = {.kind = BAT_HANDLE_CURVE, .u = (p->stretch[0] + p->stretch[1]) / 2};
    bat_handle_seen(curve, c->stage, &middle, at);
    bat_overlay_label(list, BAT_ROLE_VALUE, at, 14, -14, text);
}

static void show_marked(const bat_context *c, const bat_pointing *p, bat_overlay *list,
                        const bat_curve *curve) {
    for (int i = 0; p->marked > 1 && i < p->marks_size; i++) {
        const bat_handle handle = {.kind = BAT_HANDLE_POINT, .index = i};
        if (p->marks[i]) bat_handles_show_one(list, curve, &handle, BAT_ROLE_CHOSEN, c->stage);
    }
}

void bat_pointing_overlay(bat_context *c, void *state, bat_overlay *list) {
    bat_pointing *p = state;
    const bat_handle *hot = p->dragging ? &p->grip : &p->hot;
    const bat_curve *curve = bat_pointing_curve(c, p);
    const bat_curve *under = hot->object
                                 ? bat_edit_target_in(c->session->document, 0, hot->object, hot->curve)
                                 : NULL;
    if (c->input->holding_pan) under = NULL;
    bool other = under && under != curve;
    if (other) {
        bat_overlay_item(list, BAT_ROLE_HIGHLIGHT, BAT_ITEM_STROKED, HIGHLIGHT_WIDTH);
        bat_path_curve(&list->path, under);
    }
    if (under && hot->kind != BAT_HANDLE_POINT) show_support(list, under, hot->u);
    if (curve && p->measured) {
        bat_overlay_item(list, BAT_ROLE_STRETCH, BAT_ITEM_STROKED, STRETCH_WIDTH);
        bat_overlay_stretch(list, curve, p->stretch[0], p->stretch[1]);
        show_length(c, p, list, curve);
    }
    const bat_curve *shown = curve ? curve : under;
    if (shown) {
        bat_handles_show_points(list, shown, c->stage);
        bat_handles_show_knots(list, shown, c->stage);
    }
    if (p->boxing) {
        bat_overlay_item(list, BAT_ROLE_MARQUEE, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1);
        bat_overlay_window_box(list, c->stage, p->start, p->at);
    }
    if (curve) show_marked(c, p, list, curve);
    if (curve && p->chosen.kind) bat_handles_show_one(list, curve, &p->chosen, BAT_ROLE_CHOSEN, c->stage);
    if (under && !(same(hot, &p->chosen) && curve))
        bat_handles_show_one(list, under, hot, BAT_ROLE_HANDLE, c->stage);
}
