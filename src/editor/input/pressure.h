/* The effect of a pen's pressure. */
#ifndef BATTEN_EDITOR_INPUT_PRESSURE_H
#define BATTEN_EDITOR_INPUT_PRESSURE_H

#include "editor/session/context.h"

/* The share of the reach, 0.25 to 1, according to the property. */
double bat_pressure(const bat_context *c, double pressure);
/* The same for an event; 1 unless it is a pen that is down. */
double bat_pressure_of(const bat_context *c, const bat_pointer *event);

#endif
