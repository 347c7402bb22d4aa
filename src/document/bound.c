#include "document/bound.h"
#include "base/matrix.h"
#include "base/pose.h"
#include "curve/curve.h"
#include "curve/function.h"
#include "document/digest.h"
#include "document/kind.h"
#include "form/wire/match.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- a bound ---- */

static bat_status copy_wire(const bat_wire *from, bat_wire *to) {
    bat_curve *reference = NULL, *domain = NULL;
    bat_status status = from->reference ? bat_curve_copy(from->reference, &reference) : BAT_ARGUMENT;
    to->reference = reference;
    if (status == BAT_OK && from->domain) status = bat_curve_copy(from->domain, &domain);
    to->domain = domain;
    to->turn = from->turn;
    if (status == BAT_OK) status = bat_function_copy(&from->radius, &to->radius);
    if (status == BAT_OK) status = bat_function_copy(&from->scale, &to->scale);
    return status;
}

bat_bound *bat_bound_retain(bat_bound *bound) {
    bat_users_add(&bound->users);
    return bound;
}

void bat_bound_release(bat_bound *bound) {
    if (!bound || !bat_users_drop(&bound->users)) return;
    for (int i = 0; i < bound->count; i++) {
        bat_curve_free((bat_curve *)bound->wires[i].reference); /* its own */
        bat_curve_free((bat_curve *)bound->wires[i].domain);
        bat_function_clear(&bound->wires[i].radius), bat_function_clear(&bound->wires[i].scale);
    }
    bat_binding_free(bound->binding);
    free(bound->rest);
    free(bound);
}

static uint64_t digest_function(uint64_t digest, const bat_function *f) {
    return f->curve ? bat_digest_curve(digest, f->curve) : bat_digest_double(digest, f->constant);
}

static uint64_t digest_of(const bat_bound *bound) {
    uint64_t digest = bat_digest_number(bat_digest_begin(), (uint64_t)bound->count);
    for (int i = 0; i < bound->count; i++) {
        const bat_wire *wire = &bound->wires[i];
        digest = bat_digest_number(digest, bound->ids[i]);
        digest = bat_digest_curve(digest, wire->reference);
        digest = digest_function(digest_function(digest, &wire->radius), &wire->scale);
        digest = wire->domain ? bat_digest_curve(digest, wire->domain) : bat_digest_number(digest, 0);
        if (wire->turn != BAT_TURN_TANGENT) digest = bat_digest_number(digest, (uint64_t)wire->turn);
    }
    digest = bat_digest_number(digest, (uint64_t)bound->options.blend);
    digest = bat_digest_double(digest, bound->options.exponent);
    digest = bat_digest_number(digest, bound->flat);
    for (int i = bound->count; i < bound->source_count; i++) {
        digest = bat_digest_number(digest, bound->ids[i]);
        digest = bat_digest_number(digest, (uint64_t)bound->bounds[i]);
    }
    for (size_t k = 0; k < 3 * bound->point_count; k++) digest = bat_digest_double(digest, bound->rest[k]);
    return digest;
}

bat_status bat_bound_create(size_t count, const bat_wire *wires, const bat_id *ids, const bat_id *domains,
                            const bat_wire_options *options, size_t point_count, const double *rest,
                            bool flat, bat_bound **out, size_t *wrong) {
    if (count < 1 || count > BAT_BOUND_WIRES) return BAT_COUNT;
    bat_bound *bound = calloc(1, sizeof *bound);
    if (!bound) return BAT_MEMORY;
    *bound = (bat_bound){.users = BAT_USERS_ONE, .flat = flat, .point_count = point_count};
    bound->options = options ? *options : bat_wire_defaults();
    bound->rest = malloc((3 * point_count + 1) * sizeof *rest);
    bat_status status = bound->rest ? BAT_OK : BAT_MEMORY;
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        bound->count++;
        bound->ids[i] = ids[i];
        status = copy_wire(&wires[i], &bound->wires[i]);
    }
    bound->source_count = bound->count;
    for (int i = 0; i < bound->count && domains; i++)
        if (domains[i])
            bound->bounds[bound->source_count] = i, bound->ids[bound->source_count++] = domains[i];
    if (status == BAT_OK) {
        memcpy(bound->rest, rest, 3 * point_count * sizeof *rest);
        status = bat_wires_bind(count, bound->wires, point_count, bound->rest, &bound->options,
                                &bound->binding, wrong);
    }
    if (status == BAT_OK)
        bound->digest = digest_of(bound), *out = bound;
    else
        bat_bound_release(bound);
    return status;
}

