/*
 * Surfaces that are made from the selected curves, and follow them until they are free. What fits is found from the curves
 * alone: the user chooses curves, not roles.
 */
#ifndef BATTEN_EDITOR_EDIT_MAKING_H
#define BATTEN_EDITOR_EDIT_MAKING_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include <batten/recipe.h>

typedef enum bat_making_number { BAT_MAKING_TWIST, BAT_MAKING_SCALE, BAT_MAKING_ANGLE } bat_making_number;

/* Whether the selection, or all that is drawn where nothing is selected, is nothing but curves, one an object, of which such a
 * surface can be made. For Coons patches:
 * closing false: the corners meet, or are too far apart to be closed (the command then says so); true: they are near
 * enough. */
bool bat_making_fits(const bat_context *c, bat_recipe_kind kind, bool closing);
/* Whether a drawing has just a curve and, beside it, a straight line: the profile and the axis of a vase. */
bool bat_making_offers_revolving(const bat_context *c);
/* Makes it, as one step; it is then selected. BAT_STATE: it does not fit. Tells what there is to be told. */
bat_status bat_making_make(bat_context *c, bat_recipe_kind kind, bool closing);
/* Whether something selected follows its curves; frees all of it, as one step. */
bool bat_making_can_free(const bat_context *c);
bat_status bat_making_free(bat_context *c);
/* A number of the one surface that is selected; false: it has no such number. Degrees, or a factor. */
bool bat_making_get(const bat_context *c, bat_making_number which, double *value);
bat_status bat_making_set(bat_context *c, bat_making_number which, double value);

#endif
