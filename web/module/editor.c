/* The engine as exports: one function each, arguments as addresses in the module's memory. */
#include "module.h"

#include "editor/export.h"
#include "format/formats.h"
#include "format/json/losses.h"

#include <math.h>
#include <string.h>

MODULE_EXPORT(editor_create) bat_editor *editor_create(void);
MODULE_EXPORT(editor_pointer)
void editor_pointer(bat_editor *editor, const bat_pointer *events, size_t count);
MODULE_EXPORT(editor_wheel)
void editor_wheel(bat_editor *editor, double x, double y, double dx, double dy, uint32_t modifiers,
                  double time);
MODULE_EXPORT(editor_glide) void editor_glide(bat_editor *editor, double share);
MODULE_EXPORT(editor_key)
int editor_key(bat_editor *editor, const char *key, int down, uint32_t modifiers, double time);
MODULE_EXPORT(editor_resize)
void editor_resize(bat_editor *editor, double width, double height, double pixel_ratio);
MODULE_EXPORT(editor_command) int editor_command(bat_editor *editor, const char *name);
MODULE_EXPORT(editor_set) int editor_set(bat_editor *editor, const char *property, double value);
MODULE_EXPORT(editor_get) double editor_get(const bat_editor *editor, const char *property);
MODULE_EXPORT(editor_pressure) double editor_pressure(const bat_editor *editor, double pressure);
MODULE_EXPORT(editor_enter) int editor_enter(bat_editor *editor, const char *name, const char *text);
MODULE_EXPORT(editor_number) const char *editor_number(bat_editor *editor, const char *name);
MODULE_EXPORT(editor_tables) const char *editor_tables(bat_editor *editor);
MODULE_EXPORT(editor_words) int editor_words(bat_editor *editor, const char *text, size_t size);
MODULE_EXPORT(editor_bind) int editor_bind(bat_editor *editor, const char *command, const char *keys);
MODULE_EXPORT(editor_actions) const char *editor_actions(bat_editor *editor);
MODULE_EXPORT(editor_refused) const char *editor_refused(bat_editor *editor);
MODULE_EXPORT(editor_place_layer) int editor_place_layer(bat_editor *editor, uint32_t id, uint32_t target);
MODULE_EXPORT(editor_layers) const char *editor_layers(bat_editor *editor);
MODULE_EXPORT(editor_readings) const char *editor_readings(bat_editor *editor);
MODULE_EXPORT(editor_read_as) int editor_read_as(bat_editor *editor, int reading);
MODULE_EXPORT(editor_refit) int editor_refit(bat_editor *editor, double amount, int done);
MODULE_EXPORT(editor_refit_other) int editor_refit_other(bat_editor *editor, double amount, int done);
MODULE_EXPORT(editor_levels) const char *editor_levels(bat_editor *editor);
MODULE_EXPORT(editor_level)
int editor_level(bat_editor *editor, int act, int level, double value, int done);
MODULE_EXPORT(editor_move) const char *editor_move(bat_editor *editor);
MODULE_EXPORT(editor_seek) int editor_seek(bat_editor *editor, double seconds);
MODULE_EXPORT(editor_play) void editor_play(bat_editor *editor, double time);
MODULE_EXPORT(editor_move_set)
int editor_move_set(bat_editor *editor, int act, int path, int level, double value, int done);
MODULE_EXPORT(editor_retime)
int editor_retime(bat_editor *editor, const double *points, size_t count, int done);
MODULE_EXPORT(editor_correct)
int editor_correct(bat_editor *editor, int kind, double wide, double tall, double x, double y, double to_x,
                   double to_y, int done);
