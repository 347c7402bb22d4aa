/* What an object is bound to: wires, which are the first curves of other objects, and its points as they were when it was
 * bound. While it is bound, its points are where the wires take them (batten/wires.h). Points: the vertices of a mesh, the
 * control points of a surface or of curves; 3 numbers each. */
#ifndef BATTEN_DOCUMENT_BOUND_H
#define BATTEN_DOCUMENT_BOUND_H

#include "base/users.h"

#include <batten/document.h>
#include <batten/wires.h>

enum { BAT_BOUND_SOURCES = 2 * BAT_BOUND_WIRES };

/* Immutable, counted: shared by copies of the object. */
typedef struct bat_bound {
    bat_users users;
    int count, source_count;
    bat_id ids[BAT_BOUND_SOURCES];   /* whose first curves are the wires, then those that are domain curves */
    int bounds[BAT_BOUND_SOURCES];   /* which wire a domain curve bounds, ascending */
    bat_wire wires[BAT_BOUND_WIRES]; /* with curves of their own */
    bat_wire_options options;
    bool flat; /* of curves: they were in the plane */
    size_t point_count;
    double *rest;
    bat_binding *binding;
    uint64_t digest;
} bat_bound;

/* The part of it that each object has for itself; zeros: it is not bound. */
typedef struct bat_hold {
    bat_bound *bound;
    bool known; /* it is where the curves with these digests take it */
    bool moved; /* since then */
    uint64_t digests[BAT_BOUND_SOURCES];
} bat_hold;

/* Copies everything. domains: of each wire the object whose first curve its domain curve is, as it was; 0: none. NULL: of
 * no wire. wrong: as bat_wires_bind. */
bat_status bat_bound_create(size_t count, const bat_wire *wires, const bat_id *ids, const bat_id *domains,
                            const bat_wire_options *options, size_t point_count, const double *rest,
                            bool flat, bat_bound **out, size_t *wrong);
bat_bound *bat_bound_retain(bat_bound *bound);
void bat_bound_release(bat_bound *bound); /* NULL is fine */

/* Where the wires take the points; each curve with the parameters of its reference (form/wire/match.h). report may be NULL. */
bat_status bat_bound_apply(const bat_bound *bound, const bat_curve *const *curves, double *points,
                           bat_wire_report *report);

/* What the same points are bound to in another order: point k of it is point order[k]. *out: of one user, which
 * bat_bound_release ends. */
bat_status bat_bound_reorder(const bat_hold *hold, const size_t *order, bat_hold *out);

/* For kinds whose objects can be bound: what bat_kind_type says. */
bat_status bat_bound_remake(const bat_object *object, const bat_id *ids, const bat_object *const *from,
                            bat_object **out);
/* The image of an object with points, bound or not: what it is bound to goes with it. */
bat_status bat_bound_transform(const bat_object *object, const double rows[12], bat_object **out);

/* Of each wire the object whose first curve bounds its reach, among the sources of the bound; NULL: none. */
void bat_bound_domains(const bat_bound *bound, const bat_object *const *from,
                       const bat_object *out[BAT_BOUND_WIRES]);

/* NULL: the kind can't be bound, or the object is not. */
const bat_hold *bat_object_hold(const bat_object *object);

#endif
