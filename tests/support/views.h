/* Seeded random views for tests of what is seen in space. */
#ifndef BATTEN_TESTS_VIEWS_H
#define BATTEN_TESTS_VIEWS_H

#include <batten/view.h>

#include "support/random_curve.h"

/* Looks from `distance` away, from a random side, at a target near `about`; every other number is parallel. */
static inline bat_viewpoint some_view(random_source *r, int number, const double about[3], double distance) {
    bat_viewpoint view = {.size = {800 + 10 * (number % 7), 600 - 10 * (number % 5)}};
    double way[3], length = 0;
    while (!(length > 0.1)) {
        for (int c = 0; c < 3; c++) way[c] = random_between(r, -1, 1);
        length = way[0] * way[0] + way[1] * way[1] + way[2] * way[2];
    }
    for (int c = 0; c < 3; c++) {
        view.target[c] = about[c] + 0.02 * distance * random_between(r, -1, 1);
        view.eye[c] = about[c] + distance * way[c] / sqrt(length);
        view.up[c] = random_between(r, -1, 1);
    }
    if (number % 2)
        view.fov = random_between(r, 10, 90);
    else
        view.height = distance * random_between(r, 0.5, 1.5);
    if (bat_viewpoint_check(&view, NULL) != BAT_OK) abort();
    return view;
}

#endif
