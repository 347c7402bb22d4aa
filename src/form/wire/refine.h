/* A surface whose control points are too far apart to show what a wire does. */
#ifndef BATTEN_FORM_WIRE_REFINE_H
#define BATTEN_FORM_WIRE_REFINE_H

#include <batten/surface.h>
#include <batten/wires.h>

enum { BAT_REFINE_MOST = 1 << 16 }; /* control points of what comes out, at most */

/* The same surface with knots put in where a wire reaches and a span is longer than two thirds of the radius there, so that none
 * is: what lies on the wire then follows it by three quarters at least (docs/math/surfaces.md). *out NULL with BAT_OK: none is,
 * or BAT_REFINE_MOST would be passed. O(points of the result + samples of the wire). */
bat_status bat_wire_refine(const bat_surface *surface, const bat_wire *wire, bat_surface **out);

#endif
