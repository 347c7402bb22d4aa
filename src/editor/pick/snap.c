#include "editor/pick/snap.h"
#include "editor/pick/isometric.h"
#include "base/real.h"
#include "base/vec.h"
#include "curve/frames/walk.h"
#include "editor/scene/path.h"
#include "editor/scene/scene.h"
#include "editor/scene/seen.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/view/unit.h"
#include "editor/view/stage.h"
#include "hands/levels/shape.h"
#include <math.h>
#include <string.h>

static const double REACH = 8;                /* px */
static const double CROWDED = 8;              /* px: least distance between grid lines */
static const double LEAST_SLANT = 0.1;        /* of the page: the grid gets no coarser beyond */
static const double STEP = 15 * BAT_PI / 180; /* radians */
enum { BRANCHES = 12, TURNS = 4, NEWTON = 16 };

/* A part of a curve that comes near: the parameter of its closest point. */
typedef struct branch {
    const bat_curve *curve;
    double u;
} branch;

typedef struct search {
    bat_context *c;
    unsigned kinds;
    int size; /* 2: a point of the page, which snaps to what is there; 3: one in space */
    double point[3], seen[2], within; /* seen, within: in drawing coordinates */
    bool free[3], flat;               /* flat: in space, on the plane that is drawn on */
    int count;
    const int *but;
    branch branches[BRANCHES];
    int branch_count;
    bat_snap best;
} search;

static double apart(const double a[2], const double b[2]) { return bat_hypot(a[0] - b[0], a[1] - b[1]); }

/* ---- choosing the best ---- */

static bool better(const bat_snap *a, const bat_snap *b) {
    if (a->kind == BAT_SNAP_NONE || b->kind == BAT_SNAP_NONE) return a->kind != BAT_SNAP_NONE;
    if (a->kind != b->kind) return a->kind < b->kind;
    int more = a->bound[0] + a->bound[1] + a->bound[2] - b->bound[0] - b->bound[1] - b->bound[2];
    return more ? more > 0 : a->distance < b->distance;
}

/* How far from where the point is seen another is. */
static double seen_apart(const search *s, const double *point) {
    double at[2];
    return bat_stage_look(s->c->stage, s->size, point, at) ? apart(at, s->seen) : INFINITY;
}

/* The point moves there as far as it is free to; in space, not past what it is not seen to meet then. */
static void offer(search *s, bat_snap_kind kind, const double *place) {
    bat_snap snap = {kind, {0, 0, 0}, {s->free[0], s->free[1], s->free[2]}, 0, {0, 0}};
    double at[2], there[2];
    for (int k = 0; k < s->size; k++) snap.point[k] = s->free[k] ? place[k] : s->point[k];
    snap.distance = seen_apart(s, snap.point);
    if (!(snap.distance <= s->within) || !better(&snap, &s->best)) return;
    if (s->size == 3 && !(bat_stage_look(s->c->stage, 3, snap.point, at) &&
                          bat_stage_look(s->c->stage, 3, place, there) && apart(at, there) <= s->within))
        return;
    s->best = snap;
}

static bool wants(const search *s, bat_snap_kind kind) { return s->kinds >> kind & 1; }

/* ---- curves ---- */

static bool left_aside(const search *s, int index) {
    for (int i = 0; i < s->count; i++)
        if (s->but[i] >= index) return s->but[i] == index;
    return false;
}

/* A place of a curve of the page or in space, and the derivative there. */
static void eval(const bat_curve *curve, double u, double place[3], double way[3]) {
    double both[2 * BAT_DIMENSION_MAX];
    const int size = bat_curve_dimension(curve);
    bat_curve_eval(curve, u, way ? 1 : 0, both);
    for (int k = 0; k < 3; k++) {
        place[k] = k < size ? both[k] : 0;
        if (way) way[k] = k < size ? both[size + k] : 0;
    }
}

