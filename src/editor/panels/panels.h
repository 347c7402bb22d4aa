/* What stands beside the drawing, as text that the host reads; each made when asked for, and kept until then. */
#ifndef BATTEN_EDITOR_PANELS_PANELS_H
#define BATTEN_EDITOR_PANELS_PANELS_H

#include "editor/panels/in_words.h"
#include "editor/session/context.h"
#include "editor/view/unit.h"

typedef struct bat_panels {
    char *actions, *layers, *outline, *readings, *tables;
    char number_text[BAT_UNIT_ROOM]; /* what bat_panel_number hands out */
    bat_told told;
} bat_panels;

void bat_panels_free(bat_panels *panels);
/* What the calls of the public header say, which have their names. */
const char *bat_panel_tables(bat_context *c);
const char *bat_panel_layers(bat_context *c);
const char *bat_panel_actions(bat_context *c);
const char *bat_panel_outline(bat_context *c, int first, int count);
const char *bat_panel_points(bat_context *c, bat_id id);
bat_status bat_panel_choose(bat_context *c, bat_id id, int point);
const char *bat_panel_said(bat_context *c);
bat_status bat_panel_enter(bat_context *c, const char *name, const char *text);
const char *bat_panel_number(bat_context *c, const char *name);
const char *bat_panel_levels(bat_context *c);
const char *bat_panel_readings(bat_context *c);
bat_status bat_panel_read_as(bat_context *c, int reading);
bat_status bat_panel_refit(bat_context *c, double amount, bool done);
bat_status bat_level_do(bat_context *c, bat_level_act act, int level, double value, bool done);

#endif
