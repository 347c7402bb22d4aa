#include "editor/panels/in_words.h"
#include "hands/tangents/spline.h"
#include "curve/curve.h"
#include "document/document.h"
#include "document/kind.h"
#include "document/lettering.h"
#include "document/nesting.h"
#include "document/source.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/commands/dispatch.h"
#include "editor/edit/stroke.h"
#include "editor/panels/panels.h"
#include "editor/session/context.h"
#include "editor/session/history.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/tables.h"
#include "editor/show/moves.h"
#include "editor/show/body.h"
#include "editor/tools/gazes/find.h"
#include "editor/tools/gazes/joint.h"
#include "editor/tools/gazes/words.h"
#include "editor/tools/keyed/range.h"
#include "editor/tools/keyed/waypoints.h"
#include "editor/tools/points/state.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "hands/levels/shape.h"
#include "text/text.h"
#include "editor/show/handles.h"
#include "editor/tools/tangents/state.h"
#include "editor/edit/curves_of.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROWS_MAX = 500, POINTS_MAX = 1000, NAME_ROOM = 48 };

/* Writes the text with each % replaced by the next value. */
static void fill(const bat_context *c, bat_text *text, bat_string words, const char *const *values) {
    const char *at = bat_word(c, words);
    for (const char *hole; (hole = strchr(at, '%')); at = hole + 1, values++) {
        bat_text_add(text, at, (size_t)(hole - at));
        bat_text_string(text, *values);
    }
    bat_text_string(text, at);
}

static void fill_number(const bat_context *c, bat_text *text, bat_string words, int number) {
    char value[16];
    snprintf(value, sizeof value, "%d", number);
    fill(c, text, words, (const char *const[]){value});
}

/* ---- points: of a spline, else the control points of all curves in sequence ---- */

static int points_of(const bat_object *object) {
    const bat_camera *camera = bat_object_camera(object); /* its keys */
    if (camera) return (int)bat_gazing_keys(camera);
    if (bat_joints_of(object)) return bat_joints_of(object);
    const bat_spline *spline = bat_object_spline(object);
    int count = spline ? bat_spline_count(spline) : 0;
    for (int i = 0; !spline && i < bat_object_curve_count(object); i++)
        count += bat_point_count(bat_object_curve(object, i));
    return count;
}

/* The curve that the point belongs to; *index becomes the point's index in it. NULL: no such point. */
static const bat_curve *curve_of(const bat_object *object, int *index, int *curve) {
    for (int i = 0; i < bat_object_curve_count(object); i++) {
        const bat_curve *found = bat_object_curve(object, i);
        *curve = i;
        if (*index < bat_point_count(found)) return bat_curve_dimension(found) == 2 ? found : NULL;
        *index -= bat_point_count(found);
    }
    return NULL;
}

static bool place_of(const bat_object *object, int index, double out[2]) {
    const bat_spline *spline = bat_object_spline(object);
    if (index < 0 || index >= points_of(object) || bat_object_camera(object)) return false;
    if (spline) {
        memcpy(out, spline->points + (size_t)index * (size_t)spline->dimension, 2 * sizeof *out);
        return true;
    }
    int curve;
    const bat_curve *found = curve_of(object, &index, &curve);
    if (!found || bat_curve_dimension(found) != 2) return false;
    bat_handle_place(found, &(bat_handle){.kind = BAT_HANDLE_POINT, .index = index}, out);
    return true;
}

/* words: a text with placeholders for x and y, or for the point's number, the count, x and y. */
static void place_words(const bat_context *c, bat_text *text, bat_string words, int index, int count,
                        const double at[2]) {
    char values[4][32];
    snprintf(values[0], sizeof values[0], "%d", index + 1);
    snprintf(values[1], sizeof values[1], "%d", count);
    for (int k = 0; k < 2; k++) snprintf(values[2 + k], sizeof values[2], "%.4g", at[k] + 0.0);
    const char *list[] = {values[0], values[1], values[2], values[3]};
    fill(c, text, words, list + (count ? 0 : 2));
}