static void try_ends(search *s, const bat_curve *curve) {
    double domain[2], end[3];
    if (bat_curve_is_closed(curve)) return;
    bat_curve_domain(curve, domain);
    for (int k = 0; k < 2; k++) {
        eval(curve, domain[k], end, NULL);
        offer(s, BAT_SNAP_END, end);
    }
}

static void try_curve(search *s, int entry, int index, const bat_curve *curve) {
    const bat_finder *finder = bat_scene_finder(s->c->scene, entry, index);
    bat_near near[TURNS];
    double place[3];
    size_t found = 0;
    if (!finder) return;
    bat_finder_nearest(finder, s->seen, near);
    if (near->distance > s->within) return;
    eval(curve, near->u, place, NULL);
    if (wants(s, BAT_SNAP_CURVE)) offer(s, BAT_SNAP_CURVE, place);
    if (!wants(s, BAT_SNAP_CROSSING)) return;
    /* A curve may come near more than once: each time is a branch. */
    const bat_curve *picture = s->c->scene->entries[entry].lines[index].picture;
    if (bat_curve_nearest_all(picture ? picture : curve, s->seen, s->within, TURNS, near, &found) != BAT_OK)
        return;
    for (size_t i = 0; i < found && i < TURNS && s->branch_count < BRANCHES; i++)
        s->branches[s->branch_count++] = (branch){curve, near[i].u};
}

static void try_curves(search *s) {
    const bat_scene *scene = s->c->scene;
    for (int i = 0; i < scene->count; i++) {
        const bat_scene_entry *entry = &scene->entries[i];
        if (entry->hidden || s->seen[0] < entry->box[0] - s->within ||
            s->seen[0] > entry->box[2] + s->within || s->seen[1] < entry->box[1] - s->within ||
            s->seen[1] > entry->box[3] + s->within || left_aside(s, i))
            continue;
        for (int k = 0; k < bat_object_curve_count(entry->object); k++) {
            const bat_curve *curve = bat_object_curve(entry->object, k);
            if (bat_curve_dimension(curve) > s->size) continue;
            if (wants(s, BAT_SNAP_END)) try_ends(s, curve);
            if (wants(s, BAT_SNAP_CURVE) || wants(s, BAT_SNAP_CROSSING)) try_curve(s, i, k, curve);
        }
    }
}

/* ---- crossings ---- */

static double inside(const bat_curve *curve, double u) {
    double domain[2];
    bat_curve_domain(curve, domain);
    double period = domain[1] - domain[0];
    if (bat_curve_is_closed(curve)) return u - period * floor((u - domain[0]) / period);
    return fmin(fmax(u, domain[0]), domain[1]);
}

/* The point where two branches meet, by Gauss-Newton steps from their points closest to the pen; on the page, Newton's. */
static void cross(search *s, branch a, branch b) {
    double p[3], q[3], v[3], w[3], way[3];
    const double near = 1e-12 * (fabs(s->point[0]) + fabs(s->point[1]) + fabs(s->point[2]) + s->within);
    for (int i = 0; i < NEWTON; i++) {
        eval(a.curve, a.u, p, v);
        eval(b.curve, b.u, q, w);
        for (int k = 0; k < 3; k++) way[k] = q[k] - p[k];
        const double vv = vec_dot3(v, v), vw = vec_dot3(v, w), ww = vec_dot3(w, w);
        const double wv = vec_dot3(way, v), wq = vec_dot3(way, w), turn = vv * ww - vw * vw;
        if (sqrt(vec_dot3(way, way)) <= near) break;
        if (!(turn > 1e-18 * vv * ww)) return; /* parallel */
        a.u = inside(a.curve, a.u + (ww * wv - vw * wq) / turn);
        b.u = inside(b.curve, b.u + (vw * wv - vv * wq) / turn);
    }
    eval(a.curve, a.u, p, NULL);
    eval(b.curve, b.u, q, NULL);
    for (int k = 0; k < 3; k++) way[k] = q[k] - p[k];
    if (!(sqrt(vec_dot3(way, way)) <= 1e3 * near)) return;
    if (a.curve == b.curve) {
        double domain[2];
        bat_curve_domain(a.curve, domain);
        double period = domain[1] - domain[0], gap = fabs(a.u - b.u);
        if (bat_curve_is_closed(a.curve)) gap = fmin(gap, period - gap);
        if (gap <= 1e-6 * period) return; /* the two have merged */
    }
    offer(s, BAT_SNAP_CROSSING, p);
}