/* ---- applying ---- */

bat_status bat_bound_apply(const bat_bound *bound, const bat_curve *const *curves, double *points,
                           bat_wire_report *report) {
    const bat_curve *mapped[BAT_BOUND_WIRES];
    bat_curve *own[BAT_BOUND_WIRES] = {NULL};
    bat_status status = BAT_OK;
    for (int i = 0; i < bound->count && status == BAT_OK; i++) {
        status = bat_wire_match(bound->wires[i].reference, curves[i], &own[i]);
        mapped[i] = own[i] ? own[i] : curves[i];
    }
    memcpy(points, bound->rest, 3 * bound->point_count * sizeof *points);
    if (status == BAT_OK) status = bat_binding_apply(bound->binding, mapped, points, report, NULL);
    for (int i = 0; i < bound->count; i++) bat_curve_free(own[i]);
    return status;
}

/* ---- objects ---- */

const bat_hold *bat_object_hold(const bat_object *object) {
    const bat_kind_type *type = bat_object_type(object);
    const bat_hold *hold = type->hold ? type->hold(bat_object_own(object, type)) : NULL;
    return hold && hold->bound ? hold : NULL;
}

int bat_object_wires(const bat_object *object, const bat_wire **wires, const bat_wire_options **options) {
    const bat_hold *hold = bat_object_hold(object);
    if (wires) *wires = hold ? hold->bound->wires : NULL;
    if (options) *options = hold ? &hold->bound->options : NULL;
    return hold ? hold->bound->count : 0;
}

void bat_bound_domains(const bat_bound *bound, const bat_object *const *from,
                       const bat_object *out[BAT_BOUND_WIRES]) {
    for (int i = 0; i < bound->count; i++) out[i] = NULL;
    for (int i = bound->count; i < bound->source_count; i++) out[bound->bounds[i]] = from[i];
}

/* Of each wire the id of the object that bounds its reach, 0: none; ids: of the sources. */
static void domain_ids(const bat_bound *bound, const bat_id *ids, bat_id out[BAT_BOUND_WIRES]) {
    for (int i = 0; i < bound->count; i++) out[i] = 0;
    for (int i = bound->count; i < bound->source_count; i++) out[bound->bounds[i]] = ids[i];
}

/* The same with the domain curves as they are now; it is itself, retained, if they are no others. */
static bat_status bounded_anew(bat_bound *bound, const bat_object *const *from, bat_bound **out) {
    bat_wire wires[BAT_BOUND_WIRES];
    bat_id domains[BAT_BOUND_WIRES];
    bool same = true;
    memcpy(wires, bound->wires, sizeof wires);
    for (int i = bound->count; i < bound->source_count; i++) {
        const bat_curve *now = bat_object_curve(from[i], 0);
        same = same && bat_curve_is_equal(wires[bound->bounds[i]].domain, now);
        wires[bound->bounds[i]].domain = now;
    }
    *out = same ? bat_bound_retain(bound) : NULL;
    if (same) return BAT_OK;
    domain_ids(bound, bound->ids, domains);
    return bat_bound_create((size_t)bound->count, wires, bound->ids, domains, &bound->options,
                            bound->point_count, bound->rest, bound->flat, out, NULL);
}

