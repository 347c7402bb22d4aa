/* Triangles as they are seen: surfaces divided finely enough for the picture, in pixels, cut off at the near plane. */
#include "form/shade/soup.h"
#include "form/mesh/facets.h"
#include "form/shade/curving.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TRIANGLES_MAX = 2000000 };

static const double chord = 0.1, angle = 0.1,
                    fine_angle = 0.04; /* pixels, radians; fine: reflections show more */
static const double near_share = 1e-3; /* of the target's distance: the near plane in perspective */

void bat_soup_clear(bat_soup *soup) {
    free(soup->corner), free(soup->triangle), free(soup->owner);
    *soup = (bat_soup){.corners = 0};
}

static double near_plane(const bat_viewpoint *view, const bat_gaze *gaze) {
    if (!(gaze->focus > 0)) return 0;
    return near_share * vec_dot(vec_sub(vec_load(view->target, 3), gaze->eye), gaze->ahead);
}

/* The length of a pixel where the surface is nearest. */
static double pixel_of(const bat_viewpoint *view, const bat_gaze *gaze, const bat_surface *surface) {
    if (!(gaze->focus > 0)) return gaze->pixel;
    double low[3], high[3], far = INFINITY;
    bat_surface_box(surface, low, high);
    for (int k = 0; k < 8; k++) {
        const vec corner = {k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]};
        far = fmin(far, vec_dot(vec_sub(corner, gaze->eye), gaze->ahead));
    }
    const double least = vec_norm(vec_sub(vec_load(view->target, 3), gaze->eye)) / 20;
    return fmax(far, least) / gaze->focus;
}

static bat_status make_room(bat_soup *soup, size_t corners, size_t triangles) {
    if (soup->corners + corners > INT_MAX || soup->triangles + triangles > INT_MAX) return BAT_COUNT;
    if (soup->corners + corners > soup->corner_room) {
        const size_t room = soup->corners + corners + soup->corner_room / 2;
        bat_corner *larger = realloc(soup->corner, room * sizeof *larger);
        if (!larger) return BAT_MEMORY;
        soup->corner = larger, soup->corner_room = room;
    }
    if (soup->triangles + triangles > soup->triangle_room) {
        const size_t room = soup->triangles + triangles + soup->triangle_room / 2;
        int(*larger)[3] = realloc(soup->triangle, room * sizeof *larger);
        if (larger) soup->triangle = larger;
        int *owner = larger ? realloc(soup->owner, room * sizeof *owner) : NULL;
        if (!owner) return BAT_MEMORY;
        soup->owner = owner, soup->triangle_room = room;
    }
    return BAT_OK;
}

/* x and y relative to the middle, times the depth: set right by `project` once nothing lies behind the near plane. */
static bat_corner corner_of(const bat_gaze *gaze, const double *point, const double *normal, double value) {
    const vec way = vec_sub(vec_load(point, 3), gaze->eye), n = vec_load(normal, 3);
    return (bat_corner){
        .x = vec_dot(way, gaze->right),
        .y = vec_dot(way, gaze->above),
        .far = vec_dot(way, gaze->ahead),
        .normal = {vec_dot(n, gaze->right), vec_dot(n, gaze->above), -vec_dot(n, gaze->ahead)},
        .value = value};
}

static void project(const bat_gaze *gaze, bat_corner *c) {
    const double scale = gaze->focus > 0 ? gaze->focus / c->far : 1 / gaze->pixel;
    c->x = gaze->middle[0] + scale * c->x;
    c->y = gaze->middle[1] - scale * c->y;
}

static bat_corner between(const bat_corner *a, const bat_corner *b, double near) {
    const double w = (near - a->far) / (b->far - a->far);
    bat_corner c = {.x = a->x + w * (b->x - a->x), .y = a->y + w * (b->y - a->y), .far = near};
    for (int k = 0; k < 3; k++) c.normal[k] = a->normal[k] + w * (b->normal[k] - a->normal[k]);
    c.value = a->value + w * (b->value - a->value);
    return c;
}

