#include "editor/show/ruler.h"
#include "editor/input/input.h"
#include "editor/scene/path.h"
#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/view/stage.h"
#include "editor/view/unit.h"
#include <math.h>
#include <string.h>

static const double LABEL_APART = 64, TICK_APART = 5; /* px: least distances */
static const double TICK = 4, MIDDLE = 8;             /* px: lengths */
enum { TICKS_MAX = 4000 };

bool bat_rulers_on(const bat_context *c) {
    return c->settings->values[BAT_PROPERTY_SHOW_RULERS] != 0 && c->stage->view.angle == 0 &&
           !bat_stage_tilted(c->stage);
}

int bat_ruler_at(const bat_context *c, const double pixel[2]) {
    if (!bat_rulers_on(c) || pixel[0] < 0 || pixel[1] < 0) return -1;
    bool left = pixel[0] < BAT_RULER_WIDTH, top = pixel[1] < BAT_RULER_WIDTH;
    return left == top ? -1 : top;
}

/* A line in view pixels at the position `along` on the window's axis k, across from a to b. */
static void across(bat_overlay *overlay, const bat_stage *stage, int k, double along, double a, double b) {
    double from[2], to[2];
    bat_stage_seen(stage, k ? (double[]){a, along} : (double[]){along, a}, from);
    bat_stage_seen(stage, k ? (double[]){b, along} : (double[]){along, b}, to);
    bat_path_move(&overlay->path, from[0], from[1]);
    bat_path_line(&overlay->path, to[0], to[1]);
}

/* The least of 1, 2 or 5 times a power of ten that is not below the value. */
static double round_up(double value) {
    double power = 1;
    while (power < value) power *= 10;
    while (power >= value && power > 1e-12) power /= 10;
    return 2 * power >= value ? 2 * power : 5 * power >= value ? 5 * power : 10 * power;
}

/* Axis 0 is the upper ruler, along x. */
static void show_ticks(const bat_context *c, bat_overlay *overlay, int axis) {
    const bat_stage *stage = c->stage;
    double zero[2], unit = bat_unit_size(c), scale = unit * stage->view.zoom, R = BAT_RULER_WIDTH;
    bat_unit_origin(c, zero);
    double low = ((axis ? stage->view.y : stage->view.x) - zero[axis]) / unit;
    double high = low + (axis ? stage->view.height : stage->view.width) / scale,
           step = round_up(LABEL_APART / scale);
    int parts = 10;
    while (parts > 1 && step * scale / parts < TICK_APART) parts = parts == 10 ? 5 : parts == 5 ? 2 : 1;
    double first = floor(low / step);
    for (int i = 0; i < TICKS_MAX; i++) {
        double value = (first + i / parts) * step + step * (i % parts) / parts;
        double along = (value - low) * scale;
        if (value > high) break;
        if (along < R) continue;
        bool labelled = i % parts == 0;
        across(overlay, stage, axis, along, R - (labelled ? R : 2 * (i % parts) == parts ? MIDDLE : TICK), R);
        if (!labelled) continue;
        char text[BAT_UNIT_ROOM];
        double at[2];
        bat_unit_number(value, text);
        bat_stage_seen(stage, axis ? (double[]){0, along} : (double[]){along, 0}, at);
        double half = 3.2 * (double)strlen(text) + 4; /* about half the text's width */
        bat_overlay_label(overlay, BAT_ROLE_RULER, at, axis ? 7 : half, axis ? half : 7, text);
        if (axis && overlay->label_count) overlay->labels[overlay->label_count - 1].turn = 90;
    }
}

static void strip(bat_overlay *overlay, const bat_stage *stage, const double box[4]) {
    double corner[2];
    for (int i = 0; i < 4; i++) {
        bat_stage_seen(stage, (double[]){box[i == 1 || i == 2 ? 2 : 0], box[i > 1 ? 3 : 1]}, corner);
        (i ? bat_path_line : bat_path_move)(&overlay->path, corner[0], corner[1]);
    }
    bat_path_close(&overlay->path);
}

void bat_rulers_show(const bat_context *c, bat_overlay *overlay) {
    const bat_stage *stage = c->stage;
    double R = BAT_RULER_WIDTH;
    if (!bat_rulers_on(c)) return;
    bat_overlay_item(overlay, BAT_ROLE_RULER, BAT_ITEM_FILLED, 0);
    strip(overlay, stage, (double[]){0, 0, stage->view.width, R});
    strip(overlay, stage, (double[]){0, R, R, stage->view.height});
    bat_overlay_item(overlay, BAT_ROLE_RULER, BAT_ITEM_STROKED, 1);
    across(overlay, stage, 1, R - 0.5, 0, stage->view.width);
    across(overlay, stage, 0, R - 0.5, 0, stage->view.height);
    show_ticks(c, overlay, 0);
    show_ticks(c, overlay, 1);
    if (!c->input->pen_near) return;
    bat_overlay_item(overlay, BAT_ROLE_SELECTION, BAT_ITEM_STROKED, 1.5F);
    for (int k = 0; k < 2; k++)
        if (c->input->pen[k] >= R) across(overlay, stage, k, c->input->pen[k], 0, R);
}
