/* The known distance between the span tool's two points: setting it scales the pictures about the first point. */
#ifndef BATTEN_EDITOR_TOOLS_SPAN_H
#define BATTEN_EDITOR_TOOLS_SPAN_H

#include "editor/session/context.h"

bat_status bat_span_set(bat_context *c, double value); /* BAT_STATE: there are no two points */
double bat_span_value(const bat_context *c);           /* document units; 0: none yet */

#endif
