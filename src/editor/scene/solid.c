/* Triangles of a surface as buffers. While a stroke moves it, only its rows or columns are made anew; when another surface
 * takes its place, all are evaluated where they are, and only what changed counts as moved. */
#include "editor/scene/solid.h"
#include "form/shade/curving.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { TRIANGLES_MAX = 300000, COARSER = 3 /* buffers stay while the view goes away, up to 2^COARSER */ };

static const double chord = 0.1;                    /* view pixels */
static const double angle = 0.1, fine_angle = 0.05; /* radians; fine: reflections show more */
static const double too_bent = 0.9;                 /* cosine: 26 degrees */

void bat_solid_clear(bat_solid *solid) {
    bat_tessellation_free(solid->mesh);
    if (solid->facets.points) bat_facets_clear(&solid->facets);
    free(solid->corners), free(solid->points), free(solid->rim);
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

/* Makes the corner anew; false: it is as it was. */
static bool put_corner(bat_solid *s, const bat_surface *surface, const bat_mesh *mesh, size_t i, size_t j) {
    const size_t k = i * mesh->columns + j;
    float *to = s->corners + BAT_SOLID_CORNER * k;
    bool same = true;
    for (size_t d = 0; d < 6; d++) {
        const double number = d < 3 ? mesh->points[3 * k + d] - s->grain.origin[d]
                                    : mesh->normals[3 * k + d - 3];
        same = same && to[d] == (float)number;
        to[d] = (float)number;
    }
    if (same) return false;
    to[6] = (float)bat_curving_value(surface, mesh, i, j, s->grain.look);
    return true;
}

/* Whether the normals of two corners are far more apart than they were to be. */
static bool bends(const bat_mesh *mesh, size_t a, size_t b) {
    double cosine = 0;
    for (size_t d = 0; d < 3; d++) cosine += mesh->normals[3 * a + d] * mesh->normals[3 * b + d];
    return cosine < too_bent;
}

/* Makes the corners of rows and columns anew; `moved` becomes where they have changed. */
static void fill(bat_solid *s, const bat_surface *surface, const size_t row[2], const size_t column[2]) {
    size_t least[2] = {SIZE_MAX, SIZE_MAX}, most[2] = {0, 0};
    bat_mesh mesh;
    bat_tessellation_mesh(s->mesh, &mesh);
    for (size_t i = row[0]; i < row[1]; i++)
        for (size_t j = column[0]; j < column[1]; j++) {
            const size_t at[2] = {i, j}, k = i * mesh.columns + j;
            if (!put_corner(s, surface, &mesh, i, j)) continue;
            for (int d = 0; d < 2; d++) {
                if (at[d] < least[d]) least[d] = at[d];
                if (at[d] >= most[d]) most[d] = at[d] + 1;
            }
            if ((i > 0 && bends(&mesh, k, k - mesh.columns)) || (j > 0 && bends(&mesh, k, k - 1)))
                s->coarse = true;
        }
    for (int d = 0; d < 2; d++) {
        s->moved[2 * d] = most[d] ? (uint32_t)least[d] : 0;
        s->moved[2 * d + 1] = (uint32_t)most[d];
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
    s->corners = calloc(mesh.rows * mesh.columns * BAT_SOLID_CORNER, sizeof *s->corners);
    if (!s->corners) return BAT_MEMORY;
    fill(s, surface, (size_t[2]){0, mesh.rows}, (size_t[2]){0, mesh.columns});
    s->coarse = false; /* as fine as they can be */
    return BAT_OK;
}

/* The triangles of a polygon mesh, which are made anew with it. */
static bat_status make_facets(bat_solid *s, const bat_polymesh *mesh) {
    bat_status status = bat_polymesh_facets(mesh, &s->facets);
    if (status != BAT_OK) return status;
    const size_t count = s->facets.corner_count;
    s->corners = calloc(count * BAT_SOLID_CORNER, sizeof *s->corners);
    if (!s->corners) return BAT_MEMORY;
    for (size_t i = 0; i < count; i++) {
        float *to = s->corners + BAT_SOLID_CORNER * i;
        for (size_t d = 0; d < 3; d++) {
            to[d] = (float)(s->facets.points[3 * i + d] - s->grain.origin[d]);
            to[d + 3] = (float)s->facets.normals[3 * i + d];
        }
    }
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
    const bool any = range[0] < range[1];
    fill(s, surface, (size_t[2]){range[0] / n, any ? end / n + 1 : 0},
         (size_t[2]){range[0] % n, any ? end % n + 1 : 0});
    return BAT_OK;
}

/* Follows a surface: puts a guise on, changes it, takes it off, or shows the surface that has replaced the object's. */
static bat_status follow(bat_solid *s, const bat_object *object, const bat_guise *guise, uint32_t *versions) {
    const bat_surface *surface = guise ? guise->surface : bat_object_surface(object);
    const bat_direction direction = guise ? guise->direction : s->direction;
    double differs[2] = {INFINITY, -INFINITY};
    if (!surface || !s->mesh || (s->guised && direction != s->direction)) return BAT_STATE;
    if (guise) memcpy(differs, guise->moved, sizeof differs);
    for (int k = 0; k < 2 && s->guised; k++)
        differs[k] = k ? fmax(differs[k], s->differs[k]) : fmin(differs[k], s->differs[k]);
    if (s->old) bat_surface_domain(surface, direction, differs); /* anywhere */
    bat_status status = move_triangles(s, surface, direction, differs);
    if (status == BAT_ARGUMENT) return BAT_STATE; /* another domain */
    if (status == BAT_OK) status = bat_solid_lines(s, object, surface);
    s->line_version = ++*versions;
    s->guised = guise != NULL;
    s->direction = direction;
    s->old = false;
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
    grow(s, s->corners, s->mesh ? mesh.rows * mesh.columns : s->facets.corner_count, BAT_SOLID_CORNER);
    grow(s, s->points, s->point_count, BAT_SOLID_POINT);
}

/* Makes everything anew. */
static bat_status make(bat_solid *s, const bat_object *object, const bat_grain *grain, const bat_guise *guise,
                       uint32_t *versions) {
    const bat_surface *surface = bat_object_surface(object);
    bat_solid_clear(s);
    s->grain = *grain;
    const bat_polymesh *mesh = bat_object_mesh(object);
    bat_status status = surface ? make_triangles(s, surface) : mesh ? make_facets(s, mesh) : BAT_OK;
    if (status == BAT_OK) status = bat_solid_lines(s, object, NULL);
    s->version = s->line_version = ++*versions;
    return status == BAT_OK && guise ? follow(s, object, guise, versions) : status;
}

bat_status bat_solid_update(bat_solid *solid, const bat_object *object, const bat_grain *grain,
                            const bat_guise *guise, uint32_t *versions) {
    const bool surface = bat_object_surface(object) != NULL;
    memset(solid->moved, 0, sizeof solid->moved);
    const bool serving = solid->version != 0 && serves(&solid->grain, grain, surface);
    const bool follows = guise || solid->guised || solid->old;
    if (serving && !follows && !solid->coarse) return BAT_OK;
    bat_status status = serving && follows ? follow(solid, object, guise, versions) : BAT_STATE;
    if (status == BAT_STATE) status = make(solid, object, grain, guise, versions);
    if (status == BAT_OK)
        measure(solid);
    else
        bat_solid_clear(solid);
    return status;
}
