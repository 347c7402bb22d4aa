/* The editor as a whole: creating, opening, saving, freeing it; and the public calls, passed on to the rooms. */
#include "editor/editor.h"
#include "format/seen/seen.h"
#include "editor/commands/dispatch.h"
#include "editor/edit/excerpt.h"
#include "editor/edit/pictures.h"
#include "editor/edit/symmetry.h"
#include "editor/input/pressure.h"
#include "editor/refusal.h"
#include "editor/tables/words.h"
#include "editor/tools/gazes/correct.h"
#include "editor/tools/gazes/fade.h"
#include "editor/view/unit.h"
#include <stdlib.h>

static void wire(bat_editor *editor) {
    editor->context = (bat_context){.settings = &editor->settings,
                                    .session = &editor->session,
                                    .notices = &editor->notices,
                                    .stage = &editor->stage,
                                    .views = &editor->views,
                                    .input = &editor->input,
                                    .choice = &editor->choice,
                                    .clipboard = &editor->clipboard,
                                    .scene = &editor->scene,
                                    .snap = &editor->snap,
                                    .moves = &editor->moves,
                                    .insight = &editor->insight,
                                    .simplifying = &editor->simplifying,
                                    .tuning = &editor->tuning,
                                    .panels = &editor->panels,
                                    .toolbox = &editor->toolbox};
}

static const bat_tool *(*const tools[BAT_SLOTS])(void) = {
#define TOOL(id, name, command, behaviour, traits) behaviour,
#define MODE(id, behaviour) behaviour,
#include "editor/tables/commands.def"
};

bat_status bat_editor_create(bat_editor **out) {
    if (!out) return BAT_ARGUMENT;
    bat_editor *editor = calloc(1, sizeof *editor);
    if (!editor) return BAT_MEMORY;
    wire(editor);
    editor->session.stepped = bat_choice_follow;
    editor->session.mirror = bat_symmetry_finish;
    editor->stage = bat_stage_defaults();
    editor->stage.casters = &editor->casters;
    editor->casters.document = &editor->session.document;
    editor->notices.notice = BAT_STRING_COUNT;
    editor->session.freed = BAT_STRING_COUNT;
    bat_scene_init(&editor->scene);
    bat_settings_init(&editor->settings);
    bat_document *document = NULL;
    bat_status status = bat_toolbox_fill(&editor->toolbox, tools);
    if (status == BAT_OK) status = bat_document_create(&document);
    if (status == BAT_OK) status = bat_editor_open(editor, document, "");
    if (status != BAT_OK) {
        bat_editor_free(editor);
        return status;
    }
    *out = editor;
    return BAT_OK;
}

void bat_editor_free(bat_editor *editor) {
    if (!editor) return;
    if (editor->session.document) bat_toolbox_interrupt(&editor->context);
    bat_toolbox_free(&editor->toolbox);
    bat_scene_free(&editor->scene);
    bat_casters_free(&editor->casters);
    bat_overlay_free(&editor->overlay);
    bat_taken_free(&editor->input.taken);
    bat_choice_free(&editor->choice);
    bat_session_free(&editor->session);
    bat_tuning_free(&editor->tuning);
    bat_panels_free(&editor->panels);
    bat_deviating_end(&editor->insight.deviating);
    bat_settings_free(&editor->settings);
    free(editor);
}

bat_status bat_editor_open(bat_editor *editor, bat_document *document, const char *name) {
    if (!editor || !document) {
        bat_document_free(document);
        return BAT_ARGUMENT;
    }
    bat_context *c = &editor->context;
    if (c->session->document) bat_toolbox_interrupt(c);
    bat_status status = bat_session_open(c->session, document, name ? name : "");
    if (status != BAT_OK) {
        bat_document_free(document);
        return status;
    }
    bat_choice_forget(c);
    bat_deviating_end(&c->insight->deviating);
    bat_tuning_free(c->tuning);
    bat_moves_forget(c->moves);
    bat_toolbox_forget(c->toolbox);
    bat_notice(c, BAT_STRING_COUNT);
    bat_view_look_afresh(&c->stage->view);
    *c->views = (bat_views){.jumps = c->views->jumps};
    c->stage->ground = bat_ground_page();
    c->stage->view.fit_wanted = !bat_seen_fit(c);
    if (bat_seen_view(document)) bat_notice_saved_view(c);
    bat_unit_adopt(c);
    bat_toolbox_settle(c);
    return BAT_OK;
}

