/* Commands and properties of levels: taking a curve apart, adding a level, stepping, copying, flattening, the frame
 * rule. They act on the curve chosen in the levels tool, or otherwise on the selection. */
#include "editor/tables/commands.h"
#include "editor/choice/choice.h"
#include "editor/edit/stroke.h"
#include "editor/pick/pick.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/levels/state.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/edit/curves_of.h"
#include "base/real.h"
#include <batten/relief.h>
#include <math.h>
#include <stdio.h>

/* Whether a curve or a surface is chosen; switches to the levels tool, which shows it. */
static bool chosen(bat_context *c) {
    if (!(bat_tool_at(c->choice->tool)->traits & BAT_EDITS_LEVELS))
        bat_toolbox_choose(c, bat_tool_that(BAT_EDITS_LEVELS));
    bat_leveling_settle(c);
    const bool any = bat_leveling_curve(c) || bat_leveling_solid(c);
    if (!any) bat_notice(c, BAT_STRING_NOTICE_CHOOSE_CURVE);
    return any;
}

static bat_status told(bat_context *c, bat_status status, bat_string why) {
    if (status == BAT_STATE || status == BAT_COUNT)
        bat_notice(c, why);
    else if (status != BAT_OK)
        bat_notice_failure(c, status);
    return status;
}

/* ---- taking apart ---- */

/* Down to a base of a dozen points in each direction, as it would be with half at each level. */
static bat_status apart_solid(bat_context *c) {
    const bat_surface *surface = bat_object_surface(bat_leveling_solid(c));
    const double most = fmax((double)bat_surface_count(surface, BAT_U),
                             (double)bat_surface_count(surface, BAT_V));
    const double levels = fmax(1, ceil(bat_log(most / 12) / bat_log(2)));
    c->settings->values[BAT_PROPERTY_APART_LEVELS] = levels;
    c->settings->values[BAT_PROPERTY_APART_POINTS] = fmin(most, 12);
    return bat_apart_make(c);
}

bat_status bat_command_take_apart(bat_context *c, bat_command_id id) {
    (void)id;
    if (!chosen(c)) return BAT_STATE;
    bat_leveling_of(c)->copying = false;
    if (bat_leveling_solid(c)) return told(c, apart_solid(c), BAT_STRING_NOTICE_FEW_POINTS);
    const bat_curve *curve = bat_leveling_curve(c);
    int levels = 1;
    while (levels < BAT_LEVELS_MAX && bat_apart_halved(curve, levels) > 12 &&
           bat_apart_halved(curve, levels + 1) < bat_apart_halved(curve, levels))
        levels++;
    c->settings->values[BAT_PROPERTY_APART_LEVELS] = levels;
    c->settings->values[BAT_PROPERTY_APART_POINTS] = bat_apart_halved(curve, levels);
    return told(c, bat_apart_make(c), BAT_STRING_NOTICE_FEW_POINTS);
}

/* ---- levels ---- */

/* What is chosen with one level more. */
static bat_status one_more(const bat_context *c, bat_ladder *out) {
    const bat_object *solid = bat_leveling_solid(c);
    bat_shape *shape = NULL;
    bat_relief *relief = NULL;
    *out = (bat_ladder){NULL, NULL};
    const bat_ladder before = bat_leveling_ladder(c);
    bat_status status = before.relief  ? bat_relief_copy(before.relief, &relief)
                        : before.shape ? bat_shape_copy(before.shape, &shape)
                        : solid        ? bat_relief_create(bat_object_surface(solid), &relief)
                                       : bat_shape_create(bat_leveling_curve(c), NULL, &shape);
    if (status == BAT_OK)
        status = relief ? bat_relief_add_level(relief, NULL, NULL, NULL, NULL, NULL)
                        : bat_shape_add_level(shape, 0, NULL, NULL, NULL);
    *out = (bat_ladder){shape, relief};
    return status;
}

