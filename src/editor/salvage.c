/*
 * Salvage: runs what can be run of a journal that is damaged. A step that cannot be done counts as one that is missing: an undo
 * that would take it back, and a redo that would bring it again, do nothing, so that they do not hit another step.
 */
#include "editor/editor.h"
#include "editor/replay.h"
#include <stdlib.h>
#include <string.h>

/* The steps of the journal so far, whether each was done: list[0..done) can be undone, list[done..count) redone. */
typedef struct salvaging {
    bat_editor *editor;
    bool *list;
    size_t count, done, room;
    int lines, left_out;
} salvaging;

static bat_status push(salvaging *s, bool was_done) {
    if (s->done == s->room) {
        size_t room = s->room ? 2 * s->room : 64;
        bool *list = realloc(s->list, room * sizeof *list);
        if (!list) return BAT_MEMORY;
        s->list = list;
        s->room = room;
    }
    s->list[s->done++] = was_done;
    s->count = s->done;
    return BAT_OK;
}

/* The document that the journal begins with; where it cannot be read an empty one. */
static bat_status begin(salvaging *s, const bat_json *json) {
    bat_problem problem;
    bat_status status = json ? bat_replay_line(s->editor, true, json, &problem) : BAT_SYNTAX;
    if (status == BAT_OK || status == BAT_UNSUPPORTED || status == BAT_MEMORY) return status;
    s->left_out++;
    bat_document *empty = NULL;
    status = bat_document_create(&empty);
    return status == BAT_OK ? bat_editor_open(s->editor, empty, NULL) : status;
}

static bat_status go_on(salvaging *s, const bat_json *json) {
    const char *what = json ? bat_json_text(json, bat_json_member(json, 1, "do")) : NULL;
    const bool back = what && !strcmp(what, "undo"), again = what && !strcmp(what, "redo");
    bat_problem problem;
    if (back && s->done > 0 && !s->list[s->done - 1]) {
        s->done--;
        return BAT_OK;
    }
    if (again && s->done < s->count && !s->list[s->done]) {
        s->done++;
        return BAT_OK;
    }
    bat_status status = json ? bat_replay_line(s->editor, false, json, &problem) : BAT_SYNTAX;
    if (status == BAT_MEMORY) return status;
    s->left_out += status != BAT_OK;
    if (back || again) {
        if (status == BAT_OK && (back ? s->done > 0 : s->done < s->count))
            s->done = back ? s->done - 1 : s->done + 1;
        return BAT_OK;
    }
    return what || status != BAT_OK ? push(s, status == BAT_OK) : BAT_OK;
}

static bat_status line(salvaging *s, const char *text, size_t size) {
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, NULL);
    if (status == BAT_MEMORY) return status;
    const bat_json *read = status == BAT_OK ? &json : NULL;
    status = s->lines++ == 0 ? begin(s, read) : go_on(s, read);
    if (read) bat_json_free(&json);
    return status;
}

bat_status bat_editor_salvage(bat_editor *editor, const char *text, size_t size, int *left_out) {
    if (!editor || (!text && size)) return BAT_ARGUMENT;
    bool read_only = editor->session.read_only;
    editor->session.read_only = false; /* it restricts the user, not the host */
    editor->session.partly = true;
    salvaging s = {.editor = editor};
    bat_status status = BAT_OK;
    for (size_t at = 0; at < size && status == BAT_OK;) {
        const char *end = memchr(text + at, '\n', size - at);
        size_t length = end ? (size_t)(end - text) - at : size - at;
        if (!bat_replay_skips(text + at, length)) status = line(&s, text + at, length);
        at += length + 1;
    }
    if (s.lines == 0) status = BAT_SYNTAX;
    editor->session.partly = false;
    editor->session.read_only = read_only;
    free(s.list);
    if (left_out) *left_out = s.left_out;
    return status;
}
