#include "editor/edit/dashes.h"

#include <batten/paint.h>

#include <math.h>
#include <string.h>

enum { PATTERN = 4 };

/* Lengths and gaps in widths of the stroke; with butt caps a dot is as long as it is wide. */
static const struct {
    size_t count;
    double round[PATTERN], butt[PATTERN];
} patterns[] = {[BAT_DASHING_DASHED] = {2, {3, 3}, {4, 2}},
                [BAT_DASHING_DOTTED] = {2, {0, 2}, {1, 1}},
                [BAT_DASHING_DASH_DOT] = {4, {3, 2.5, 0, 2.5}, {4, 2, 1, 2}}};

static const double SAME = 1e-9; /* of the width */

static size_t pattern(const bat_object *object, bat_dashing dashing, double *out) {
    const bat_style *style = bat_object_style(object);
    for (size_t i = 0; i < patterns[dashing].count; i++)
        out[i] = style->width *
                 (style->cap == BAT_CAP_BUTT ? patterns[dashing].butt[i] : patterns[dashing].round[i]);
    return patterns[dashing].count;
}

bat_dashing bat_dashing_of(const bat_object *object) {
    const bat_paint *paint = bat_object_paint(object);
    if (!paint || !paint->dash_count) return BAT_DASHING_SOLID;
    const double width = bat_object_style(object)->width;
    for (int d = BAT_DASHING_DASHED; d < BAT_DASHING_OTHER; d++) {
        double dashes[PATTERN];
        bool same = pattern(object, (bat_dashing)d, dashes) == paint->dash_count;
        for (size_t i = 0; i < paint->dash_count && same; i++)
            same = fabs(dashes[i] - paint->dashes[i]) <= SAME * width;
        if (same) return (bat_dashing)d;
    }
    return BAT_DASHING_OTHER;
}

bat_status bat_dashing_give(const bat_object *object, bat_dashing dashing, bat_object **out) {
    const bat_paint *before = bat_object_paint(object);
    bat_paint paint = {0};
    double dashes[PATTERN];
    if (before) paint = *before;
    if (dashing != BAT_DASHING_OTHER) {
        paint.dash_count = dashing == BAT_DASHING_SOLID ? 0 : pattern(object, dashing, dashes);
        paint.dashes = dashes;
        paint.dash_offset = 0;
    }
    if (!paint.dash_count) paint.dashes = NULL;
    return bat_object_with_paint(object, &paint, out);
}