bat_status bat_command_level_add(bat_context *c, bat_command_id id) {
    (void)id;
    bat_ladder ladder;
    if (!chosen(c)) return BAT_STATE;
    bat_apart_drop(c);
    bat_status status = one_more(c, &ladder);
    if (status != BAT_OK) {
        bat_ladder_free(&ladder);
        return told(c, status, BAT_STRING_NOTICE_MANY_LEVELS);
    }
    int top = bat_ladder_levels(ladder);
    status = bat_leveling_commit_ladder(c, ladder, BAT_STRING_STEP_LEVEL_ADD);
    if (status == BAT_OK) bat_leveling_of(c)->level = top, bat_leveling_of(c)->chosen = -1;
    return told(c, status, BAT_STRING_NOTICE_FAILED);
}

bat_status bat_command_levels_flatten(bat_context *c, bat_command_id id) {
    (void)id;
    if (!chosen(c)) return BAT_STATE;
    const bat_curve *curve = bat_leveling_curve(c);
    if (!bat_ladder_any(bat_leveling_ladder(c))) return told(c, BAT_STATE, BAT_STRING_NOTICE_NO_LEVELS);
    bat_curve *plain = NULL;
    bat_apart_drop(c);
    if (!curve)
        return told(c, bat_relief_commit(c, bat_leveling_of(c)->object, NULL, BAT_STRING_STEP_FLATTEN),
                    BAT_STRING_NOTICE_FAILED);
    bat_status status = bat_curve_copy(curve, &plain);
    if (status == BAT_OK)
        status = bat_commit_curve(c, bat_leveling_of(c)->object, bat_leveling_of(c)->curve, plain,
                                  BAT_STRING_STEP_FLATTEN);
    return told(c, status, BAT_STRING_NOTICE_FAILED);
}

bat_status bat_command_levels_copy(bat_context *c, bat_command_id id) {
    (void)id;
    if (!chosen(c)) return BAT_STATE;
    if (!bat_ladder_any(bat_leveling_ladder(c))) return told(c, BAT_STATE, BAT_STRING_NOTICE_NO_LEVELS);
    bat_apart_drop(c);
    bat_leveling_of(c)->copying = !bat_leveling_of(c)->copying;
    return BAT_OK;
}

/* From surface to surface. */
static bat_status copy_to_solid(bat_context *c, bat_id object) {
    const bat_relief *from = bat_leveling_relief(c);
    const bat_object *target = bat_document_at(c->session->document,
                                               bat_document_find(c->session->document, object));
    const bat_surface *surface = target ? bat_object_surface(target) : NULL;
    if (!surface) return told(c, BAT_STATE, BAT_STRING_NOTICE_SURFACE_DETAIL);
    const bat_relief *there = bat_object_relief(target);
    bat_relief *relief = NULL;
    bat_status status = bat_relief_copy_levels(from, there ? bat_relief_surface(there, 0) : surface, &relief);
    if (status == BAT_OK) status = bat_relief_commit(c, object, relief, BAT_STRING_STEP_COPY_DETAIL);
    if (status == BAT_OK) bat_leveling_choose(c, object, 0);
    return told(c, status, BAT_STRING_NOTICE_FAILED);
}

bat_status bat_leveling_copy_to(bat_context *c, bat_id object, int curve) {
    if (bat_leveling_relief(c)) return copy_to_solid(c, object);
    const bat_shape *from = bat_leveling_shape(c);
    const bat_curve *target = bat_edit_target_in(c->session->document, 0, object, curve);
    if (!from || !target) return BAT_STATE;
    const bat_object *owner = bat_document_at(c->session->document,
                                              bat_document_find(c->session->document, object));
    if (bat_object_surface(owner)) return told(c, BAT_STATE, BAT_STRING_NOTICE_SURFACE_DETAIL);
    const bat_shape *there = bat_object_shape(owner, curve);
    bat_shape *shape = NULL;
    bat_status status = bat_shape_copy_levels(from, there ? bat_shape_curve(there, 0) : target, &shape);
    if (status == BAT_OK) status = bat_commit_shape(c, object, curve, shape, BAT_STRING_STEP_COPY_DETAIL);
    if (status == BAT_OK) bat_leveling_choose(c, object, curve);
    return told(c, status, BAT_STRING_NOTICE_FAILED);
}

