#include "form/wire/stops.h"

#include <math.h>
#include <string.h>

static const double NEAR = 0.03; /* stops are at least so far apart, and from the ends of open wires */

static double value_at(const bat_function *f, double at) {
    double jet[3];
    bat_function_eval(f, at, jet);
    return jet[0];
}

/* Whether it has a knot twice at each of the inner stops, and nowhere else. */
static bool read_stops(const bat_curve *curve, bat_stops *stops) {
    const int count = bat_curve_knot_count(curve);
    const double *knots = bat_curve_knots(curve);
    if (bat_curve_degree(curve) != 3 || bat_curve_is_closed(curve) || count < 8 || count % 2) return false;
    for (int i = 4; i + 4 < count; i += 2) {
        if (knots[i] != knots[i + 1] || stops->count == BAT_WIRE_STOPS) return false;
        if (knots[i] <= knots[i - 1] || knots[i] >= 1) return false;
        stops->at[stops->count++] = knots[i];
    }
    return true;
}

bat_stops bat_stops_of(const bat_function *radius, bool closed) {
    bat_stops stops = {.count = closed};
    if (!radius->curve || !read_stops(radius->curve, &stops) || stops.count == 0)
        stops = (bat_stops){.count = 2, .at = {closed ? 0 : 0.25, closed ? 0.5 : 0.75}};
    for (int i = 0; i < stops.count; i++) stops.radius[i] = value_at(radius, stops.at[i]);
    return stops;
}

bat_status bat_stops_function(const bat_stops *stops, bool closed, bat_function *out) {
    double points[4 * (BAT_WIRE_STOPS + 2)] = {0}, knots[2 * BAT_WIRE_STOPS + 8];
    const int first = closed, last = stops->count - 1;
    int n = 0, k = 0;
    bool even = true;
    for (int i = 0; i < stops->count; i++) {
        if (!(stops->radius[i] > 0)) return BAT_PARAMETER;
        even = even && stops->radius[i] == stops->radius[0];
    }
    *out = bat_function_of(stops->radius[0]);
    if (even) return BAT_OK;
    for (int i = 0; i < 4; i++) knots[k++] = 0;
    for (int i = 0; i < 2; i++) points[2 * n++] = stops->radius[0];
    for (int i = first; i <= last; i++)
        for (int twice = 0; twice < 2; twice++) knots[k++] = stops->at[i], points[2 * n++] = stops->radius[i];
    for (int i = 0; i < 2; i++) points[2 * n++] = stops->radius[closed ? 0 : last];
    for (int i = 0; i < 4; i++) knots[k++] = 1;
    return bat_curve_create(2, 3, false, (size_t)n, points, k, knots, &out->curve);
}

int bat_stops_add(bat_stops *stops, const bat_function *radius, double at) {
    int i = 0;
    if (stops->count == BAT_WIRE_STOPS || !(at > NEAR && at < 1 - NEAR)) return -1;
    while (i < stops->count && stops->at[i] < at) i++;
    if ((i > 0 && at - stops->at[i - 1] < NEAR) || (i < stops->count && stops->at[i] - at < NEAR)) return -1;
    const size_t after = (size_t)(stops->count - i);
    memmove(stops->at + i + 1, stops->at + i, after * sizeof *stops->at);
    memmove(stops->radius + i + 1, stops->radius + i, after * sizeof *stops->radius);
    stops->at[i] = at, stops->radius[i] = value_at(radius, at);
    stops->count++;
    return i;
}