MODULE_EXPORT(editor_outline)
const char *editor_outline(bat_editor *editor, int first, int count);
MODULE_EXPORT(editor_unshown) const char *editor_unshown(bat_editor *editor);
MODULE_EXPORT(editor_history) const char *editor_history(bat_editor *editor);
MODULE_EXPORT(editor_go) int editor_go(bat_editor *editor, int done);
MODULE_EXPORT(editor_colours) const char *editor_colours(bat_editor *editor);
MODULE_EXPORT(editor_mixed) const char *editor_mixed(bat_editor *editor);
MODULE_EXPORT(editor_holds) const char *editor_holds(bat_editor *editor);
MODULE_EXPORT(editor_outline_points) const char *editor_outline_points(bat_editor *editor, uint32_t id);
MODULE_EXPORT(editor_choose) int editor_choose(bat_editor *editor, uint32_t id, int point);
MODULE_EXPORT(editor_select) int editor_select(bat_editor *editor, uint32_t id, int add);
MODULE_EXPORT(editor_said) const char *editor_said(bat_editor *editor);
MODULE_EXPORT(editor_activate_layer) int editor_activate_layer(bat_editor *editor, uint32_t id);
MODULE_EXPORT(editor_rename) int editor_rename(bat_editor *editor, uint32_t id, const char *name);
MODULE_EXPORT(editor_set_state)
int editor_set_state(bat_editor *editor, uint32_t id, int hidden, int locked);
MODULE_EXPORT(editor_saved) void editor_saved(bat_editor *editor);
MODULE_EXPORT(editor_read_only) void editor_read_only(bat_editor *editor, int on);
MODULE_EXPORT(editor_frame) const bat_frame *editor_frame(bat_editor *editor);
MODULE_EXPORT(editor_space) const bat_space *editor_space(bat_editor *editor);
MODULE_EXPORT(editor_lens) const bat_space *editor_lens(bat_editor *editor, double wide, double tall);
MODULE_EXPORT(space_constants) const char *space_constants(void);
MODULE_EXPORT(editor_journal) const char *editor_journal(const bat_editor *editor, size_t *size);
MODULE_EXPORT(editor_compact) int editor_compact(bat_editor *editor);
MODULE_EXPORT(editor_replay)
int editor_replay(bat_editor *editor, const char *text, size_t size, int check, bat_problem *problem);
MODULE_EXPORT(editor_salvage) int editor_salvage(bat_editor *editor, const char *text, size_t size);
MODULE_EXPORT(editor_replay_line)
int editor_replay_line(bat_editor *editor, const char *text, size_t size, bat_problem *problem);
MODULE_EXPORT(editor_check) const char *editor_check(const bat_editor *editor);
MODULE_EXPORT(editor_open_native)
int editor_open_native(bat_editor *editor, const char *text, size_t size, const char *name,
                       bat_problem *problem);
MODULE_EXPORT(editor_open_file)
int editor_open_file(bat_editor *editor, const char *text, size_t size, const char *name,
                     bat_problem *problem);
MODULE_EXPORT(editor_paste_file)
int editor_paste_file(bat_editor *editor, const char *text, size_t size, const char *name,
                      bat_problem *problem);
MODULE_EXPORT(editor_copy) int editor_copy(bat_editor *editor, int cut, module_bytes *out);
MODULE_EXPORT(editor_export)
int editor_export(const bat_editor *editor, const char *format, int part, uint32_t id, module_bytes *out,
                  bat_problem *problem);
MODULE_EXPORT(editor_add_picture)
int editor_add_picture(bat_editor *editor, const void *bytes, size_t size, const char *name);
MODULE_EXPORT(editor_writing)
const char *editor_writing(bat_editor *editor);
MODULE_EXPORT(editor_texts)
const char *editor_texts(bat_editor *editor);
MODULE_EXPORT(editor_write)
int editor_write(bat_editor *editor, const char *json);
MODULE_EXPORT(editor_picture)
const void *editor_picture(const bat_editor *editor, uint32_t picture, size_t *size);
MODULE_EXPORT(editor_save) int editor_save(const bat_editor *editor, int native, int kept, module_bytes *out);
MODULE_EXPORT(editor_losses) const bat_losses *editor_losses(const bat_editor *editor);
MODULE_EXPORT(editor_lost) int editor_lost(const bat_editor *editor);
MODULE_EXPORT(editor_keeps) int editor_keeps(const bat_editor *editor);
MODULE_EXPORT(editor_set_losses) int editor_set_losses(bat_editor *editor, const bat_losses *losses);
MODULE_EXPORT(loss_key) const char *loss_key(int kind);
MODULE_EXPORT(editor_digest) uint64_t editor_digest(const bat_editor *editor);
MODULE_EXPORT(status_message) const char *status_message(int status);

bat_editor *editor_create(void) {
    bat_editor *editor = NULL;
    return bat_editor_create(&editor) == BAT_OK ? editor : NULL;
}

