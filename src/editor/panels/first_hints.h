/*
 * The first minute: a few short hints over a drawing, each gone for good once it has been followed. Progress is the
 * property "first-hints", which the host keeps; a hint followed out of order is remembered here until its turn.
 */
#ifndef BATTEN_EDITOR_PANELS_FIRST_HINTS_H
#define BATTEN_EDITOR_PANELS_FIRST_HINTS_H

#include "editor/session/context.h"
#include <batten/editor.h>

/* Bit i: hint i is to be shown. None over an empty drawing, where the page itself says what to do. */
uint32_t bat_first_shown(const bat_context *c);

#endif
