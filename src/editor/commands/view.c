/* Commands that change the view, not the drawing. */
#include "editor/tables/commands.h"
#include "editor/input/input.h"
#include "editor/pick/pivot.h"
#include "editor/pick/surface.h"
#include "editor/scene/seen.h"
#include "editor/scene/space.h"
#include "editor/session/notice.h"
#include "editor/show/moves.h"
#include "editor/tables/settings.h"
#include "editor/tables/words.h"
#include "editor/session/session.h"
#include "editor/view/room.h"
#include "editor/view/saved.h"
#include "editor/view/stage.h"
#include "editor/view/views.h"
#include "format/seen/seen.h"
#include <math.h>

static const double TURN = 15;      /* degrees per step */
static const double EDGE_ON = 1e-6; /* sine of the angle */
static const double TAP = 300;      /* ms that a tap of a key takes at most */

bat_status bat_command_view_fit(bat_context *c, bat_command_id id) {
    (void)id;
    return bat_seen_fit(c) ? BAT_OK : BAT_STATE;
}

bat_status bat_command_view_selection(bat_context *c, bat_command_id id) {
    (void)id;
    if (bat_seen_fit_selection(c)) return BAT_OK;
    bat_notice(c, BAT_STRING_NOTICE_SELECT_FIRST);
    return BAT_STATE;
}

static void middle_of(const bat_stage *stage, double middle[2]) {
    middle[0] = stage->view.width / 2;
    middle[1] = stage->view.height / 2;
}

bat_status bat_command_zoom(bat_context *c, bat_command_id id) {
    double middle[2], factor = id == BAT_COMMAND_ZOOM_IN    ? sqrt(2)
                               : id == BAT_COMMAND_ZOOM_OUT ? 1 / sqrt(2)
                                                            : 1 / c->stage->view.zoom;
    middle_of(c->stage, middle);
    bat_stage_zoom(c->stage, middle, factor);
    return BAT_OK;
}

/* Where what the pen draws on is seen edge-on, it draws on the plane of the view: through the pivot, at right angles to the gaze.
 * Where nothing is, the plane of the view before goes. */
static void draw_on_seen(bat_context *c) {
    bat_stage *stage = c->stage;
    double axes[9];
    const bool had = bat_ground_is_of_view(&stage->ground);
    if (had) stage->ground = bat_ground_page();
    if (bat_ground_bounded(&stage->ground) || bat_stage_slant(stage) > EDGE_ON) {
        if (had) bat_ground_take(c, NULL);
        return;
    }
    bat_view_axes(&stage->view, axes, axes + 3, axes + 6);
    stage->ground = bat_ground_of_view(stage->view.pivot, axes, axes + 3);
    bat_notice_value(c, BAT_STRING_NOTICE_ON_PLANE, bat_word(c, BAT_STRING_A_PLANE));
}

/* Home from a tilted view: the last face-on page, as it was. */
static bat_status go_home(bat_context *c) {
    bat_view *view = &c->stage->view, from = *view;
    bat_saved_leave(c);
    if (!bat_views_home(c->views, view)) return BAT_STATE;
    draw_on_seen(c);
    bat_views_jump(c->views, &from, view);
    return BAT_OK;
}

/* About the middle of the selection, or of everything. */
static bat_view leave(bat_context *c) {
    bat_pivot_set(c, NULL);
    bat_saved_leave(c);
    return c->stage->view;
}

static bool is_wall(const bat_context *c) { return bat_room_is_wall(c->session->document); }

/* Up: the table is tilted, and the eye comes down; before a wall it rises. */
bat_status bat_command_orbit(bat_context *c, bat_command_id id) {
    bat_view *view = &c->stage->view;
    const bool wall = is_wall(c);
    const double across = (id == BAT_COMMAND_ORBIT_LEFT) - (id == BAT_COMMAND_ORBIT_RIGHT);
    const double up = (id == BAT_COMMAND_ORBIT_UP) - (id == BAT_COMMAND_ORBIT_DOWN);
    if (up < 0 && view->tilt == 0 && !wall) return BAT_STATE;
    const bat_view from = leave(c);
    bat_room_orbit(view, wall, TURN * across, wall ? -TURN * up : TURN * up, NULL);
    bat_views_jump(c->views, &from, view);
    return BAT_OK;
}

/* The ends of the dial's axes. */
bat_status bat_command_view_named(bat_context *c, bat_command_id id) {
    const bat_attitude pose = {.turn = id == BAT_COMMAND_VIEW_SIDE ? 90 : 0,
                               .tilt = id == BAT_COMMAND_VIEW_TOP ? 0 : 90};
    const bat_view from = leave(c);
    bat_room_take(&c->stage->view, is_wall(c), &pose);
    draw_on_seen(c);
    bat_views_jump(c->views, &from, &c->stage->view);
    return BAT_OK;
}

/* From the right in front and above, all of it. */
bat_status bat_command_view_quarter(bat_context *c, bat_command_id id) {
    (void)id;
    if (!bat_seen_in_space(c->session->document)) return BAT_STATE;
    const bat_view from = leave(c);
    bat_room_take(&c->stage->view, is_wall(c), &(bat_attitude){.turn = 30, .tilt = 65});
    (void)bat_seen_fit_drawn(c);
    bat_views_jump(c->views, &from, &c->stage->view);
    return BAT_OK;
}