/* The point where a branch meets the guide. */
static void cross_guide(search *s, branch a, int axis, double at) {
    double p[4], near = 1e-12 * (fabs(s->point[0]) + fabs(s->point[1]) + s->within);
    for (int i = 0; i < NEWTON; i++) {
        bat_curve_eval(a.curve, a.u, 1, p);
        if (fabs(p[axis] - at) <= near || p[2 + axis] == 0) break;
        a.u = inside(a.curve, a.u + (at - p[axis]) / p[2 + axis]);
    }
    if (!(fabs(p[axis] - at) <= 1e3 * near)) return;
    p[axis] = at;
    offer(s, BAT_SNAP_CROSSING, p);
}

/* ---- guides and grid ---- */

/* The nearest line along each axis, if any is near. */
typedef struct lines {
    bool there[3];
    double at[3];
} lines;

/* How far it is seen to go when one coordinate changes. */
static double away(const search *s, int axis, double at) {
    double there[3] = {s->point[0], s->point[1], s->point[2]};
    there[axis] = at;
    return bat_stage_tilted(s->c->stage) ? seen_apart(s, there) : fabs(at - s->point[axis]);
}

static lines near_guides(search *s) {
    const bat_scene *scene = s->c->scene;
    lines found = {{false}, {0}};
    for (int i = 0; i < scene->count; i++) {
        double at;
        int axis = scene->entries[i].hidden ? -1 : bat_object_guide(scene->entries[i].object, &at);
        if (axis < 0 || left_aside(s, i) || away(s, axis, at) > s->within) continue;
        if (found.there[axis] && fabs(at - s->point[axis]) >= fabs(found.at[axis] - s->point[axis])) continue;
        found.there[axis] = true;
        found.at[axis] = at;
    }
    return found;
}

/* Of the places of the ground that the grid lies on. */
static int dimension_of(const bat_grid *grid) { return grid->ground.type->dimension; }

static lines near_grid(const search *s) {
    lines found = {{false}, {0}};
    const bat_grid grid = bat_grid_shown(s->c);
    double zero[3];
    if (!(grid.step > 0) || grid.triangles || s->flat || s->size < dimension_of(&grid)) return found;
    bat_ground_at(&grid.ground, grid.zero, zero);
    for (int k = 0; k < s->size; k++) {
        found.at[k] = zero[k] + grid.step * round((s->point[k] - zero[k]) / grid.step);
        found.there[k] = s->free[k] && away(s, k, found.at[k]) <= s->within;
    }
    return found;
}

/* The corner of the grid that is nearest to a place, or, with a family of its lines, the foot on the nearest of them. */
static void grid_place(const bat_grid *grid, int family, const double own[2], double out[2]) {
    if (grid->triangles && family < 0) bat_isometric_corner(grid->zero, grid->step, own, out);
    if (grid->triangles && family >= 0) bat_isometric_foot(grid->zero, grid->step, family, own, out);
    for (int k = 0; k < 2 && !grid->triangles; k++)
        out[k] = family == 1 - k ? own[k]
                                 : grid->zero[k] + grid->step * round((own[k] - grid->zero[k]) / grid->step);
}

