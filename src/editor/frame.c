/* The frame: what the host paints and says. */
#include "document/document.h"
#include "editor/show/axis.h"
#include "editor/show/disc.h"
#include "editor/show/body.h"
#include "editor/show/flight.h"
#include "editor/show/followers.h"
#include "editor/show/snapped.h"
#include "editor/panels/first_hints.h"
#include "editor/commands/three.h"
#include "editor/editor.h"
#include "editor/commands/calm.h"
#include "editor/show/ruler.h"
#include "editor/tools/gazes/find.h"
#include "editor/tools/levels/state.h"
#include "editor/tools/width/state.h"
#include "editor/tools/modes/guides.h"
#include "editor/tools/modes/reach.h"
#include "editor/tools/sketch/sketching.h"
#include <stdio.h>
#include <string.h>

enum { NAME_LONG = 80 /* bytes: a longer name does not stand in the hint */ };
enum { BAT_OUTLINES_MAX = 300 }; /* of more objects than this, only the first ones are outlined */

static bat_cursor cursor(bat_context *c) {
    if (c->moves->through) return BAT_CURSOR_ARROW;
    if (c->input->orbit.on ||
        (!bat_contacts_clear(c) && bat_contacts_count(&c->input->contacts, BAT_DUTY_NAVIGATE, NULL)))
        return BAT_CURSOR_GRABBING;
    if (c->input->holding_pan || c->session->read_only) return BAT_CURSOR_GRAB;
    const bat_slot *tool = bat_toolbox_tool(c);
    if (!bat_toolbox_faces(c)) return BAT_CURSOR_ARROW;
    int guide = bat_guides_hot(c);
    if (guide >= 0) return guide ? BAT_CURSOR_RESIZE_NS : BAT_CURSOR_RESIZE_EW;
    return tool->is->cursor ? tool->is->cursor(c, tool->state) : BAT_CURSOR_CROSS;
}

static const char *hint(bat_context *c) {
    const bat_slot *tool = bat_toolbox_tool(c);
    if (c->moves->through) return bat_word(c, BAT_STRING_HINT_THROUGH);
    if (c->session->read_only) return bat_word(c, BAT_STRING_HINT_READ_ONLY);
    if (c->input->three.on) return bat_word(c, BAT_STRING_HINT_THREE_POINTS);
    if (!bat_guiding_of(c)->on && bat_guides_hot(c) >= 0)
        return bat_word(c, bat_ruler_at(c, c->input->pen) < 0 ? BAT_STRING_HINT_GUIDE
                                                              : BAT_STRING_HINT_GUIDE_NEW);
    if (c->input->holding_pan && !bat_toolbox_busy(c)) return bat_word(c, BAT_STRING_HINT_PAN);
    if (!bat_toolbox_faces(c)) return bat_word(c, BAT_STRING_HINT_TILTED);
    return tool->is->hint ? bat_word(c, tool->is->hint(c, tool->state)) : "";
}

enum { PLAIN_ROOM = 320 }; /* bytes of a hint without what stands before and behind it */

/* "{tap|click}" in a hint is the first for a pen or a finger, the second for a mouse. */
static const char *by_device(const bat_context *c, const char *text, char out[PLAIN_ROOM]) {
    const bool mouse = c->input->points == BAT_DEVICE_MOUSE;
    size_t used = 0;
    int part = 0; /* 1, 2: of what is in brackets */
    if (!strchr(text, '{')) return text;
    for (; *text && used < PLAIN_ROOM - 1; text++) {
        if (*text == '{')
            part = 1;
        else if (part && *text == '|')
            part = 2;
        else if (part && *text == '}')
            part = 0;
        else if (!part || (part == 2) == mouse)
            out[used++] = *text;
    }
    out[used] = 0;
    return out;
}

/* What a stroke lands on, in words. */
static const char *ground_word(const bat_context *c, const bat_ground *ground) {
    const int at = bat_document_find(c->session->document, ground->object);
    const bat_object *object = ground->object ? bat_document_at(c->session->document, at) : NULL;
    const char *name = object ? bat_object_name(object) : "";
    if (!ground->type->numbers) return bat_word(c, BAT_STRING_THE_PAGE);
    if (!object) return bat_word(c, BAT_STRING_ITS_PLANE);
    if (bat_object_is_made_of_curves(object)) return bat_word(c, BAT_STRING_A_RULED);
    if (*name && strlen(name) < NAME_LONG) return name;
    return bat_word(c, bat_object_surface(object) ? BAT_STRING_A_SURFACE : BAT_STRING_A_PLANE);
}

