#include "editor/view/ground.h"
#include "base/vec.h"
#include "curve/curve.h"
#include "document/kind.h"
#include <math.h>
#include <string.h>

static const double EDGE_ON = 0.0871557427476581736; /* sine of 5 degrees */

/* ---- the page: z = 0 ---- */

static bat_status hit_page(const bat_ground *ground, const bat_ray *ray, bat_hit *out) {
    (void)ground;
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
    return BAT_OK;
}

/* ---- a plane in space: origin, x axis, y axis ---- */

static bool good_plane(const double *frame) {
    const double *x = frame + 3, *y = frame + 6;
    return bat_are_coordinates(frame, 9) && fabs(vec_dot3(x, x) - 1) <= 1e-9 &&
           fabs(vec_dot3(y, y) - 1) <= 1e-9 && fabs(vec_dot3(x, y)) <= 1e-9;
}

static bat_status hit_plane(const bat_ground *ground, const bat_ray *ray, bat_hit *out) {
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
    return BAT_OK;
}

static const bat_ground_type GROUNDS[] = {{"page", 2, 0, NULL, hit_page},
                                          {"plane", 3, 9, good_plane, hit_plane}};

bat_ground bat_ground_page(void) { return (bat_ground){.type = &GROUNDS[0]}; }

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
    const double *numbers = kind->ground ? kind->ground(object, &count) : NULL;
    bool found = numbers && bat_ground_named(kind->name, count, numbers, out);
    if (found) out->object = bat_object_id(object);
    return found;
}

void bat_ground_axes(const bat_ground *ground, double x[3], double y[3]) {
    static const double page[6] = {1, 0, 0, 0, 1, 0};
    const double *axes = ground->type->numbers ? ground->numbers + 3 : page;
    for (int k = 0; k < 3; k++) {
        x[k] = axes[k];
        y[k] = axes[3 + k];
    }
}

bool bat_ground_same(const bat_ground *a, const bat_ground *b) {
    bool same = a->type == b->type;
    for (int k = 0; k < BAT_GROUND_NUMBERS; k++) same = same && a->numbers[k] == b->numbers[k];
    return same;
}