void editor_pointer(bat_editor *editor, const bat_pointer *events, size_t count) {
    MODULE_CHECK(editor);
    bat_editor_pointer(editor, count, events);
}

void editor_wheel(bat_editor *editor, double x, double y, double dx, double dy, uint32_t modifiers,
                  double time) {
    MODULE_CHECK(editor);
    bat_editor_wheel(editor, x, y, dx, dy, modifiers, time);
}

void editor_glide(bat_editor *editor, double share) {
    MODULE_CHECK(editor);
    bat_editor_glide(editor, share);
}

int editor_key(bat_editor *editor, const char *key, int down, uint32_t modifiers, double time) {
    MODULE_CHECK(editor);
    return bat_editor_key(editor, key, down != 0, modifiers, time);
}

void editor_resize(bat_editor *editor, double width, double height, double pixel_ratio) {
    MODULE_CHECK(editor);
    bat_editor_resize(editor, width, height, pixel_ratio);
}

int editor_command(bat_editor *editor, const char *name) {
    MODULE_CHECK(editor);
    return (int)bat_editor_command(editor, name);
}

int editor_set(bat_editor *editor, const char *property, double value) {
    MODULE_CHECK(editor);
    return (int)bat_editor_set(editor, property, value);
}

/* NaN when there is no such property. */
double editor_get(const bat_editor *editor, const char *property) {
    MODULE_CHECK(editor);
    double value;
    return bat_editor_get(editor, property, &value) == BAT_OK ? value : (double)NAN;
}

int editor_enter(bat_editor *editor, const char *name, const char *text) {
    MODULE_CHECK(editor);
    return (int)bat_editor_enter(editor, name, text);
}

const char *editor_number(bat_editor *editor, const char *name) {
    MODULE_CHECK(editor);
    return bat_editor_number(editor, name);
}

const char *editor_actions(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_actions(editor);
}

const char *editor_refused(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_refused(editor);
}

int editor_place_layer(bat_editor *editor, uint32_t id, uint32_t target) {
    MODULE_CHECK(editor);
    return (int)bat_editor_place_layer(editor, id, target);
}

const char *editor_layers(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_layers(editor);
}

const char *editor_readings(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_readings(editor);
}

int editor_refit(bat_editor *editor, double amount, int done) {
    MODULE_CHECK(editor);
    return (int)bat_editor_refit(editor, amount, done != 0);
}

int editor_refit_other(bat_editor *editor, double amount, int done) {
    MODULE_CHECK(editor);
    return (int)bat_editor_refit_other(editor, amount, done != 0);
}

int editor_read_as(bat_editor *editor, int reading) {
    MODULE_CHECK(editor);
    return (int)bat_editor_read_as(editor, reading);
}

const char *editor_levels(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_levels(editor);
}

int editor_level(bat_editor *editor, int act, int level, double value, int done) {
    MODULE_CHECK(editor);
    return (int)bat_editor_level(editor, (bat_level_act)act, level, value, done != 0);
}

const char *editor_move(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_move(editor);
}

int editor_seek(bat_editor *editor, double seconds) {
    MODULE_CHECK(editor);
    return (int)bat_editor_seek(editor, seconds);
}

void editor_play(bat_editor *editor, double time) {
    MODULE_CHECK(editor);
    bat_editor_play(editor, time);
}

int editor_move_set(bat_editor *editor, int act, int path, int level, double value, int done) {
    MODULE_CHECK(editor);
    return (int)bat_editor_move_set(editor, (bat_move_act)act, path != 0, level, value, done != 0);
}

int editor_retime(bat_editor *editor, const double *points, size_t count, int done) {
    MODULE_CHECK(editor);
    return (int)bat_editor_retime(editor, count, points, done != 0);
}

int editor_correct(bat_editor *editor, int kind, double wide, double tall, double x, double y, double to_x,
                   double to_y, int done) {
    MODULE_CHECK(editor);
    return (int)bat_editor_correct(editor, (bat_correction)kind, (double[]){wide, tall}, (double[]){x, y},
                                   (double[]){to_x, to_y}, done != 0);
}

const char *editor_outline(bat_editor *editor, int first, int count) {
    MODULE_CHECK(editor);
    return bat_editor_outline(editor, first, count);
}

const char *editor_unshown(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_unshown(editor);
}

