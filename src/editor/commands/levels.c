/* Commands and properties of levels: taking a curve apart, adding a level, stepping, copying, flattening, the
 * frame rule. They act on the curve chosen in the levels tool, or else on what is selected. */
#include "editor/commands/act.h"
#include "editor/editor.h"
#include "editor/edit/curves_of.h"
#include <math.h>
#include <stdio.h>

/* The chosen curve, seen in its tool. */
static const bat_curve *chosen(bat_editor *editor) {
    if (editor->tool != BAT_TOOL_LEVELS) bat_editor_command(editor, "tool-levels");
    bat_leveling_settle(editor);
    const bat_curve *curve = bat_leveling_curve(editor);
    if (!curve) bat_editor_notice(editor, BAT_STRING_NOTICE_CHOOSE_CURVE);
    return curve;
}

static bat_status told(bat_editor *editor, bat_status status, bat_string why) {
    if (status == BAT_STATE || status == BAT_COUNT)
        bat_editor_notice(editor, why);
    else if (status != BAT_OK)
        bat_editor_notice_failure(editor, status);
    return status;
}

/* ---- taking apart ---- */

/* The fewest points that a base has. */
static int least(const bat_curve *curve) { return bat_curve_closed(curve) ? 3 : bat_curve_degree(curve) + 1; }

/* As many as are left when every other knot goes, `levels` times. */
static int halved(const bat_curve *curve, int levels) {
    int fixed = bat_curve_closed(curve) ? 1 : bat_curve_degree(curve) + 1, count = bat_curve_count(curve);
    for (; levels > 0; levels--) count = (count - fixed) / 2 + fixed;
    return count < least(curve) ? least(curve) : count;
}

static double within(double value, double low, double high) {
    return fmin(fmax(floor(value + 0.5), low), high);
}

bat_status bat_apart_make(bat_editor *editor) {
    bat_leveling *l = &editor->leveling;
    const bat_curve *curve = bat_leveling_curve(editor);
    double *levels = &editor->values[BAT_PROPERTY_APART_LEVELS],
           *points = &editor->values[BAT_PROPERTY_APART_POINTS];
    int count = bat_curve_count(curve), few = least(curve);
    if (count <= few) return BAT_COUNT;
    *levels = within(*levels, 1, fmin(BAT_LEVELS_MAX, count - few));
    *points = within(*points, few, count - *levels);
    bat_shape *shape = NULL;
    bat_status status = bat_shape_decompose_to(curve, (int)*levels, (int)*points, NULL, &shape);
    if (status != BAT_OK) return status;
    bat_apart_drop(editor);
    l->apart = shape;
    l->apart_revision = editor->revision;
    return BAT_OK;
}

bool bat_apart_drop(bat_editor *editor) {
    bat_leveling *l = &editor->leveling;
    bool any = l->apart != NULL;
    bat_shape_free(l->apart);
    l->apart = NULL;
    return any;
}

bool bat_apart_accept(bat_editor *editor) {
    bat_leveling *l = &editor->leveling;
    bat_shape *shape = l->apart;
    if (!shape) return false;
    l->apart = NULL;
    bat_status status = bat_leveling_commit(editor, shape, BAT_STRING_STEP_APART);
    if (status == BAT_OK) l->level = 0, l->chosen = -1;
    told(editor, status, BAT_STRING_NOTICE_FAILED);
    return true;
}

bat_status bat_do_take_apart(bat_editor *editor, bool down) {
    (void)down;
    const bat_curve *curve = chosen(editor);
    if (!curve) return BAT_STATE;
    int levels = 1;
    while (levels < BAT_LEVELS_MAX && halved(curve, levels) > 12 &&
           halved(curve, levels + 1) < halved(curve, levels))
        levels++;
    editor->values[BAT_PROPERTY_APART_LEVELS] = levels;
    editor->values[BAT_PROPERTY_APART_POINTS] = halved(curve, levels);
    editor->leveling.copying = false;
    return told(editor, bat_apart_make(editor), BAT_STRING_NOTICE_FEW_POINTS);
}

/* ---- levels ---- */

bat_status bat_do_level_add(bat_editor *editor, bool down) {
    (void)down;
    const bat_curve *curve = chosen(editor);
    if (!curve) return BAT_STATE;
    const bat_shape *before = bat_leveling_shape(editor);
    bat_shape *shape = NULL;
    bat_apart_drop(editor);
    bat_status status = before ? bat_shape_copy(before, &shape) : bat_shape_create(curve, NULL, &shape);
    if (status == BAT_OK) status = bat_shape_add_level(shape, 0, NULL, NULL, NULL);
    if (status != BAT_OK) {
        bat_shape_free(shape);
        return told(editor, status, BAT_STRING_NOTICE_MANY_LEVELS);
    }
    int top = bat_shape_levels(shape);
    status = bat_leveling_commit(editor, shape, BAT_STRING_STEP_LEVEL_ADD);
    if (status == BAT_OK) editor->leveling.level = top, editor->leveling.chosen = -1;
    return told(editor, status, BAT_STRING_NOTICE_FAILED);
}

