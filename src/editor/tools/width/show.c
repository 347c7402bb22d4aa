/* The width tool: how stops, and the width under the pen, are shown. */
#include "editor/input/input.h"
#include "editor/scene/path.h"
#include "editor/session/session.h"
#include "editor/tools/width/state.h"
#include "editor/view/stage.h"
#include "editor/view/unit.h"

static const float HIGHLIGHT_WIDTH = 1.5F;
static const double MIDDLE = 4.5, HANDLE = 3.5; /* px, from the middle of a mark to its edge */

enum { LINES, HANDLES, MIDDLES, PARTS };

/* One part of the marks at a place. */
static void mark(const bat_context *c, const bat_breadth_spot *spot, int part, bat_overlay *list) {
    const double pixel = bat_stage_pixel(c->stage);
    if (part == LINES) bat_overlay_polyline(list, 2, spot->seen[1]);
    if (part == MIDDLES) bat_overlay_mark(list, spot->seen[0], MIDDLE * pixel);
    for (int k = 1; k < 3 && part == HANDLES; k++) bat_overlay_circle(list, spot->seen[k], HANDLE * pixel);
}

static void begin(bat_overlay *list, int part, bat_role role) {
    if (part == LINES)
        bat_overlay_item(list, BAT_ROLE_POLYGON, BAT_ITEM_STROKED, 1);
    else
        bat_overlay_item(list, role, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1.5F);
}

static void show_stops(const bat_context *c, const bat_object *object, int curve, int but,
                       bat_overlay *list) {
    bat_breadths breadths;
    bat_breadth_spot spot;
    bat_broadening_load(object, curve, &breadths);
    for (int part = 0; part < PARTS; part++) {
        begin(list, part, part == HANDLES ? BAT_ROLE_HANDLE : BAT_ROLE_POINT);
        for (size_t i = 0; i < breadths.count; i++) {
            const bat_width_stop *stop = &breadths.stops[i];
            if ((int)i == but) continue;
            if (bat_broadening_spot(c, object, curve, stop->at, stop->share, &spot))
                mark(c, &spot, part, list);
        }
    }
}

/* One place with its width beside it. */
static void show_one(const bat_context *c, const bat_object *object, int curve, double at, double share,
                     bat_role role, bat_overlay *list) {
    bat_breadth_spot spot;
    char text[BAT_UNIT_ROOM];
    if (!bat_broadening_spot(c, object, curve, at, share, &spot)) return;
    for (int part = 0; part < PARTS; part++) {
        begin(list, part, role);
        mark(c, &spot, part, list);
    }
    bat_unit_write(c, 2 * spot.half, text);
    bat_overlay_label(list, BAT_ROLE_VALUE, spot.seen[0], 22, -22, text);
}

void bat_broadening_overlay(bat_context *c, void *state, bat_overlay *list) {
    const bat_broadening *b = state;
    const bat_breadth_hit *hot = &b->hot;
    const bat_object *own = bat_broadening_object(c, b->object, b->curve);
    const bat_object *under = c->input->holding_pan || b->dragging
                                  ? NULL
                                  : bat_broadening_object(c, hot->object, hot->curve);
    const bat_object *shown = own ? own : under;
    const int curve = own ? b->curve : hot->curve;
    bat_breadths breadths;
    if (under && (under != own || hot->curve != b->curve)) {
        bat_overlay_item(list, BAT_ROLE_HIGHLIGHT, BAT_ITEM_STROKED, HIGHLIGHT_WIDTH);
        bat_path_curve(&list->path, bat_object_curve(under, hot->curve));
    }
    if (shown) {
        bat_overlay_item(list, BAT_ROLE_SELECTION, BAT_ITEM_STROKED, HIGHLIGHT_WIDTH);
        bat_path_curve(&list->path, bat_object_curve(shown, curve));
        show_stops(c, shown, curve, own && b->chosen ? b->stop : -1, list);
    }
    const int chosen = own ? bat_broadening_chosen(c, b, &breadths) : -1;
    if (chosen >= 0)
        show_one(c, own, b->curve, breadths.stops[chosen].at, breadths.stops[chosen].share, BAT_ROLE_CHOSEN,
                 list);
    if (!under || (under == own && hot->curve == b->curve && b->chosen && hot->stop == b->stop)) return;
    bat_broadening_load(under, hot->curve, &breadths);
    show_one(c, under, hot->curve, hot->at, bat_breadths_at(&breadths, hot->at), BAT_ROLE_HANDLE, list);
}
