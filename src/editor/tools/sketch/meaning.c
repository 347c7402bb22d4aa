#include "editor/tools/sketch/meaning.h"
#include "curve/curve.h"
#include "document/kind.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/input/input.h"
#include "editor/scene/scene.h"
#include "editor/scene/seen.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "base/real.h"
#include <batten/levels.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double STRIDE = 16; /* px between two looks for curves */
static const double BESIDE = 64,
                    BESIDE_SHARE =
                        0.2; /* px from the stroke, or share of its size, within which a curve can matter */
static const double MORE = 1.5; /* times as far as before is looked when a stroke has grown */

/* Whether entry i, walked through in order, is chosen, by itself or with a group it is in. end: 0 at first. */
static bool chosen(const bat_context *c, int i, int *end) {
    bat_id id = bat_object_id(c->scene->entries[i].object);
    if (i >= *end && bat_selection_has(&c->choice->selection, id))
        *end = bat_document_end(c->session->document, i);
    return i < *end;
}

/* Whether something that could be meant is chosen. */
static bool restricts(const bat_context *c) {
    const bat_scene *scene = c->scene;
    for (int i = 0, end = 0; i < scene->count && c->choice->selection.count; i++) {
        const bat_scene_entry *entry = &scene->entries[i];
        bool within = chosen(c, i, &end);
        if (within && !entry->hidden && !entry->locked && bat_object_is_made_of_curves(entry->object))
            return true;
    }
    return false;
}

bat_status bat_meaning_begin(bat_context *c, bat_meaning *m, bat_device device) {
    bat_seen_sync(c);
    bat_meaning_end(m);
    m->restricts = restricts(c);
    m->within = BESIDE;
    m->box[0] = m->box[1] = INFINITY, m->box[2] = m->box[3] = -INFINITY;
    return bat_intent_create(device == BAT_DEVICE_TOUCH, m->restricts, &m->intent);
}

void bat_meaning_end(bat_meaning *m) {
    bat_intent_free(m->intent);
    free(m->curves);
    free(m->found);
    *m = (bat_meaning){0};
}

/* Where a curve is among those found, or would be. */
static int *place_of(const bat_meaning *m, bat_id object, int curve) {
    size_t mask = 2 * (size_t)m->curve_room - 1;
    uint64_t mixed = (object * 31 + (uint64_t)curve) * 0x9e3779b97f4a7c15u;
    for (size_t at = (size_t)(mixed >> 40);; at++) {
        int *place = &m->found[at & mask];
        if (*place < 0 || (m->curves[*place].object == object && m->curves[*place].curve == curve))
            return place;
    }
}

static bool has(const bat_meaning *m, bat_id object, int curve) {
    return m->curve_count > 0 && *place_of(m, object, curve) >= 0;
}

/* Room for one more; a power of two, so that the hash needs no division. */
static bool room_for(bat_meaning *m) {
    if (m->curve_count < m->curve_room) return true;
    int room = m->curve_room ? 2 * m->curve_room : 16;
    bat_meaning_curve *curves = realloc(m->curves, (size_t)room * sizeof *curves);
    if (curves) m->curves = curves;
    int *found = curves ? malloc(2 * (size_t)room * sizeof *found) : NULL;
    if (!found) return false;
    free(m->found);
    m->found = found;
    m->curve_room = room;
    for (int i = 0; i < 2 * room; i++) found[i] = -1;
    for (int i = 0; i < m->curve_count; i++) *place_of(m, m->curves[i].object, m->curves[i].curve) = i;
    return true;
}

static bool boxes_meet(const double a[4], const double b[4]) {
    return a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3];
}

/* Box of the control points, which holds the curve. */
static void hull(const bat_curve *curve, double box[4]) {
    const double *p = bat_curve_points(curve);
    const int d = bat_curve_dimension(curve);
    box[0] = box[1] = INFINITY, box[2] = box[3] = -INFINITY;
    for (int i = 0; i < bat_point_count(curve); i++, p += d)
        for (int k = 0; k < 2; k++) {
            box[k] = fmin(box[k], p[k]);
            box[2 + k] = fmax(box[2 + k], p[k]);
        }
}