/* A corner of the grid, or else its nearest line. */
static void try_grid(search *s) {
    const bat_grid grid = bat_grid_shown(s->c);
    const int families = grid.triangles ? BAT_ISOMETRIC_FAMILIES : 2;
    double zero[3], x[3], y[3], own[2] = {0, 0}, place[2], at[3] = {0};
    if (!(grid.step > 0) || !(s->size == 2 ? grid.triangles : s->flat) || s->size != dimension_of(&grid))
        return;
    bat_ground_at(&grid.ground, own, zero);
    bat_ground_axes(&grid.ground, x, y);
    for (int k = 0; k < s->size; k++) {
        own[0] += (s->point[k] - zero[k]) * x[k];
        own[1] += (s->point[k] - zero[k]) * y[k];
    }
    for (int i = -1; i < families; i++) {
        grid_place(&grid, i, own, place);
        bat_ground_at(&grid.ground, place, at);
        offer(s, BAT_SNAP_GRID, at);
        if (i < 0 && seen_apart(s, at) <= s->within) return;
    }
}

/* Guides take precedence; a coordinate that no guide holds snaps to the grid. */
static void try_lines(search *s, const lines *guides, const lines *grid) {
    bat_snap snap = {BAT_SNAP_NONE, {s->point[0], s->point[1], s->point[2]}, {false}, 0, {0, 0}};
    for (int k = 0; k < s->size; k++) {
        const lines *drawing = guides->there[k] ? guides : grid;
        if (!drawing->there[k]) continue;
        snap.point[k] = drawing->at[k];
        snap.bound[k] = true;
        if (snap.kind != BAT_SNAP_GUIDE) snap.kind = drawing == guides ? BAT_SNAP_GUIDE : BAT_SNAP_GRID;
    }
    snap.distance = seen_apart(s, snap.point);
    if (better(&snap, &s->best)) s->best = snap;
}

static void run(search *s) {
    lines guides = {{false}, {0}}, grid = guides;
    if (s->size == 2 && wants(s, BAT_SNAP_GUIDE)) guides = near_guides(s);
    if (wants(s, BAT_SNAP_GRID)) grid = near_grid(s);
    try_curves(s);
    for (int i = 0; i < s->branch_count; i++) {
        for (int k = 0; k < i; k++) cross(s, s->branches[k], s->branches[i]);
        for (int k = 0; k < 2; k++)
            if (guides.there[k]) cross_guide(s, s->branches[i], k, guides.at[k]);
    }
    if (guides.there[0] && guides.there[1] && wants(s, BAT_SNAP_CROSSING))
        offer(s, BAT_SNAP_CROSSING, guides.at);
    try_lines(s, &guides, &grid);
    if (wants(s, BAT_SNAP_GRID)) try_grid(s);
}

static unsigned switched_on(const bat_context *c) {
    static const bat_property_id switches[] = {
        [BAT_SNAP_END] = BAT_PROPERTY_SNAP_ENDS,     [BAT_SNAP_CROSSING] = BAT_PROPERTY_SNAP_CROSSINGS,
        [BAT_SNAP_GUIDE] = BAT_PROPERTY_SNAP_GUIDES, [BAT_SNAP_CURVE] = BAT_PROPERTY_SNAP_CURVES,
        [BAT_SNAP_GRID] = BAT_PROPERTY_SNAP_GRID,
    };
    unsigned kinds = 0;
    if (c->settings->values[BAT_PROPERTY_SNAP] == 0 || c->modifiers & (BAT_CTRL | BAT_META)) return 0;
    for (unsigned k = BAT_SNAP_END; k <= BAT_SNAP_GRID; k++)
        if (c->settings->values[switches[k]] != 0) kinds |= 1u << k;
    return kinds;
}