/* The object where the bound takes it; from: its sources. */
static bat_status pull(const bat_object *object, bat_bound *was, const bat_object *const *from,
                       bat_object **out) {
    const bat_curve *curves[BAT_BOUND_WIRES];
    bat_hold hold = {.known = true};
    double *points = malloc((3 * was->point_count + 1) * sizeof *points);
    bat_status status = points ? bounded_anew(was, from, &hold.bound) : BAT_MEMORY;
    for (int i = 0; i < was->source_count; i++) hold.digests[i] = bat_object_curve_digest(from[i], 0);
    for (int i = 0; i < was->count; i++) curves[i] = bat_object_curve(from[i], 0);
    if (status == BAT_OK) status = bat_bound_apply(hold.bound, curves, points, NULL);
    if (status == BAT_OK) status = bat_object_type(object)->put(object, points, &hold, out);
    bat_bound_release(hold.bound);
    free(points);
    return status;
}

/* Where its points are; the caller frees them. */
static double *points_of(const bat_object *object, size_t *count) {
    const bat_kind_type *type = bat_object_type(object);
    *count = type->points(object, NULL);
    double *points = malloc((3 * *count + 1) * sizeof *points);
    if (points) type->points(object, points);
    return points;
}

static bool is_flat(const bat_object *object) {
    return bat_object_is_made_of_curves(object) && bat_curve_dimension(bat_object_curve(object, 0)) == 2;
}

static bat_status take_ids(const bat_object *object, size_t count, const bat_object *const *curves,
                           bat_id *ids) {
    for (size_t i = 0; i < count; i++) {
        if (!bat_object_leads(curves[i])) return BAT_ARGUMENT;
        ids[i] = bat_object_id(curves[i]);
        if (ids[i] == bat_object_id(object)) return BAT_ARGUMENT;
        for (size_t k = 0; k < i; k++)
            if (ids[k] == ids[i]) return BAT_ARGUMENT;
    }
    return BAT_OK;
}

/* The domain curves of objects: into wires, their objects behind the wires' in from, their ids into domains. */
static bat_status take_domains(const bat_object *object, size_t count, const bat_object *const *given,
                               bat_wire *wires, const bat_object **from, bat_id *domains) {
    for (size_t i = 0; i < count; i++) {
        const bat_object *domain = given ? given[i] : NULL;
        domains[i] = domain ? bat_object_id(domain) : 0;
        if (!domain) continue;
        if (!bat_object_leads(domain) || domains[i] == bat_object_id(object)) return BAT_ARGUMENT;
        wires[i].domain = bat_object_curve(domain, 0);
        *from++ = domain;
    }
    return BAT_OK;
}

bat_status bat_object_bind(const bat_object *object, size_t count, const bat_wire *wires,
                           const bat_object *const *curves, const bat_object *const *domains,
                           const bat_wire_options *options, bat_object **out) {
    bat_id ids[BAT_BOUND_WIRES], bounds[BAT_BOUND_WIRES];
    bat_wire own[BAT_BOUND_WIRES];
    const bat_object *from[BAT_BOUND_SOURCES];
    if (!object || !wires || !curves || !out) return BAT_ARGUMENT;
    if (!bat_object_type(object)->put) return BAT_UNSUPPORTED;
    if (count < 1 || count > BAT_BOUND_WIRES) return BAT_COUNT;
    memcpy(own, wires, count * sizeof *own);
    memcpy(from, curves, count * sizeof *from);
    bat_status status = take_ids(object, count, curves, ids);
    if (status == BAT_OK) status = take_domains(object, count, domains, own, from + count, bounds);
    if (status != BAT_OK) return status;
    const bat_hold *was = bat_object_hold(object);
    size_t points;
    double *now = points_of(object, &points);
    bat_bound *bound = NULL;
    status = now ? bat_bound_create(count, own, ids, bounds, options, points, was ? was->bound->rest : now,
                                    was ? was->bound->flat : is_flat(object), &bound, NULL)
                 : BAT_MEMORY;
    free(now);
    if (status == BAT_OK) status = pull(object, bound, from, out);
    bat_bound_release(bound);
    return status;
}

