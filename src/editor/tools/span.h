/* The distance of the span tool's two places, which the user knows: set, it scales the pictures about the first place. */
#ifndef BATTEN_EDITOR_TOOLS_SPAN_H
#define BATTEN_EDITOR_TOOLS_SPAN_H

#include "editor/session/context.h"

bat_status bat_span_set(bat_context *c, double value); /* BAT_STATE: there are no two places */
double bat_span_value(const bat_context *c);           /* document units; 0: none yet */

#endif
