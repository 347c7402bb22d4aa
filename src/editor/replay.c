/*
 * Replay: runs a journal line by line through the same calls that made it. Besides the engine's own lines it accepts
 * raw events, so a scripted session is a journal too.
 */
#include "document/digest.h"
#include "editor/session/page.h"
#include "editor/session/record.h"
#include "editor/edit/stroke_record.h"
#include "editor/edit/surface_line.h"
#include "editor/editor.h"
#include "editor/invariants.h"
#include "editor/replay.h"
#include "format/native/native.h"
#include <batten/bezier.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bat_status say(bat_problem *problem, bat_status status, const char *message) {
    return bat_problem_set(problem, status, "", message);
}

/* The size of one JSON value, which starts at `from`: up to its closing brace, ignoring braces inside strings. */
static size_t value_size(const char *text, size_t size, size_t from) {
    int depth = 0;
    bool quoted = false;
    for (size_t i = from; i < size; i++) {
        char c = text[i];
        if (quoted) {
            if (c == '\\')
                i++;
            else if (c == '"')
                quoted = false;
        } else if (c == '"')
            quoted = true;
        else if (c == '{' || c == '[')
            depth++;
        else if ((c == '}' || c == ']') && --depth == 0)
            return i + 1 - from;
    }
    return size - from;
}

static bat_status open_snapshot(bat_editor *editor, const bat_json *json, bat_problem *problem) {
    const char *kind = bat_json_text(json, bat_json_member(json, 1, "journal"));
    if (!kind || strcmp(kind, "batten")) return say(problem, BAT_SYNTAX, "expected a journal's first line");
    double version;
    bat_status status = bat_edit_number(json, 1, "version", 1, 1e9, NULL, &version, problem);
    if (status != BAT_OK) return status;
    if (version != 1) return say(problem, BAT_UNSUPPORTED, "this version of the journal is not known");
    const char *name = bat_json_text(json, bat_json_member(json, 1, "name"));
    bat_document *document = NULL;
    uint32_t node = bat_json_member(json, 1, "document");
    if (node && bat_json_type_of(json, node) != BAT_JSON_NULL) {
        size_t from = json->nodes[node].position;
        status = bat_document_read(json->text + from, value_size(json->text, json->size, from), &document,
                                   problem);
    } else {
        status = bat_document_create(&document);
    }
    if (status != BAT_OK) return status;
    return bat_editor_open(editor, document, name);
}

static bat_status perform(bat_editor *editor, const bat_json *json, bat_problem *problem) {
    const char *name = bat_json_text(json, bat_json_member(json, 1, "do"));
    if (name && (!strcmp(name, "undo") || !strcmp(name, "redo"))) {
        bat_status status = bat_editor_command(editor, name);
        return status == BAT_OK ? status : say(problem, status, "nothing to undo or redo here");
    }
    if (name && !strcmp(name, "change")) return bat_change_perform(&editor->context, json, problem);
    if (name && !strcmp(name, "page")) return bat_page_perform(&editor->context, json, problem);
    if (name && !strcmp(name, BAT_LINE_EDIT)) return bat_line_edit_perform(&editor->context, json, problem);
    bat_edit edit = {0};
    bat_edit_result result = {0};
    bat_sketch_report report;
    bat_status status = bat_edit_read(json, editor->context.stage->casters, &edit, problem);
    if (status == BAT_OK) {
        status = bat_edit_compute(editor->context.session->document, &edit, NULL, &result, &report);
        if (status == BAT_TOLERANCE && edit.accepted) status = BAT_OK;
        if (status == BAT_OK) status = bat_edit_commit(&editor->context, &edit, &result);
        bat_edit_result_clear(&result);
    }
    bat_samples_free(&edit.samples);
    return status;
}

static int named(const char *name, const char *const *names, int count) {
    int i = 0;
    while (i < count && (!name || strcmp(name, names[i]))) i++;
    return i;
}

static double number(const bat_json *json, const char *name, double otherwise) {
    uint32_t node = bat_json_member(json, 1, name);
    return bat_json_type_of(json, node) == BAT_JSON_NUMBER ? json->nodes[node].value.number : otherwise;
}

static uint32_t bits(const bat_json *json, const char *name) {
    double value = number(json, name, 0);
    return value >= 0 && value <= 4294967295.0 ? (uint32_t)value : 0;
}

/* Up to four numbers of a list; NaN for missing ones. */
static void triple(const bat_json *json, const char *name, double out[4]) {
    uint32_t node = bat_json_first(json, bat_json_member(json, 1, name));
    for (int i = 0; i < 4; i++) {
        out[i] = node && json->nodes[node].type == BAT_JSON_NUMBER ? json->nodes[node].value.number : NAN;
        if (node) node = json->nodes[node].next;
    }
}

