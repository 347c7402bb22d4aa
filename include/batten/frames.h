/*
 * Batten: frames along a curve. Rotation-minimising by double reflection (Wang et al. 2008), Frenet, or
 * fixed. Columns [t s r], right-handed, r = t x s; points and vectors have three coordinates, also for planar
 * curves, whose frames are t = (tx, ty, 0), s = (-ty, tx, 0), r = (0, 0, 1). Source: multilevel-2016 3.2;
 * math 2.
 */
#ifndef BATTEN_FRAMES_H
#define BATTEN_FRAMES_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum bat_frame_rule {
    BAT_FRAMES_RMF,
    BAT_FRAMES_FRENET, /* keeps the last normal where the curvature vanishes, and flips after inflections */
    BAT_FRAMES_FIXED   /* the world's axes everywhere */
} bat_frame_rule;

typedef struct bat_frame_options {
    size_t size; /* of this struct, as base.h says */
    bat_frame_rule rule;
    int substeps; /* least number of steps of the chain per span; 0: 8, more where it turns by over 30 degrees */
    bool has_first; /* first: s at the start, projected on the normal plane there */
    double first[3];
    bool has_reference;    /* the persistent pair (math 2.2): s(0) is ref_s turned by the least rotation */
    double reference_t[3]; /* that takes ref_t to t(0). Goes before `first` */
    double reference_s[3];
    double holonomy_near; /* closed curves: of all angles that differ by whole turns, take the one nearest to
                           * it, so that a loop that is being edited never jumps past +-pi (math 2.3); 0 by
                           * default */
} bat_frame_options;

typedef struct bat_frame3 {
    double u;
    double point[3], t[3], s[3], r[3];
} bat_frame3;

/* The defaults: RMF, 8 steps per span, an arbitrary first normal. */
BAT_API void bat_frame_options_init(bat_frame_options *options, size_t size);
static inline bat_frame_options bat_frame_defaults(void) {
    bat_frame_options options;
    bat_frame_options_init(&options, sizeof options);
    return options;
}

/*
 * options may be NULL: the defaults, here and below. Frames at count parameters in any order (closed curves: any
 * period; open: clamped). A frame depends on the curve and the options alone, not on which other frames are asked
 * for. *holonomy (may be NULL): on closed curves the angle from s(0) to s after it has been transported once round,
 * signed about t(0), in (-pi, pi], before it is distributed over the curve by arc length (math 2.3); 0 on open ones.
 * Never NaN for a valid curve. Cost: spans * substeps + count.
 */
BAT_API bat_status bat_frames(const bat_curve *curve, size_t count, const double *u,
                              const bat_frame_options *options, bat_frame3 *out, double *holonomy);

/*
 * The same chain, kept for further use: it is built once in O(spans * substeps), and then gives any frame in O(log
 * spans), for animation, levels and sweeps. Copies what it needs of the curve.
 */
typedef struct bat_frame_chain bat_frame_chain;
BAT_API bat_status bat_frame_chain_create(const bat_curve *curve, const bat_frame_options *options,
                                          bat_frame_chain **out);
BAT_API void bat_frame_chain_free(bat_frame_chain *chain); /* NULL is fine */
BAT_API void bat_frame_chain_at(const bat_frame_chain *chain, double u, bat_frame3 *out);
/* Many frames at once, into arrays of count * 3; NULL: not wanted. Parameters may be in any order; ascending ones
 * cost the least, some nanoseconds each, since the steps do not wait for one another (math 2.4). The result has
 * the same bits as frames taken one at a time. BAT_NUMBER: a parameter is not finite. */
typedef struct bat_frame_arrays {
    double *point, *t, *s, *r;
} bat_frame_arrays;
BAT_API bat_status bat_frame_chain_many(const bat_frame_chain *chain, size_t count, const double *u,
                                        const bat_frame_arrays *out);
BAT_API double bat_frame_chain_holonomy(const bat_frame_chain *chain);
/*
 * For animation: turns options into those of the next image. The persistent pair becomes this chain's first frame, so
 * that the next curve's s(0) is turned from it by the least rotation; and the angle of a loop is followed past +-pi.
 * As long as the start tangent turns by less than half a turn from one image to the next, frames never jump.
 */
BAT_API void bat_frame_chain_follow(const bat_frame_chain *chain, bat_frame_options *options);

#ifdef __cplusplus
}
#endif
#endif
