/* Triangles of a surface as buffers; where a stroke moves it, only its rows or columns are made anew. */
#include "editor/scene/solid.h"
#include "form/shade/curving.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TRIANGLES_MAX = 300000, COARSER = 3 /* buffers stay while the view goes away, up to 2^COARSER */ };

static const double chord = 0.1;                    /* view pixels */
static const double angle = 0.1, fine_angle = 0.05; /* radians; fine: reflections show more */

void bat_solid_clear(bat_solid *solid) {
    bat_tessellation_free(solid->mesh);
    free(solid->corners), free(solid->points);
    *solid = (bat_solid){.version = 0};
}

void bat_solid_free(bat_solid *solid) {
    if (solid) bat_solid_clear(solid);
    free(solid);
}

void bat_space_free(bat_space_kept *kept) {
    if (!kept) return;
    free(kept->items);
    free(kept);
}

/* Whether buffers made for `was` serve for `grain`, too. */
static bool serves(const bat_grain *was, const bat_grain *grain, bool surface) {
    return was->scale >= grain->scale && was->scale <= grain->scale + COARSER &&
           (!surface || was->look == grain->look) && was->origin[0] == grain->origin[0] &&
           was->origin[1] == grain->origin[1] && was->origin[2] == grain->origin[2];
}

static void fill(bat_solid *s, const bat_surface *surface) {
    bat_mesh mesh;
    bat_tessellation_mesh(s->mesh, &mesh);
    for (size_t i = s->moved[0]; i < s->moved[1]; i++)
        for (size_t j = s->moved[2]; j < s->moved[3]; j++) {
            const size_t k = i * mesh.columns + j;
            float *to = s->corners + BAT_SOLID_CORNER * k;
            for (int d = 0; d < 3; d++) {
                to[d] = (float)(mesh.points[3 * k + (size_t)d] - s->grain.origin[d]);
                to[3 + d] = (float)mesh.normals[3 * k + (size_t)d];
            }
            to[6] = (float)bat_curving_value(surface, &mesh, i, j, s->grain.look);
        }
}

static bat_status make_triangles(bat_solid *s, const bat_surface *surface) {
    bat_tessellate_options options = bat_tessellate_defaults();
    bat_mesh mesh;
    options.tolerance = ldexp(chord, -s->grain.scale);
    options.angle = s->grain.look == BAT_LOOK_ZEBRA ? fine_angle : angle;
    options.triangles_max = TRIANGLES_MAX;
    bat_status status = bat_surface_tessellate(surface, &options, &s->mesh, NULL);
    if (status != BAT_OK) return status;
    bat_tessellation_mesh(s->mesh, &mesh);
    s->corners = malloc(mesh.rows * mesh.columns * BAT_SOLID_CORNER * sizeof *s->corners);
    if (!s->corners) return BAT_MEMORY;
    s->moved[1] = (uint32_t)mesh.rows, s->moved[3] = (uint32_t)mesh.columns;
    fill(s, surface);
    return BAT_OK;
}

/* Moves the triangles to a surface that differs only there. */
static bat_status move_triangles(bat_solid *s, const bat_surface *surface, bat_direction direction,
                                 const double differs[2]) {
    bat_mesh mesh;
    size_t range[2];
    bat_status status = bat_tessellation_update(s->mesh, surface, direction, differs, range);
    if (status != BAT_OK) return status;
    bat_tessellation_mesh(s->mesh, &mesh);
    const size_t n = mesh.columns, end = range[1] ? range[1] - 1 : 0;
    memset(s->moved, 0, sizeof s->moved);
    if (range[0] < range[1]) {
        s->moved[0] = (uint32_t)(range[0] / n), s->moved[1] = (uint32_t)(end / n + 1);
        s->moved[2] = (uint32_t)(range[0] % n), s->moved[3] = (uint32_t)(end % n + 1);
    }
    fill(s, surface);
    return BAT_OK;
}

/* Puts a guise on, changes it, or takes it off. */
static bat_status dress(bat_solid *s, const bat_object *object, const bat_guise *guise, uint32_t *versions) {
    const bat_surface *surface = guise ? guise->surface : bat_object_surface(object);
    const bat_direction direction = guise ? guise->direction : s->direction;
    double differs[2] = {INFINITY, -INFINITY};
    if (guise) memcpy(differs, guise->moved, sizeof differs);
    for (int k = 0; k < 2 && s->guised; k++)
        differs[k] = k ? fmax(differs[k], s->differs[k]) : fmin(differs[k], s->differs[k]);
    if (s->guised && direction != s->direction) return BAT_STATE;
    bat_status status = move_triangles(s, surface, direction, differs);
    if (status == BAT_OK) status = bat_solid_lines(s, object, surface);
    s->line_version = ++*versions;
    s->guised = guise != NULL;
    s->direction = direction;
    if (guise) memcpy(s->differs, guise->moved, sizeof s->differs);
    return status;
}

static void grow(bat_solid *s, const float *numbers, size_t count, size_t stride) {
    for (size_t i = 0; i < count; i++, numbers += stride)
        for (int d = 0; d < 3; d++) {
            s->low[d] = fminf(s->low[d], numbers[d]);
            s->high[d] = fmaxf(s->high[d], numbers[d]);
        }
}

static void measure(bat_solid *s) {
    bat_mesh mesh = {.rows = 0};
    for (int d = 0; d < 3; d++) s->low[d] = INFINITY, s->high[d] = -INFINITY;
    if (s->mesh) bat_tessellation_mesh(s->mesh, &mesh);
    grow(s, s->corners, mesh.rows * mesh.columns, BAT_SOLID_CORNER);
    grow(s, s->points, s->point_count, BAT_SOLID_POINT);
}

bat_status bat_solid_update(bat_solid *solid, const bat_object *object, const bat_grain *grain,
                            const bat_guise *guise, uint32_t *versions) {
    const bat_surface *surface = bat_object_surface(object);
    bat_status status = BAT_OK;
    memset(solid->moved, 0, sizeof solid->moved);
    const bool kept = solid->version != 0 && serves(&solid->grain, grain, surface != NULL);
    if (kept && !guise && !solid->guised) return BAT_OK;
    status = kept ? dress(solid, object, guise, versions) : BAT_STATE;
    if (status == BAT_STATE) {
        bat_solid_clear(solid);
        solid->grain = *grain;
        status = surface ? make_triangles(solid, surface) : BAT_OK;
        if (status == BAT_OK) status = bat_solid_lines(solid, object, NULL);
        solid->version = solid->line_version = ++*versions;
        if (status == BAT_OK && guise) status = dress(solid, object, guise, versions);
        if (status == BAT_OK && solid->mesh) { /* everything is new */
            bat_mesh mesh;
            bat_tessellation_mesh(solid->mesh, &mesh);
            memcpy(solid->moved, (uint32_t[4]){0, (uint32_t)mesh.rows, 0, (uint32_t)mesh.columns},
                   sizeof solid->moved);
        }
    }
    if (status == BAT_OK)
        measure(solid);
    else
        bat_solid_clear(solid);
    return status;
}