static bat_status pointer(bat_editor *editor, const bat_json *json, bat_problem *problem) {
    static const char *const phases[] = {"hover", "down", "move", "up", "cancel", "leave"};
    static const char *const devices[] = {"mouse", "pen", "touch"};
    int phase = named(bat_json_text(json, bat_json_member(json, 1, "pointer")), phases, 6);
    const char *device_name = bat_json_text(json, bat_json_member(json, 1, "device"));
    int device = device_name ? named(device_name, devices, 3) : BAT_DEVICE_MOUSE;
    if (phase == 6 || device == 3)
        return say(problem, BAT_UNSUPPORTED, "no such phase or device of a pointer");
    double tilt[4];
    triple(json, "tilt", tilt);
    bat_pointer event = {.phase = (bat_pointer_phase)phase,
                         .device = (bat_device)device,
                         .contact = bits(json, "id"),
                         .buttons = bits(json, "buttons"),
                         .modifiers = bits(json, "modifiers"),
                         .x = number(json, "x", NAN),
                         .y = number(json, "y", NAN),
                         .pressure = number(json, "pressure", 0.5),
                         .tilt_x = tilt[0],
                         .tilt_y = tilt[1],
                         .twist = number(json, "twist", 0),
                         .width = number(json, "width", 0),
                         .height = number(json, "height", 0),
                         .time = number(json, "time", editor->context.time),
                         .predicted = bat_json_type_of(json, bat_json_member(json, 1, "predicted")) ==
                                      BAT_JSON_TRUE};
    bat_editor_pointer(editor, 1, &event);
    return BAT_OK;
}

/* An empty list: no axis is chosen. */
static bat_status axis(bat_editor *editor, const bat_json *json, bat_problem *problem) {
    uint32_t node = bat_json_member(json, 1, "axis");
    double n[4] = {0};
    bat_mirror mirror = {.on = bat_json_count(json, node) > 0};
    triple(json, "axis", n);
    if (mirror.on) mirror = (bat_mirror){true, {n[0], n[1]}, {n[2], n[3]}};
    bat_status status = bat_session_set_axis(&editor->session, &mirror);
    return status == BAT_NUMBER ? say(problem, status, "axis: a place and a direction of length 1") : status;
}

static bat_status raw(bat_editor *editor, const bat_json *json, bat_problem *problem) {
    double list[4];
    const char *text;
    bat_status status;
    if (bat_json_member(json, 1, "pointer")) return pointer(editor, json, problem);
    if (bat_json_member(json, 1, "wheel")) {
        triple(json, "wheel", list);
        bat_editor_wheel(editor, list[0], list[1], list[2], list[3], bits(json, "modifiers"),
                         number(json, "time", editor->context.time));
        return BAT_OK;
    }
    if (bat_json_member(json, 1, "resize")) {
        triple(json, "resize", list);
        bat_editor_resize(editor, list[0], list[1], list[2]);
        return BAT_OK;
    }
    if ((text = bat_json_text(json, bat_json_member(json, 1, "key")))) {
        bool down = bat_json_type_of(json, bat_json_member(json, 1, "down")) != BAT_JSON_FALSE;
        bat_editor_key(editor, text, down, bits(json, "modifiers"),
                       number(json, "time", editor->context.time));
        return BAT_OK;
    }
    if ((text = bat_json_text(json, bat_json_member(json, 1, "set")))) {
        status = bat_editor_set(editor, text, number(json, "value", NAN));
        return status == BAT_OK ? status
                                : say(problem, status, "no such property, or its value is out of range");
    }
    if ((text = bat_json_text(json, bat_json_member(json, 1, "enter")))) {
        const char *number = bat_json_text(json, bat_json_member(json, 1, "text"));
        status = bat_editor_enter(editor, text, number);
        return status == BAT_UNSUPPORTED ? say(problem, status, "no such number") : BAT_OK;
    }
    if ((text = bat_json_text(json, bat_json_member(json, 1, "command")))) {
        status = bat_editor_command(editor, text);
        /* A command that finds nothing to do is as much part of a session as any other event. */
        return status == BAT_UNSUPPORTED ? say(problem, status, "no such command") : BAT_OK;
    }
    if (bat_json_member(json, 1, "picture")) {
        bat_pictures one = {0};
        status = bat_picture_from_json(json, 1, &one, problem);
        if (status == BAT_OK) status = bat_session_keep_picture(&editor->session, one.list[0]);
        bat_pictures_free(&one);
        return status;
    }
    if (bat_json_member(json, 1, "axis")) return axis(editor, json, problem);
    uint32_t lost = bat_json_member(json, 1, "lost");
    if (lost) {
        bat_losses losses;
        bat_losses_from_json(json, lost, &losses);
        return bat_editor_set_losses(editor, &losses);
    }
    if (bat_json_member(json, 1, "frame")) {
        bat_editor_frame(editor);
        return BAT_OK;
    }
    if (bat_json_member(json, 1, "digest")) return BAT_OK; /* only a check */
    return say(problem, BAT_UNSUPPORTED, "no such line is known");
}

