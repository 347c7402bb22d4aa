#include "document/document.h"
#include "editor/panels/numbers.h"
#include "hands/tangents/spline.h"
#include "base/real.h"
#include "editor/edit/affine.h"
#include "editor/edit/arrange.h"
#include "editor/edit/making.h"
#include "editor/edit/shapes/primitives.h"
#include "editor/edit/binding.h"
#include "editor/choice/choice.h"
#include "editor/commands/dispatch.h"
#include "editor/panels/page.h"
#include "editor/panels/view.h"
#include "editor/panels/panels.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/tables.h"
#include "editor/tools/modes/guides.h"
#include "editor/tools/points/state.h"
#include "editor/tools/tangents/state.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/tools/width/state.h"
#include "editor/view/unit.h"
#include "editor/view/stage.h"
#include "base/matrix.h"
#include "base/pose.h"
#include "format/seen/seen.h"
#include <math.h>
#include <string.h>

/* The chosen control point, or point of a spline. */
static bool point_now(bat_context *c, double place[2]) {
    if (bat_tool_at(c->choice->tool)->traits & BAT_EDITS_POINTS) return bat_pointing_chosen(c, place);
    const bat_spline *spline = bat_tool_at(c->choice->tool)->traits & BAT_EDITS_SPLINES
                                   ? bat_splining_spline(c)
                                   : NULL;
    int point = bat_splining_of(c)->point;
    if (!spline || point < 0 || point >= bat_spline_count(spline) || spline->dimension != 2) return false;
    memcpy(place, spline->points + 2 * point, 2 * sizeof *place);
    return true;
}

/* Those of shapes that stay shapes are in the order of bat_primitive_number. */
static bool is_of_shape(bat_number_id id) {
    return id >= BAT_NUMBER_SHAPE_RADIUS && id <= BAT_NUMBER_SHAPE_ROUNDNESS;
}
static bat_primitive_number shape_number(bat_number_id id) {
    return (bat_primitive_number)(id - BAT_NUMBER_SHAPE_RADIUS);
}

/* Whether heights mean something: the drawing has space, or is about to get it. */
static bool is_in_space(const bat_context *c) {
    return bat_stage_tilted(c->stage) || bat_seen_in_space(c->session->document);
}

bool bat_number_now(bat_context *c, bat_number_id id, double *value) {
    double box[4], zero[2], place[2], at, low[3], high[3];
    bat_unit_origin(c, zero);
    switch (id) {
    case BAT_NUMBER_POINT_X:
    case BAT_NUMBER_POINT_Y: {
        int axis = id == BAT_NUMBER_POINT_Y;
        if (!point_now(c, place)) return false;
        *value = place[axis] - zero[axis];
        return true;
    }
    case BAT_NUMBER_GUIDE: {
        const bat_object *guide = bat_document_at(c->session->document, bat_guide_chosen(c));
        int axis = guide ? bat_object_guide(guide, &at) : -1;
        if (axis < 0) return false;
        *value = at - zero[axis];
        return true;
    }
    case BAT_NUMBER_WIDTH_HERE:
    case BAT_NUMBER_WIDTH_PLACE:
        return bat_tool_at(c->choice->tool)->traits & BAT_EDITS_WIDTHS &&
               bat_broadening_number(c, id == BAT_NUMBER_WIDTH_PLACE, value);
    case BAT_NUMBER_SURFACE_TWIST: return bat_making_get(c, BAT_MAKING_TWIST, value);
    case BAT_NUMBER_SURFACE_SCALE: return bat_making_get(c, BAT_MAKING_SCALE, value);
    case BAT_NUMBER_WIRE_RADIUS:
    case BAT_NUMBER_WIRE_RADIUS_END:
        return bat_document_has_followers(c->session->document) &&
               bat_bind_radius(c, id == BAT_NUMBER_WIRE_RADIUS_END, value);
    case BAT_NUMBER_SURFACE_ANGLE: return bat_making_get(c, BAT_MAKING_ANGLE, value);
    default: break;
    }
    if (is_of_shape(id))
        return c->choice->selection.count > 0 && bat_primitives_get(c, shape_number(id), value);
    if (!bat_arrange_selection_box(c, box)) return false;
    switch (id) {
    case BAT_NUMBER_Z:
    case BAT_NUMBER_DEPTH:
        if (!is_in_space(c) || !bat_arrange_selection_space(c, low, high)) return false;
        *value = id == BAT_NUMBER_Z ? low[2] : high[2] - low[2];
        break;
    case BAT_NUMBER_X: *value = box[0] - zero[0]; break;
    case BAT_NUMBER_Y: *value = box[1] - zero[1]; break;
    case BAT_NUMBER_WIDTH: *value = box[2] - box[0]; break;
    case BAT_NUMBER_HEIGHT: *value = box[3] - box[1]; break;
    default: *value = 0; /* relative to the present state */
    }
    return true;
}

