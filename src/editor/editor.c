/* The editor as a whole: made, opened, saved, ended. */
#include "editor/editor.h"
#include "format/native/native.h"
#include <batten/bezier.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const bat_tool *bat_editor_tool(const bat_editor *editor) {
    static const bat_tool *(*const tools[BAT_TOOL_COUNT])(void) = {
#define TOOL(id, name, command, behaviour) behaviour,
#include "editor/tables/commands.def"
    };
    if (editor->guiding.on) return bat_tool_guides();
    if (editor->waypoints.on) return bat_tool_waypoints();
    if (editor->range.on) return bat_tool_range();
    return tools[editor->erasing ? BAT_TOOL_ERASER : editor->tool]();
}

bool bat_editor_busy(const bat_editor *editor) {
    if (editor->leveling.fading) return true;
    const bat_tool *tool = bat_editor_tool(editor);
    return tool->busy && tool->busy(editor);
}

void bat_editor_notice_value(bat_editor *editor, bat_string text, const char *value) {
    if (editor->freed) text = BAT_STRING_NOTICE_FREED;
    if (editor->refused) text = BAT_STRING_NOTICE_READ_ONLY;
    editor->freed = editor->refused = false;
    editor->notice = text;
    if (text == BAT_STRING_COUNT) return;
    const char *words = bat_editor_text(editor, text), *hole = value ? strchr(words, '%') : NULL;
    if (hole)
        snprintf(editor->notice_text, BAT_NOTICE_ROOM, "%.*s%s%s", (int)(hole - words), words, value,
                 hole + 1);
    else
        snprintf(editor->notice_text, BAT_NOTICE_ROOM, "%s", words);
    editor->notice_version++;
}

void bat_editor_notice(bat_editor *editor, bat_string text) { bat_editor_notice_value(editor, text, NULL); }

void bat_editor_notice_failure(bat_editor *editor, bat_status status) {
    bat_editor_notice(editor, status == BAT_MEMORY ? BAT_STRING_NOTICE_MEMORY : BAT_STRING_NOTICE_FAILED);
}

const char *bat_editor_text(const bat_editor *editor, bat_string text) {
    return editor->words && editor->words[text] ? editor->words[text] : bat_string_english(text);
}

void bat_editor_follow(bat_editor *editor) {
    bat_selection_prune(&editor->selection, editor->document);
    if (editor->layer && bat_document_find(editor->document, editor->layer) < 0) editor->layer = 0;
    if (editor->entered && bat_document_find(editor->document, editor->entered) < 0) editor->entered = 0;
}

void bat_editor_sync(bat_editor *editor) {
    bat_scene_look(&editor->scene, editor->values[BAT_PROPERTY_OUTLINE] != 0, &editor->isolation);
    if (bat_scene_sync(&editor->scene, editor->document, editor->revision) != BAT_OK)
        bat_editor_notice(editor, BAT_STRING_NOTICE_MEMORY);
}

bool bat_editor_out_of_reach(const bat_editor *editor, int at) {
    const bat_scene *scene = &editor->scene;
    if (scene->revision != editor->revision || at >= scene->count) return false;
    return scene->entries[at].hidden || scene->entries[at].locked;
}

void bat_editor_interrupt(bat_editor *editor) {
    bat_leveling_let_go(editor);
    bat_range_end(editor);
    const bat_tool *tool = bat_editor_tool(editor);
    if (tool->cancel) tool->cancel(editor);
    if (tool->leave) tool->leave(editor);
    editor->erasing = editor->calming = false;
    editor->contacts.count = 0;
    editor->holding_pan = false;
}

bool bat_editor_fit(bat_editor *editor) {
    double page[4], box[4];
    bat_document_page(editor->document, page);
    if (page[2] > 0 && page[3] > 0) {
        double corners[4] = {page[0], page[1], page[0] + page[2], page[1] + page[3]};
        memcpy(box, corners, sizeof box);
    } else {
        bat_document_bounds(editor->document, box);
    }
    return bat_view_fit(&editor->view, box, BAT_FIT_MARGIN);
}

bat_status bat_editor_create(bat_editor **out) {
    if (!out) return BAT_ARGUMENT;
    bat_editor *editor = calloc(1, sizeof *editor);
    if (!editor) return BAT_MEMORY;
    editor->view = bat_view_defaults();
    editor->notice = BAT_STRING_COUNT;
    editor->spanning.held = -1;
    bat_scene_init(&editor->scene);
    for (int i = 0; i < BAT_PROPERTY_COUNT; i++)
        editor->values[i] = bat_property_at((bat_property_id)i)->standard;
    for (int i = 0; i < BAT_COMMAND_COUNT; i++)
        strcpy(editor->keys[i], bat_command_at((bat_command_id)i)->keys);
    bat_document *document = NULL;
    bat_status status = bat_document_create(&document);
    if (status == BAT_OK) {
        status = bat_editor_open(editor, document, "");
        if (status != BAT_OK) bat_document_free(document);
    }
    if (status != BAT_OK) {
        bat_editor_free(editor);
        return status;
    }
    *out = editor;
    return BAT_OK;
}