/* What a replay has to do, and its progress. */
typedef struct playing {
    bat_editor *editor;
    bool check;
    int lines; /* run so far */
    bat_checked checked;
} playing;

/* Checks everything after lines 1, 2, 4, 8 ...; in between only what each line changes. */
static bat_status compare(playing *p, const bat_json *json, bat_problem *problem) {
    bat_editor *editor = p->editor;
    const char *wrong = bat_editor_check_since(editor, &p->checked, (p->lines & (p->lines - 1)) == 0);
    if (wrong) return say(problem, BAT_STATE, wrong);
    const char *expected = bat_json_text(json, bat_json_member(json, 1, "digest"));
    if (!expected) return BAT_OK;
    char found[17];
    bat_digest_print(bat_document_digest(editor->session.document), found);
    return strcmp(expected, found)
               ? say(problem, BAT_STATE, "the document differs from what the journal says")
               : BAT_OK;
}

bat_status bat_replay_line(bat_editor *editor, bool first, const bat_json *json, bat_problem *problem) {
    if (first) return open_snapshot(editor, json, problem);
    return bat_json_member(json, 1, "do") ? perform(editor, json, problem) : raw(editor, json, problem);
}

static bat_status line(playing *p, const char *text, size_t size, bat_problem *problem) {
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    status = bat_replay_line(p->editor, p->lines++ == 0, &json, problem);
    if (status == BAT_OK && p->check) status = compare(p, &json, problem);
    bat_json_free(&json);
    return status;
}

bool bat_replay_skips(const char *text, size_t size) {
    if (size && text[0] == '#') return true;
    for (size_t i = 0; i < size; i++)
        if (text[i] != ' ' && text[i] != '\t' && text[i] != '\r') return false;
    return true;
}

/* *number: the line at which it stopped. */
static bat_status run(playing *p, const char *text, size_t size, int *number, bat_problem *problem) {
    for (size_t at = 0; at < size;) {
        const char *end = memchr(text + at, '\n', size - at);
        size_t length = end ? (size_t)(end - text) - at : size - at;
        ++*number;
        bat_status status = bat_replay_skips(text + at, length) ? BAT_OK
                                                                : line(p, text + at, length, problem);
        if (status != BAT_OK) return status;
        at += length + 1;
    }
    if (p->lines == 0) {
        *number = 1;
        return say(problem, BAT_SYNTAX, "the journal is empty");
    }
    const char *wrong = p->check ? bat_editor_check(p->editor) : NULL;
    return wrong ? say(problem, BAT_STATE, wrong) : BAT_OK;
}

bat_status bat_editor_replay(bat_editor *editor, const char *text, size_t size, bool check,
                             bat_problem *problem) {
    if (!editor || (!text && size)) return BAT_ARGUMENT;
    bool read_only = editor->session.read_only;
    editor->session.read_only = false; /* it restricts the user, not the host */
    playing p = {.editor = editor, .check = check};
    bat_problem fault = {"", ""};
    int number = 0;
    bat_status status = run(&p, text, size, &number, &fault);
    editor->session.read_only = read_only;
    if (status == BAT_OK) return status;
    if (!fault.message[0]) say(&fault, status, bat_status_message(status)); /* nobody knew better */
    snprintf(fault.place, sizeof fault.place, "line %d", number);
    if (problem) *problem = fault;
    return status;
}

bat_status bat_editor_replay_line(bat_editor *editor, const char *text, size_t size, bat_problem *problem) {
    if (!editor || (!text && size)) return BAT_ARGUMENT;
    const bool read_only = editor->session.read_only;
    editor->session.read_only = false;
    editor->session.partly = true;
    playing p = {.editor = editor, .lines = 1};
    bat_problem fault = {"", ""};
    bat_status status = bat_replay_skips(text, size) ? BAT_OK : line(&p, text, size, &fault);
    editor->session.partly = false;
    editor->session.read_only = read_only;
    if (status != BAT_OK && problem) *problem = fault;
    return status;
}
