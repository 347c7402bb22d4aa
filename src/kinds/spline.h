/* Inside: a spline object made otherwise. */
#ifndef BATTEN_KINDS_SPLINE_H
#define BATTEN_KINDS_SPLINE_H

#include <batten/document.h>

/* The object with its spline made by another mode; its points, directions and tension stay. BAT_ARGUMENT: no spline. */
bat_status bat_object_with_spline_mode(const bat_object *object, bat_tangents_mode mode, bat_object **out);

#endif