/* Steps in the levels tool, and in the sketch tool over the chosen curve; elsewhere the keys have other meanings. */
static bat_status step(bat_context *c, int direction) {
    bat_leveling *l = bat_leveling_of(c);
    const bat_slot *chosen_tool = bat_toolbox_chosen(c);
    bat_focus pick = {0};
    if (bat_toolbox_has(c, BAT_DRAWS)) chosen_tool->is->focus(c, chosen_tool->state, &pick);
    bool over = l->object && pick.object == l->object && pick.curve == l->curve;
    over = over || (bat_toolbox_has(c, BAT_REDRAWS_LINES) && bat_leveling_relief(c));
    if (!(bat_tool_at(c->choice->tool)->traits & BAT_EDITS_LEVELS) && !over) return BAT_STATE;
    bat_leveling_settle(c);
    const bat_ladder ladder = bat_leveling_ladder(c);
    if (!bat_ladder_any(ladder))
        return bat_tool_at(c->choice->tool)->traits & BAT_EDITS_LEVELS ? chosen(c), BAT_OK : BAT_STATE;
    int level = l->level + direction;
    if (level >= 0 && level <= bat_ladder_levels(ladder)) l->level = level, l->chosen = -1;
    char number[32];
    snprintf(number, sizeof number, "%d / %d", l->level, bat_ladder_levels(ladder));
    bat_notice_value(c, BAT_STRING_NOTICE_LEVEL, number);
    return BAT_OK;
}
/* The levels of widths are those of the tool that pulls them. */
static bat_status to_widths(bat_context *c, bat_command_id id) {
    const bat_slot *tool = bat_toolbox_chosen(c);
    return tool->is->command(c, tool->state, id);
}

bat_status bat_command_level_up(bat_context *c, bat_command_id id) {
    return bat_toolbox_has(c, BAT_EDITS_WIDTHS) ? to_widths(c, id) : step(c, 1);
}
bat_status bat_command_level_down(bat_context *c, bat_command_id id) {
    return bat_toolbox_has(c, BAT_EDITS_WIDTHS) ? to_widths(c, id) : step(c, -1);
}

/* ---- properties ---- */

static bat_status set_rule(bat_context *c, bat_frame_rule rule) {
    const bat_shape *before = bat_leveling_shape(c);
    bat_shape *shape = NULL;
    if (!before || bat_shape_options_of(before)->frame == rule) return BAT_OK;
    if (bat_toolbox_busy(c)) return BAT_STATE;
    bat_status status = bat_shape_copy(before, &shape);
    if (status == BAT_OK) status = bat_shape_reframe(shape, NULL, rule);
    if (status != BAT_OK) {
        bat_shape_free(shape);
        return told(c, status, BAT_STRING_NOTICE_FAILED);
    }
    return told(c, bat_leveling_commit(c, shape, BAT_STRING_STEP_FRAME_RULE), BAT_STRING_NOTICE_FAILED);
}

bat_status bat_leveling_set(bat_context *c, bat_property_id id, double value) {
    bat_leveling_settle(c);
    if (id >= BAT_PROPERTY_HOLD_LENGTH && id <= BAT_PROPERTY_HOLD_SYMMETRY)
        return bat_leveling_told_held(c, id);
    if (id == BAT_PROPERTY_FRAME_RULE) return set_rule(c, (bat_frame_rule)(int)value);
    const bat_curve *curve = bat_leveling_curve(c);
    if (!bat_ladder_any(bat_leveling_of(c)->apart)) return BAT_OK;
    if (curve && id == BAT_PROPERTY_APART_LEVELS)
        c->settings->values[BAT_PROPERTY_APART_POINTS] = bat_apart_halved(
            curve, (int)fmin(fmax(floor(value + 0.5), 1), BAT_LEVELS_MAX));
    return told(c, bat_apart_make(c), BAT_STRING_NOTICE_FEW_POINTS);
}