/* Changes the selection: about its upper left corner; rotation is about its middle, counterclockwise. */
static bat_status change_selection(bat_context *c, bat_number_id id, double from, double to) {
    double box[4], matrix[6], factor = to / from;
    bat_string step = BAT_STRING_STEP_MOVE;
    bat_arrange_selection_box(c, box);
    if (id == BAT_NUMBER_X || id == BAT_NUMBER_Y) {
        bat_matrix_translation(id == BAT_NUMBER_X ? to - from : 0, id == BAT_NUMBER_Y ? to - from : 0,
                               matrix);
    } else if (id == BAT_NUMBER_TURN) {
        double about[2] = {box[0] / 2 + box[2] / 2, box[1] / 2 + box[3] / 2};
        bat_matrix_rotation(-fmod(to, 360) * BAT_PI / 180, about, matrix);
        step = BAT_STRING_STEP_ROTATE;
    } else {
        if (!(from > 0)) return BAT_STATE; /* nothing can be scaled up from zero */
        if (!(factor != 0 && isfinite(factor))) return BAT_ARGUMENT;
        bat_matrix_scaling(id == BAT_NUMBER_WIDTH ? factor : 1, id == BAT_NUMBER_HEIGHT ? factor : 1, box,
                           matrix);
        if (factor < 0) matrix[id == BAT_NUMBER_WIDTH ? 4 : 5] -= to; /* a mirror image in the same place */
        step = factor < 0 ? BAT_STRING_STEP_MIRROR : BAT_STRING_STEP_SCALE;
    }
    return bat_arrange_transform(c, matrix, step);
}

/* Moves the selection along z, or makes it as deep from its lowest z on. */
static bat_status change_depth(bat_context *c, bat_number_id id, double from, double to) {
    double low[3], high[3], rows[12];
    const double factor = to / from;
    bat_arrange_selection_space(c, low, high);
    bat_pose_translation((double[]){0, 0, to - from}, rows);
    if (id == BAT_NUMBER_DEPTH) {
        if (!(from > 0)) return BAT_STATE; /* what is flat has no depth to stretch */
        if (!(factor > 0 && isfinite(factor))) return BAT_ARGUMENT;
        rows[10] = factor, rows[11] = low[2] - factor * low[2];
    }
    const bat_status status = bat_arrange_pose(
        c, rows, id == BAT_NUMBER_DEPTH ? BAT_STRING_STEP_SCALE : BAT_STRING_STEP_MOVE);
    if (status == BAT_UNSUPPORTED) bat_notice(c, BAT_STRING_NOTICE_STAYS_ON_PAGE);
    return status;
}

static bat_status change_point(bat_context *c, int axis, double by) {
    double delta[2] = {axis ? 0 : by, axis ? by : 0};
    if (bat_tool_at(c->choice->tool)->traits & BAT_EDITS_POINTS) return bat_pointing_shift(c, delta);
    bat_splining *s = bat_splining_of(c);
    bat_status status = bat_splining_load(c);
    if (status != BAT_OK) return status;
    s->draft.points[2 * s->point + axis] += by;
    return bat_splining_commit(c, BAT_STRING_STEP_MOVE_POINT);
}

static bat_status change(bat_context *c, bat_number_id id, double from, double to) {
    if (is_of_shape(id)) return bat_primitives_set(c, shape_number(id), to);
    if (id == BAT_NUMBER_Z || id == BAT_NUMBER_DEPTH) return change_depth(c, id, from, to);
    if (id == BAT_NUMBER_SURFACE_TWIST) return bat_making_set(c, BAT_MAKING_TWIST, to);
    if (id == BAT_NUMBER_SURFACE_SCALE) return bat_making_set(c, BAT_MAKING_SCALE, to);
    if (id == BAT_NUMBER_SURFACE_ANGLE) return bat_making_set(c, BAT_MAKING_ANGLE, to);
    if (id == BAT_NUMBER_WIRE_RADIUS || id == BAT_NUMBER_WIRE_RADIUS_END)
        return bat_bind_set_radius(c, id == BAT_NUMBER_WIRE_RADIUS_END, to);
    if (id == BAT_NUMBER_WIDTH_HERE || id == BAT_NUMBER_WIDTH_PLACE)
        return bat_broadening_enter(c, id == BAT_NUMBER_WIDTH_PLACE, to);
    if (id == BAT_NUMBER_POINT_X || id == BAT_NUMBER_POINT_Y)
        return change_point(c, id == BAT_NUMBER_POINT_Y, to - from);
    if (id != BAT_NUMBER_GUIDE) return change_selection(c, id, from, to);
    double at = 0;
    int axis = bat_object_guide(bat_document_at(c->session->document, bat_guide_chosen(c)), &at);
    return bat_guide_put(c, bat_guiding_of(c)->chosen, axis, at + to - from);
}

