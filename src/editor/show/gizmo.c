#include "editor/show/gizmo.h"
#include "base/real.h"
#include "editor/session/notice.h"
#include "editor/view/unit.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const float THIN = 2, THICK = 3.5F;
static const double DOT = 4.5, ARROW = 7;         /* px */
static const double INNER = 0.34, OUTER = 0.5;    /* of the arms: the squares of planes */
static const double BEGIN = 0.12, NAME_AWAY = 15; /* of an arm; px */
static const double LONG = 40;                    /* arms: a line that something is kept to */
static const char *const NAMES[3] = {"x", "y", "z"};

/* An arrow's head, as a triangle in the picture. */
static void show_head(const bat_context *c, const bat_gizmo *g, int axis, double size, bat_overlay *overlay) {
    double tip[3], seen[2], from[2];
    bat_gizmo_handle(g, BAT_GIZMO_ALONG + axis, tip);
    if (!bat_stage_look(c->stage, 3, tip, seen) || !bat_stage_look(c->stage, 3, g->middle, from)) return;
    const double x = seen[0] - from[0], y = seen[1] - from[1], length = bat_hypot(x, y);
    if (!(length > 0)) return;
    const double u = size * bat_stage_pixel(c->stage) / length, v = 0.6 * u;
    const double corners[8] = {seen[0] + u * x,         seen[1] + u * y,         seen[0] - u * x + v * y,
                               seen[1] - u * y - v * x, seen[0] - u * x - v * y, seen[1] - u * y + v * x,
                               seen[0] + u * x,         seen[1] + u * y};
    bat_overlay_polyline(overlay, 4, corners);
    bat_path_close(&overlay->path);
}

static void show_square(const bat_gizmo *g, int axis, bat_overlay *overlay) {
    double corners[12], shares[3] = {0, 0, 0};
    for (int i = 0; i < 4; i++) {
        shares[(axis + 1) % 3] = i == 1 || i == 2 ? OUTER : INNER;
        shares[(axis + 2) % 3] = i > 1 ? OUTER : INNER;
        bat_gizmo_at(g, shares[0], shares[1], shares[2], corners + (ptrdiff_t)3 * i);
    }
    bat_path_polygon(&overlay->path, 3, 4, corners, true);
}

/* The lines of a part; its handle, which is filled. */
static void show_lines(const bat_gizmo *g, int part, bat_overlay *overlay) {
    double line[3 * BAT_GIZMO_ARC];
    const int axis = part % 3;
    if (part >= BAT_GIZMO_ABOUT) {
        bat_gizmo_arc(g, axis, line);
        bat_path_polygon(&overlay->path, 3, BAT_GIZMO_ARC, line, false);
    } else if (part < BAT_GIZMO_ACROSS) {
        memcpy(line, g->middle, sizeof g->middle);
        line[axis] += BEGIN * g->arms[axis];
        bat_gizmo_handle(g, part, line + 3);
        bat_path_polygon(&overlay->path, 3, 2, line, false);
    }
}

static void show_handle(const bat_context *c, const bat_gizmo *g, int part, bool over, bat_overlay *overlay) {
    double at[3], seen[2];
    const double grown = over ? 1.4 : 1;
    bat_gizmo_handle(g, part, at);
    if (part < BAT_GIZMO_ACROSS)
        show_head(c, g, part, grown * ARROW, overlay);
    else if (part < BAT_GIZMO_ABOUT)
        show_square(g, part - BAT_GIZMO_ACROSS, overlay);
    else if (bat_stage_look(c->stage, 3, at, seen))
        bat_overlay_circle(overlay, seen, grown * DOT * bat_stage_pixel(c->stage));
}

static void show_name(const bat_context *c, const bat_gizmo *g, int axis, bat_overlay *overlay) {
    double tip[3], seen[2], from[2], a[2], b[2];
    bat_gizmo_handle(g, BAT_GIZMO_ALONG + axis, tip);
    if (!bat_stage_look(c->stage, 3, tip, seen) || !bat_stage_look(c->stage, 3, g->middle, from)) return;
    bat_stage_project(c->stage, seen, a);
    bat_stage_project(c->stage, from, b);
    const double length = bat_hypot(a[0] - b[0], a[1] - b[1]), far = length > 0 ? NAME_AWAY / length : 0;
    bat_overlay_label(overlay, BAT_ROLE_VALUE, seen, far * (a[0] - b[0]), far * (a[1] - b[1]), NAMES[axis]);
}