const char *editor_history(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_history(editor);
}

int editor_go(bat_editor *editor, int done) {
    MODULE_CHECK(editor);
    return (int)bat_editor_go(editor, done);
}

const char *editor_colours(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_colours(editor);
}

const char *editor_mixed(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_mixed(editor);
}

const char *editor_holds(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_holds(editor);
}

const char *editor_outline_points(bat_editor *editor, uint32_t id) {
    MODULE_CHECK(editor);
    return bat_editor_outline_points(editor, id);
}

int editor_choose(bat_editor *editor, uint32_t id, int point) {
    MODULE_CHECK(editor);
    return (int)bat_editor_choose(editor, id, point);
}

int editor_select(bat_editor *editor, uint32_t id, int add) {
    MODULE_CHECK(editor);
    return (int)bat_editor_select(editor, id, add != 0);
}

const char *editor_said(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_said(editor);
}

int editor_activate_layer(bat_editor *editor, uint32_t id) {
    MODULE_CHECK(editor);
    return (int)bat_editor_activate_layer(editor, id);
}

int editor_rename(bat_editor *editor, uint32_t id, const char *name) {
    MODULE_CHECK(editor);
    return (int)bat_editor_rename(editor, id, name);
}

int editor_set_state(bat_editor *editor, uint32_t id, int hidden, int locked) {
    MODULE_CHECK(editor);
    return (int)bat_editor_set_state(editor, id, hidden != 0, locked != 0);
}

double editor_pressure(const bat_editor *editor, double pressure) {
    MODULE_CHECK(editor);
    return bat_editor_pressure(editor, pressure);
}

const char *editor_tables(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_tables(editor);
}

int editor_words(bat_editor *editor, const char *text, size_t size) {
    MODULE_CHECK(editor);
    return (int)bat_editor_words(editor, text, size, NULL);
}

/* keys: NULL for the default. */
int editor_bind(bat_editor *editor, const char *command, const char *keys) {
    MODULE_CHECK(editor);
    return (int)bat_editor_bind(editor, command, keys);
}

void editor_saved(bat_editor *editor) {
    MODULE_CHECK(editor);
    bat_editor_saved(editor);
}

void editor_read_only(bat_editor *editor, int on) {
    MODULE_CHECK(editor);
    bat_editor_set_read_only(editor, on != 0);
}

const bat_frame *editor_frame(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_frame(editor);
}

const bat_space *editor_lens(bat_editor *editor, double wide, double tall) {
    MODULE_CHECK(editor);
    return bat_editor_lens(editor, (double[]){wide, tall});
}

const bat_space *editor_space(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_space(editor);
}

const char *space_constants(void) { return bat_space_constants(); }

const char *editor_journal(const bat_editor *editor, size_t *size) {
    MODULE_CHECK(editor);
    return bat_editor_journal(editor, size);
}

int editor_replay(bat_editor *editor, const char *text, size_t size, int check, bat_problem *problem) {
    MODULE_CHECK(editor);
    return (int)bat_editor_replay(editor, text, size, check != 0, problem);
}

/* How many lines were left out; -1: nothing could be run. */
int editor_salvage(bat_editor *editor, const char *text, size_t size) {
    MODULE_CHECK(editor);
    int left_out = 0;
    return bat_editor_salvage(editor, text, size, &left_out) == BAT_OK ? left_out : -1;
}

int editor_replay_line(bat_editor *editor, const char *text, size_t size, bat_problem *problem) {
    MODULE_CHECK(editor);
    return (int)bat_editor_replay_line(editor, text, size, problem);
}

int editor_compact(bat_editor *editor) {
    MODULE_CHECK(editor);
    return (int)bat_editor_compact(editor);
}

const char *editor_check(const bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_check(editor);
}

int editor_open_native(bat_editor *editor, const char *text, size_t size, const char *name,
                       bat_problem *problem) {
    MODULE_CHECK(editor);
    bat_document *document = NULL;
    bat_status status = bat_document_read(text, size, &document, problem);
    if (status != BAT_OK) {
        return (int)status;
    }
    return (int)bat_editor_open(editor, document, name);
}