/* The page as it was last seen face-on, or the plane that the pen draws on from straight above. */
bat_status bat_command_view_ground(bat_context *c, bat_command_id id) {
    double normal[3];
    (void)id;
    if (bat_stage_dimension(c->stage) == 2) return bat_stage_tilted(c->stage) ? go_home(c) : BAT_STATE;
    const bat_view from = leave(c);
    bat_stage_facing(c->stage, normal);
    bat_room_look_along(&c->stage->view, is_wall(c), normal);
    bat_views_jump(c->views, &from, &c->stage->view);
    return BAT_OK;
}

bat_status bat_command_view_back(bat_context *c, bat_command_id id) {
    (void)id;
    bat_view *view = &c->stage->view, from = *view;
    if (!bat_views_back(c->views, view)) return BAT_STATE;
    bat_views_jump(c->views, &from, view);
    return BAT_OK;
}

bat_status bat_command_turn(bat_context *c, bat_command_id id) {
    double middle[2], angle = c->stage->view.angle;
    if (id == BAT_COMMAND_VIEW_UPRIGHT && bat_stage_tilted(c->stage)) return go_home(c);
    if (id == BAT_COMMAND_VIEW_UPRIGHT && angle == 0) return BAT_STATE;
    const double turn = id == BAT_COMMAND_VIEW_UPRIGHT ? -angle : id == BAT_COMMAND_VIEW_LEFT ? -TURN : TURN;
    middle_of(c->stage, middle);
    if (bat_stage_tilted(c->stage))
        bat_room_orbit(&c->stage->view, is_wall(c), turn, 0, NULL);
    else
        bat_stage_rotate(c->stage, middle, turn);
    return BAT_OK;
}

/* Pans by a tenth of the window. */
bat_status bat_command_pan(bat_context *c, bat_command_id id) {
    double x = (id == BAT_COMMAND_PAN_RIGHT) - (id == BAT_COMMAND_PAN_LEFT);
    double y = (id == BAT_COMMAND_PAN_DOWN) - (id == BAT_COMMAND_PAN_UP);
    double to[2] = {-x * c->stage->view.width / 10, -y * c->stage->view.height / 10};
    bat_stage_pan(c->stage, (double[]){0, 0}, to);
    return BAT_OK;
}

bat_status bat_command_hold_pan(bat_context *c, bool down) {
    bat_input *input = c->input;
    const bool tapped = !down && input->holding_pan && input->pan_time >= 0 &&
                        c->time - input->pan_time <= TAP;
    if (down && !input->holding_pan) input->pan_time = c->time;
    input->holding_pan = down;
    if (tapped) bat_moves_toggle(c); /* a tap plays, or stops */
    return BAT_OK;
}

/* Toggles the property with the command's name. */
bat_status bat_command_switch(bat_context *c, bat_command_id id) {
    bat_property_id property = bat_property_named(bat_command_at(id)->name);
    double *value = &c->settings->values[property];
    *value = *value == 0;
    if (property == BAT_PROPERTY_SNAP)
        bat_notice(c, *value != 0 ? BAT_STRING_NOTICE_SNAP_ON : BAT_STRING_NOTICE_SNAP_OFF);
    return BAT_OK;
}

bat_status bat_command_look(bat_context *c, bat_command_id id) {
    (void)id;
    bat_seen_sync(c);
    if (!bat_stage_tilted(c->stage) || !bat_space_shows_surface(c->scene)) return BAT_STATE;
    double *value = &c->settings->values[BAT_PROPERTY_LOOK];
    *value = *value + 1 < BAT_LOOK_COUNT ? *value + 1 : 0;
    bat_notice_value(c, BAT_STRING_NOTICE_LOOK,
                     bat_word(c, (bat_string)(BAT_STRING_LOOK_MATTE + (int)*value)));
    return BAT_OK;
}

bat_status bat_command_perspective(bat_context *c, bat_command_id id) {
    double *value = &c->settings->values[BAT_PROPERTY_PERSPECTIVE];
    (void)id;
    *value = *value == 0;
    bat_perspective_follow(c);
    bat_notice(c, *value != 0 ? BAT_STRING_NOTICE_PERSPECTIVE : BAT_STRING_NOTICE_PARALLEL);
    return BAT_OK;
}

bat_status bat_command_draw_new(bat_context *c, bool down) {
    c->input->drawing_new = down;
    return BAT_OK;
}

/* Cycles through: as drawn, redraw only, new only. */
bat_status bat_command_meaning(bat_context *c, bat_command_id id) {
    static const bat_string words[] = {BAT_STRING_MEANING_DRAWN, BAT_STRING_MEANING_REDRAW,
                                       BAT_STRING_MEANING_NEW};
    (void)id;
    double *value = &c->settings->values[BAT_PROPERTY_STROKE_MEANING];
    *value = *value >= 2 ? 0 : *value + 1;
    bat_notice_value(c, BAT_STRING_NOTICE_MEANING, bat_word(c, words[(int)*value]));
    return BAT_OK;
}

/* Moves to the next value on a scale with six steps per decade. */
bat_status bat_command_tolerance(bat_context *c, bat_command_id id) {
    static const double rungs[] = {0.1, 0.15, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3, 5, 7, 10, 15, 20};
    const int count = (int)(sizeof rungs / sizeof *rungs);
    int direction = id == BAT_COMMAND_TOLERANCE_UP ? 1 : -1, i = direction > 0 ? 0 : count - 1;
    double now = c->settings->values[BAT_PROPERTY_TOLERANCE];
    while (i >= 0 && i < count && (rungs[i] - now) * direction <= 1e-9) i += direction;
    if (i < 0 || i >= count) return BAT_STATE;
    c->settings->values[BAT_PROPERTY_TOLERANCE] = rungs[i];
    return BAT_OK;
}