static void put_triangle(bat_soup *soup, int a, int b, int c, int owner) {
    int *to = soup->triangle[soup->triangles];
    to[0] = a, to[1] = b, to[2] = c;
    soup->owner[soup->triangles++] = owner;
}

/* A triangle of which a part is behind the near plane: what is left has three or four corners. */
static bat_status put_cut(bat_soup *soup, const int *corner, double near, int owner) {
    bat_status status = make_room(soup, 4, 2);
    if (status != BAT_OK) return status;
    bat_corner left[4];
    int count = 0;
    for (int k = 0; k < 3; k++) {
        const bat_corner *a = soup->corner + corner[k], *b = soup->corner + corner[(k + 1) % 3];
        if (a->far > near) left[count++] = *a;
        if ((a->far > near) != (b->far > near))
            left[count++] = a->far > near ? between(a, b, near) : between(b, a, near);
    }
    const int first = (int)soup->corners;
    for (int k = 0; k < count; k++) soup->corner[soup->corners++] = left[k];
    for (int k = 2; k < count; k++) put_triangle(soup, first, first + k - 1, first + k, owner);
    return BAT_OK;
}

static bat_status put_mesh(bat_soup *soup, const bat_surface *surface, const bat_mesh *m, double near,
                           int owner, bat_look look) {
    const size_t first = soup->corners;
    bat_status status = make_room(soup, m->rows * m->columns, m->triangle_count);
    if (status != BAT_OK) return status;
    for (size_t i = 0; i < m->rows; i++)
        for (size_t j = 0; j < m->columns; j++) {
            const size_t k = 3 * (i * m->columns + j);
            soup->corner[soup->corners++] = corner_of(&soup->gaze, m->points + k, m->normals + k,
                                                      surface ? bat_curving_value(surface, m, i, j, look)
                                                              : 0);
        }
    for (size_t k = 0; status == BAT_OK && k < m->triangle_count; k++) {
        const int corner[3] = {(int)first + m->triangles[3 * k], (int)first + m->triangles[3 * k + 1],
                               (int)first + m->triangles[3 * k + 2]};
        int before = 0;
        for (int c = 0; c < 3; c++) before += soup->corner[corner[c]].far > near;
        if (before == 3)
            put_triangle(soup, corner[0], corner[1], corner[2], owner);
        else if (before > 0)
            status = put_cut(soup, corner, near, owner);
    }
    for (size_t k = first; k < soup->corners; k++)
        if (soup->corner[k].far >= near) project(&soup->gaze, soup->corner + k);
    return status;
}

bat_status bat_soup_add(bat_soup *soup, const bat_viewpoint *view, const bat_surface *surface, int owner,
                        bat_look look) {
    bat_tessellate_options options = bat_tessellate_defaults();
    options.tolerance = chord * pixel_of(view, &soup->gaze, surface);
    options.angle = look == BAT_LOOK_ZEBRA ? fine_angle : angle;
    options.triangles_max = TRIANGLES_MAX;
    bat_tessellation *t = NULL;
    bat_status status = bat_surface_tessellate(surface, &options, &t, NULL);
    if (status != BAT_OK) return status;
    bat_mesh mesh;
    bat_tessellation_mesh(t, &mesh);
    status = put_mesh(soup, surface, &mesh, near_plane(view, &soup->gaze), owner, look);
    bat_tessellation_free(t);
    return status;
}

bat_status bat_soup_add_mesh(bat_soup *soup, const bat_viewpoint *view, const bat_polymesh *mesh, int owner) {
    bat_facets facets;
    bat_status status = bat_polymesh_facets(mesh, &facets);
    if (status != BAT_OK) return status;
    const bat_mesh m = {.rows = facets.corner_count,
                        .columns = 1,
                        .points = facets.points,
                        .normals = facets.normals,
                        .triangle_count = facets.triangle_count,
                        .triangles = facets.triangles};
    status = put_mesh(soup, NULL, &m, near_plane(view, &soup->gaze), owner, BAT_LOOK_SHADED);
    bat_facets_clear(&facets);
    return status;
}
