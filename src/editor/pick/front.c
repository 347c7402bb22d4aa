#include "editor/pick/front.h"
#include "base/vec.h"
#include "curve/curve.h"
#include "document/document.h"
#include "document/kind.h"
#include "editor/pick/pick.h"
#include "editor/scene/seen.h"
#include "editor/session/session.h"
#include "editor/view/stage.h"
#include <batten/mesh.h>
#include <math.h>

static const double SLACK = 2; /* px: of lines that lie on a surface */

/* Along the gaze. */
static double depth_of(const bat_context *c, const double at[3]) {
    double right[3], down[3], ahead[3];
    bat_view_axes(&c->stage->view, right, down, ahead);
    return vec_dot3(at, ahead);
}

/* Whether a face covers the place in the picture, and Newell's normal of it. */
static bool covers(const bat_context *c, const double *vertices, const int *face, size_t count,
                   const double place[2], double normal[3]) {
    double was[2], now[2];
    bool within = false;
    const double *from = vertices + 3 * (ptrdiff_t)face[count - 1];
    if (!bat_stage_look(c->stage, 3, from, was)) return false;
    normal[0] = normal[1] = normal[2] = 0;
    for (size_t i = 0; i < count; i++) {
        const double *to = vertices + 3 * (ptrdiff_t)face[i];
        if (!bat_stage_look(c->stage, 3, to, now)) return false;
        if (bat_is_beside(place, was, now)) within = !within;
        for (int k = 0; k < 3; k++) {
            const int a = (k + 1) % 3, b = (k + 2) % 3;
            normal[k] += (from[a] - to[a]) * (from[b] + to[b]);
        }
        from = to;
        was[0] = now[0], was[1] = now[1];
    }
    return within;
}

/* How deep the mesh is first met at the pixel, which is at `place` in the picture; INFINITY: not at all. */
static double mesh_depth(const bat_context *c, const bat_polymesh *mesh, const double pixel[2],
                         const double place[2]) {
    const bat_ray ray = bat_view_ray(&c->stage->view, pixel);
    const double *vertices = bat_polymesh_vertices(mesh);
    double least = INFINITY, normal[3], away[3], at[3];
    for (size_t f = 0; f < bat_polymesh_face_count(mesh); f++) {
        size_t count;
        const int *face = bat_polymesh_face(mesh, f, &count);
        if (!covers(c, vertices, face, count, place, normal)) continue;
        const double towards = vec_dot3(ray.along, normal), *corner = vertices + 3 * (ptrdiff_t)face[0];
        if (towards == 0) continue;
        for (int k = 0; k < 3; k++) away[k] = corner[k] - ray.from[k];
        const double far = vec_dot3(away, normal) / towards;
        for (int k = 0; k < 3; k++) at[k] = ray.from[k] + far * ray.along[k];
        least = fmin(least, depth_of(c, at));
    }
    return least;
}

static double surface_depth(const bat_context *c, const bat_object *object, const double pixel[2]) {
    bat_stage stage = *c->stage;
    bat_hit hit;
    if (!bat_ground_of(object, &stage.ground) || bat_stage_place(&stage, pixel, NULL, &hit) != BAT_OK)
        return INFINITY;
    return depth_of(c, hit.at);
}

/* What is shaded there, the nearest to the eye; -1: nothing. */
static int shaded_at(const bat_context *c, const double pixel[2], double *depth) {
    double place[2];
    int found = -1;
    *depth = INFINITY;
    bat_stage_seen(c->stage, pixel, place);
    for (int i = 0; i < c->scene->count; i++) {
        const bat_scene_entry *entry = &c->scene->entries[i];
        const double *box = entry->box;
        if (entry->hidden || entry->locked || place[0] < box[0] || place[0] > box[2] || place[1] < box[1] ||
            place[1] > box[3])
            continue;
        const bat_object *object = bat_document_at(c->session->document, i); /* the scene has its picture */
        const bat_polymesh *mesh = bat_object_mesh(object);
        const bool surface = bat_object_surface(object) != NULL;
        const double met = mesh      ? mesh_depth(c, mesh, pixel, place)
                           : surface ? surface_depth(c, object, pixel)
                                     : INFINITY;
        if (met < *depth) *depth = met, found = i;
    }
    return found;
}

/* Whether the curve that is picked lies behind what is shaded where it is. */
static bool is_hidden(const bat_context *c, const bat_pick *pick) {
    double depth, at[3] = {0}, line[2];
    bat_stage_project(c->stage, pick->near.point, line);
    const int front = shaded_at(c, line, &depth);
    if (front < 0) return false;
    bat_curve_eval(bat_object_curve(bat_scene_shown(c->scene, pick->index), pick->curve), pick->near.u, 0,
                   at);
    return depth_of(c, at) > depth + SLACK * bat_stage_pixel(c->stage);
}

int bat_pick_front(bat_context *c, const double pixel[2], double within) {
    double place[2], depth;
    const double reach = within * bat_stage_pixel(c->stage);
    bat_seen_sync(c);
    bat_stage_seen(c->stage, pixel, place);
    const int index = bat_pick_object(c->scene, place, reach);
    if (!bat_stage_tilted(c->stage)) return index;
    const bat_pick pick = bat_pick_curve(c->scene, 0, place, reach); /* no line of a surface or a mesh */
    if (index >= 0 && pick.object && pick.index == index && !is_hidden(c, &pick)) return index;
    const int front = shaded_at(c, pixel, &depth);
    return front >= 0 ? front : index;
}
