/* Lengths in the unit in force, formatted for users and parsed as they write them. An inch has 96 px; how long a document
 * unit is, its scale says. */
#ifndef BATTEN_EDITOR_VIEW_UNIT_H
#define BATTEN_EDITOR_VIEW_UNIT_H

#include "editor/session/context.h"
#include <batten/editor.h>

enum { BAT_UNIT_ROOM = 32 };

/* Document units per unit in force. */
double bat_unit_size(const bat_context *c);
/* The value of the property in which a document of that unit is shown. */
int bat_unit_way(bat_unit unit);
/* px, mm or in: the unit in force. */
bat_unit bat_unit_in_force(const bat_context *c);
/* Whether lengths of a document in that unit are shown so: those in cm, pt and pc are shown in mm. */
bool bat_unit_is_shown_as(bat_unit unit, bat_unit shown);
/* Takes the unit in which the document says its size, if it is one of paper. */
void bat_unit_adopt(bat_context *c);
/* "12.5 mm": at most three decimals. */
void bat_unit_write(const bat_context *c, double length, char out[BAT_UNIT_ROOM]);
/* "0.0123 mm": three digits, however small. */
void bat_unit_about(const bat_context *c, double length, char out[BAT_UNIT_ROOM]);
/* A number with at most three decimals and no trailing zeros. */
void bat_unit_number(double value, char out[BAT_UNIT_ROOM]);
/*
 * Reads "12", "12mm", "1in + 3 mm", "(2 + 3) * 4,5": + - * / and parentheses over numbers with px, mm, cm, in, pt or pc;
 * a number without a unit is in the unit in force, or a factor. angle: plain numbers or degrees only. BAT_SYNTAX: not
 * such a text; BAT_NUMBER: not finite.
 */
bat_status bat_unit_read(const bat_context *c, const char *text, bool angle, double *value);
/* The point from which rulers and numbers count: the page's corner, or the document's origin. */
void bat_unit_origin(const bat_context *c, double origin[2]);

#endif
