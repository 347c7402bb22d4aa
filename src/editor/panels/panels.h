/* The contents of the panels beside the drawing, as text that the host reads; each is made on request and kept until
 * the next one. */
#ifndef BATTEN_EDITOR_PANELS_PANELS_H
#define BATTEN_EDITOR_PANELS_PANELS_H

#include "editor/panels/in_words.h"
#include "editor/session/context.h"
#include "editor/view/unit.h"

typedef struct bat_panels {
    char *actions, *refused, *layers, *outline, *readings, *tables, *move, *mixed, *history, *colours, *view,
        *writing;
    char number_text[BAT_UNIT_ROOM]; /* the text returned by bat_panel_number */
    bat_told told;
} bat_panels;

void bat_panels_free(bat_panels *panels);
/* See the calls of the same names in the public header. */
const char *bat_panel_tables(bat_context *c);
const char *bat_panel_layers(bat_context *c);
const char *bat_panel_actions(bat_context *c);
const char *bat_panel_refused(bat_context *c);
const char *bat_panel_mixed(bat_context *c);
const char *bat_panel_colours(bat_context *c);
const char *bat_panel_history(bat_context *c);
const char *bat_panel_outline(bat_context *c, int first, int count);
const char *bat_panel_unshown(bat_context *c);
const char *bat_panel_holds(bat_context *c);
const char *bat_panel_points(bat_context *c, bat_id id);
bat_status bat_panel_choose(bat_context *c, bat_id id, int point);
const char *bat_panel_writing(bat_context *c);
const char *bat_panel_texts(bat_context *c);
bat_status bat_panel_write(bat_context *c, const char *json, size_t size, bat_problem *problem);
const char *bat_panel_said(bat_context *c);
bat_status bat_panel_enter(bat_context *c, const char *name, const char *text);
const char *bat_panel_number(bat_context *c, const char *name);
const char *bat_panel_levels(bat_context *c);
const char *bat_panel_readings(bat_context *c);
bat_status bat_panel_read_as(bat_context *c, int reading);
bat_status bat_panel_refit(bat_context *c, double amount, bool done);
bat_status bat_panel_refit_other(bat_context *c, double amount, bool done);
const char *bat_panel_move(bat_context *c);
bat_status bat_panel_seek(bat_context *c, double seconds);
void bat_panel_play(bat_context *c, double time);
bat_status bat_level_do(bat_context *c, bat_level_act act, int level, double value, bool done);

#endif