/* The hint; before it, where this is not plain, what a stroke would land on. */
static const char *whole_hint(bat_editor *editor) {
    bat_context *c = &editor->context;
    const bat_slot *tool = bat_toolbox_tool(c);
    const bat_stage *stage = tool->is->lands ? tool->is->lands(c, tool->state) : NULL;
    char room[PLAIN_ROOM];
    const char *text = by_device(c, hint(c), room);
    if (!stage) stage = c->stage;
    if (!bat_toolbox_has(c, BAT_LANDS) || !bat_toolbox_faces(c) || c->input->holding_pan ||
        (!bat_stage_tilted(stage) && bat_stage_dimension(stage) == 2)) {
        if (text != room) return text;
        memcpy(editor->hint, room, sizeof room);
        return editor->hint;
    }
    const char *ground = ground_word(c, &stage->ground);
    bat_word_fill(c, BAT_STRING_HINT_ON, 1, &ground, editor->hint, sizeof editor->hint);
    const size_t used = strlen(editor->hint);
    snprintf(editor->hint + used, sizeof editor->hint - used, "%s", text);
    return editor->hint;
}

/* Behind the hint, in numbers: while a curve is being drawn what follows it, else the surface that is selected. */
static const char *hint_with_numbers(bat_editor *editor, const bat_readout *made) {
    const char *text = whole_hint(editor);
    const bat_context *c = &editor->context;
    char written[BAT_FOLLOWERS_ROOM];
    bat_follow_numbers numbers;
    if (!bat_document_has_followers(c->session->document)) return text;
    if (c->session->transaction.open)
        bat_follow_numbers_now(c, &numbers);
    else
        bat_follow_numbers_selected(c, &numbers);
    bat_follow_numbers_write(c, made->followers ? &made->followers->numbers : &numbers, written);
    if (!written[0]) return text;
    size_t used = strlen(text);
    if (used >= sizeof editor->hint) return text;
    if (text != editor->hint) memcpy(editor->hint, text, used);
    snprintf(editor->hint + used, sizeof editor->hint - used, " \xc2\xb7 %s", written);
    return editor->hint;
}

static void drawing(const bat_readout *made, bat_frame *frame) {
    frame->pending = made->waits ? 1 : made->goes_on ? 2 : 0;
    if (!made->report) return;
    frame->knots_before = (uint32_t)made->report->knots_before;
    frame->knots_after = (uint32_t)made->report->knots_after;
    frame->error = made->report->max_error;
}

/* Shows the outlines of the selection, under the tool's own display. */
static void show_selection(bat_context *c, bat_overlay *overlay) {
    const bat_scene *scene = c->scene;
    const bat_selection *selection = &c->choice->selection;
    if (!selection->count) return;
    bat_overlay_item(overlay, BAT_ROLE_SELECTION, BAT_ITEM_STROKED, 1.5F);
    int shown = 0, end = 0; /* of the selected group being walked through */
    for (int i = 0; i < scene->count && shown < BAT_OUTLINES_MAX; i++) {
        const bat_scene_entry *entry = &scene->entries[i];
        if (i >= end && bat_selection_has(selection, bat_object_id(entry->object)))
            end = bat_document_end(c->session->document, i);
        if (i >= end || !entry->path || entry->hidden) continue;
        shown++;
        bat_path_copy(&overlay->path, entry->path, entry->item.path_count);
    }
}

/* The point that the view turns about. */
static void show_pivot(const bat_context *c, bat_overlay *overlay) {
    if (!c->input->orbit.on) return;
    bat_overlay_item(overlay, BAT_ROLE_PIVOT, BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1.5F);
    bat_overlay_circle(overlay, c->stage->view.pivot, 4 * bat_stage_pixel(c->stage));
}

/* Whether curves are inspected: what does so comes with the second part of the browser's module. */
static bool inspects(const bat_context *c) {
    const double *values = c->settings->values;
    return !bat_stage_tilted(c->stage) &&
           (values[BAT_PROPERTY_SHOW_COMB] != 0 || values[BAT_PROPERTY_SHOW_KNOTS] != 0 ||
            values[BAT_PROPERTY_SHOW_LENGTH] != 0);
}

