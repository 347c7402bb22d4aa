#include "editor/input/double_tap.h"

#include "base/real.h"

static const double SOON = 400, NEAR = 8; /* ms, px */

bool bat_double_tap_ends(bat_double_tap *last, const bat_pointer *event) {
    const bool twice = last->first && event->time - last->time <= SOON &&
                       bat_hypot(event->x - last->at[0], event->y - last->at[1]) <= NEAR;
    *last = (bat_double_tap){.first = !twice, .at = {event->x, event->y}, .time = event->time};
    return twice;
}
