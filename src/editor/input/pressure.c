/* The effect of a pen's pressure: it scales the reach of the smooth brush and of the eraser. */
#include "base/real.h"
#include "editor/input/pressure.h"
#include "editor/session/context.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include <math.h>

static const double LEAST = 0.25; /* share of the reach at the lightest touch */

double bat_pressure(const bat_context *c, double pressure) {
    if (c->settings->values[BAT_PROPERTY_PRESSURE] == 0 || isnan(pressure)) return 1;
    double p = fmin(fmax(pressure, 0), 1);
    if (p > 0) p = bat_exp(bat_log(p) * c->settings->values[BAT_PROPERTY_PRESSURE_CURVE]);
    return LEAST + (1 - LEAST) * p;
}

double bat_pressure_of(const bat_context *c, const bat_pointer *event) {
    bool pressed = event->phase == BAT_POINTER_DOWN || event->phase == BAT_POINTER_MOVE;
    return pressed && event->device == BAT_DEVICE_PEN ? bat_pressure(c, event->pressure) : 1;
}