static bat_status take(bat_context *c, bat_meaning *m, int entry, int index, const double map[6],
                       bool meant) {
    const bat_object *object = c->scene->entries[entry].object;
    bat_id id = bat_object_id(object);
    if (!room_for(m)) return BAT_MEMORY;
    const bat_curve *seen = bat_scene_seen(c->scene, entry, index);
    bat_status status = seen ? bat_intent_line(m->intent, seen, map, meant) : BAT_MEMORY;
    if (status == BAT_OK) {
        *place_of(m, id, index) = m->curve_count;
        m->curves[m->curve_count++] = (bat_meaning_curve){id, entry, index};
    }
    return status == BAT_NUMBER ? BAT_OK : status; /* too far out to be near anything */
}

/* Whether the curve passes at u where the ground is, within two pixels; its place, which is zeroed before. */
static bool meets(const bat_curve *curve, double u, const bat_stage *stage, double *at) {
    bat_hit hit;
    double seen[2], pixel[2], apart = 0;
    bat_curve_eval(curve, u, 0, at);
    bat_stage_look(stage, bat_curve_dimension(curve), at, seen);
    bat_stage_project(stage, seen, pixel);
    if (bat_stage_place(stage, pixel, NULL, &hit) != BAT_OK) return false;
    for (int k = 0; k < 3; k++) apart = bat_hypot(apart, at[k] - hit.at[k]);
    return apart <= 2 * hit.pixel;
}

/* Whether a curve in space passes, near a place of the stroke, where the ground is. */
static bool on_ground(bat_context *c, const bat_stage *stage, int entry, int index, const double point[2]) {
    const bat_object *object = c->scene->entries[entry].object;
    const bat_finder *finder = bat_scene_finder(c->scene, entry, index);
    double at[BAT_DIMENSION_MAX] = {0};
    bat_near near;
    if (bat_ground_rules(&stage->ground, bat_object_id(object), index)) return true;
    if (!finder) return false;
    bat_finder_nearest(finder, point, &near);
    return meets(bat_object_curve(object, index), near.u, stage, at);
}

/* Curves near one place of the stroke, in the order in which they lie. */
static bat_status look_at(bat_context *c, bat_meaning *m, const bat_stage *stage, const double point[2],
                          double within) {
    const bat_scene *scene = c->scene;
    const double box[4] = {point[0] - within, point[1] - within, point[0] + within, point[1] + within};
    const int dimension = bat_stage_dimension(stage);
    double map[6];
    bat_stage_map(stage, map);
    bat_status status = BAT_OK;
    for (int i = 0, end = 0; i < scene->count && status == BAT_OK; i++) {
        const bat_scene_entry *entry = &scene->entries[i];
        bool meant = !m->restricts || chosen(c, i, &end);
        if (entry->hidden || entry->locked || !boxes_meet(entry->box, box)) continue;
        if (!bat_object_is_made_of_curves(entry->object)) continue;
        int count = bat_object_curve_count(entry->object);
        for (int j = 0; j < count && status == BAT_OK; j++) {
            const bat_curve *curve = bat_object_curve(entry->object, j);
            double own[4];
            if (bat_curve_dimension(curve) != dimension || has(m, bat_object_id(entry->object), j)) continue;
            if (dimension == 3 && !on_ground(c, stage, i, j, point)) continue;
            const bat_curve *seen = count > 1 ? bat_scene_seen(c->scene, i, j) : NULL;
            if (seen) hull(seen, own);
            if (!seen || boxes_meet(own, box)) status = take(c, m, i, j, map, meant);
        }
    }
    return status;
}

/* Only new curves, or none, when that was asked for. */
static void keep_allowed(const bat_context *c, bat_meaning *m) {
    enum { AS_DRAWN, REDRAW_ONLY, NEW_ONLY };
    int way = c->input->drawing_new ? NEW_ONLY : (int)c->settings->values[BAT_PROPERTY_STROKE_MEANING];
    int kept = 0;
    for (int i = 0; i < m->count && way != AS_DRAWN; i++)
        if ((m->readings[i].kind == BAT_INTENT_NEW) == (way == NEW_ONLY))
            m->readings[kept++] = m->readings[i];
    if (way != AS_DRAWN) m->count = kept;
}

