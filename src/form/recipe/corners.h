/* Internal: how four curves go round a patch. */
#ifndef BATTEN_FORM_RECIPE_CORNERS_H
#define BATTEN_FORM_RECIPE_CORNERS_H

#include <batten/recipe.h>

typedef struct bat_recipe_corners {
    int side[4];    /* by bat_side: which of the curves it is */
    bool turned[4]; /* and whether it runs the other way */
    double apart;   /* the greatest distance of two ends in a corner */
} bat_recipe_corners;

/* Of all ways the one with the least sum of distances in the corners; the first curve stays the side at v = 0.
 * BAT_ARGUMENT: a curve is closed. */
bat_status bat_recipe_meet(const bat_curve *const curves[4], bat_recipe_corners *out);

#endif