void bat_editor_saved(bat_editor *editor) {
    bat_session *session = &editor->session;
    session->saved_state = session->asked ? session->asked_state : session->history.state;
    session->asked = false;
    bat_notice(&editor->context, BAT_STRING_NOTICE_SAVED);
}

void bat_editor_set_read_only(bat_editor *editor, bool read_only) {
    if (editor->session.read_only == read_only) return;
    bat_toolbox_interrupt(&editor->context);
    editor->session.read_only = read_only;
    bat_toolbox_settle(&editor->context);
}

bat_status bat_editor_set_losses(bat_editor *editor, const bat_losses *losses) {
    return editor ? bat_session_set_losses(&editor->session, losses) : BAT_ARGUMENT;
}

const bat_losses *bat_editor_losses(const bat_editor *editor) { return &editor->session.losses; }

const bat_document *bat_editor_document(const bat_editor *editor) { return editor->session.document; }

const char *bat_editor_journal(const bat_editor *editor, size_t *size) {
    if (size) *size = editor->session.journal.size;
    return editor->session.journal.text;
}

bat_status bat_editor_compact(bat_editor *editor) {
    if (!editor) return BAT_ARGUMENT;
    return bat_toolbox_busy(&editor->context) ? BAT_STATE : bat_session_compact(&editor->session);
}

/* Whether places in the window are places on the page; if not, the way home is offered. */
static bool face_on(bat_context *c) {
    if (bat_stage_tilted(c->stage)) bat_notice_tilted(c);
    return !bat_stage_tilted(c->stage);
}

/* ---- calls passed on ---- */

static bat_status settled(bat_editor *editor, bat_status status) {
    bat_toolbox_settle(&editor->context);
    return status;
}

bat_status bat_editor_command(bat_editor *editor, const char *name) {
    return bat_refusal_command(editor, settled(editor, bat_command_do(&editor->context, name)), name);
}

bat_status bat_editor_set(bat_editor *editor, const char *property, double value) {
    const bat_status status = settled(editor, bat_property_set(&editor->context, property, value));
    return bat_refusal_property(editor, status, property, value);
}

bat_status bat_editor_get(const bat_editor *editor, const char *property, double *value) {
    return bat_property_get(&editor->context, property, value);
}

bat_status bat_editor_enter(bat_editor *editor, const char *name, const char *text) {
    const bat_status status = settled(editor, bat_panel_enter(&editor->context, name, text));
    return bat_refusal_text(editor, status, name, text);
}

const char *bat_editor_number(bat_editor *editor, const char *name) {
    return bat_panel_number(&editor->context, name);
}

double bat_editor_pressure(const bat_editor *editor, double pressure) {
    return bat_pressure(&editor->context, pressure);
}

bat_status bat_editor_bind(bat_editor *editor, const char *command, const char *keys) {
    return bat_refusal_keys(editor, bat_command_bind(&editor->context, command, keys), command, keys);
}

const char *bat_editor_tables(bat_editor *editor) { return bat_panel_tables(&editor->context); }

bat_status bat_editor_words(bat_editor *editor, const char *text, size_t size, bat_problem *problem) {
    return bat_words_read(&editor->settings, text, size, problem);
}

const char *bat_editor_layers(bat_editor *editor) { return bat_panel_layers(&editor->context); }

const char *bat_editor_actions(bat_editor *editor) { return bat_panel_actions(&editor->context); }

const char *bat_editor_refused(bat_editor *editor) { return bat_panel_refused(&editor->context); }
const char *bat_editor_history(bat_editor *editor) { return bat_panel_history(&editor->context); }

bat_status bat_editor_go(bat_editor *editor, int done) {
    if (editor->session.busy) return BAT_STATE;
    return settled(editor, bat_history_go(&editor->context, done));
}

const char *bat_editor_colours(bat_editor *editor) { return bat_panel_colours(&editor->context); }

const char *bat_editor_mixed(bat_editor *editor) { return bat_panel_mixed(&editor->context); }

bat_status bat_editor_place_layer(bat_editor *editor, bat_id id, bat_id target) {
    return settled(editor, bat_layer_place(&editor->context, id, target));
}

bat_status bat_editor_activate_layer(bat_editor *editor, bat_id id) {
    return settled(editor, bat_layer_activate(&editor->context, id));
}

bat_status bat_editor_rename(bat_editor *editor, bat_id id, const char *name) {
    return settled(editor, bat_layer_rename(&editor->context, id, name));
}