bat_status bat_do_levels_flatten(bat_editor *editor, bool down) {
    (void)down;
    const bat_curve *curve = chosen(editor);
    if (!curve) return BAT_STATE;
    if (!bat_leveling_shape(editor)) return told(editor, BAT_STATE, BAT_STRING_NOTICE_NO_LEVELS);
    bat_curve *plain = NULL;
    bat_apart_drop(editor);
    bat_status status = bat_curve_copy(curve, &plain);
    if (status == BAT_OK)
        status = bat_commit_curve(editor, editor->leveling.object, editor->leveling.curve, plain,
                                  BAT_STRING_STEP_FLATTEN);
    return told(editor, status, BAT_STRING_NOTICE_FAILED);
}

bat_status bat_do_levels_copy(bat_editor *editor, bool down) {
    (void)down;
    if (!chosen(editor)) return BAT_STATE;
    if (!bat_leveling_shape(editor)) return told(editor, BAT_STATE, BAT_STRING_NOTICE_NO_LEVELS);
    bat_apart_drop(editor);
    editor->leveling.copying = !editor->leveling.copying;
    return BAT_OK;
}

bat_status bat_leveling_copy_to(bat_editor *editor, bat_id object, int curve) {
    const bat_shape *from = bat_leveling_shape(editor);
    const bat_curve *target = bat_edit_target(editor->document, object, curve);
    if (!from || !target) return BAT_STATE;
    const bat_shape *there = bat_object_shape(
        bat_document_at(editor->document, bat_document_find(editor->document, object)), curve);
    bat_shape *shape = NULL;
    bat_status status = bat_shape_copy_levels(from, there ? bat_shape_curve(there, 0) : target, &shape);
    if (status == BAT_OK)
        status = bat_leveling_commit_at(editor, object, curve, shape, BAT_STRING_STEP_COPY_DETAIL);
    if (status == BAT_OK) bat_leveling_choose(editor, object, curve);
    return told(editor, status, BAT_STRING_NOTICE_FAILED);
}

/* In the levels tool, and in the sketch tool over the chosen curve; elsewhere the keys mean something else. */
static bat_status step(bat_editor *editor, int direction) {
    bat_leveling *l = &editor->leveling;
    const bat_pick *pick = &editor->sketching.pick;
    bool over = editor->tool == BAT_TOOL_SKETCH && l->object && pick->object == l->object &&
                pick->curve == l->curve;
    if (editor->tool != BAT_TOOL_LEVELS && !over) return BAT_STATE;
    bat_leveling_settle(editor);
    const bat_shape *shape = bat_leveling_shape(editor);
    if (!shape) return editor->tool == BAT_TOOL_LEVELS ? chosen(editor), BAT_OK : BAT_STATE;
    int level = l->level + direction;
    if (level >= 0 && level <= bat_shape_levels(shape)) l->level = level, l->chosen = -1;
    char number[32];
    snprintf(number, sizeof number, "%d / %d", l->level, bat_shape_levels(shape));
    bat_editor_notice_value(editor, BAT_STRING_NOTICE_LEVEL, number);
    return BAT_OK;
}
bat_status bat_do_level_up(bat_editor *editor, bool down) {
    (void)down;
    return step(editor, 1);
}
bat_status bat_do_level_down(bat_editor *editor, bool down) {
    (void)down;
    return step(editor, -1);
}

/* ---- properties ---- */

bool bat_leveling_is(bat_property_id id) {
    return id == BAT_PROPERTY_SHOW_LEVELS || id == BAT_PROPERTY_SHOW_FRAMES ||
           id == BAT_PROPERTY_FRAME_RULE || id == BAT_PROPERTY_LEVEL_SKETCH ||
           id == BAT_PROPERTY_APART_LEVELS || id == BAT_PROPERTY_APART_POINTS;
}

static bat_status set_rule(bat_editor *editor, bat_frame_rule rule) {
    const bat_shape *before = bat_leveling_shape(editor);
    bat_shape *shape = NULL;
    if (!before || bat_shape_options_of(before)->frame == rule) return BAT_OK;
    if (bat_editor_busy(editor)) return BAT_STATE;
    bat_status status = bat_shape_copy(before, &shape);
    if (status == BAT_OK) status = bat_shape_reframe(shape, rule, NULL);
    if (status != BAT_OK) {
        bat_shape_free(shape);
        return told(editor, status, BAT_STRING_NOTICE_FAILED);
    }
    return told(editor, bat_leveling_commit(editor, shape, BAT_STRING_STEP_FRAME_RULE),
                BAT_STRING_NOTICE_FAILED);
}

bat_status bat_leveling_set(bat_editor *editor, bat_property_id id, double value) {
    bat_leveling_settle(editor);
    if (id == BAT_PROPERTY_FRAME_RULE) return set_rule(editor, (bat_frame_rule)(int)value);
    const bat_curve *curve = bat_leveling_curve(editor);
    if (!editor->leveling.apart || !curve) return BAT_OK;
    if (id == BAT_PROPERTY_APART_LEVELS)
        editor->values[BAT_PROPERTY_APART_POINTS] = halved(curve, (int)within(value, 1, BAT_LEVELS_MAX));
    return told(editor, bat_apart_make(editor), BAT_STRING_NOTICE_FEW_POINTS);
}