static bool is_angle(bat_number_id id) {
    return id == BAT_NUMBER_TURN || id == BAT_NUMBER_SURFACE_TWIST || id == BAT_NUMBER_SURFACE_ANGLE ||
           id == BAT_NUMBER_SHAPE_START || id == BAT_NUMBER_SHAPE_END;
}

/* No length, nor an angle. */
static bool is_bare(bat_number_id id) {
    return id == BAT_NUMBER_SURFACE_SCALE ||
           (id >= BAT_NUMBER_SHAPE_SIDES && id <= BAT_NUMBER_SHAPE_ROUNDNESS);
}

static bat_status enter_property(bat_context *c, const char *name, const char *text) {
    bat_property_id id = bat_property_named(name);
    double value;
    if (id == BAT_PROPERTY_COUNT || bat_property_at(id)->type != BAT_PROPERTY_NUMBER) return BAT_UNSUPPORTED;
    bool length = !strcmp(bat_property_at(id)->unit, "unit");
    bat_status status = bat_unit_read(c, text, !length, &value);
    return status == BAT_OK ? bat_property_set(c, name, value) : status;
}

bat_status bat_panel_enter(bat_context *c, const char *name, const char *text) {
    bat_number_id id = bat_number_named(name);
    double from, to;
    if (!name || !text) return BAT_ARGUMENT;
    if (bat_page_names(name)) return bat_page_enter(c, name, text);
    if (!strcmp(name, "view")) return bat_view_enter(c, text);
    if (id == BAT_NUMBER_COUNT) return enter_property(c, name, text);
    if (bat_toolbox_busy(c) || c->session->transaction.open || !bat_number_now(c, id, &from))
        return BAT_STATE;
    bat_status status = bat_unit_read(c, text, is_angle(id) || is_bare(id), &to);
    if (status != BAT_OK) return status;
    if (!(fabs(to) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    if (to == from) return BAT_OK;
    status = change(c, id, from, to);
    if (status == BAT_MEMORY) bat_notice_failure(c, status);
    return status;
}

const char *bat_panel_number(bat_context *c, const char *name) {
    bat_number_id id = bat_number_named(name);
    char *text = c->panels->number_text;
    double value;
    *text = 0;
    if (id != BAT_NUMBER_COUNT) {
        if (!bat_number_now(c, id, &value)) return text;
        if (is_angle(id) || is_bare(id)) {
            bat_unit_number(value, text);
            if (is_angle(id)) strcat(text, "°");
        } else
            bat_unit_write(c, value, text);
        return text;
    }
    if (name && !strcmp(name, "missed")) { /* by how much the fit that is shown misses the tolerance */
        const bat_readout made = bat_toolbox_readout(c);
        if (made.report) bat_unit_about(c, made.report->max_error, text);
        return text;
    }
    if (name && !strcmp(name, "points")) { /* how many are chosen together */
        const int count = bat_tool_at(c->choice->tool)->traits & BAT_EDITS_POINTS ? bat_pointing_of(c)->marked
                                                                                  : 0;
        if (count > 0) bat_unit_number(count, text);
        return text;
    }
    if (name && !strcmp(name, "view")) return bat_view_text(c);
    if (name && !strcmp(name, "room")) {
        bat_view_room_text(c, text);
        return text;
    }
    if (bat_page_names(name)) {
        bat_page_number(c, name, text);
        return text;
    }
    bat_property_id property = bat_property_named(name);
    if (property == BAT_PROPERTY_COUNT || bat_property_get(c, name, &value) != BAT_OK) return text;
    const char *unit = bat_property_at(property)->unit;
    bool pixels = !strcmp(unit, "px"); /* view pixels */
    if (pixels || !strcmp(unit, "unit"))
        bat_unit_write(c, pixels ? value * bat_stage_pixel(c->stage) : value, text);
    else
        bat_unit_number(value, text);
    return text;
}
