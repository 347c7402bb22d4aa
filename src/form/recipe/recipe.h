/* Internal: the parts of making a surface by a recipe. */
#ifndef BATTEN_FORM_RECIPE_H
#define BATTEN_FORM_RECIPE_H

#include <batten/recipe.h>

enum { BAT_RECIPE_POINTS = 1 << 22 }; /* of a surface, at most */

bat_status bat_recipe_sweep(const bat_recipe *recipe, const bat_curve *path, const bat_curve *profile,
                            bat_surface **out, bat_recipe_report *report);
/* The curve, turned round, and, when it is closed, begun elsewhere, such that the joins to `before` are shortest. */
bat_status bat_recipe_align(const bat_curve *before, const bat_curve *curve, bat_curve **out);

#endif
