/* The curve of one entity. */
#include "base/real.h"
#include "format/dxf/path.h"
#include "format/model/rational.h"
#include "text/json.h"

#include <batten/bezier.h>
#include <batten/interpolate.h>
#include <batten/refine.h>
#include <math.h>
#include <string.h>

typedef struct reading {
    const bat_dxf_record *entity, *vertices;
    size_t vertex_count;
    bat_dxf_place place;
    const bat_svg_options *how;
    bat_curve **out;
    bat_problem *problem;
} reading;

/* ---- what the readers share ---- */

static bat_status get(const reading *r, int code, double left_out, double *out) {
    return bat_dxf_get(r->entity, code, left_out, out, r->problem);
}

static bat_status get_point(const reading *r, int code, double out[3]) {
    return bat_dxf_get_point(r->entity, code, out, r->problem);
}

/* From here on the entity is drawn in the axes of its extrusion. */
static bat_status turn_to_extrusion(reading *r) {
    double extrusion[3];
    if (!bat_dxf_find(r->entity, 230)) return BAT_OK; /* 0 0 1 */
    const bat_status status = get_point(r, 210, extrusion);
    const bat_dxf_place axes = bat_dxf_axes(extrusion);
    if (status == BAT_OK && !(extrusion[0] == 0 && extrusion[1] == 0 && extrusion[2] > 0))
        r->place = bat_dxf_within(&r->place, &axes);
    return status;
}

static bat_status flags(const reading *r, int *out) {
    double value;
    const bat_status status = get(r, 70, 0, &value);
    *out = fabs(value) < 1e6 ? (int)value : 0;
    return status;
}

static bat_status wrong(const reading *r, bat_status status, const char *message) {
    return bat_dxf_wrong(r->entity->pairs[0].line, status, message, r->problem);
}

static bat_status finish(const reading *r, bat_dxf_path *path, bool closed) {
    return bat_dxf_path_curve(path, closed, &r->place, r->how, r->out);
}

/* ---- the entities ---- */

static bat_status read_line(reading *r) {
    double from[3], to[3];
    bat_dxf_path path = {.begun = false};
    bat_status status = get_point(r, 10, from);
    if (status == BAT_OK) status = get_point(r, 11, to);
    if (status != BAT_OK) return status;
    bat_dxf_begin(&path, from);
    bat_dxf_line(&path, to);
    return finish(r, &path, false);
}

/* From one angle anticlockwise to the other; equal ones are a whole turn. */
static bool turns_round(double *from, double *to) {
    const double turn = 2 * BAT_PI;
    if (fabs(*from) > 1e6 || fabs(*to) > 1e6) *from = 0, *to = turn;
    *to = *from + fmod(fmod(*to - *from, turn) + turn, turn);
    if (*to - *from < 1e-9 || *to - *from > turn - 1e-9) *to = *from + turn;
    return *to - *from == turn || *to == *from + turn;
}

static bat_status read_arc(reading *r) {
    const bool whole = bat_dxf_is(&r->entity->pairs[0], 0, "CIRCLE");
    double centre[3], radius, from = 0, to = 360;
    bat_dxf_path path = {.begun = false};
    bat_status status = get_point(r, 10, centre);
    if (status == BAT_OK) status = get(r, 40, 0, &radius);
    if (status == BAT_OK && !whole) status = get(r, 50, 0, &from);
    if (status == BAT_OK && !whole) status = get(r, 51, 360, &to);
    if (status == BAT_OK) status = turn_to_extrusion(r);
    if (status != BAT_OK || !(radius > 0)) return status;
    from *= BAT_PI / 180, to *= BAT_PI / 180;
    const bool closed = turns_round(&from, &to);
    bat_dxf_sweep(&path, centre, (double[]){radius, 0, 0}, (double[]){0, radius, 0}, from, to);
    return finish(r, &path, closed);
}

static bat_status read_ellipse(reading *r) {
    double centre[3], x[3], y[3], ratio, from, to, z[3] = {0, 0, 1};
    bat_dxf_path path = {.begun = false};
    bat_status status = get_point(r, 10, centre);
    if (status == BAT_OK) status = get_point(r, 11, x);
    if (status == BAT_OK) status = get(r, 40, 1, &ratio);
    if (status == BAT_OK) status = get(r, 41, 0, &from);
    if (status == BAT_OK) status = get(r, 42, 2 * BAT_PI, &to);
    if (status == BAT_OK && bat_dxf_find(r->entity, 230)) status = get_point(r, 210, z);
    if (status != BAT_OK) return status;
    const double radius = bat_hypot(bat_hypot(x[0], x[1]), x[2]);
    if (!(radius > 0) || !(ratio != 0)) return BAT_OK;
    bat_dxf_across(z, x, y);
    for (int k = 0; k < 3; k++) y[k] *= ratio * radius;
    const bool closed = turns_round(&from, &to);
    bat_dxf_sweep(&path, centre, x, y, from, to);
    return finish(r, &path, closed);
}

