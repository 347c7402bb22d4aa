/*
 * Binding what is selected to wires. What is bound: the selected surfaces and meshes, and what selected groups hold; the wires
 * are the other selected curves, one an object. Where only curves are selected, the one drawn last is the wire.
 */
#ifndef BATTEN_EDITOR_EDIT_BINDING_H
#define BATTEN_EDITOR_EDIT_BINDING_H

#include "editor/session/context.h"

#include <batten/document.h>

/* Whether the selection can be bound. */
bool bat_bind_fits(const bat_context *c);
/* Binds it, as one step. What is bound already keeps the wires it has. The radius is a quarter of a wire's size; where the
 * control points of a surface are too far apart for that, it is refined first. BAT_STATE: it does not fit. Tells what there is
 * to be told. */
bat_status bat_bind_selection(bat_context *c);
/* Whether something selected is bound, or is a wire; all that is, or that hangs on it, becomes free, as one step: as it is, or
 * (revert) as it was. */
bool bat_bind_can_free(const bat_context *c);
bat_status bat_bind_free(bat_context *c, bool revert);

#endif
