/*
 * Batten: the width of a stroke as a curve along it: a profile, and the outline of what it draws.
 *
 * A profile gives shares of a nib's width at shares of the length of the curve. Between its stops it is the monotone
 * cubic of Fritsch and Carlson (1980): it has the values of the stops and one tangent at each, never leaves the values of
 * the two stops around it, and so is never negative. Before the first stop and behind the last it stays as it is there;
 * along a closed curve it runs on from the last stop to the first. Width is measured across the curve.
 */
#ifndef BATTEN_WIDTH_H
#define BATTEN_WIDTH_H

#include <batten/relate.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The most stops of a profile, and the greatest share of a nib's width at one. */
enum { BAT_WIDTHS_MAX = 256, BAT_WIDTH_SHARE_MAX = 1000 };

typedef struct bat_width_stop {
    double at;    /* 0..1: share of the curve's length */
    double share; /* of the nib's width, 0..BAT_WIDTH_SHARE_MAX */
} bat_width_stop;

typedef struct bat_width_profile {
    size_t count;                /* 0: the nib's width everywhere */
    const bat_width_stop *stops; /* borrowed; `at` ascends strictly */
} bat_width_profile;

/* BAT_COUNT: too many stops; BAT_ARGUMENT: there are none where the count says so; BAT_NUMBER: a number out of range, or
 * stops that do not ascend. problem (may be NULL) says which: "stops[2].at". */
BAT_API bat_status bat_width_check(const bat_width_profile *profile, bat_problem *problem);
/* The share at a place 0..1 (beyond: clamped) and its derivative by the place: out[2]. Programmer errors: a profile that is not
 * valid. O(count). */
BAT_API void bat_width_eval(const bat_width_profile *profile, bool closed, double at, double out[2]);
/* Whether it is the same everywhere, to the bit. */
BAT_API bool bat_width_is_even(const bat_width_profile *profile);

/* Edits of a list of *count stops with room for BAT_WIDTHS_MAX, which stays a profile: numbers are clamped to their ranges. */
/* A new stop, or the one that lies within `near` of `at` (the nearest), which takes the share but stays in its place.
 * Returns its index; -1: there is no room, or a number is not finite. */
BAT_API int bat_width_put(size_t *count, bat_width_stop *stops, double at, double share, double near);
/* Takes a stop to another place, between its neighbours, and share. BAT_ARGUMENT: no such stop; BAT_NUMBER: a number is not
 * finite. */
BAT_API bat_status bat_width_move(size_t count, bat_width_stop *stops, int index, double at, double share);
/* BAT_ARGUMENT: no such stop. */
BAT_API bat_status bat_width_remove(size_t *count, bat_width_stop *stops, int index);

/* The profile of a stretch of the curve, from..to (0 <= from < to <= 1), of a curve that runs the other way (from > to), or of
 * both. Stops at its ends, and those between; out has room for BAT_WIDTHS_MAX of them, of which the return value says how
 * many there are. */
BAT_API size_t bat_width_stretch(const bat_width_profile *profile, double from, double to,
                                 bat_width_stop *out);

/*
 * The outline of the stroke along a planar curve whose width is nib->width times the profile: closed curves as those of
 * bat_curve_outline, and the same where the profile is even and that finds them (nothing, where it is 0). The stroke is all that lies on the lines
 * across the curve, of that width and with their middles on it, with the joins of its corners and its caps, as long as the
 * width is there. tolerance, corner, *max_error (from the sides and caps), *count and *out as there, and so are the refusals.
 * Cost: that of bat_regions_combine. docs/math/relate.md 8.
 */
BAT_API bat_status bat_curve_outline_width(const bat_curve *curve, const bat_nib *nib,
                                           const bat_width_profile *profile, double tolerance, double corner,
                                           size_t *count, bat_curve ***out, double *max_error);
/*
 * The same for painting: closed chains of cubics which together cover the stroke where filled by the non-zero rule; they may
 * cross and lie over each other. Much faster. *points: *cubics * 8 numbers, ends repeated; where
 * a cubic does not start at the end of the one before, a chain begins. Both the caller's (bat_free). BAT_COUNT: over 2^18 cubics.
 */
BAT_API bat_status bat_curve_cover_width(const bat_curve *curve, const bat_nib *nib,
                                         const bat_width_profile *profile, double tolerance, double corner,
                                         size_t *cubics, double **points);

#ifdef __cplusplus
}
#endif
#endif