/* A stroke that has grown is looked at anew, for lines farther off. */
static void widen(bat_meaning *m, const bat_samples *samples) {
    for (size_t i = m->fed; i < samples->count; i++)
        for (int k = 0; k < 2; k++) {
            const double x = samples->pixels[2 * i + (size_t)k];
            m->box[k] = fmin(m->box[k], x), m->box[2 + k] = fmax(m->box[2 + k], x);
        }
    const double needed = BESIDE_SHARE * bat_hypot(m->box[2] - m->box[0], m->box[3] - m->box[1]);
    if (!(needed > m->within)) return;
    while (needed > m->within) m->within *= MORE;
    m->asked = 0;
}

bat_status bat_meaning_look(bat_context *c, bat_meaning *m, const bat_stage *stage,
                            const bat_samples *samples, bool whole) {
    if (!m->intent || !samples->count) return BAT_STATE;
    widen(m, samples);
    const double within = (m->within + STRIDE) * bat_stage_pixel(stage);
    bat_seen_sync(c);
    bat_status status = bat_intent_add(m->intent, samples->count - m->fed, samples->pixels + 2 * m->fed);
    if (status == BAT_OK) m->fed = samples->count;
    for (; m->asked < samples->count && status == BAT_OK; m->asked++) {
        const double *pixel = samples->pixels + 2 * m->asked;
        bool last = whole && m->asked + 1 == samples->count;
        if (m->asked && !last && bat_hypot(pixel[0] - m->last[0], pixel[1] - m->last[1]) < STRIDE) continue;
        memcpy(m->last, pixel, sizeof m->last);
        status = look_at(c, m, stage, samples->points + 2 * m->asked, within);
    }
    m->count = 0;
    if (status == BAT_OK) status = bat_intent_rank(m->intent, whole, m->readings, &m->count);
    if (status == BAT_OK) keep_allowed(c, m);
    return status;
}

/* ---- readings as edits ---- */

static bat_end_rule rule(const bat_intent_part *part, int side) {
    return part->free[side] ? BAT_END_RULE_FREE : part->held[side] ? BAT_END_RULE_HELD : BAT_END_RULE_AUTO;
}

static bat_sketch_meaning meaning_of(const bat_intent_part *part) {
    return (bat_sketch_meaning){.sense = part->sense, .end = {rule(part, 0), rule(part, 1)}};
}

/* The place of the sample up to which the stroke has this length. */
static const double *place_along(const bat_samples *samples, double along) {
    double length = 0;
    size_t i = 1;
    for (; i + 1 < samples->count && length < along; i++) {
        const double *p = samples->pixels + 2 * i;
        length += bat_hypot(p[0] - p[-2], p[1] - p[-1]);
    }
    return samples->places + (size_t)samples->dimension * (i < samples->count ? i : 0);
}

static const bat_edit_kind KINDS[] = {
    [BAT_INTENT_NEW] = BAT_EDIT_NEW,         [BAT_INTENT_REDRAW] = BAT_EDIT_REDRAW,
    [BAT_INTENT_SEVERAL] = BAT_EDIT_SEVERAL, [BAT_INTENT_EXTEND] = BAT_EDIT_EXTEND,
    [BAT_INTENT_JOIN] = BAT_EDIT_JOIN,       [BAT_INTENT_CLOSE] = BAT_EDIT_CLOSE};

static const bat_meaning_curve *curve_of(const bat_meaning *m, const bat_intent_reading *reading, int part) {
    return &m->curves[reading->part[part].line];
}

static void put_tip(bat_context *c, const bat_meaning *m, const bat_intent_reading *reading, int side,
                    bat_edit *edit) {
    if (reading->onto[side] < 0 || !edit->samples.count) return;
    const bat_meaning_curve *curve = &m->curves[reading->onto[side]];
    const bat_finder *finder = bat_scene_finder(c->scene, curve->entry, curve->curve);
    bat_near near;
    if (!finder) return;
    double from[2], at[BAT_DIMENSION_MAX] = {0};
    bat_stage_seen(&edit->stage, reading->tip[side], from);
    bat_finder_nearest(finder, from, &near);
    const bat_curve *onto = bat_edit_curve(c->session->document, edit, curve->object, curve->curve);
    if (!edit->samples.apart)
        memcpy(at, near.point, 2 * sizeof *near.point);
    else if (!onto || !meets(onto, near.u, &edit->stage, at))
        return; /* seen there, but it lies before the ground or behind it */
    edit->meaning.put[side] = true;
    memcpy(edit->meaning.tip[side], at, sizeof at);
}