void bat_gizmo_show(const bat_context *c, const bat_gizmo *g, int over, bat_overlay *overlay) {
    bat_overlay_item(overlay, BAT_ROLE_CHOSEN, BAT_ITEM_STROKED,
                     THICK + 2); /* they stand out from what is selected */
    for (int part = 0; part < BAT_GIZMO_PARTS; part++)
        if (g->there[part]) show_lines(g, part, overlay), show_handle(c, g, part, part == over, overlay);
    for (int axis = 0; axis < 3; axis++) {
        const bat_role role = (bat_role)(BAT_ROLE_AXIS_X + axis);
        for (int thick = 0; thick < 2; thick++) {
            bat_overlay_item(overlay, role, BAT_ITEM_STROKED, thick ? THICK : THIN);
            for (int part = axis; part < BAT_GIZMO_PARTS; part += 3)
                if (g->there[part] && (part == over) == (thick == 1)) show_lines(g, part, overlay);
        }
        bat_overlay_item(overlay, role, BAT_ITEM_FILLED, 0);
        for (int part = axis; part < BAT_GIZMO_PARTS; part += 3)
            if (g->there[part]) show_handle(c, g, part, part == over, overlay);
        if (g->there[BAT_GIZMO_ALONG + axis]) show_name(c, g, axis, overlay);
    }
}

/* "along x: 12 mm". */
static void say(const bat_context *c, int part, const double by[3], char text[BAT_LABEL_ROOM]) {
    static const bat_string words[] = {BAT_STRING_GIZMO_ALONG, BAT_STRING_GIZMO_ACROSS,
                                       BAT_STRING_GIZMO_ABOUT};
    char axes[8] = "", numbers[2 * BAT_UNIT_ROOM + 4] = "", one[BAT_UNIT_ROOM];
    for (int k = 0; k < 3; k++) {
        if ((part < BAT_GIZMO_ACROSS || part >= BAT_GIZMO_ABOUT) != (k == part % 3)) continue;
        if (part >= BAT_GIZMO_ABOUT) {
            bat_unit_number(by[k] * 180 / BAT_PI, one);
            strcat(one, "°");
        } else
            bat_unit_write(c, by[k], one);
        if (*axes) strcat(axes, " "), strcat(numbers, ", ");
        strcat(axes, NAMES[k]), strcat(numbers, one);
    }
    bat_word_fill(c, words[part / 3], 2, (const char *const[]){axes, numbers}, text, BAT_LABEL_ROOM);
}

void bat_gizmo_show_drag(const bat_context *c, const bat_gizmo *g, int part, const double by[3],
                         bat_overlay *overlay) {
    double at[3], seen[2], line[6];
    char text[BAT_LABEL_ROOM];
    const int axis = part % 3;
    const bat_role role = (bat_role)(BAT_ROLE_AXIS_X + axis);
    const double far = LONG * fabs(g->arms[0]);
    for (int k = 0; k < 3; k++) {
        if ((part < BAT_GIZMO_ACROSS || part >= BAT_GIZMO_ABOUT) != (k == axis)) continue;
        bat_overlay_item(overlay, (bat_role)(BAT_ROLE_AXIS_X + k), BAT_ITEM_STROKED, 1.5F);
        memcpy(line, g->middle, sizeof g->middle), memcpy(line + 3, g->middle, sizeof g->middle);
        line[k] -= far, line[3 + k] += far;
        bat_path_polygon(&overlay->path, 3, 2, line, false);
    }
    bat_overlay_item(overlay, role, BAT_ITEM_STROKED, THICK);
    show_lines(g, part, overlay);
    bat_overlay_item(overlay, role, BAT_ITEM_FILLED, 0);
    show_handle(c, g, part, true, overlay);
    bat_gizmo_handle(g, part, at);
    if (!bat_stage_look(c->stage, 3, at, seen)) return;
    say(c, part, by, text);
    bat_overlay_label(overlay, BAT_ROLE_VALUE, seen, 0, -28, text);
}