static bat_snap find(bat_context *c, int size, bool flat, const bool free[3], int count, const int *but,
                     int source_count, const bat_snap_source *sources, const double *delta, int *which) {
    bat_snap best = {0};
    unsigned kinds = switched_on(c);
    for (int i = 0; i < source_count && kinds; i++) {
        search s = {.c = c,
                    .kinds = kinds & sources[i].kinds,
                    .size = size,
                    .flat = flat,
                    .free = {free[0], free[1], free[2]},
                    .within = REACH * bat_stage_pixel(c->stage),
                    .count = count,
                    .but = but};
        for (int k = 0; k < size; k++) s.point[k] = sources[i].point[k] + delta[k];
        if (s.kinds && bat_stage_look(c->stage, size, s.point, s.seen)) run(&s);
        if (!better(&s.best, &best)) continue;
        best = s.best;
        if (which) *which = i;
    }
    return best;
}

bat_snap bat_snap_find(bat_context *c, int count, const int *but, int source_count,
                       const bat_snap_source *sources, const double delta[2], int *which) {
    return find(c, 2, false, (bool[]){true, true, false}, count, but, source_count, sources, delta, which);
}

bat_snap bat_snap_find_space(bat_context *c, int count, const int *but, int source_count,
                             const bat_snap_source *sources, const double delta[3], const bool free[3],
                             int *which) {
    return find(c, 3, false, free, count, but, source_count, sources, delta, which);
}

void bat_snap_point(bat_context *c, int count, const int *but, double point[2]) {
    bat_snap_source source = {{point[0], point[1]}, BAT_SNAP_ALL};
    bat_seen_sync(c);
    (*c->snap) = bat_snap_find(c, count, but, 1, &source, (double[]){0, 0}, NULL);
    if (c->snap->kind) memcpy(point, c->snap->point, 2 * sizeof *point);
}

void bat_snap_point_space(bat_context *c, int count, const int *but, double point[3]) {
    const bat_snap_source source = {{point[0], point[1], point[2]}, BAT_SNAP_ALL};
    bat_seen_sync(c);
    (*c->snap) = find(c, 3, true, (bool[]){true, true, true}, count, but, 1, &source, (double[]){0, 0, 0},
                      NULL);
    if (c->snap->kind) memcpy(point, c->snap->point, sizeof c->snap->point);
}

void bat_snap_angle(bat_context *c, const double origin[2], double point[2]) {
    double x = point[0] - origin[0], y = point[1] - origin[1];
    bool fine = c->settings->values[BAT_PROPERTY_SNAP_ANGLES] != 0;
    int turn = (int)round(bat_atan2(y, x) / STEP); /* 24 make a full turn */
    if (!fine) turn = fabs(x) >= fabs(y) ? 0 : 6;
    double u = bat_cos(turn * STEP), v = bat_sin(turn * STEP);
    if (turn % 6 == 0) u = turn % 12 == 0, v = !(turn % 12 == 0); /* exact along the axes */
    double length = x * u + y * v;
    point[0] = origin[0] + length * u;
    point[1] = origin[1] + length * v;
    (*c->snap) = (bat_snap){BAT_SNAP_ANGLE, {point[0], point[1]}, {true, true}, 0, {origin[0], origin[1]}};
}

bat_grid bat_grid_shown(const bat_context *c) {
    const double *values = c->settings->values;
    const bool plane = bat_stage_dimension(c->stage) == 3 && !bat_ground_bounded(&c->stage->ground);
    bat_grid grid = {.triangles = values[BAT_PROPERTY_GRID_KIND] != 0,
                     .ground = plane ? c->stage->ground : bat_ground_page()};
    if (values[BAT_PROPERTY_SHOW_GRID] == 0) return grid;
    const bat_stage on = {.view = c->stage->view, .ground = grid.ground};
    const double scale = bat_stage_scale(&on) * fmax(bat_stage_slant(&on), LEAST_SLANT);
    grid.step = values[BAT_PROPERTY_GRID_SPACING];
    for (int i = 0; grid.step * scale < CROWDED && i < 60; i++) grid.step *= i & 1 ? 2 : 5;
    if (!plane) bat_unit_origin(c, grid.zero);
    return grid;
}