void bat_editor_free(bat_editor *editor) {
    if (!editor) return;
    if (editor->document) bat_editor_interrupt(editor);
    bat_samples_free(&editor->sketching.edit.samples);
    bat_samples_free(&editor->sketching.pending.samples);
    bat_splining_free(&editor->splining);
    bat_leveling_free(&editor->leveling);
    bat_scene_free(&editor->scene);
    free(editor->overlay.path.data);
    bat_selection_free(&editor->selection);
    bat_selection_free(&editor->selecting.earlier);
    bat_selection_free(&editor->isolation.kept);
    bat_history_clear(&editor->history);
    bat_journal_free(&editor->journal);
    bat_pictures_free(&editor->pictures);
    bat_document_free(editor->document);
    free(editor->name);
    free(editor->tables);
    free(editor->layers);
    free(editor->actions);
    free(editor->words);
    free(editor->outline);
    free(editor);
}

const bat_document *bat_editor_document(const bat_editor *editor) { return editor->document; }

/* The journal's first line: the document as it is when the journal begins. JSON may be broken over lines; a
 * journal's line may not, and outside strings a line's end is as good as a space. */
static bat_status write_head(const bat_document *document, const char *name, bat_journal *journal) {
    char *text = NULL;
    size_t size = 0;
    bat_status status = bat_document_write(document, &text, &size);
    if (status != BAT_OK) return status;
    for (size_t i = 0; i < size; i++)
        if (text[i] == '\n' || text[i] == '\r') text[i] = ' ';
    while (size && text[size - 1] == ' ') size--;
    bat_text line = {0};
    bat_text_string(&line, "{\"journal\":\"batten\",\"version\":1,\"name\":");
    bat_text_json_string(&line, name);
    bat_text_string(&line, ",\"digest\":");
    bat_line_digest(&line, bat_document_digest(document));
    bat_text_string(&line, ",\"document\":");
    bat_text_add(&line, text, size);
    bat_text_string(&line, "}");
    bat_free(text);
    status = bat_journal_append(journal, line.data, line.size, line.failed);
    bat_text_free(&line);
    return status;
}

bat_status bat_editor_begin_journal(const bat_document *document, const char *name, bat_journal *journal,
                                    bat_pictures *pictures) {
    bat_status status = write_head(document, name, journal);
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_picture *picture = bat_object_picture(bat_document_at(document, i));
        if (picture) status = bat_pictures_add(pictures, picture);
    }
    return status;
}

bat_status bat_editor_log(bat_editor *editor, bat_text *line, const bat_document *document) {
    bat_text_string(line, ",\"digest\":");
    bat_line_digest(line, bat_document_digest(document));
    bat_text_string(line, "}");
    bat_status status = bat_journal_append(&editor->journal, line->data, line->size, line->failed);
    bat_text_free(line);
    return status;
}

bat_status bat_editor_open(bat_editor *editor, bat_document *document, const char *name) {
    if (!document) return BAT_ARGUMENT;
    if (!name) name = "";
    char *own_name = malloc(strlen(name) + 1);
    bat_journal journal = {0};
    bat_pictures pictures = {0};
    bat_status status = own_name ? bat_editor_begin_journal(document, name, &journal, &pictures) : BAT_MEMORY;
    if (status != BAT_OK) {
        free(own_name);
        bat_journal_free(&journal);
        bat_pictures_free(&pictures);
        return status;
    }
    strcpy(own_name, name);
    if (editor->document) bat_editor_interrupt(editor);
    bat_selection_clear(&editor->selection);
    bat_isolate_end(editor);
    editor->guiding = (bat_guiding){0};
    editor->layer = editor->entered = 0;
    bat_splining_free(&editor->splining);
    bat_leveling_free(&editor->leveling);
    bat_history_clear(&editor->history);
    bat_journal_free(&editor->journal);
    free(editor->name);
    bat_document_free(editor->document);
    editor->document = document;
    editor->name = own_name;
    editor->journal = journal;
    bat_pictures_free(&editor->pictures);
    editor->pictures = pictures;
    editor->revision++;
    editor->saved_state = editor->history.state;
    editor->asked = false;
    bat_editor_notice(editor, BAT_STRING_COUNT);
    /* A look at nothing begins at the origin, one to one. */
    double x = editor->view.width, y = editor->view.height, ratio = editor->view.ratio;
    editor->view = bat_view_defaults();
    editor->view.width = x;
    editor->view.height = y;
    editor->view.ratio = ratio;
    editor->fit_wanted = !bat_editor_fit(editor);
    return BAT_OK;
}

bat_status bat_editor_keep_picture(bat_editor *editor, const bat_picture *picture) {
    int before = editor->pictures.count;
    bat_status status = bat_pictures_add(&editor->pictures, picture);
    if (status != BAT_OK || editor->pictures.count == before) return status;
    bat_text line = {0};
    bat_picture_to_json(picture, &line);
    status = bat_journal_append(&editor->journal, line.data, line.size, line.failed);
    bat_text_free(&line);
    if (status != BAT_OK) bat_pictures_drop(&editor->pictures);
    return status;
}

void bat_editor_saved(bat_editor *editor) {
    editor->saved_state = editor->asked ? editor->asked_state : editor->history.state;
    editor->asked = false;
    bat_editor_notice(editor, BAT_STRING_NOTICE_SAVED);
}

void bat_editor_set_read_only(bat_editor *editor, bool read_only) {
    if (editor->read_only == read_only) return;
    bat_editor_interrupt(editor);
    editor->read_only = read_only;
}

bool bat_editor_refuses(bat_editor *editor) {
    if (editor->read_only) bat_editor_notice(editor, BAT_STRING_NOTICE_READ_ONLY);
    editor->refused = editor->read_only;
    return editor->read_only;
}

const char *bat_editor_journal(const bat_editor *editor, size_t *size) {
    if (size) *size = editor->journal.size;
    return editor->journal.text;
}