bool bat_meaning_level(const bat_context *c, bat_id object, int curve, int *level) {
    const bat_slot *levels = bat_toolbox_that(c, BAT_EDITS_LEVELS);
    bat_focus l = {0};
    levels->is->focus(c, levels->state, &l);
    int at = bat_document_find(c->session->document, object);
    const bat_shape *shape = at < 0 ? NULL
                                    : bat_object_shape(bat_document_at(c->session->document, at), curve);
    if (!shape) return false;
    bool chosen = l.object == object && l.curve == curve;
    int way = (int)c->settings->values[BAT_PROPERTY_LEVEL_SKETCH];
    *level = way == 1                                       ? BAT_LEVEL_FREE
             : way == 2                                     ? BAT_LEVEL_BARE
             : chosen && l.level <= bat_shape_levels(shape) ? l.level
                                                            : BAT_LEVEL_AUTO;
    return true;
}

void bat_meaning_apply(bat_context *c, const bat_meaning *m, const bat_intent_reading *reading,
                       bat_edit *edit) {
    edit->kind = KINDS[reading->kind];
    edit->meaning = (bat_sketch_meaning){0};
    edit->object = edit->other = 0;
    edit->curve = edit->other_curve = edit->part_count = 0;
    if (reading->kind == BAT_INTENT_NEW) {
        edit->meaning.closing = reading->closed ? BAT_CLOSING_YES : BAT_CLOSING_NO;
        for (int side = 0; side < 2; side++) put_tip(c, m, reading, side, edit);
        return;
    }
    edit->object = curve_of(m, reading, 0)->object;
    edit->curve = curve_of(m, reading, 0)->curve;
    edit->meaning = meaning_of(&reading->part[0]);
    if (reading->kind == BAT_INTENT_JOIN) {
        edit->other = curve_of(m, reading, 1)->object;
        edit->other_curve = curve_of(m, reading, 1)->curve;
    }
    /* A curve with levels follows at one of them. */
    bool one = reading->kind == BAT_INTENT_REDRAW || reading->kind == BAT_INTENT_EXTEND;
    if (one && bat_meaning_level(c, edit->object, edit->curve, &edit->level)) edit->kind = BAT_EDIT_LEVEL;
    if (reading->kind != BAT_INTENT_SEVERAL) return;
    edit->part_count = reading->count;
    for (int i = 0; i < reading->count; i++) {
        bat_edit_part *part = &edit->part[i];
        const bat_intent_part *from = &reading->part[i];
        *part = (bat_edit_part){.object = curve_of(m, reading, i)->object,
                                .curve = curve_of(m, reading, i)->curve,
                                .meaning = meaning_of(from)};
        memcpy(part->end, place_along(&edit->samples, from->along[1]),
               (size_t)edit->samples.dimension * sizeof *part->end);
    }
}

bool bat_meaning_is(const bat_meaning *m, const bat_intent_reading *reading, const bat_edit *edit) {
    bool levelled = edit->kind == BAT_EDIT_LEVEL &&
                    (reading->kind == BAT_INTENT_REDRAW || reading->kind == BAT_INTENT_EXTEND);
    if (KINDS[reading->kind] != edit->kind && !levelled) return false;
    if (reading->kind == BAT_INTENT_NEW) return true;
    const bat_meaning_curve *curve = curve_of(m, reading, 0);
    if (curve->object != edit->object || curve->curve != edit->curve) return false;
    if (reading->kind == BAT_INTENT_JOIN)
        return curve_of(m, reading, 1)->object == edit->other &&
               curve_of(m, reading, 1)->curve == edit->other_curve;
    if (reading->kind != BAT_INTENT_SEVERAL) return true;
    bool same = reading->count == edit->part_count;
    for (int i = 0; i < reading->count && same; i++)
        same = curve_of(m, reading, i)->object == edit->part[i].object &&
               curve_of(m, reading, i)->curve == edit->part[i].curve;
    return same;
}