bat_status bat_editor_set_state(bat_editor *editor, bat_id id, bool hidden, bool locked) {
    return settled(editor, bat_layer_set_state(&editor->context, id, hidden, locked));
}

bat_status bat_editor_select(bat_editor *editor, bat_id id, bool add) {
    return settled(editor, bat_choice_select(&editor->context, id, add));
}

const char *bat_editor_outline(bat_editor *editor, int first, int count) {
    return bat_panel_outline(&editor->context, first, count);
}

const char *bat_editor_unshown(bat_editor *editor) { return bat_panel_unshown(&editor->context); }

const char *bat_editor_holds(bat_editor *editor) { return bat_panel_holds(&editor->context); }

const char *bat_editor_outline_points(bat_editor *editor, bat_id id) {
    return bat_panel_points(&editor->context, id);
}

bat_status bat_editor_choose(bat_editor *editor, bat_id id, int point) {
    return settled(editor, bat_panel_choose(&editor->context, id, point));
}

const char *bat_editor_move(bat_editor *editor) { return bat_panel_move(&editor->context); }

bat_status bat_editor_seek(bat_editor *editor, double seconds) {
    return bat_panel_seek(&editor->context, seconds);
}

void bat_editor_play(bat_editor *editor, double time) { bat_panel_play(&editor->context, time); }

bat_status bat_editor_move_set(bat_editor *editor, bat_move_act act, bool path, int level, double value,
                               bool done) {
    return settled(editor, bat_move_set(&editor->context, act, path, level, value, done));
}

bat_status bat_editor_retime(bat_editor *editor, size_t count, const double *points, bool done) {
    return settled(editor, bat_move_retime(&editor->context, count, points, done));
}

bat_status bat_editor_correct(bat_editor *editor, bat_correction kind, const double size[2],
                              const double from[2], const double to[2], bool done) {
    return settled(editor, bat_correct(&editor->context, kind, size, from, to, done));
}

const char *bat_editor_said(bat_editor *editor) { return bat_panel_said(&editor->context); }

bat_status bat_editor_add_picture(bat_editor *editor, const void *bytes, size_t size, const char *name) {
    if (!face_on(&editor->context)) return BAT_STATE;
    return settled(editor, bat_picture_place(&editor->context, bytes, size, name));
}

const char *bat_editor_writing(bat_editor *editor) { return bat_panel_writing(&editor->context); }

const char *bat_editor_texts(bat_editor *editor) { return bat_panel_texts(&editor->context); }

bat_status bat_editor_write(bat_editor *editor, const char *json, size_t size, bat_problem *problem) {
    if (!editor || !json) return BAT_ARGUMENT;
    if (!face_on(&editor->context)) return BAT_STATE;
    return settled(editor, bat_panel_write(&editor->context, json, size, problem));
}

const bat_picture *bat_editor_picture(const bat_editor *editor, uint32_t picture) {
    return bat_picture_shown(&editor->context, picture);
}

bat_status bat_editor_excerpt(const bat_editor *editor, bat_excerpt part, bat_document **out) {
    if (!editor || !out || (int)part < BAT_EXCERPT_PAGE || part > BAT_EXCERPT_SELECTION) return BAT_ARGUMENT;
    return bat_excerpt_make(&editor->context, part, out);
}

bat_status bat_editor_copy(bat_editor *editor, bool cut, char **text, size_t *size) {
    return settled(editor, bat_clipboard_copy(&editor->context, cut, text, size));
}

bat_status bat_editor_paste(bat_editor *editor, const bat_document *document, bool own) {
    if (!face_on(&editor->context)) return BAT_STATE;
    return settled(editor, bat_clipboard_paste(&editor->context, document, own));
}

const char *bat_editor_readings(bat_editor *editor) { return bat_panel_readings(&editor->context); }

bat_status bat_editor_refit(bat_editor *editor, double amount, bool done) {
    return settled(editor, bat_panel_refit(&editor->context, amount, done));
}

bat_status bat_editor_refit_other(bat_editor *editor, double amount, bool done) {
    return settled(editor, bat_panel_refit_other(&editor->context, amount, done));
}

bat_status bat_editor_read_as(bat_editor *editor, int reading) {
    return settled(editor, bat_panel_read_as(&editor->context, reading));
}

const char *bat_editor_levels(bat_editor *editor) { return bat_panel_levels(&editor->context); }

bat_status bat_editor_level(bat_editor *editor, bat_level_act act, int level, double value, bool done) {
    return settled(editor, bat_level_do(&editor->context, act, level, value, done));
}
