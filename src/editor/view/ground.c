#include "editor/view/ground.h"
#include "base/vec.h"
#include "curve/curve.h"
#include "document/kind.h"
#include "editor/view/casters.h"
#include <math.h>
#include <string.h>

static const double EDGE_ON = 0.0871557427476581736; /* sine of 5 degrees */

/* ---- the page: z = 0 ---- */

static bat_status hit_page(const bat_ground *ground, bat_casters *casters, const bat_ray *ray,
                           const bat_hit *last, bat_hit *out) {
    (void)ground, (void)casters, (void)last;
    double far = 0;
    /* Face-on, rays begin on the page, so the point is taken over unchanged, however far away. */
    const bool across = ray->along[0] == 0 && ray->along[1] == 0;
    if (!(fabs(ray->along[2]) >= EDGE_ON)) return BAT_SINGULAR;
    if (!across) far = -ray->from[2] / ray->along[2];
    for (int k = 0; k < 2; k++) {
        const double at = across ? ray->from[k] : ray->from[k] + far * ray->along[k];
        if (!across && !(fabs(at) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
        out->at[k] = out->own[k] = at;
    }
    out->at[2] = 0;
    out->normal[2] = 1;
    return BAT_OK;
}

/* ---- a plane in space: origin, x axis, y axis ---- */

static bool good_plane(const double *frame) {
    const double *x = frame + 3, *y = frame + 6;
    return bat_are_coordinates(frame, 9) && fabs(vec_dot3(x, x) - 1) <= 1e-9 &&
           fabs(vec_dot3(y, y) - 1) <= 1e-9 && fabs(vec_dot3(x, y)) <= 1e-9;
}

static bat_status hit_plane(const bat_ground *ground, bat_casters *casters, const bat_ray *ray,
                            const bat_hit *last, bat_hit *out) {
    (void)casters, (void)last;
    const double *origin = ground->numbers, *x = origin + 3, *y = origin + 6;
    const double normal[3] = {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2],
                              x[0] * y[1] - x[1] * y[0]};
    double away[3], towards = vec_dot3(ray->along, normal);
    for (int k = 0; k < 3; k++) away[k] = origin[k] - ray->from[k];
    if (!(fabs(towards) >= EDGE_ON)) return BAT_SINGULAR;
    double far = vec_dot3(away, normal) / towards;
    for (int k = 0; k < 3; k++) {
        out->at[k] = ray->from[k] + far * ray->along[k];
        if (!(fabs(out->at[k]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
        away[k] = out->at[k] - origin[k];
    }
    out->own[0] = vec_dot3(away, x);
    out->own[1] = vec_dot3(away, y);
    memcpy(out->normal, normal, sizeof normal);
    return BAT_OK;
}

/* ---- the ruled surface of a curve: its direction, the object, the number of the curve ---- */

static bool whole(double number, double low) {
    return number >= low && number <= BAT_ID_MAX && number == floor(number);
}

static bool good_ruled(const double *n) {
    return fabs(vec_dot3(n, n) - 1) <= 1e-9 && whole(n[3], 1) && whole(n[4], 0);
}

static bat_status fate(bat_cast_fate fate) {
    return fate == BAT_CAST_LANDED ? BAT_OK : fate == BAT_CAST_EDGE_ON ? BAT_SINGULAR : BAT_FAR;
}

static bat_status hit_ruled(const bat_ground *ground, bat_casters *casters, const bat_ray *ray,
                            const bat_hit *last, bat_hit *out) {
    const double *along = ground->numbers;
    bat_cast_point place;
    bat_casting *found = NULL;
    bat_status status = bat_casters_find(casters, (bat_id)along[3], (int)along[4], along, &found);
    if (status == BAT_OK)
        status = bat_caster_line(found->caster, ray->from, ray->along, last ? last->own[0] : NAN, &place);
    if (status == BAT_OK) status = fate(place.fate);
    if (status != BAT_OK) return status;
    double jet[2 * BAT_DIMENSION_MAX] = {0};
    const int dimension = bat_curve_dimension(found->line);
    bat_curve_eval(found->line, place.own[0], 1, jet);
    memcpy(out->at, place.point, sizeof out->at);
    memcpy(out->own, place.own, sizeof out->own);
    vec_store(vec_unit(vec_cross(vec_load(jet + dimension, dimension), vec_load(along, 3))), out->normal);
    return BAT_OK;
}

/* ---- a surface: the object ---- */

static bool good_surface(const double *n) { return whole(n[0], 1); }

/* On the plane through the last place, at right angles to the normal there. */
static bat_status hit_beside(const bat_ray *ray, const bat_hit *last, bat_hit *out) {
    const vec n = vec_load(last->normal, 3), at = vec_load(last->at, 3), from = vec_load(ray->from, 3),
              along = vec_load(ray->along, 3);
    const double towards = vec_dot(along, n);
    if (!(fabs(towards) >= EDGE_ON)) return BAT_SINGULAR;
    vec_store(vec_add(from, vec_scale(along, vec_dot(vec_sub(at, from), n) / towards)), out->at);
    for (int k = 0; k < 3; k++)
        if (!(fabs(out->at[k]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    memcpy(out->normal, last->normal, sizeof out->normal);
    memcpy(out->own, last->own, sizeof out->own);
    out->beside = true;
    return BAT_OK;
}

static bat_status hit_surface(const bat_ground *ground, bat_casters *casters, const bat_ray *ray,
                              const bat_hit *last, bat_hit *out) {
    static const double none[3] = {0};
    bat_cast_point place;
    bat_casting *found = NULL;
    if (last && last->beside) return hit_beside(ray, last, out);
    bat_status status = bat_casters_find(casters, (bat_id)ground->numbers[0], -1, none, &found);
    if (status == BAT_OK) status = bat_caster_line(found->caster, ray->from, ray->along, NAN, &place);
    if (status != BAT_OK) return status;
    if (place.fate == BAT_CAST_MISSED && last) return hit_beside(ray, last, out);
    status = fate(place.fate);
    if (status == BAT_OK)
        status = bat_surface_normal(found->surface, place.own[0], place.own[1], out->normal);
    if (status != BAT_OK) return status;
    memcpy(out->at, place.point, sizeof out->at);
    memcpy(out->own, place.own, sizeof out->own);
    return BAT_OK;
}

enum { PAGE, PLANE, OF_VIEW, RULED, SURFACE };
static const bat_ground_type GROUNDS[] = {[PAGE] = {"page", 2, 0, NULL, hit_page},
                                          [PLANE] = {"plane", 3, 9, good_plane, hit_plane},
                                          [OF_VIEW] = {"view", 3, 9, good_plane, hit_plane},
                                          [RULED] = {"ruled", 3, 5, good_ruled, hit_ruled},
                                          [SURFACE] = {"surface", 3, 1, good_surface, hit_surface}};

bat_ground bat_ground_plane(const double origin[3], const double x[3], const double y[3]) {
    bat_ground ground = {.type = &GROUNDS[PLANE]};
    memcpy(ground.numbers, origin, 3 * sizeof *origin);
    memcpy(ground.numbers + 3, x, 3 * sizeof *x);
    memcpy(ground.numbers + 6, y, 3 * sizeof *y);
    return ground;
}

bat_ground bat_ground_of_view(const double origin[3], const double x[3], const double y[3]) {
    bat_ground ground = bat_ground_plane(origin, x, y);
    ground.type = &GROUNDS[OF_VIEW];
    return ground;
}

bool bat_ground_is_of_view(const bat_ground *ground) { return ground->type == &GROUNDS[OF_VIEW]; }

bat_ground bat_ground_ruled(bat_id object, int curve, const double along[3]) {
    return (bat_ground){.type = &GROUNDS[RULED],
                        .numbers = {along[0], along[1], along[2], (double)object, (double)curve},
                        .object = object};
}

bool bat_ground_rules(const bat_ground *ground, bat_id object, int curve) {
    return ground->type == &GROUNDS[RULED] && ground->numbers[3] == (double)object &&
           ground->numbers[4] == (double)curve;
}

bat_ground bat_ground_page(void) { return (bat_ground){.type = &GROUNDS[PAGE]}; }

const char *bat_ground_name(int index) {
    return index >= 0 && (size_t)index < sizeof GROUNDS / sizeof *GROUNDS ? GROUNDS[index].name : NULL;
}

bool bat_ground_named(const char *name, int count, const double *numbers, bat_ground *out) {
    for (size_t i = 0; i < sizeof GROUNDS / sizeof *GROUNDS; i++) {
        const bat_ground_type *type = &GROUNDS[i];
        if (strcmp(type->name, name) || type->numbers != count || (type->good && !type->good(numbers)))
            continue;
        *out = (bat_ground){.type = type};
        memcpy(out->numbers, numbers, (size_t)count * sizeof *numbers);
        return true;
    }
    return false;
}

bool bat_ground_of(const bat_object *object, bat_ground *out) {
    const bat_kind_type *kind = bat_object_type(object);
    int count = 0;
    const double id = (double)bat_object_id(object);
    const double *numbers = kind->ground ? kind->ground(object, &count) : NULL;
    if (bat_object_surface(object)) numbers = &id, count = 1;
    bool found = numbers && bat_ground_named(kind->name, count, numbers, out);
    if (found) out->object = bat_object_id(object);
    return found;
}

bool bat_ground_bounded(const bat_ground *ground) { return ground->type >= &GROUNDS[RULED]; }

void bat_ground_axes(const bat_ground *ground, double x[3], double y[3]) {
    static const double page[6] = {1, 0, 0, 0, 1, 0};
    const double *axes = ground->type == &GROUNDS[PLANE] || ground->type == &GROUNDS[OF_VIEW]
                             ? ground->numbers + 3
                             : page;
    for (int k = 0; k < 3; k++) {
        x[k] = axes[k];
        y[k] = axes[3 + k];
    }
}

void bat_ground_at(const bat_ground *ground, const double own[2], double at[3]) {
    double x[3], y[3];
    bat_ground_axes(ground, x, y); /* the page has no numbers: its origin is 0 */
    for (int k = 0; k < 3; k++) at[k] = ground->numbers[k] + own[0] * x[k] + own[1] * y[k];
}

bool bat_ground_same(const bat_ground *a, const bat_ground *b) {
    bool same = a->type == b->type;
    for (int k = 0; k < BAT_GROUND_NUMBERS; k++) same = same && a->numbers[k] == b->numbers[k];
    return same;
}
