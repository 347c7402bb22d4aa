/* What a pen's pressure counts as. */
#ifndef BATTEN_EDITOR_INPUT_PRESSURE_H
#define BATTEN_EDITOR_INPUT_PRESSURE_H

#include "editor/session/context.h"

/* As the property has it: of the reach, within 0.25 to 1. */
double bat_pressure(const bat_context *c, double pressure);
/* Of an event; 1 but for a pen that is down. */
double bat_pressure_of(const bat_context *c, const bat_pointer *event);

#endif
