/* Inside: a spline's points, counted as everything inside is. */
#ifndef BATTEN_SRC_SPLINE_H
#define BATTEN_SRC_SPLINE_H

#include "base/count.h"
#include <batten/tangents.h>

static inline int bat_spline_count(const bat_spline *spline) { return bat_count_inside(spline->count); }

/* The options as this version has them, whatever the caller's; NULL: the defaults. */
bat_status bat_tangents_options_read(const bat_tangents_options *given, bat_tangents_options *own);

#endif