static void point_words(const bat_context *c, bat_text *text, const bat_object *object, int index) {
    double at[2];
    if (bat_object_camera(object)) {
        char words[BAT_KEY_ROOM];
        bat_key_in_words(c, bat_object_camera(object), (size_t)index, words);
        bat_text_string(text, words);
        return;
    }
    if (bat_joints_of(object)) {
        bat_joint_in_words(object, index, text);
        return;
    }
    if (place_of(object, index, at))
        place_words(c, text, BAT_STRING_OUTLINE_POINT, index, points_of(object), at);
}

/* ---- objects ---- */

static void add(const bat_context *c, bat_text *text, bat_string words) {
    bat_text_string(text, ", ");
    bat_text_string(text, bat_word(c, words));
}

static int curves_of(const bat_object *object) {
    return bat_object_camera(object) ? 0 : bat_object_curve_count(object);
}

/* Its name; what a text without one begins with; "". */
static const char *name_of(const bat_object *object, char words[NAME_ROOM]) {
    const bat_lettering *lettering = bat_object_lettering(object);
    const char *name = bat_object_name(object);
    if (*name || !lettering) return name;
    size_t size = strcspn(lettering->content, ",\n"); /* a comma ends a name in words */
    if (size >= NAME_ROOM) size = NAME_ROOM - 1;
    while (size > 0 && ((unsigned char)lettering->content[size] & 0xc0) == 0x80) size--;
    memcpy(words, lettering->content, size);
    words[size] = '\0';
    return words;
}

void bat_outline_name(const bat_context *c, const bat_object *object, bat_text *text) {
    char words[NAME_ROOM];
    const char *name = name_of(object, words);
    const int curves = curves_of(object);
    bat_text_string(text, name);
    if (*name && curves < 2) bat_text_string(text, ", ");
    if (!*name || curves < 2) bat_text_string(text, bat_word(c, bat_kind_word(bat_object_type(object))));
    if (!*name) { /* a number, because it needs some name */
        bat_text_string(text, " ");
        bat_text_integer(text, bat_object_id(object));
    }
}

void bat_outline_words(const bat_context *c, const bat_object *object, bat_text *text) {
    const bool camera = bat_object_camera(object) != NULL;
    int curves = curves_of(object), points = points_of(object);
    bat_outline_name(c, object, text);
    if (curves == 1)
        add(c, text,
            bat_curve_is_closed(bat_object_curve(object, 0)) ? BAT_STRING_OUTLINE_CLOSED
                                                             : BAT_STRING_OUTLINE_OPEN);
    if (curves > 1) {
        bat_text_string(text, ", ");
        fill_number(c, text, BAT_STRING_OUTLINE_CURVES, curves);
    }
    if (points) {
        bat_text_string(text, ", ");
        fill_number(c, text, camera ? BAT_STRING_OUTLINE_KEYS : BAT_STRING_OUTLINE_POINTS, points);
    }
    if (bat_object_is_hidden(object)) add(c, text, BAT_STRING_OUTLINE_HIDDEN);
    if (bat_object_is_locked(object)) add(c, text, BAT_STRING_OUTLINE_LOCKED);
    if (bat_source_lost(bat_document_origin(c->session->document), bat_object_id(object)))
        add(c, text, BAT_STRING_OUTLINE_UNSHOWN);
}

/* Writes the words as a JSON string, and frees them. */
static void quote(bat_text *json, bat_text *words) {
    bat_text_add(words, "", 1);
    if (words->failed) json->failed = true;
    bat_text_json_string(json, words->failed ? "" : words->data);
    bat_text_free(words);
}

static void member(bat_text *json, const char *name, int64_t value) {
    bat_text_string(json, name);
    if (value < 0) bat_text_string(json, "-");
    bat_text_integer(json, (uint64_t)(value < 0 ? -value : value));
}