/* Builds the overlay: guide lines, the selection, the tool's display. */
static void show_overlay(bat_context *c, const bat_slot *tool, const bat_readout *made,
                         bat_overlay *overlay) {
    const bool faces = bat_toolbox_faces(c);
    bat_overlay_begin(overlay, c->scene->origin, c->scene->tilted ? c->scene->map : NULL,
                      c->scene->tolerance);
    if (c->moves->through) { /* places in the window are not those of the view */
        bat_overlay_end(overlay, bat_stage_pixel(c->stage));
        return;
    }
    bat_grid_show(c, overlay);
    bat_guides_show(c, overlay);
    if (c->settings->values[BAT_PROPERTY_SYMMETRY] != 0) bat_axis_show(c, overlay);
    if (bat_toolbox_has(c, BAT_LANDS)) bat_plane_show(c->stage, overlay);
    if (c->choice->selection.count && bat_document_has_followers(c->session->document))
        bat_reach_show(c, overlay), bat_folds_show_chosen(c, overlay);
    show_selection(c, overlay);
    if (inspects(c)) bat_insight_show(c, made->curve, overlay);
    if (c->insight->deviating.reference)
        bat_deviating_show(c, &(bat_deviation_change){made->object, made->number, made->curve}, overlay);
    bat_calm_show(c, overlay);
    bat_tuning_show(c, overlay);
    bat_sketching_show_kept(c, overlay);
    if (tool->is->overlay && faces) tool->is->overlay(c, tool->state, overlay);
    if (c->snap->kind != BAT_SNAP_NONE) bat_snap_show(c, overlay);
    bat_rulers_show(c, overlay);
    show_pivot(c, overlay);
    if (c->moves->camera) bat_flight_show(c, overlay), bat_gazes_show(c, overlay), bat_body_show(c, overlay);
    if (c->input->three.on) bat_three_show(c, overlay);
    bat_overlay_end(overlay, bat_stage_pixel(c->stage));
}

static uint32_t readings(const bat_context *c) {
    const uint32_t tuned = bat_tuning_version(c);
    return tuned ? tuned : bat_toolbox_readings(c);
}

static uint32_t levels(bat_context *c) {
    return bat_toolbox_has(c, BAT_EDITS_WIDTHS) ? bat_broadening_levels_version(c) : bat_leveling_version(c);
}

/* A drag shows in the same frame, and with it what follows its curves. */
static void update(bat_context *c, const bat_slot *tool) {
    if (tool->is->update) tool->is->update(c, tool->state);
    bat_transaction_follow(c);
    bat_seen_sync(c);
}

const bat_frame *bat_editor_frame(bat_editor *editor) {
    bat_context *c = &editor->context;
    bat_overlay *overlay = &editor->overlay;
    const bat_slot *tool = bat_toolbox_tool(c);
    bat_scene *scene = c->scene;
    bat_scene_rebase(scene, c->stage);
    bat_seen_sync(c);
    if (!bat_toolbox_busy(c)) c->snap->kind = BAT_SNAP_NONE;
    bat_moves_sync(c);
    bat_flight_stand(c);
    update(c, tool);
    bat_readout made = bat_toolbox_readout(c);
    show_overlay(c, tool, &made, overlay);

    bat_frame *frame = &editor->frame;
    *frame = (bat_frame){
        .view = {c->stage->view.x, c->stage->view.y, c->stage->view.zoom, c->stage->view.angle},
        .jumps = c->views->jumps,
        .tilt = c->stage->view.tilt,
        .surfaces = scene->surfaces,
        .origin = {scene->origin[0], scene->origin[1]},
        .still_version = scene->still_version,
        .still_count = (uint32_t)scene->item_count,
        .still = scene->items,
        .live_count = overlay->count,
        .live = overlay->items,
        .label_count = overlay->label_count,
        .labels = overlay->labels,
        .cursor = (uint32_t)cursor(c),
        .requests = c->notices->requests,
        .unsaved = c->session->history.state != c->session->saved_state,
        .can_undo = bat_history_can_undo(&c->session->history),
        .can_redo = bat_history_can_redo(&c->session->history),
        .tool = (uint32_t)c->choice->tool,
        .tolerance = c->settings->values[BAT_PROPERTY_TOLERANCE] * bat_stage_pixel(c->stage),
        .hint = hint_with_numbers(editor, &made),
        .notice = c->notices->notice == BAT_STRING_COUNT ? "" : c->notices->notice_text,
        .notice_version = c->notices->notice_version,
        .offer = c->notices->offer == BAT_COMMAND_COUNT ? "" : bat_command_at(c->notices->offer)->name,
        .name = c->session->name,
        .revision = (uint32_t)c->session->revision,
        .selection = c->choice->selection.version,
        .selected = (uint32_t)c->choice->selection.count,
        .layer = (uint32_t)c->choice->layer,
        .readings = readings(c),
        .levels = levels(c),
        .moves = bat_moves_version(c),
        .lost = (uint32_t)bat_losses_told(&c->session->losses, c->session->document),
        .first = bat_first_shown(c)};
    memcpy(frame->dirty, scene->dirty, sizeof frame->dirty);
    bat_box_clear(scene->dirty);
    frame->busy = bat_toolbox_busy(c);
    drawing(&made, frame);
    if (c->notices->requests & BAT_ASK_SAVE) {
        c->session->asked = true;
        c->session->asked_state = c->session->history.state;
    }
    c->notices->requests = 0;
    return frame;
}
