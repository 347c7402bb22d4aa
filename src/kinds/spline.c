#include "kinds/spline.h"

#include "document/digest.h"

#include <stdlib.h>
#include <string.h>

static bool zero(const double *v, int size) {
    for (int d = 0; d < size; d++)
        if (v[d] != 0) return false;
    return true;
}

static bat_kept_spline *copy(const bat_spline *spline, const bat_tangents_options *options) {
    size_t count = (size_t)spline->count, size = count * (size_t)spline->dimension;
    bat_kept_spline *kept = malloc(sizeof *kept + (2 * size + 2 * count) * sizeof(double));
    if (!kept) return NULL;
    double *points = (double *)(void *)(kept + 1), *tangents = points + size, *tension = tangents + size;
    memcpy(points, spline->points, size * sizeof(double));
    for (int i = 0; i < spline->count; i++) {
        int at = i * spline->dimension;
        bool given = spline->tangents && !zero(spline->tangents + at, spline->dimension);
        for (int d = 0; d < spline->dimension; d++) tangents[at + d] = given ? spline->tangents[at + d] : 0;
    }
    for (size_t i = 0; i < 2 * count; i++) tension[i] = spline->tension ? spline->tension[i] : 1;
    *kept = (bat_kept_spline){BAT_USERS_ONE, *spline, options ? *options : bat_tangents_defaults()};
    kept->spline.points = points;
    kept->spline.tangents = tangents;
    kept->spline.tension = tension;
    return kept;
}

bat_status bat_kept_spline_create(const bat_spline *spline, const bat_tangents_options *options,
                                  bat_kept_spline **out, bat_curve **curve) {
    /* First the check of everything, so that the copy can trust counts and pointers. */
    bat_status status = bat_tangents(spline, options, NULL, NULL, NULL, NULL);
    if (status != BAT_OK) return status;
    bat_kept_spline *kept = copy(spline, options);
    if (!kept) return BAT_MEMORY;
    status = bat_tangents(&kept->spline, &kept->options, NULL, NULL, NULL, curve);
    if (status == BAT_OK)
        *out = kept;
    else
        free(kept);
    return status;
}

void bat_kept_spline_release(bat_kept_spline *kept) {
    if (kept && bat_users_drop(&kept->users)) free(kept);
}

uint64_t bat_kept_spline_digest(uint64_t digest, const bat_kept_spline *kept) {
    const bat_spline *s = &kept->spline;
    size_t count = (size_t)s->count, size = count * (size_t)s->dimension;
    digest = bat_digest_number(digest, (uint64_t)kept->options.mode);
    digest = bat_digest_number(digest, (uint64_t)kept->options.missing);
    digest = bat_digest_number(digest, s->closed);
    digest = bat_digest_number(digest, (uint64_t)s->dimension);
    digest = bat_digest_number(digest, count);
    for (size_t i = 0; i < size; i++) digest = bat_digest_double(digest, s->points[i]);
    for (size_t i = 0; i < size; i++) digest = bat_digest_double(digest, s->tangents[i]);
    for (size_t i = 0; i < 2 * count; i++) digest = bat_digest_double(digest, s->tension[i]);
    return digest;
}

const char *bat_kept_spline_check(const bat_kept_spline *kept, const bat_curve *curve) {
    bat_curve *again = NULL;
    bat_status status = bat_tangents(&kept->spline, &kept->options, NULL, NULL, NULL, &again);
    if (status == BAT_MEMORY) return NULL;
    if (status != BAT_OK) return "a spline is not valid";
    bool same = bat_curve_equal(curve, again);
    bat_curve_free(again);
    return same ? NULL : "the curve of a spline is not the one its points give";
}