/* What a list of objects shows besides: bit 0: it holds others, bit 1: hidden, bit 2: locked. */
static void state_of(const bat_object *object, bat_text *json) {
    const int state = (bat_object_is_group(object) ? 1 : 0) | (bat_object_is_hidden(object) ? 2 : 0) |
                      (bat_object_is_locked(object) ? 4 : 0);
    member(json, ",\"state\":", state);
    bat_text_string(json, ",\"name\":");
    bat_text_json_string(json, bat_object_name(object));
}

const char *bat_panel_outline(bat_context *c, int first, int count) {
    const bat_document *document = c->session->document;
    const bat_selection *selection = &c->choice->selection;
    bat_text json = {0};
    bat_nesting nesting = {0};
    int total = bat_document_count(document), made = 0;
    if (first < 0) first = 0;
    if (count > ROWS_MAX) count = ROWS_MAX;
    member(&json, "{\"total\":", total);
    member(&json, ",\"at\":", selection->count ? bat_document_find(document, selection->ids[0]) : -1);
    bat_text_string(&json, ",\"rows\":[");
    for (int i = 0; i < total && made < count; i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_next(&nesting, object, NULL);
        if (i < first) continue;
        bat_text words = {0};
        bat_id id = bat_object_id(object);
        member(&json, made++ ? ",{\"id\":" : "{\"id\":", (int64_t)id);
        state_of(object, &json);
        member(&json, ",\"level\":", nesting.depth + !bat_object_is_group(object));
        member(&json, ",\"points\":", points_of(object));
        bat_text_string(&json, bat_selection_has(selection, id) ? ",\"selected\":true,\"words\":"
                                                                : ",\"selected\":false,\"words\":");
        bat_outline_words(c, object, &words);
        quote(&json, &words);
        bat_text_string(&json, "}");
    }
    bat_text_string(&json, "]}");
    return bat_text_keep(&json, &c->panels->outline);
}

/* The chosen point of the object; -1: none. */
static int chosen_of(const bat_context *c, const bat_object *object) {
    const bat_pointing *p = bat_pointing_of(c);
    bat_id id = bat_object_id(object);
    if (bat_joints_of(object)) return id == c->moves->camera ? bat_body_chosen(c) : -1;
    if (bat_object_camera(object)) return id == c->moves->camera ? (int)bat_gazing_chosen(c) : -1;
    if (bat_tool_at(c->choice->tool)->traits & BAT_EDITS_SPLINES && bat_object_spline(object))
        return bat_splining_of(c)->object == id ? bat_splining_of(c)->point : -1;
    if (!(bat_tool_at(c->choice->tool)->traits & BAT_EDITS_POINTS) || p->object != id ||
        p->chosen.kind != BAT_HANDLE_POINT)
        return -1;
    int index = p->chosen.index;
    for (int i = 0; i < p->curve; i++) index += bat_point_count(bat_object_curve(object, i));
    return bat_object_spline(object) ? -1 : index;
}

const char *bat_panel_points(bat_context *c, bat_id id) {
    const bat_object *object = bat_document_at(c->session->document,
                                               bat_document_find(c->session->document, id));
    bat_text json = {0};
    int count = object ? points_of(object) : 0;
    member(&json, "{\"at\":", object ? chosen_of(c, object) : -1);
    bat_text_string(&json, ",\"points\":[");
    for (int i = 0; i < count && i < POINTS_MAX; i++) {
        bat_text words = {0};
        if (i) bat_text_string(&json, ",");
        point_words(c, &words, object, i);
        quote(&json, &words);
    }
    bat_text_string(&json, "]}");
    return bat_text_keep(&json, &c->panels->outline);
}