/* Reads any other format that needs no XML parser, from the table of formats: recognised by its name, else by its text. */
static bat_status read_file(const char *text, size_t size, const char *name, bat_document **out,
                            bat_svg_report *report, bat_problem *problem) {
    const bat_reading how = {.svg = bat_svg_merging()};
    const bat_format *format = bat_format_called(name);
    return bat_formats_read(&how, text, size, &format, out, report, problem);
}

int editor_open_file(bat_editor *editor, const char *text, size_t size, const char *name,
                     bat_problem *problem) {
    MODULE_CHECK(editor && name);
    bat_document *document = NULL;
    bat_svg_report report;
    bat_status status = read_file(text, size, name, &document, &report, problem);
    if (status == BAT_OK) {
        status = bat_editor_open(editor, document, name);
    }
    return status == BAT_OK ? (int)bat_editor_set_losses(editor, &report.lost) : (int)status;
}

int editor_paste_file(bat_editor *editor, const char *text, size_t size, const char *name,
                      bat_problem *problem) {
    MODULE_CHECK(editor && name);
    bat_document *document = NULL;
    bat_svg_report report;
    bat_status status = read_file(text, size, name, &document, &report, problem);
    if (status == BAT_OK) {
        status = bat_editor_paste(editor, document, false);
    }
    bat_document_free(document);
    return (int)status;
}

int editor_copy(bat_editor *editor, int cut, module_bytes *out) {
    MODULE_CHECK(editor && out);
    return (int)bat_editor_copy(editor, cut != 0, &out->data, &out->size);
}

/* A file of an object, or, when id is 0, of part of the drawing (bat_excerpt), in a format of the table; "plain": SVG without the native document. */
int editor_export(const bat_editor *editor, const char *format, int part, uint32_t id, module_bytes *out,
                  bat_problem *problem) {
    MODULE_CHECK(editor && format && out && problem);
    return (int)bat_editor_export(editor, format, (bat_excerpt)part, id, &out->data, &out->size, problem);
}

int editor_add_picture(bat_editor *editor, const void *bytes, size_t size, const char *name) {
    MODULE_CHECK(editor);
    return (int)bat_editor_add_picture(editor, bytes, size, name);
}

const char *editor_writing(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_writing(editor);
}

const char *editor_texts(bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_texts(editor);
}

int editor_write(bat_editor *editor, const char *json) {
    MODULE_CHECK(editor && json);
    return (int)bat_editor_write(editor, json, strlen(json), NULL);
}

/* The bytes of a picture, not copied; NULL when there is none. */
const void *editor_picture(const bat_editor *editor, uint32_t picture, size_t *size) {
    MODULE_CHECK(editor && size);
    const bat_picture *found = bat_editor_picture(editor, picture);
    return found ? bat_picture_bytes(found, size) : NULL;
}

/* The document as a file: native JSON, or SVG with what SVG cannot hold inside. kept: BAT_UNSUPPORTED where the file that it keeps
 * would have to be written anew. */
int editor_save(const bat_editor *editor, int native, int kept, module_bytes *out) {
    MODULE_CHECK(editor && out);
    const bat_document *document = bat_editor_document(editor);
    bat_status status = BAT_STATE;
    if (native) return (int)bat_document_write(document, &out->data, &out->size);
    if (kept) status = bat_svg_write_kept(document, true, BAT_SVG_UNSEEN, &out->data, &out->size);
    return (int)(status == BAT_STATE ? bat_svg_write(document, true, &out->data, &out->size) : status);
}

/* Losses counted by kind; NULL: saving loses nothing any more. */
const bat_losses *editor_losses(const bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_editor_losses(editor);
}

/* How many things to tell the user of: bat_frame's `lost`. */
int editor_lost(const bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_losses_told(bat_editor_losses(editor), bat_editor_document(editor));
}

/* Whether the document keeps the file that it was read from: then saving it as SVG loses nothing. */
int editor_keeps(const bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_svg_is_kept(bat_editor_document(editor));
}

int editor_set_losses(bat_editor *editor, const bat_losses *losses) {
    MODULE_CHECK(editor);
    return (int)bat_editor_set_losses(editor, losses);
}

const char *loss_key(int kind) { return bat_loss_key((bat_loss)kind); }

uint64_t editor_digest(const bat_editor *editor) {
    MODULE_CHECK(editor);
    return bat_document_digest(bat_editor_document(editor));
}

const char *status_message(int status) { return bat_status_message((bat_status)status); }
