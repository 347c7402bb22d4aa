#include "form/recipe/corners.h"
#include "base/vec.h"

#include <math.h>

enum { ORDERS = 6, TURNS = 8 };

/* Distances in the corners when the curves are these sides. */
static double gaps(vec ends[4][2], const int side[4], const bool turned[4], double *most) {
    /* side, end; side, end: the corners (0, 0), (1, 0), (0, 1), (1, 1) */
    static const int meet[4][4] = {{BAT_SIDE_V0, 0, BAT_SIDE_U0, 0},
                                   {BAT_SIDE_V0, 1, BAT_SIDE_U1, 0},
                                   {BAT_SIDE_V1, 0, BAT_SIDE_U0, 1},
                                   {BAT_SIDE_V1, 1, BAT_SIDE_U1, 1}};
    double sum = 0;
    *most = 0;
    for (int k = 0; k < 4; k++) {
        const int a = meet[k][0], b = meet[k][2];
        const double gap = vec_norm(
            vec_sub(ends[side[a]][meet[k][1] != turned[a]], ends[side[b]][meet[k][3] != turned[b]]));
        sum += gap;
        *most = fmax(*most, gap);
    }
    return sum;
}

bat_status bat_recipe_meet(const bat_curve *const curves[4], bat_recipe_corners *out) {
    static const int orders[ORDERS][3] = {{1, 2, 3}, {1, 3, 2}, {2, 1, 3}, {2, 3, 1}, {3, 1, 2}, {3, 2, 1}};
    vec ends[4][2];
    double least = INFINITY;
    for (int i = 0; i < 4; i++) {
        double domain[2], point[BAT_DIMENSION_MAX];
        if (bat_curve_is_closed(curves[i])) return BAT_ARGUMENT;
        bat_curve_domain(curves[i], domain);
        for (int end = 0; end < 2; end++) {
            bat_curve_eval(curves[i], domain[end], 0, point);
            ends[i][end] = vec_load(point, bat_curve_dimension(curves[i]));
        }
    }
    for (int order = 0; order < ORDERS; order++)
        for (int turns = 0; turns < TURNS; turns++) {
            const int *rest = orders[order];
            bat_recipe_corners way = {
                {0, rest[0], rest[1], rest[2]}, {false, turns & 1, turns & 2, turns & 4}, 0};
            const double sum = gaps(ends, way.side, way.turned, &way.apart);
            if (!(sum < least * (1 - 1e-9)) && least < INFINITY) continue;
            least = sum;
            *out = way;
        }
    return BAT_OK;
}
