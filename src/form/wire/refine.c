#include "form/wire/refine.h"

#include <math.h>
#include <stdlib.h>

enum { SAMPLES = 8 /* of a span of the wire */, PIECES = 32 /* of a span of the surface, at most */ };
static const double SHARE = 2.0 / 3; /* of the radius: how long a span may be */

/* One direction: where spans begin and end, and how many pieces each is to have. */
typedef struct ruler {
    int count; /* spans */
    double *ends, domain[2];
    int *pieces;
    bool closed;
} ruler;

static bool begin(const bat_surface *surface, bat_direction d, ruler *r) {
    const double *knots = bat_surface_knots(surface, d);
    const int count = bat_surface_knot_count(surface, d);
    *r = (ruler){.closed = bat_surface_is_closed(surface, d)};
    bat_surface_domain(surface, d, r->domain);
    r->ends = malloc(((size_t)count + 2) * sizeof *r->ends);
    r->pieces = malloc(((size_t)count + 2) * sizeof *r->pieces);
    if (!r->ends || !r->pieces) return false;
    r->ends[0] = r->domain[0];
    for (int i = 0; i < count; i++)
        if (knots[i] > r->ends[r->count] && knots[i] < r->domain[1]) r->ends[++r->count] = knots[i];
    r->ends[++r->count] = r->domain[1];
    for (int i = 0; i < r->count; i++) r->pieces[i] = 1;
    return true;
}

static void drop(ruler *r) { free(r->ends), free(r->pieces); }

/* Spans from `from` to `to` are to be `most` long at most. */
static void ask_within(ruler *r, double from, double to, double most) {
    for (int i = 0; i < r->count; i++) {
        const double long_by = (r->ends[i + 1] - r->ends[i]) / most;
        if (r->ends[i + 1] < from || r->ends[i] > to || !(long_by > 1)) continue;
        const int pieces = long_by < PIECES ? (int)ceil(long_by) : PIECES;
        if (pieces > r->pieces[i]) r->pieces[i] = pieces;
    }
}

/* About x within reach; round a closed direction. speed: length for a unit of the parameter. */
static void ask(ruler *r, double x, double radius, double speed) {
    const double reach = radius / speed, most = SHARE * reach, turn = r->domain[1] - r->domain[0];
    if (!(speed > 0) || !(most > 0)) return;
    for (int k = r->closed ? -1 : 0; k <= (r->closed ? 1 : 0); k++)
        ask_within(r, x - reach + k * turn, x + reach + k * turn, most);
}

static double length_of(const double *v) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/* What the wire asks for at one of its places. */
static bat_status ask_at(const bat_surface *surface, const bat_surface_finder *finder, const bat_wire *wire,
                         double u, double share, ruler rulers[2]) {
    const int size = bat_curve_dimension(wire->reference);
    double at[3] = {0, 0, 0}, radius[3], jet[9];
    bat_surface_point near;
    bat_curve_eval(wire->reference, u, 0, at);
    if (size == 2) at[2] = 0;
    bat_function_eval(&wire->radius, share, radius);
    const bat_status status = bat_surface_finder_nearest(finder, at, &near);
    if (status != BAT_OK || !(near.distance < radius[0])) return status;
    bat_surface_eval(surface, near.u, near.v, 1, jet);
    ask(&rulers[0], near.u, radius[0], length_of(jet + 3));
    ask(&rulers[1], near.v, radius[0], length_of(jet + 6));
    return BAT_OK;
}

static bat_status ask_all(const bat_surface *surface, const bat_wire *wire, ruler rulers[2]) {
    const size_t count = SAMPLES * bat_curve_count(wire->reference);
    bat_surface_finder *finder = NULL;
    double domain[2];
    bat_curve_domain(wire->reference, domain);
    bat_status status = bat_surface_finder_create(surface, &finder);
    for (size_t i = 0; i <= count && status == BAT_OK; i++) {
        const double share = (double)i / (double)count;
        status = ask_at(surface, finder, wire, domain[0] + share * (domain[1] - domain[0]), share, rulers);
    }
    bat_surface_finder_free(finder);
    return status;
}

static size_t added(const ruler *r) {
    size_t sum = 0;
    for (int i = 0; i < r->count; i++) sum += (size_t)r->pieces[i] - 1;
    return sum;
}

/* *surface, which is replaced, gets the knots. */
static bat_status put_in(const ruler *r, bat_direction d, bat_surface **surface) {
    const size_t more = added(r);
    double *knots = malloc((more + 1) * sizeof *knots);
    bat_surface *made = NULL;
    int n = 0;
    if (!knots) return BAT_MEMORY;
    for (int i = 0; i < r->count; i++)
        for (int k = 1; k < r->pieces[i]; k++)
            knots[n++] = r->ends[i] + (r->ends[i + 1] - r->ends[i]) * k / r->pieces[i];
    const bat_status status = n > 0 ? bat_surface_insert_knots(*surface, d, n, knots, &made) : BAT_OK;
    free(knots);
    if (!made) return status;
    bat_surface_free(*surface);
    *surface = made;
    return status;
}

bat_status bat_wire_refine(const bat_surface *surface, const bat_wire *wire, bat_surface **out) {
    ruler rulers[2] = {{.count = 0}};
    bat_surface *made = NULL;
    *out = NULL;
    bat_status status = begin(surface, BAT_U, &rulers[0]) && begin(surface, BAT_V, &rulers[1]) ? BAT_OK
                                                                                               : BAT_MEMORY;
    if (status == BAT_OK) status = ask_all(surface, wire, rulers);
    const size_t more[2] = {added(&rulers[0]), added(&rulers[1])},
                 all = (bat_surface_count(surface, BAT_U) + more[0]) *
                       (bat_surface_count(surface, BAT_V) + more[1]);
    if (status == BAT_OK && more[0] + more[1] > 0 && all <= BAT_REFINE_MOST) {
        status = bat_surface_copy(surface, &made);
        for (int d = 0; d < 2 && status == BAT_OK; d++) status = put_in(&rulers[d], (bat_direction)d, &made);
    }
    drop(&rulers[0]), drop(&rulers[1]);
    if (status == BAT_OK)
        *out = made;
    else
        bat_surface_free(made);
    return status;
}
