/*
 * The smooth brush. A circle shows its reach; the stretch of the nearest curve within it is lit. Painting adds to the
 * stretch, which is faired as a whole: the curve as it will be is shown, and kept when the pen is lifted. A tap calms
 * what is lit.
 */
#include "editor/editor.h"
#include "base/real.h"
#include "editor/tools/calm.h"
#include "editor/pick/pick.h"
#include "editor/edit/curves_of.h"
#include <math.h>

static const float STRETCH_WIDTH = 4, FIT_WIDTH = 2;

static double radius(const bat_editor *editor) {
    return editor->values[BAT_PROPERTY_BRUSH_SIZE] * bat_view_pixel(&editor->view);
}

/* What the pen's pressure makes of it. A curve is found within all of it, however light the tap. */
static double pressed(const bat_editor *editor) { return editor->brushing.pressure * radius(editor); }

static const bat_curve *target(const bat_editor *editor) {
    const bat_brushing *b = &editor->brushing;
    return b->object ? bat_edit_target(editor->document, b->object, b->curve) : NULL;
}

/* Half of the stretch within a circle: the chord's, at this distance from its middle. */
static double half(double radius_, double distance) {
    return sqrt(fmax(radius_ * radius_ - distance * distance, radius_ * radius_ / 16));
}

static void look(bat_editor *editor) {
    bat_brushing *b = &editor->brushing;
    double point[2], r = radius(editor);
    b->object = 0;
    bat_editor_sync(editor);
    bat_view_to_document(&editor->view, b->at, point);
    bat_pick pick = bat_pick_nearest(&editor->scene, point, r);
    if (!pick.object) return;
    b->object = pick.object;
    b->curve = pick.curve;
    b->u = pick.near.u;
    const bat_curve *curve = target(editor);
    if (curve)
        bat_calm_range(curve, b->u, half(pressed(editor), pick.near.distance), b->range);
    else
        b->object = 0;
}

/* The curve goes on under the brush: its stretch grows, in whichever period lies next. */
static void paint(bat_editor *editor) {
    bat_brushing *b = &editor->brushing;
    const bat_curve *curve = target(editor);
    double point[2], domain[2], range[2], r = radius(editor);
    bat_near near;
    if (!curve) return;
    bat_view_to_document(&editor->view, b->at, point);
    if (bat_curve_nearest(curve, point, &near) != BAT_OK || near.distance > r) return;
    bat_curve_domain(curve, domain);
    double period = domain[1] - domain[0], turns = 0;
    if (bat_curve_closed(curve)) turns = floor((b->u - near.u) / period + 0.5) * period;
    bat_calm_range(curve, near.u, half(pressed(editor), near.distance), range);
    b->u = near.u + turns;
    b->range[0] = fmin(b->range[0], range[0] + turns);
    b->range[1] = fmax(b->range[1], range[1] + turns);
    if (b->range[1] - b->range[0] > period) b->range[1] = b->range[0] + period;
    b->due = true;
}

static bat_status fair(bat_editor *editor, bat_curve **out) {
    double pixel = bat_view_pixel(&editor->view);
    return bat_calm_curve(target(editor), editor->brushing.range,
                          editor->values[BAT_PROPERTY_SMOOTH_LIMIT] * pixel, pixel, out);
}

static void note(bat_editor *editor, const bat_pointer *event) {
    bat_brushing *b = &editor->brushing;
    b->hovering = true;
    b->device = event->device;
    b->at[0] = event->x;
    b->at[1] = event->y;
    if (event->phase != BAT_POINTER_UP) b->pressure = bat_pressure_of(editor, event);
}

static void hover(bat_editor *editor, const bat_pointer *event) { note(editor, event); }
static void leave(bat_editor *editor) { editor->brushing.hovering = false; }

static void down(bat_editor *editor, const bat_pointer *event) {
    bat_brushing *b = &editor->brushing;
    bat_brushing_end(b);
    note(editor, event);
    look(editor);
    b->painting = b->due = true;
    bat_editor_notice(editor, BAT_STRING_COUNT);
}

static void move(bat_editor *editor, const bat_pointer *event) {
    bat_brushing *b = &editor->brushing;
    if (!b->painting || event->predicted) return;
    note(editor, event);
    if (b->object)
        paint(editor);
    else
        look(editor); /* the stroke began beside every curve */
}

static void up(bat_editor *editor, const bat_pointer *event) {
    bat_brushing *b = &editor->brushing;
    (void)event;
    if (!b->painting) return;
    bat_curve *curve = NULL;
    if (!target(editor)) {
        bat_editor_notice(editor, BAT_STRING_NOTICE_NOTHING_TO_SMOOTH);
    } else {
        bat_status status = fair(editor, &curve);
        if (status == BAT_OK)
            status = bat_commit_curve(editor, b->object, b->curve, curve, BAT_STRING_STEP_SMOOTH);
        if (status != BAT_OK) bat_editor_notice_failure(editor, status);
    }
    bat_brushing_end(b);
}

static bool cancel(bat_editor *editor) {
    if (!editor->brushing.painting) return false;
    bat_brushing_end(&editor->brushing);
    bat_editor_notice(editor, BAT_STRING_NOTICE_CANCELLED);
    return true;
}

static bool busy(const bat_editor *editor) { return editor->brushing.painting; }

static void update(bat_editor *editor) {
    bat_brushing *b = &editor->brushing;
    if (!b->painting) {
        b->object = 0;
        if (b->hovering) look(editor);
        return;
    }
    if (!b->due || !target(editor)) return;
    b->due = false;
    bat_curve_free(b->preview);
    b->preview = NULL;
    fair(editor, &b->preview); /* without one nothing is shown */
}

static void overlay(bat_editor *editor, bat_overlay *list) {
    const bat_brushing *b = &editor->brushing;
    const bat_curve *curve = target(editor);
    double point[2];
    if (!b->hovering || editor->holding_pan) return;
    if (curve) {
        bat_overlay_item(list, BAT_ROLE_STRETCH, BAT_ITEM_STROKED, STRETCH_WIDTH);
        bat_overlay_stretch(list, curve, b->range[0], b->range[1]);
    }
    if (b->preview) {
        bat_overlay_item(list, BAT_ROLE_FIT, BAT_ITEM_STROKED, FIT_WIDTH);
        bat_path_curve(&list->path, b->preview);
    }
    bat_view_to_document(&editor->view, b->at, point);
    bat_overlay_item(list, BAT_ROLE_REACH, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1.25F);
    bat_overlay_circle(list, point, pressed(editor));
}

static bat_string hint(const bat_editor *editor) {
    const bat_brushing *b = &editor->brushing;
    if (b->painting) return BAT_STRING_HINT_BRUSHING;
    return b->object ? BAT_STRING_HINT_BRUSH : BAT_STRING_HINT_SMOOTH_NOTHING;
}

static bat_cursor cursor(const bat_editor *editor) {
    (void)editor;
    return BAT_CURSOR_CROSS;
}

static const char *check(const bat_editor *editor) {
    const bat_brushing *b = &editor->brushing;
    if (b->preview && !b->painting) return "a preview outlived its brush";
    if (b->painting && bat_contacts_count(&editor->contacts, BAT_DUTY_TOOL, NULL) != 1)
        return "a brush without a pen";
    return NULL;
}

const bat_tool *bat_tool_smooth(void) {
    static const bat_tool tool = {.hover = hover,
                                  .leave = leave,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .busy = busy,
                                  .update = update,
                                  .overlay = overlay,
                                  .hint = hint,
                                  .cursor = cursor,
                                  .check = check};
    return &tool;
}