bat_status bat_object_unbind(const bat_object *object, bool revert, bat_object **out) {
    const bat_hold *hold = object ? bat_object_hold(object) : NULL;
    if (!hold || !out) return BAT_ARGUMENT;
    const bat_kind_type *type = bat_object_type(object);
    const bat_hold none = {.bound = NULL};
    size_t count;
    double *now = revert ? NULL : points_of(object, &count);
    if (!revert && !now) return BAT_MEMORY;
    const bat_status status = type->put(object, revert ? hold->bound->rest : now, &none, out);
    free(now);
    return status;
}

/* ---- following ---- */

/* A domain curve whose id is 0 stays as it is. */
static bat_status renumbered(const bat_object *object, const bat_hold *hold, const bat_id *ids,
                             bat_object **out) {
    const bat_bound *bound = hold->bound;
    bat_id domains[BAT_BOUND_WIRES];
    bat_hold next = {.bound = NULL};
    size_t count;
    double *now = points_of(object, &count);
    if (!now) return BAT_MEMORY;
    domain_ids(bound, ids, domains);
    bat_status status = bat_bound_create((size_t)bound->count, bound->wires, ids, domains, &bound->options,
                                         count, bound->rest, bound->flat, &next.bound, NULL);
    if (status == BAT_OK) status = bat_object_type(object)->put(object, now, &next, out);
    bat_bound_release(next.bound);
    free(now);
    return status;
}

static bool is_up_to_date(const bat_hold *hold, const bat_object *const *from) {
    bool same = hold->known;
    for (int i = 0; i < hold->bound->source_count && same; i++)
        same = hold->digests[i] == bat_object_curve_digest(from[i], 0);
    return same;
}

/* The ids of those that are there, 0 of the others; false: all are. */
static bool is_short(const bat_bound *bound, const bat_object *const *from, bat_id ids[BAT_BOUND_SOURCES]) {
    bool lacks = false;
    for (int i = 0; i < bound->source_count; i++) {
        ids[i] = from[i] ? bound->ids[i] : 0;
        lacks = lacks || !from[i];
    }
    return lacks;
}

static bool has_wires(const bat_bound *bound, const bat_id *ids) {
    for (int i = 0; i < bound->count; i++)
        if (!ids[i]) return false;
    return true;
}

/* Without the sources whose ids are 0. */
static bat_status without(const bat_object *object, const bat_bound *bound, const bat_id *ids,
                          const bat_object *const *from, bat_object **out) {
    const bat_object *left[BAT_BOUND_SOURCES];
    bat_object *loose = NULL;
    int count = 0;
    for (int i = 0; i < bound->source_count; i++)
        if (ids[i]) left[count++] = from[i];
    bat_status status = bat_bound_remake(object, ids, NULL, &loose);
    if (status == BAT_OK && bat_object_hold(loose)) {
        status = bat_bound_remake(loose, NULL, left, out);
        bat_object_release(loose);
    } else if (status == BAT_OK) {
        *out = loose;
    }
    return status;
}

bat_status bat_bound_remake(const bat_object *object, const bat_id *ids, const bat_object *const *from,
                            bat_object **out) {
    const bat_hold *hold = bat_object_hold(object);
    bat_id left[BAT_BOUND_SOURCES];
    *out = NULL;
    if (!hold) return BAT_OK;
    if (!ids && from && is_short(hold->bound, from, left))
        return without(object, hold->bound, left, from, out);
    if (ids)
        return has_wires(hold->bound, ids) ? renumbered(object, hold, ids, out)
                                           : bat_object_unbind(object, false, out);
    if (from && is_up_to_date(hold, from)) {
        if (!hold->moved) return BAT_OK;
        from = NULL; /* it was moved away from its wires */
    }
    bat_status status = from ? pull(object, hold->bound, from, out) : BAT_STATE;
    return status == BAT_OK || status == BAT_MEMORY ? status : bat_object_unbind(object, false, out);
}