bat_status bat_panel_choose(bat_context *c, bat_id id, int point) {
    const bat_object *object = bat_document_at(c->session->document,
                                               bat_document_find(c->session->document, id));
    double at[2];
    if (object && bat_object_camera(object)) return bat_key_choose(c, id, point);
    if (object && bat_joints_of(object)) return bat_joint_choose_of(c, id, point);
    if (!object || !place_of(object, point, at)) return BAT_ARGUMENT;
    bool spline = bat_object_spline(object) != NULL;
    bat_tool_id tool = bat_tool_that(spline ? BAT_EDITS_SPLINES : BAT_EDITS_POINTS);
    bat_range_end(c);
    bat_status status = c->choice->tool == tool ? BAT_OK
                                                : bat_command_run(c, bat_tool_at(tool)->command, true);
    if (status == BAT_OK) status = bat_choice_select(c, id, false);
    if (status != BAT_OK || !bat_selection_has(&c->choice->selection, id))
        return BAT_STATE; /* locked or hidden */
    bat_stage_bring(c->stage, at, 40);
    if (spline) {
        bat_splining_of(c)->object = id;
        bat_splining_of(c)->point = point;
        bat_splining_of(c)->placing = bat_splining_of(c)->on_direction = false;
        return BAT_OK;
    }
    bat_pointing *p = bat_pointing_of(c);
    int index = point, which = 0;
    const bat_curve *curve = curve_of(object, &index, &which);
    p->object = p->adopted = id;
    p->curve = which;
    p->measured = false;
    p->chosen = (bat_handle){BAT_HANDLE_POINT, id, which, index, bat_handle_greville(curve, index)};
    return BAT_OK;
}

/* ---- what has just happened ---- */

enum { MODE_NONE, MODE_POINT, MODE_DIRECTION, MODE_KNOT, MODE_RANGE, MODE_WAYPOINT };

/* What the arrow keys would move, and its position. */
static void look(const bat_context *c, bat_told *now) {
    const bat_document *document = c->session->document;
    const bat_waypoints *w = bat_waypoints_of(c);
    const bat_pointing *p = bat_pointing_of(c);
    if (w->on) {
        *now = (bat_told){.mode = MODE_WAYPOINT, .point = w->chosen};
        memcpy(now->at, w->points + 2 * w->chosen, sizeof now->at);
    } else if (bat_range_curve(c)) {
        *now = (bat_told){
            .mode = MODE_RANGE, .object = bat_range_of(c)->object, .point = bat_range_of(c)->end};
        bat_curve_eval(bat_range_curve(c), bat_range_of(c)->u[bat_range_of(c)->end], 0, now->at);
    } else if (bat_tool_at(c->choice->tool)->traits & BAT_EDITS_POINTS && p->chosen.kind) {
        const bat_curve *curve = bat_edit_target(document, p->object, p->curve);
        bool point = p->chosen.kind == BAT_HANDLE_POINT;
        if (!curve || (point && p->chosen.index >= bat_point_count(curve))) return;
        *now = (bat_told){
            .mode = point ? MODE_POINT : MODE_KNOT, .object = p->object, .point = p->chosen.index};
        bat_handle_place(curve, &p->chosen, now->at);
    } else if (bat_tool_at(c->choice->tool)->traits & BAT_EDITS_SPLINES && bat_splining_of(c)->object) {
        const bat_object *object = bat_document_at(document,
                                                   bat_document_find(document, bat_splining_of(c)->object));
        now->mode = bat_splining_of(c)->on_direction ? MODE_DIRECTION : MODE_POINT;
        now->object = bat_splining_of(c)->object;
        now->point = bat_splining_of(c)->point;
        if (!object || !place_of(object, now->point, now->at)) *now = (bat_told){0};
    }
}

static void next_sentence(bat_text *text) {
    if (text->size && text->data[text->size - 1] != ' ') bat_text_string(text, ". ");
}

