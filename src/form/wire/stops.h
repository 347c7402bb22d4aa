/* The radius of a wire as a few places along it, each with a radius; between two it goes smoothly from one to the other. */
#ifndef BATTEN_FORM_WIRE_STOPS_H
#define BATTEN_FORM_WIRE_STOPS_H

#include <batten/function.h>

enum { BAT_WIRE_STOPS = 8 };

typedef struct bat_stops {
    int count;
    double at
        [BAT_WIRE_STOPS]; /* ascending, 0 to 1: open wires: between; closed: the first is 0, which is 1, too */
    double radius[BAT_WIRE_STOPS];
} bat_stops;

/* A number has two stops, at a quarter and three quarters (closed: at 0 and a half); what bat_stops_function has made has those
 * that it was made of, any other function those of a number with its values there. */
bat_stops bat_stops_of(const bat_function *radius, bool closed);
/* A cubic that is level at each stop and never leaves the range of the two around it; with one radius, a number. BAT_PARAMETER:
 * a radius that is not above 0. Free with bat_function_clear. */
bat_status bat_stops_function(const bat_stops *stops, bool closed, bat_function *out);
/* Adds a stop with the radius that the function has there; returns its index, -1: there is no room, or one is too near. */
int bat_stops_add(bat_stops *stops, const bat_function *radius, double at);

#endif