/* ---- another order ---- */

bat_status bat_bound_reorder(const bat_hold *hold, const size_t *order, bat_hold *out) {
    const bat_bound *bound = hold->bound;
    bat_id domains[BAT_BOUND_WIRES];
    domain_ids(bound, bound->ids, domains);
    double *rest = malloc((3 * bound->point_count + 1) * sizeof *rest);
    if (!rest) return BAT_MEMORY;
    for (size_t k = 0; k < bound->point_count; k++)
        memcpy(rest + 3 * k, bound->rest + 3 * order[k], 3 * sizeof *rest);
    *out = *hold;
    const bat_status status = bat_bound_create((size_t)bound->count, bound->wires, bound->ids, domains,
                                               &bound->options, bound->point_count, rest, bound->flat,
                                               &out->bound, NULL);
    free(rest);
    return status;
}

/* ---- affine images ---- */

static bat_status image_curve(const bat_curve *curve, const double rows[12], bat_curve **out) {
    *out = NULL;
    return curve ? bat_curve_posed(curve, rows, out) : BAT_OK;
}

static bat_status image_radius(const bat_function *radius, double factor, bat_function *out) {
    const double rows[6] = {factor, 0, 0, 0, 1, 0};
    *out = (bat_function){radius->constant * factor, NULL};
    return radius->curve ? bat_curve_transform(radius->curve, rows, &out->curve) : BAT_OK;
}

/* A hold on the image, with a bound of its own. */
static bat_status image_hold(const bat_hold *hold, const double rows[12], bat_hold *out) {
    const bat_bound *bound = hold->bound;
    double matrix[6];
    const bool planar = bat_pose_in_plane(rows, matrix);
    const double area = planar ? bat_matrix_area(matrix) : 1;
    const double factor = area > 0 ? sqrt(area) : 1;
    bat_wire wires[BAT_BOUND_WIRES] = {{.reference = NULL}};
    bat_id domains[BAT_BOUND_WIRES];
    domain_ids(bound, bound->ids, domains);
    double *rest = malloc((3 * bound->point_count + 1) * sizeof *rest);
    bat_status status = rest ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) bat_pose_apply(rows, bound->point_count, bound->rest, rest);
    for (int i = 0; i < bound->count && status == BAT_OK; i++) {
        bat_curve *reference = NULL, *domain = NULL;
        status = image_curve(bound->wires[i].reference, rows, &reference);
        wires[i].scale = bound->wires[i].scale; /* borrowed */
        wires[i].turn = bound->wires[i].turn;
        wires[i].reference = reference;
        if (status == BAT_OK) status = image_curve(bound->wires[i].domain, rows, &domain);
        wires[i].domain = domain;
        if (status == BAT_OK) status = image_radius(&bound->wires[i].radius, factor, &wires[i].radius);
    }
    *out = *hold;
    out->bound = NULL, out->moved = true;
    if (status == BAT_OK)
        status = bat_bound_create((size_t)bound->count, wires, bound->ids, domains, &bound->options,
                                  bound->point_count, rest, bound->flat && planar, &out->bound, NULL);
    for (int i = 0; i < bound->count; i++) {
        bat_curve_free((bat_curve *)wires[i].reference), bat_curve_free((bat_curve *)wires[i].domain);
        bat_function_clear(&wires[i].radius);
    }
    free(rest);
    return status;
}

bat_status bat_bound_transform(const bat_object *object, const double rows[12], bat_object **out) {
    const bat_hold *hold = bat_object_hold(object);
    bat_hold next = {.bound = NULL};
    size_t count;
    double *points = points_of(object, &count);
    if (!points) return BAT_MEMORY;
    bat_pose_apply(rows, count, points, points);
    bat_status status = hold ? image_hold(hold, rows, &next) : BAT_OK;
    if (status == BAT_OK) status = bat_object_type(object)->put(object, points, &next, out);
    bat_bound_release(next.bound);
    free(points);
    return status;
}
