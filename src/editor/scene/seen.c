#include "document/document.h"
#include "base/box.h"
#include "document/kind.h"
#include "editor/scene/seen.h"
#include "editor/choice/choice.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include <math.h>
#include <string.h>

/* Moves the ground to where its object is now, or to the page when the object is gone. */
static void follow_ground(bat_context *c) {
    bat_ground *ground = &c->stage->ground;
    if (!ground->object) return;
    int at = bat_document_find(c->session->document, ground->object);
    if (at < 0 || !bat_ground_of(bat_document_at(c->session->document, at), ground))
        *ground = bat_ground_page();
}

void bat_seen_sync(bat_context *c) {
    follow_ground(c);
    bat_scene_face(c->scene, c->stage);
    bat_scene_look(c->scene, c->settings->values[BAT_PROPERTY_OUTLINE] != 0, &c->choice->isolation);
    if (bat_scene_sync(c->scene, c->session->document, c->session->revision) != BAT_OK)
        bat_notice(c, BAT_STRING_NOTICE_MEMORY);
}

static bat_nesting_level level_of(const bat_context *c, int at) {
    if (c->scene->revision != c->session->revision) /* memory ran out, say */
        return bat_document_level(c->session->document, at);
    const bat_scene_entry *entry = &c->scene->entries[at];
    return (bat_nesting_level){.hidden = entry->hidden, .locked = entry->locked};
}

bool bat_seen_hidden(const bat_context *c, int at) { return at >= 0 && level_of(c, at).hidden; }

bool bat_seen_out_of_reach(const bat_context *c, int at) {
    return at >= 0 && (level_of(c, at).hidden || level_of(c, at).locked);
}

/* The box around the page and everything drawn, as it is seen in a tilted view. */
static void box_around(bat_context *c, const double page[4], double box[4]) {
    bat_seen_sync(c);
    box[0] = box[1] = INFINITY, box[2] = box[3] = -INFINITY;
    for (int i = -4; i < c->scene->count; i++) {
        const bat_scene_entry *entry = i < 0 ? NULL : &c->scene->entries[i];
        const double corner[2] = {page[0] + (i & 1 ? page[2] : 0), page[1] + (i & 2 ? page[3] : 0)};
        double at[4];
        if (entry ? entry->hidden : !(page[2] > 0 && page[3] > 0)) continue;
        if (!entry) bat_stage_look(c->stage, 2, corner, at);
        for (int k = 0; k < 4; k++) {
            const double value = entry ? entry->box[k] : at[k & 1];
            box[k] = k < 2 ? fmin(box[k], value) : fmax(box[k], value);
        }
    }
}

static void hold(double low[3], double high[3], const double *point, int dimension) {
    for (int d = 0; d < 3; d++) {
        low[d] = fmin(low[d], d < dimension ? point[d] : 0);
        high[d] = fmax(high[d], d < dimension ? point[d] : 0);
    }
}

/* In perspective: all control points of what is drawn, and the page's corners; first the box around them, then, where
 * extent is given, how far they reach aside. */
static void hold_all(const bat_context *c, const double page[4], double low[3], double high[3],
                     bat_view_extent *extent) {
    double corners[8], point[3] = {0};
    for (int i = -1; i < c->scene->count; i++) {
        const bat_scene_entry *entry = i < 0 ? NULL : &c->scene->entries[i];
        const bool flat = !entry || bat_object_picture(entry->object);
        const int curves = entry ? bat_object_curve_count(entry->object) : 0;
        if (entry ? entry->hidden : !(page[2] > 0 && page[3] > 0)) continue;
        for (int k = 0; k < 8 && !entry; k++)
            corners[k] = page[k & 1] + ((k & 1 ? k & 4 : k & 2) ? page[2 + (k & 1)] : 0);
        if (entry && flat) bat_object_corners(entry->object, corners);
        for (int j = 0; j < curves + flat; j++) {
            const bat_curve *curve = j < curves ? bat_object_curve(entry->object, j) : NULL;
            const int count = curve ? (int)bat_curve_count(curve) : 4,
                      size = curve ? bat_curve_dimension(curve) : 2;
            const double *points = curve ? bat_curve_points(curve) : corners;
            for (int k = 0; k < count; k++, points += size) {
                for (int d = 0; d < 3; d++) point[d] = d < size ? points[d] : 0;
                hold(low, high, point, 3);
                if (extent) bat_view_extent_add(&c->stage->view, extent, point);
            }
        }
    }
}

static double margin_of(const bat_context *c) {
    const bat_document *document = c->session->document;
    bool moves = false;
    for (int i = 0; i < bat_document_count(document) && !moves; i++)
        moves = bat_object_is(bat_document_at(document, i), BAT_MOVES);
    return moves ? BAT_FIT_STRIP : BAT_FIT_MARGIN;
}

/* The eye then turns about the middle of everything. */
static bool fit_deep(bat_context *c, const double page[4]) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    bat_view *view = &c->stage->view;
    bat_view_extent extent;
    bat_seen_sync(c);
    hold_all(c, page, low, high, NULL);
    if (!(low[0] <= high[0])) return false;
    for (int d = 0; d < 3; d++) view->pivot[d] = low[d] / 2 + high[d] / 2;
    bat_view_extent_start(view, margin_of(c), &extent);
    hold_all(c, page, low, high, &extent);
    return bat_view_extent_fit(view, &extent);
}

/* Everything selected with all in it, as it is seen. */
static bool box_selected(bat_context *c, double box[4]) {
    const bat_document *document = c->session->document;
    bat_seen_sync(c);
    bat_box_nothing(box);
    for (int i = 0; i < c->scene->count && c->choice->selection.count;) {
        int end = i + 1;
        if (bat_selection_has(&c->choice->selection, bat_object_id(bat_document_at(document, i)))) {
            end = bat_document_end(document, i);
            for (int k = i; k < end && k < c->scene->count; k++) {
                const bat_scene_entry *entry = &c->scene->entries[k];
                if (!entry->hidden) bat_box_hold(box, entry->box);
            }
        }
        i = end;
    }
    return box[0] <= box[2] && box[1] <= box[3];
}

bool bat_seen_fit_selection(bat_context *c) {
    double box[4];
    return box_selected(c, box) && bat_view_fit(&c->stage->view, box, margin_of(c));
}

bool bat_seen_fit_drawn(bat_context *c) {
    const double none[4] = {0};
    double box[4];
    if (bat_stage_deep(c->stage)) return fit_deep(c, none);
    box_around(c, none, box);
    return bat_view_fit(&c->stage->view, box, margin_of(c));
}

bool bat_seen_fit(bat_context *c) {
    double page[4], box[4];
    bat_document_page(c->session->document, page);
    if (bat_stage_deep(c->stage)) return fit_deep(c, page);
    if (bat_stage_tilted(c->stage)) {
        box_around(c, page, box);
    } else if (page[2] > 0 && page[3] > 0) {
        double corners[4] = {page[0], page[1], page[0] + page[2], page[1] + page[3]};
        memcpy(box, corners, sizeof box);
    } else {
        bat_document_bounds(c->session->document, box);
    }
    return bat_view_fit(&c->stage->view, box, margin_of(c));
}