/* The points of a polyline in turn, and the bulge of what leads from each to the next. */
typedef struct corners {
    bat_dxf_path path;
    double first[3], bulge;
} corners;

static void corner(corners *to, const double at[3], double bulge) {
    if (to->path.begun)
        bat_dxf_bulge(&to->path, at, to->bulge);
    else
        memcpy(to->first, at, sizeof to->first);
    bat_dxf_begin(&to->path, at);
    to->bulge = bulge;
}

static bat_status end_corners(reading *r, corners *made, bool closed) {
    if (!made->path.begun) return BAT_OK;
    if (closed) bat_dxf_bulge(&made->path, made->first, made->bulge);
    return finish(r, &made->path, closed);
}

static bat_status read_light_polyline(reading *r) {
    int flag = 0;
    double height = 0, at[3] = {0}, bulge = 0, value;
    bool any = false;
    corners made = {.bulge = 0};
    bat_status status = flags(r, &flag);
    if (status == BAT_OK) status = get(r, 38, 0, &height);
    for (size_t i = 1; i < r->entity->count && status == BAT_OK; i++) {
        const bat_dxf_pair *pair = &r->entity->pairs[i];
        if (pair->code != 10 && pair->code != 20 && pair->code != 42) continue;
        status = bat_dxf_number(pair, &value, r->problem);
        if (pair->code == 10) {
            if (any) corner(&made, at, bulge);
            at[0] = value, at[1] = 0, at[2] = height, bulge = 0, any = true;
        }
        if (pair->code == 20) at[1] = value;
        if (pair->code == 42) bulge = value;
    }
    if (any) corner(&made, at, bulge);
    if (status == BAT_OK) status = turn_to_extrusion(r);
    if (status == BAT_OK) return end_corners(r, &made, flag & 1);
    bat_numbers_clear(&made.path.points);
    return status;
}

static bat_status read_polyline(reading *r) {
    enum { CLOSED = 1, SPLINE_FIT = 4, SPACE = 8, MESHES = 16 | 64, FRAME = 16 };
    int flag = 0;
    double base[3], at[3], bulge;
    corners made = {.bulge = 0};
    bat_status status = flags(r, &flag);
    if (status == BAT_OK && flag & MESHES) return status;
    if (status == BAT_OK) status = get_point(r, 10, base);
    for (size_t i = 0; i < r->vertex_count && status == BAT_OK; i++) {
        const bat_dxf_record *vertex = &r->vertices[i];
        double kind;
        status = bat_dxf_get_point(vertex, 10, at, r->problem);
        if (status == BAT_OK) status = bat_dxf_get(vertex, 42, 0, &bulge, r->problem);
        if (status == BAT_OK) status = bat_dxf_get(vertex, 70, 0, &kind, r->problem);
        if (status != BAT_OK || (flag & SPLINE_FIT && (int)fmin(fabs(kind), 1e6) & FRAME)) continue;
        if (!(flag & SPACE)) at[2] = base[2];
        corner(&made, at, flag & SPACE ? 0 : bulge);
    }
    if (status == BAT_OK && !(flag & SPACE)) status = turn_to_extrusion(r);
    if (status == BAT_OK) return end_corners(r, &made, flag & CLOSED);
    bat_numbers_clear(&made.path.points);
    return status;
}

/* ---- splines ---- */

typedef struct spline {
    bat_numbers points, fit, knots, weights;
} spline;

static void clear(spline *s) {
    bat_numbers_clear(&s->points), bat_numbers_clear(&s->fit);
    bat_numbers_clear(&s->knots), bat_numbers_clear(&s->weights);
}

static bat_status no_memory(const reading *r) { return wrong(r, BAT_MEMORY, bat_status_message(BAT_MEMORY)); }

/* One coordinate: x begins a point. */
static bool coordinate(bat_numbers *to, int axis, double value) {
    if (axis == 0) {
        for (int k = 0; k < 3; k++)
            if (!bat_numbers_add(to, 0)) return false;
    } else if (to->count == 0) {
        return true; /* y or z without an x: read over */
    }
    to->list[to->count - 3 + (size_t)axis] = value;
    return true;
}

static bat_status read_lists(const reading *r, spline *s) {
    bat_status status = BAT_OK;
    for (size_t i = 1; i < r->entity->count && status == BAT_OK; i++) {
        const bat_dxf_pair *pair = &r->entity->pairs[i];
        const int axis = pair->code / 10 - 1, unit = pair->code % 10;
        const bool place = axis >= 0 && axis < 3 && (unit == 0 || unit == 1);
        double value;
        bool kept = true;
        if (!place && pair->code != 40 && pair->code != 41) continue;
        status = bat_dxf_number(pair, &value, r->problem);
        if (status != BAT_OK) return status;
        if (place)
            kept = coordinate(unit ? &s->fit : &s->points, axis, value);
        else
            kept = bat_numbers_add(pair->code == 40 ? &s->knots : &s->weights, value);
        if (!kept) status = no_memory(r);
    }
    return status;
}

