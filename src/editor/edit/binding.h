/*
 * Binding what is selected to wires. What is bound: the selected surfaces and meshes, and what selected groups hold; the wires
 * are the other selected curves, one an object. Where only curves are selected, the one drawn last is the wire.
 */
#ifndef BATTEN_EDITOR_EDIT_BINDING_H
#define BATTEN_EDITOR_EDIT_BINDING_H

#include "editor/session/context.h"

#include <batten/document.h>
#include <batten/function.h>

/* Whether the selection can be bound. */
bool bat_bind_fits(const bat_context *c);
/* Binds it, as one step. What is bound already keeps the wires it has. The radius is a quarter of a wire's size. A surface
 * that is too coarse to show it gets knots within reach (form/wire/refine.h). What moves are its control points; the notice says
 * how many, and of how many if they have become more. BAT_STATE: it does not fit. Tells what there is to be told. */
bat_status bat_bind_selection(bat_context *c);
/* Within an open transaction: binds the object at index to the first curve of another, too. */
bat_status bat_bind_to(bat_context *c, int index, bat_id curve);
/* Whether something selected is bound, or is a wire; all that is, or that hangs on it, becomes free, as one step: as it is, or
 * (revert) as it was. */
bool bat_bind_can_free(const bat_context *c);
bat_status bat_bind_free(bat_context *c, bool revert);

/* Within an open transaction: everything that is bound to the curve gets that radius, copied. */
bat_status bat_bind_put_radius(bat_context *c, bat_id curve, const bat_function *radius);
/* The radius at the first or (end) the last stop of the one wire that is selected, form/wire/stops.h; false: it is none. Setting
 * it is one step. BAT_NUMBER: it has to be above 0. */
bool bat_bind_radius(const bat_context *c, bool end, double *value);
bat_status bat_bind_set_radius(bat_context *c, bool end, double value);
/* Whether a wire is selected, and either one more curve, which is to bound its reach, or none, and it has one that is to go; does
 * it, as one step. */
bool bat_bind_has_domain(const bat_context *c);
bat_status bat_bind_domain(bat_context *c);
/* Whether one wire is selected, and whether it turns by frames; switching that is one step. */
bool bat_bind_turns(const bat_context *c, bool *by_frames);
bat_status bat_bind_switch_turn(bat_context *c);

#endif
