/* A relief with u and v exchanged. The first axis of a frame becomes the second, the second the first, and the third points the
 * other way; so do details. */
#include "form/relief/relief.h"

#include <stdlib.h>

typedef struct turned {
    double *details;
    int *source;
} turned;

static bat_status turn(const bat_relief *relief, int level, turned *out) {
    const bat_surface *surface = bat_relief_surface(relief, level);
    const size_t rows = bat_surface_count(surface, BAT_U), columns = bat_surface_count(surface, BAT_V);
    const double *details = bat_relief_details(relief, level);
    const int *source = bat_relief_source(relief, level);
    out->details = malloc(3 * rows * columns * sizeof *out->details);
    out->source = malloc(rows * columns * sizeof *out->source);
    if (!out->details || !out->source) return BAT_MEMORY;
    for (size_t i = 0; i < rows; i++)
        for (size_t j = 0; j < columns; j++) {
            const size_t from = i * columns + j, to = j * rows + i;
            out->details[3 * to] = details[3 * from + 1];
            out->details[3 * to + 1] = details[3 * from];
            out->details[3 * to + 2] = -details[3 * from + 2];
            out->source[to] = source[from];
        }
    return BAT_OK;
}

static bat_status add_level(const bat_relief *relief, int level, bat_relief *to) {
    const bat_surface *surface = bat_relief_surface(relief, level);
    const int count[2] = {bat_surface_knot_count(surface, BAT_V), bat_surface_knot_count(surface, BAT_U)};
    turned now = {NULL, NULL};
    bat_status status = turn(relief, level, &now);
    if (status == BAT_OK)
        status = bat_relief_add_level(to, count, bat_surface_knots(surface, BAT_V),
                                      bat_surface_knots(surface, BAT_U), now.details, now.source);
    if (status == BAT_OK) status = bat_relief_set_gain(to, level, bat_relief_gain(relief, level));
    if (status == BAT_OK) status = bat_relief_set_muted(to, level, bat_relief_is_muted(relief, level));
    free(now.details);
    free(now.source);
    return status;
}

bat_status bat_relief_transpose(const bat_relief *relief, bat_relief **out) {
    bat_surface *base = NULL;
    bat_relief *made = NULL;
    bat_status status = bat_surface_transpose(bat_relief_surface(relief, 0), &base);
    if (status == BAT_OK) status = bat_relief_create(base, &made);
    for (int level = 1; level <= bat_relief_levels(relief) && status == BAT_OK; level++)
        status = add_level(relief, level, made);
    bat_surface_free(base);
    if (status == BAT_OK)
        *out = made;
    else
        bat_relief_free(made);
    return status;
}
