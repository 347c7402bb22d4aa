/* What is made of regions (docs/math/relate.md 6). */
#include "relate/offset.h"
#include "relate/region/grid.h"

#include <math.h>
#include <stdlib.h>

/* How near things are the same, as a share of the tolerance: where curves meet, and on the grid. */
static const double GAP = 1.0 / 4, GRID = 1.0 / 16;

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

/* Where rounding decides what the tolerance tells apart. */
static bool is_rounding(const bat_arrangement *a) {
    for (size_t i = 0; i < a->curve_count; i++)
        if (bat_offset_is_rounding(a->curves[i].curve, 0, a->tolerance)) return true;
    return false;
}

static bat_status decide_by_curves(bat_arrangement *a) {
    a->gap = GAP * a->tolerance;
    bat_status status = bat_arrangement_cut(a);
    if (status == BAT_OK) status = bat_arrangement_edges(a);
    return status == BAT_OK ? bat_arrangement_judge(a) : status;
}

static bat_status decide_on_grid(bat_arrangement *a) {
    a->gap = GRID * a->tolerance;
    const bat_status status = bat_arrangement_grid(a);
    return status == BAT_OK ? bat_arrangement_faces(a) : status;
}

/* What is asked for, decided in one of these ways. */
static bat_status combine(bat_arrangement asked, bat_status (*decide)(bat_arrangement *a), size_t *count,
                          bat_curve ***out) {
    bat_status status = gather(&asked);
    if (status == BAT_OK && is_rounding(&asked)) status = BAT_TOLERANCE;
    if (status == BAT_OK) status = decide(&asked);
    if (status == BAT_OK) status = bat_arrangement_outline(&asked, count, out);
    clear(&asked);
    return status;
}

bat_status bat_regions_combine_on_grid(size_t count, const bat_region *regions, double tolerance,
                                       size_t *made, bat_curve ***out) {
    return combine(
        (bat_arrangement){
            .operation = BAT_REGION_UNION, .region_count = count, .regions = regions, .tolerance = tolerance},
        decide_on_grid, made, out);
}

bat_status bat_regions_combine(bat_region_operation operation, size_t region_count, const bat_region *regions,
                               double tolerance, size_t *count, bat_curve ***out) {
    if (!regions || region_count == 0 || !count || !out || !(tolerance > 0) ||
        tolerance > BAT_COORDINATE_MAX || (unsigned)operation >= BAT_REGION_OPERATION_COUNT)
        return BAT_ARGUMENT;
    if (region_count > BAT_POINTS_MAX) return BAT_COUNT;
    const bat_arrangement asked = {
        .operation = operation, .region_count = region_count, .regions = regions, .tolerance = tolerance};
    const bat_status status = combine(asked, decide_by_curves, count, out);
    return status == BAT_SINGULAR || status == BAT_KNOTS ? combine(asked, decide_on_grid, count, out)
                                                         : status;
}
