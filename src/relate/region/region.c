/* What is made of regions (docs/math/relate.md 6). */
#include "relate/region/arrangement.h"

#include <math.h>
#include <stdlib.h>

/* How near things are the same, as shares of the tolerance, in the order in which they are tried. */
static const double GAPS[] = {1.0 / 4, 1.0 / 64, 1.0 / 1024};
enum { TRIES = sizeof GAPS / sizeof *GAPS };

static void clear(bat_arrangement *a) {
    for (size_t i = 0; i < a->edge_count; i++) {
        bat_curve_free(a->edges[i].own);
        free(a->edges[i].bezier);
    }
    for (size_t i = 0; i < a->curve_count; i++) free(a->curves[i].cuts);
    free(a->curves), free(a->spots), free(a->node_of), free(a->nodes), free(a->edges);
}

/* The curves of all regions; those without extent bound nothing. */
static bat_status gather(bat_arrangement *a) {
    size_t room = 1;
    for (size_t k = 0; k < a->region_count; k++) {
        const bat_region *r = a->regions + k;
        if (r->count > 0 && !r->curves) return BAT_ARGUMENT;
        if (r->count > BAT_POINTS_MAX - room) return BAT_COUNT;
        room += r->count;
        for (size_t i = 0; i < r->count; i++) {
            if (!r->curves[i]) return BAT_ARGUMENT;
            if (bat_curve_dimension(r->curves[i]) != 2) return BAT_DIMENSION;
            if (!bat_curve_is_closed(r->curves[i])) return BAT_ARGUMENT;
        }
    }
    a->curves = calloc(room, sizeof *a->curves);
    if (!a->curves) return BAT_MEMORY;
    for (size_t k = 0; k < a->region_count; k++)
        for (size_t i = 0; i < a->regions[k].count; i++)
            a->curves[a->curve_count++] = (bat_cut_curve){.curve = a->regions[k].curves[i], .region = k};
    return BAT_OK;
}

bat_status bat_regions_combine(bat_region_operation operation, size_t region_count, const bat_region *regions,
                               double tolerance, size_t *count, bat_curve ***out) {
    if (!regions || region_count == 0 || !count || !out || !(tolerance > 0) ||
        tolerance > BAT_COORDINATE_MAX || (unsigned)operation >= BAT_REGION_OPERATION_COUNT)
        return BAT_ARGUMENT;
    if (region_count > BAT_POINTS_MAX) return BAT_COUNT;
    bat_status status = BAT_SINGULAR;
    for (int i = 0; i < TRIES && status == BAT_SINGULAR; i++) {
        bat_arrangement a = {.operation = operation,
                             .region_count = region_count,
                             .regions = regions,
                             .tolerance = tolerance,
                             .gap = GAPS[i] * tolerance};
        status = gather(&a);
        if (status == BAT_OK) status = bat_arrangement_cut(&a);
        if (status == BAT_OK) status = bat_arrangement_edges(&a);
        if (status == BAT_OK) status = bat_arrangement_judge(&a);
        if (status == BAT_OK) status = bat_arrangement_outline(&a, count, out);
        clear(&a);
    }
    return status;
}