static void say_place(const bat_context *c, bat_text *text, const bat_told *now) {
    const bat_object *object = bat_document_at(c->session->document,
                                               bat_document_find(c->session->document, now->object));
    if (now->mode == MODE_POINT && object)
        place_words(c, text, BAT_STRING_OUTLINE_POINT, now->point,
                    bat_object_spline(object)
                        ? points_of(object)
                        : bat_point_count(bat_object_curve(object, bat_pointing_of(c)->curve)),
                    now->at);
    if (now->mode == MODE_WAYPOINT)
        place_words(c, text, BAT_STRING_OUTLINE_POINT, now->point, bat_waypoints_of(c)->count, now->at);
    if (now->mode == MODE_DIRECTION) place_words(c, text, BAT_STRING_SAID_DIRECTION, 0, 0, now->at);
    if (now->mode == MODE_KNOT) place_words(c, text, BAT_STRING_SAID_KNOT, 0, 0, now->at);
    if (now->mode == MODE_RANGE && object && now->object != c->panels->told.object) {
        bat_outline_words(c, object, text); /* another curve than before */
        next_sentence(text);
    }
    if (now->mode == MODE_RANGE)
        place_words(c, text, now->point ? BAT_STRING_SAID_RANGE_END : BAT_STRING_SAID_RANGE_START, 0, 0,
                    now->at);
}

static void say_selection(const bat_context *c, bat_text *text, int before) {
    const bat_selection *selection = &c->choice->selection;
    bat_text words = {0};
    if (selection->count == 1) {
        int at = bat_document_find(c->session->document, selection->ids[0]);
        bat_outline_words(c, bat_document_at(c->session->document, at), &words);
        bat_text_add(&words, "", 1);
        if (!words.failed) fill(c, text, BAT_STRING_SAID_SELECTED, (const char *const[]){words.data});
        bat_text_free(&words);
    } else if (selection->count) {
        fill_number(c, text, BAT_STRING_SAID_SELECTED_MANY, selection->count);
    } else if (before) {
        bat_text_string(text, bat_word(c, BAT_STRING_SAID_DESELECTED));
    }
}

const char *bat_panel_said(bat_context *c) {
    bat_told *told = &c->panels->told, now = {0};
    const bat_history *history = &c->session->history;
    bat_text text = {0};
    if (bat_toolbox_busy(c)) return ""; /* still under way */
    look(c, &now);
    now.begun = true;
    now.tool = (int)c->choice->tool;
    now.state = history->state;
    now.selection = c->choice->selection.version;
    now.selected = c->choice->selection.count;
    /* Undo and redo have notices of their own. */
    bool undone = c->notices->notice == BAT_STRING_NOTICE_UNDONE ||
                  c->notices->notice == BAT_STRING_NOTICE_REDONE;
    bool changed = now.state != told->state && !undone && history->done > 0;
    if (told->begun && now.tool != told->tool)
        bat_text_string(&text, bat_word(c, bat_tool_at(c->choice->tool)->label));
    next_sentence(&text);
    if (told->begun && changed)
        bat_text_string(&text, bat_word(c, (bat_string)history->steps[history->done - 1].label));
    next_sentence(&text);
    if (told->begun && now.selection != told->selection) say_selection(c, &text, told->selected);
    next_sentence(&text);
    if (told->begun && (now.mode != told->mode || now.object != told->object || now.point != told->point ||
                        memcmp(now.at, told->at, sizeof now.at) != 0))
        say_place(c, &text, &now);
    *told = now;
    size_t size = text.failed ? 0 : text.size;
    if (size >= sizeof told->text) { /* cut between characters */
        size = sizeof told->text - 1;
        while (size && ((unsigned char)text.data[size] & 0xc0) == 0x80) size--;
    }
    while (size && (text.data[size - 1] == ' ' || text.data[size - 1] == '.')) size--;
    if (size) memcpy(told->text, text.data, size);
    told->text[size] = 0;
    bat_text_free(&text);
    return told->text;
}
