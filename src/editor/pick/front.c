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
#include <string.h>

static const double SLACK = 2; /* px: of lines that lie on a surface */

/* Where what is shaded is met. */
typedef struct meeting {
    int index; /* -1: nothing is */
    double depth, at[3];
    double normal[3]; /* of a mesh's face, of any length; zero: it is a surface */
} meeting;

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

/* Where the mesh is first met at the pixel, which is at `place` in the picture; depth INFINITY: not at all. */
static meeting meet_mesh(const bat_context *c, const bat_polymesh *mesh, const double pixel[2],
                         const double place[2]) {
    const bat_ray ray = bat_view_ray(&c->stage->view, pixel);
    const double *vertices = bat_polymesh_vertices(mesh);
    meeting first = {.depth = INFINITY};
    double normal[3], away[3], at[3];
    for (size_t f = 0; f < bat_polymesh_face_count(mesh); f++) {
        size_t count;
        const int *face = bat_polymesh_face(mesh, f, &count);
        if (!covers(c, vertices, face, count, place, normal)) continue;
        const double towards = vec_dot3(ray.along, normal), *corner = vertices + 3 * (ptrdiff_t)face[0];
        if (towards == 0) continue;
        for (int k = 0; k < 3; k++) away[k] = corner[k] - ray.from[k];
        const double far = vec_dot3(away, normal) / towards;
        for (int k = 0; k < 3; k++) at[k] = ray.from[k] + far * ray.along[k];
        const double depth = depth_of(c, at);
        if (!(depth < first.depth)) continue;
        first.depth = depth;
        memcpy(first.at, at, sizeof at), memcpy(first.normal, normal, sizeof normal);
    }
    return first;
}

static meeting meet_surface(const bat_context *c, const bat_object *object, const double pixel[2]) {
    bat_stage stage = *c->stage;
    meeting met = {.depth = INFINITY};
    bat_hit hit;
    if (!bat_ground_of(object, &stage.ground) || bat_stage_place(&stage, pixel, NULL, &hit) != BAT_OK)
        return met;
    memcpy(met.at, hit.at, sizeof hit.at);
    met.depth = depth_of(c, hit.at);
    return met;
}

static bool is_solid(const bat_object *object) {
    return bat_object_mesh(object) || bat_object_surface(object);
}

/* What is shaded there, the nearest to the eye. */
static meeting shaded_at(const bat_context *c, const double pixel[2]) {
    meeting first = {.index = -1, .depth = INFINITY};
    double place[2];
    bat_stage_seen(c->stage, pixel, place);
    for (int i = 0; i < c->scene->count; i++) {
        const bat_scene_entry *entry = &c->scene->entries[i];
        const double *box = entry->box;
        if (entry->hidden || entry->locked || place[0] < box[0] || place[0] > box[2] || place[1] < box[1] ||
            place[1] > box[3])
            continue;
        const bat_object *object = bat_document_at(c->session->document, i); /* the scene has its picture */
        if (!is_solid(object)) continue;
        const bat_polymesh *mesh = bat_object_mesh(object);
        meeting met = mesh ? meet_mesh(c, mesh, pixel, place) : meet_surface(c, object, pixel);
        met.index = i;
        if (met.depth < first.depth) first = met;
    }
    return first;
}

bool bat_pick_face(bat_context *c, const double pixel[2], double at[3], double normal[3]) {
    bat_seen_sync(c);
    const meeting met = shaded_at(c, pixel);
    const double length = sqrt(vec_dot3(met.normal, met.normal));
    if (met.index < 0 || !(length > 0)) return false;
    for (int k = 0; k < 3; k++) at[k] = met.at[k], normal[k] = met.normal[k] / length;
    return true;
}

/* Where a curve is, along the gaze. */
static double line_depth(const bat_context *c, int index, int curve, double u) {
    double at[BAT_DIMENSION_MAX] = {0};
    bat_curve_eval(bat_object_curve(bat_scene_shown(c->scene, index), curve), u, 0, at);
    return depth_of(c, at);
}

/* The surface or mesh with an edge within reach that lies before the line that is picked, the nearest to the eye; -1: none. */
static int edge_before(const bat_context *c, const bat_pick *pick, const double place[2], double within) {
    double least = line_depth(c, pick->index, pick->curve, pick->near.u) - SLACK * bat_stage_pixel(c->stage);
    int found = -1;
    for (int i = 0; i < c->scene->count; i++) {
        const bat_scene_entry *entry = &c->scene->entries[i];
        const double *box = entry->box;
        if (entry->hidden || entry->locked || !is_solid(entry->object) || place[0] < box[0] - within ||
            place[0] > box[2] + within || place[1] < box[1] - within || place[1] > box[3] + within)
            continue;
        for (int k = 0; k < bat_object_curve_count(entry->object); k++) {
            const bat_finder *finder = bat_scene_finder(c->scene, i, k);
            bat_near near = {.distance = INFINITY};
            if (finder) bat_finder_nearest(finder, place, &near);
            if (!(near.distance <= within)) continue;
            const double depth = line_depth(c, i, k, near.u);
            if (depth < least) least = depth, found = i;
        }
    }
    return found;
}

/* Whether the curve that is picked lies behind what is shaded where it is. */
static bool is_hidden(const bat_context *c, const bat_pick *pick) {
    double line[2];
    bat_stage_project(c->stage, pick->near.point, line);
    const meeting front = shaded_at(c, line);
    return front.index >= 0 && line_depth(c, pick->index, pick->curve, pick->near.u) >
                                   front.depth + SLACK * bat_stage_pixel(c->stage);
}

int bat_pick_front(bat_context *c, const double pixel[2], double within) {
    double place[2];
    const double reach = within * bat_stage_pixel(c->stage);
    bat_seen_sync(c);
    bat_stage_seen(c->stage, pixel, place);
    const int index = bat_pick_object(c->scene, place, reach);
    if (!bat_stage_tilted(c->stage)) return index;
    const bat_pick pick = bat_pick_curve(c->scene, 0, place, reach); /* no line of a surface or a mesh */
    if (index >= 0 && pick.object && pick.index == index && !is_hidden(c, &pick)) {
        const int edge = edge_before(c, &pick, place, reach);
        return edge >= 0 ? edge : index;
    }
    const int front = shaded_at(c, pixel).index;
    return front >= 0 ? front : index;
}
