/* Turns by frames: how the neighbourhood of a wire is turned at each place when its rotation-minimising frames are compared
 * with those of its reference (docs/math/surfaces.md). */
#ifndef BATTEN_FORM_WIRE_TURNER_H
#define BATTEN_FORM_WIRE_TURNER_H

#include "base/quat.h"

#include <batten/frames.h>

/* The frames of a reference, and at each place that was asked for the rotation from the world's axes to them. */
typedef struct bat_wire_frames {
    bat_frame_chain *chain;
    int substeps;
    quat *at;
} bat_wire_frames;

/* For count parameters, at[stride bytes apart]. The reference has points in space. BAT_MEMORY. */
bat_status bat_wire_frames_begin(const bat_curve *reference, size_t count, const void *at, size_t stride,
                                 bat_wire_frames *out);
void bat_wire_frames_end(bat_wire_frames *frames);

/* From a reference to what it has become. */
typedef struct bat_turner {
    bat_frame_chain *chain; /* of the wire */
    double cosine, sine;    /* by this its frames are turned about their tangents */
    double start, step;     /* of the parameters of signs */
    size_t count;
    quat *signs; /* the rotation at even places, each on the side of its neighbours */
} bat_turner;

/* The first pair of frames is joined by the rotation that fits the reference to the wire best: over the whole wire the frames
 * are as close to it as one angle about the tangents can make them. O(knots). */
bat_status bat_turner_begin(const bat_curve *reference, const bat_wire_frames *frames, const bat_curve *wire,
                            bat_turner *out);
void bat_turner_end(bat_turner *turner);

enum { BAT_TURNER_BATCH = 64 };
/* Rotation vectors from the reference's frames, given as rotations, to the wire's at those parameters; at most a batch.
 * They change steadily along the wire, so they may be longer than half a turn. */
void bat_turner_at(const bat_turner *turner, int count, const double *u, const quat *from, vec *out);

/* The rotation that takes count points a, less their mean, closest to b less theirs: of several the least one. O(count). */
quat bat_rigid_fit(size_t count, const vec *a, const vec *b);

#endif
