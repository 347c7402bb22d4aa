/* What the surface tool shows: the lit line with its grip and its name, the line that crosses it there, and how far an
 * edit would reach. */
#include "editor/tools/surface/state.h"
#include "editor/session/notice.h"
#include "editor/show/overlay.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double GRIP = 6; /* px */

/* The line at `value`, as it is seen, added to the item. */
static void add_line(bat_context *c, bat_overlay *list, const bat_viewpoint *view, const bat_surface *surface,
                     bat_direction direction, double value) {
    double points[3 * BAT_LINE_SAMPLES], domain[2], at[2];
    bool on = false;
    bat_surface_domain(surface, direction == BAT_U ? BAT_V : BAT_U, domain);
    bat_surfacing_trace(surface, direction, value, domain[0], domain[1], BAT_LINE_SAMPLES, points);
    for (int i = 0; i < BAT_LINE_SAMPLES; i++) {
        const bool seen = bat_surfacing_seen(c, view, points + 3 * i, at);
        if (seen) (on ? bat_path_line : bat_path_move)(&list->path, at[0], at[1]);
        on = seen;
    }
}

static void show_ink(const bat_context *c, const bat_surfacing *s, bat_overlay *list) {
    bat_overlay_item(list, BAT_ROLE_INK, BAT_ITEM_STROKED, 2);
    for (size_t i = 0; i < s->count; i++) {
        double at[2];
        bat_stage_seen(c->stage, s->pixels + 2 * i, at);
        (i ? bat_path_line : bat_path_move)(&list->path, at[0], at[1]);
    }
}

static void show_reach(bat_context *c, bat_surfacing *s, bat_overlay *list, const bat_viewpoint *view,
                       const bat_surface *surface) {
    if (!bat_surfacing_reach(c, s)) return;
    bat_overlay_item(list, BAT_ROLE_REACH, BAT_ITEM_STROKED | BAT_ITEM_DASHED, 1);
    for (int k = 0; k < 2; k++)
        if (s->reach.moved[k] != s->lit.at[s->lit.direction])
            add_line(c, list, view, surface, s->lit.direction, s->reach.moved[k]);
}

static void show_name(bat_context *c, const bat_surfacing *s, bat_overlay *list, const double at[2]) {
    char value[24], name[BAT_LABEL_ROOM];
    snprintf(value, sizeof value, "%.4g", s->lit.at[s->lit.direction]);
    const char *words = bat_word(c, s->lit.direction == BAT_U ? BAT_STRING_LINE_AT_U : BAT_STRING_LINE_AT_V);
    const char *hole = strchr(words, '%');
    snprintf(name, sizeof name, "%.*s%s%s", hole ? (int)(hole - words) : (int)strlen(words), words,
             hole ? value : "", hole ? hole + 1 : "");
    bat_overlay_label(list, BAT_ROLE_VALUE, at, 0, -20, name);
}

void bat_surfacing_show(bat_context *c, bat_surfacing *s, bat_overlay *list) {
    const bat_surface *surface = bat_surfacing_surface(c, s);
    bat_viewpoint view;
    double point[3], at[2];
    if (surface && bat_surfacing_view(c, surface, &view) == BAT_OK) {
        const bat_direction d = s->lit.direction, other = d == BAT_U ? BAT_V : BAT_U;
        show_reach(c, s, list, &view, surface);
        bat_overlay_item(list, BAT_ROLE_GHOST, BAT_ITEM_STROKED, 1.5F);
        add_line(c, list, &view, surface, other, s->lit.at[other]);
        bat_overlay_item(list, BAT_ROLE_HIGHLIGHT, BAT_ITEM_STROKED, 3);
        add_line(c, list, &view, surface, d, s->lit.at[d]);
        bat_surface_eval(surface, s->lit.at[0], s->lit.at[1], 0, point);
        if (bat_surfacing_seen(c, &view, point, at)) {
            bat_overlay_item(list, BAT_ROLE_HANDLE, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1.5F);
            bat_overlay_circle(list, at, GRIP * bat_stage_pixel(c->stage));
            show_name(c, s, list, at);
        }
    }
    if (s->doing == BAT_LINING_STROKE) show_ink(c, s, list);
}