static void settle(const reading *r, bat_numbers *points) {
    for (size_t i = 0; i + 2 < points->count; i += 3)
        bat_dxf_put(&r->place, points->list + i, points->list + i);
}

/* Clamped and even, where a file leaves them out. */
static bool even_knots(int degree, size_t count, bat_numbers *knots) {
    const int spans = (int)count - degree;
    for (int i = 0; i <= (int)count + degree; i++)
        if (!bat_numbers_add(knots, fmin(fmax(i - degree, 0), spans))) return false;
    return true;
}

static bat_status from_control_points(const reading *r, int degree, spline *s) {
    const size_t count = s->points.count / 3;
    if (count <= (size_t)degree || count > BAT_POINTS_MAX)
        return wrong(r, BAT_COUNT, "expected more control points than the degree, found fewer");
    if (s->knots.count == 0 && !even_knots(degree, count, &s->knots)) return no_memory(r);
    if (s->knots.count != count + (size_t)degree + 1)
        return wrong(r, BAT_KNOTS, "expected as many knots as control points and degree + 1, found others");
    if (s->weights.count > 0 && s->weights.count != count)
        return wrong(r, BAT_COUNT, "expected as many weights as control points, found others");
    settle(r, &s->points);
    const bat_status status = bat_weighted_curve(degree, count, s->points.list, s->weights.list,
                                                 s->knots.list, NULL, r->out);
    if (status == BAT_NUMBER && s->weights.count > 0) return wrong(r, status, BAT_WEIGHTS_EXPECTED);
    return status == BAT_OK ? status : wrong(r, status, bat_status_message(status));
}

static bat_status through_points(const reading *r, bool closed, spline *s) {
    const size_t count = s->fit.count / 3;
    settle(r, &s->fit);
    const int dimension = bat_full_pack(count, s->fit.list);
    const bat_status status = bat_interpolate(dimension, closed, count, s->fit.list, NULL, r->out);
    return status == BAT_OK ? status : wrong(r, status, bat_status_message(status));
}

/* A closed spline whose ends are clamped has no seam that shows. */
static void close_ends(const reading *r) {
    bat_curve *closed = NULL;
    if (!*r->out || bat_curve_is_closed(*r->out)) return;
    if (bat_curve_close(*r->out, 1e-9 * bat_curve_size(*r->out), &closed) != BAT_OK) return;
    bat_curve_free(*r->out);
    *r->out = closed;
}

static bat_status read_spline(reading *r) {
    enum { CLOSED = 1 };
    spline s = {.points = {0}};
    double degree;
    int flag = 0;
    bat_status status = flags(r, &flag);
    if (status == BAT_OK) status = get(r, 71, 3, &degree);
    if (status != BAT_OK || degree > BAT_DEGREE_MAX) return status; /* too high: left out */
    if (degree != floor(degree) || !(degree >= 1))
        return wrong(r, BAT_DEGREE, "expected a degree that is a whole number above 0");
    status = read_lists(r, &s);
    if (status == BAT_OK)
        status = s.points.count > 0 ? from_control_points(r, (int)degree, &s)
                 : s.fit.count > 0  ? through_points(r, flag & CLOSED, &s)
                                    : wrong(r, BAT_COUNT, "expected a spline with points, found none");
    if (status == BAT_OK && flag & CLOSED) close_ends(r);
    clear(&s);
    return status;
}

static const struct {
    const char *name;
    bat_status (*read)(reading *r);
} ENTITIES[] = {{"LINE", read_line},
                {"ARC", read_arc},
                {"CIRCLE", read_arc},
                {"ELLIPSE", read_ellipse},
                {"LWPOLYLINE", read_light_polyline},
                {"POLYLINE", read_polyline},
                {"SPLINE", read_spline}};
enum { ENTITY_COUNT = sizeof ENTITIES / sizeof *ENTITIES };

static int which(const bat_dxf_record *entity) {
    int i = 0;
    while (i < ENTITY_COUNT && !bat_dxf_is(&entity->pairs[0], 0, ENTITIES[i].name)) i++;
    return i;
}

bool bat_dxf_is_curve(const bat_dxf_record *entity) { return which(entity) < ENTITY_COUNT; }

bat_status bat_dxf_curve(const bat_dxf_record *entity, const bat_dxf_record *vertices, size_t vertex_count,
                         const bat_dxf_place *place, const bat_svg_options *how, bat_curve **out,
                         bat_problem *problem) {
    reading r = {entity, vertices, vertex_count, *place, how, out, problem};
    const int i = which(entity);
    *out = NULL;
    if (i == ENTITY_COUNT) return BAT_OK;
    const bat_status status = ENTITIES[i].read(&r);
    /* Far from the origin, what is tiny has its points in one place. */
    if (status == BAT_OK && !(*out && bat_curve_size(*out) == 0)) return status;
    bat_curve_free(*out);
    *out = NULL;
    if (status == BAT_OK) return status;
    /* What cannot be held as it is, such as points that all coincide, is left out; what is wrong was said. */
    if (status != BAT_MEMORY && problem && !problem->message[0]) return BAT_OK;
    return status;
}
