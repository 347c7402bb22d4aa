/*
 * Batten: recipes. How a surface is made from curves as they were drawn: which way round they run and where closed ones
 * begin does not matter, and a profile need not stand on its path. A document's surface that has a recipe follows its
 * curves (document.h). Curves have 2 (z = 0) or 3 coordinates. Source: docs/math/surfaces.md, "Surfaces from curves as
 * they were drawn".
 */
#ifndef BATTEN_RECIPE_H
#define BATTEN_RECIPE_H

#include <batten/sweep.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum bat_recipe_kind {
    BAT_RECIPE_SWEEP = 1,   /* the path, the profile */
    BAT_RECIPE_RULED = 2,   /* two curves, both open or both closed */
    BAT_RECIPE_REVOLVE = 3, /* the profile, and a curve through whose ends the axis goes */
    BAT_RECIPE_COONS = 4,   /* four open curves in any order */
    BAT_RECIPE_LOFT = 5     /* sections, in their order, all open or all closed */
} bat_recipe_kind;

/* How the plane of a sweep's profile meets the path. */
typedef enum bat_recipe_stand {
    BAT_STAND_LYING,  /* drawn flat: y goes along the normal of the profile's plane, x across the path */
    BAT_STAND_ACROSS, /* turned by the least rotation into the plane across the path's start */
    BAT_STAND_IN_PLACE, /* the same, and its place beside the path's start is kept; else the path runs through its middle */
    BAT_STAND_COUNT
} bat_recipe_stand;

enum { BAT_RECIPE_CURVES = 64 }; /* of a recipe, at most */
enum { BAT_RECIPE_FOLDS = 16 };  /* that are told where they lie */
#define BAT_RECIPE_TWIST 36000.0 /* degrees, at most */
#define BAT_RECIPE_SCALE 1000.0  /* at most */

typedef struct bat_recipe {
    bat_recipe_kind kind;
    bat_recipe_stand stand; /* of a sweep */
    double twist;           /* of a sweep: degrees by which the profile is turned at the end */
    double scale;           /* of a sweep: of the profile at the end, not negative; 1 at the start */
    double angle;           /* of a revolution: degrees, from -360 to 360, not 0 */
} bat_recipe;

/* No twist, scale 1, a full turn. */
static inline bat_recipe bat_recipe_of(bat_recipe_kind kind) {
    bat_recipe recipe = {kind, BAT_STAND_LYING, 0, 1, 360};
    return recipe;
}
/* BAT_ARGUMENT: no such kind or stand; BAT_COUNT: not that many curves; BAT_NUMBER: a number is out of range. problem
 * (may be NULL) says which. */
BAT_API bat_status bat_recipe_check(const bat_recipe *recipe, size_t count, bat_problem *problem);
/* How the profile of a sweep stands beside the path as they were drawn. */
BAT_API bat_recipe_stand bat_recipe_stands(const bat_curve *path, const bat_curve *profile);

typedef struct bat_recipe_report {
    double apart; /* of a Coons patch: the greatest distance of two ends that meet in a corner */
    size_t folds; /* of a sweep: the stretches of the path along which the surface is folded over */
    double
        folded[2 *
               BAT_RECIPE_FOLDS]; /* the first of them: from where to where, in the surface's u, ascending */
} bat_recipe_report;

/*
 * The surface. Sweeps and revolutions are within 1e-4 of the curves' size, the latter and 1e-7 of the distance from the axis. Open curves are turned round where the ends
 * of neighbours are then closer in sum; where closed ones begin, and which way they run, is chosen from 64 places each
 * so that the joins between neighbours have the least total length. Corners of a Coons patch meet in the middle however far
 * they are apart. report may be NULL. BAT_ARGUMENT: open curves where closed ones have to be, or the reverse;
 * BAT_UNSUPPORTED: a profile that lies in no plane, a path with a corner; BAT_SINGULAR: an axis or a path of no length, a profile
 * on its axis, two equal sections, a surface without extent; BAT_COUNT: over 4,194,304 points; BAT_TOLERANCE: a
 * sweep would need over 64 rows for each point of its path and 4096 more; else as the calls of
 * sweep.h. O(points of the result).
 */
BAT_API bat_status bat_recipe_surface(const bat_recipe *recipe, size_t count, const bat_curve *const *curves,
                                      bat_surface **out, bat_recipe_report *report);

#ifdef __cplusplus
}
#endif
#endif
