/* Binding: the closest point of each reference, the strength there, and the shares of several wires. */
#include "form/wire/wire.h"
#include "base/options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES = 32 /* of a function a span */ };

static const bat_wire_options DEFAULTS = {.size = sizeof DEFAULTS, .blend = BAT_BLEND_CROSS, .exponent = 1};
static const double on_wire = 1 - 1e-12; /* a strength above counts as 1 */

void bat_wire_options_init(bat_wire_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

void bat_binding_free(bat_binding *binding) {
    if (!binding) return;
    for (size_t w = 0; binding->wires && w < binding->wire_count; w++) {
        bat_finder_free(binding->wires[w].finder);
        bat_wire_frames_end(&binding->wires[w].frames);
        bat_curve_free(binding->wires[w].reference);
        free(binding->wires[w].influences);
    }
    free(binding->wires);
    free(binding->points);
    free(binding->rest);
    free(binding);
}

size_t bat_binding_count(const bat_binding *binding) { return binding->slot_count; }

/* ---- what is given ---- */

/* The least and the greatest value of a function, among samples. */
static void range_of(const bat_function *f, double range[2]) {
    const size_t count = f->curve ? SAMPLES * bat_curve_count(f->curve) : 1;
    range[0] = INFINITY, range[1] = -INFINITY;
    for (size_t i = 0; i <= count; i++) {
        double value[3];
        bat_function_eval(f, (double)i / (double)count, value);
        range[0] = fmin(range[0], value[0]), range[1] = fmax(range[1], value[0]);
    }
}

static bat_status check_wire(const bat_wire *wire) {
    double range[2];
    if (!wire->reference || (unsigned)wire->turn > BAT_TURN_FRAMES) return BAT_ARGUMENT;
    bat_status status = bat_function_check(&wire->radius, NULL);
    if (status == BAT_OK) status = bat_function_check(&wire->scale, NULL);
    if (status != BAT_OK) return status;
    range_of(&wire->radius, range);
    return range[0] > 0 ? BAT_OK : BAT_PARAMETER;
}

static bat_status check(size_t wire_count, const bat_wire *wires, const bat_wire_options *options,
                        size_t point_count, const double *points, size_t *wrong) {
    if (wire_count < 1 || point_count > BAT_POINTS_MAX) return BAT_COUNT;
    if (options->blend < BAT_BLEND_CROSS || options->blend > BAT_BLEND_LOCAL ||
        !(options->exponent > 0 && options->exponent < INFINITY))
        return BAT_ARGUMENT;
    for (*wrong = 0; *wrong < wire_count; ++*wrong) {
        bat_status status = check_wire(&wires[*wrong]);
        if (status != BAT_OK) return status;
    }
    for (size_t i = 0; i < 3 * point_count; i++) {
        *wrong = i / 3;
        if (!(fabs(points[i]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    }
    return BAT_OK;
}

/* ---- one wire ---- */

/* What is needed while a wire is being bound. */
typedef struct fastening {
    const bat_wire *wire;
    bat_curve *domain;      /* in space; NULL: none */
    bat_finder *beside;     /* of the domain curve */
    double start, length;   /* of the reference's domain */
    double low[3], high[3]; /* the box outside of which nothing feels the wire */
} fastening;

static void add_box(const bat_curve *curve, double low[3], double high[3]) {
    const double *p = bat_curve_points(curve);
    for (size_t i = 0; i < 3 * bat_curve_count(curve); i++) {
        low[i % 3] = fmin(low[i % 3], p[i]);
        high[i % 3] = fmax(high[i % 3], p[i]);
    }
}

static bat_status begin(const bat_wire *wire, bat_bound_wire *to, fastening *f) {
    double domain[2], range[2], most = 0;
    *f = (fastening){.wire = wire};
    bat_curve_domain(wire->reference, domain);
    f->start = domain[0], f->length = domain[1] - domain[0];
    bat_status status = bat_curve_to_dimension(wire->reference, 3, &to->reference);
    if (status == BAT_OK) status = bat_finder_create(to->reference, &to->finder);
    if (status == BAT_OK && wire->domain) status = bat_curve_to_dimension(wire->domain, 3, &f->domain);
    if (status == BAT_OK && f->domain) status = bat_finder_create(f->domain, &f->beside);
    if (status != BAT_OK) return status;
    for (int c = 0; c < 3; c++) f->low[c] = INFINITY, f->high[c] = -INFINITY;
    add_box(to->reference, f->low, f->high);
    for (int c = 0; c < 3; c++) most = fmax(most, fmax(fabs(f->low[c]), fabs(f->high[c])));
    to->rounding = 0x1p-48 * most;
    range_of(&wire->radius, range);
    double reach = wire->radius.curve ? 1.01 * range[1] : range[1]; /* samples may miss the top */
    if (f->domain) { /* it reaches as far as the domain curve at most */
        add_box(f->domain, f->low, f->high);
        for (int c = 0; c < 3; c++) reach = fmax(reach, 2 * (f->high[c] - f->low[c]));
    }
    for (int c = 0; c < 3; c++) f->low[c] -= reach, f->high[c] += reach;
    return BAT_OK;
}

static double radius_at(const fastening *f, double share, vec foot, vec away) {
    double radius[3];
    bat_function_eval(&f->wire->radius, share, radius);
    if (!f->beside) return radius[0];
    bat_near near;
    bat_finder_nearest(f->beside, (const double[3]){foot.x, foot.y, foot.z}, &near);
    const vec side = vec_sub(vec_load(near.point, 3), foot);
    const double c = vec_dot(vec_unit(away), vec_unit(side));
    return c > 0 ? radius[0] + (near.distance - radius[0]) * c * c * (3 - 2 * c) : radius[0];
}

/* Whether the point feels the wire, and how. */
static bool feel(const bat_bound_wire *to, const fastening *f, const double *point, bat_influence *out) {
    for (int c = 0; c < 3; c++)
        if (!(point[c] >= f->low[c] && point[c] <= f->high[c])) return false;
    bat_near near;
    double jet[6], scale[3];
    bat_finder_nearest(to->finder, point, &near);
    bat_curve_eval(to->reference, near.u, 1, jet);
    *out = (bat_influence){.at = near.u, .share = 1, .sum = -1};
    out->tangent = vec_load(jet + 3, 3);
    out->away = vec_sub(vec_load(point, 3), vec_load(jet, 3));
    const double share = fmin(fmax((near.u - f->start) / f->length, 0), 1);
    const double radius = radius_at(f, share, vec_load(jet, 3), out->away), far = vec_norm(out->away);
    const double x = far == 0 ? 0 : far / radius;
    if (!(x >= 0 && x < 1)) return false;
    out->strength = (x * x - 1) * (x * x - 1);
    out->on = out->strength > on_wire;
    if (out->on) out->strength = 1;
    bat_function_eval(&f->wire->scale, share, scale);
    out->stretch = (scale[0] - 1) * out->strength;
    return out->strength > 0;
}

double bat_wire_next_knot(const bat_curve *curve, double u, double end, int *at) {
    const double *knots = bat_curve_knots(curve);
    const int count = bat_curve_knot_count(curve);
    while (*at < count && knots[*at] <= u) ++*at;
    return *at < count && knots[*at] < end ? knots[*at] : end;
}

static int by_span(const void *a, const void *b) {
    const bat_influence *x = a, *y = b;
    if (x->span != y->span) return x->span < y->span ? -1 : 1;
    return (x->slot > y->slot) - (x->slot < y->slot);
}

/* Numbers the spans; ends[i]: where span i ends. */
static bat_status find_spans(const bat_bound_wire *wire, double **ends, int *count) {
    double domain[2];
    int at = 0;
    *ends = malloc(((size_t)bat_curve_knot_count(wire->reference) + 1) * sizeof **ends);
    *count = 0;
    if (!*ends) return BAT_MEMORY;
    bat_curve_domain(wire->reference, domain);
    for (double u = domain[0]; u < domain[1]; u = (*ends)[(*count)++])
        (*ends)[*count] = bat_wire_next_knot(wire->reference, u, domain[1], &at);
    return BAT_OK;
}

static bat_status order(bat_bound_wire *wire) {
    double *ends;
    int count;
    bat_status status = find_spans(wire, &ends, &count);
    for (size_t i = 0; i < wire->count && status == BAT_OK; i++) {
        int low = 0, high = count - 1;
        while (low < high) {
            const int middle = (low + high) / 2;
            if (wire->influences[i].at < ends[middle])
                high = middle;
            else
                low = middle + 1;
        }
        wire->influences[i].span = low;
    }
    free(ends);
    if (status == BAT_OK && wire->count > 1)
        qsort(wire->influences, wire->count, sizeof *wire->influences, by_span); /* no ties: slots differ */
    return status;
}

/* Fills in the wire's influences, whose slots are points as yet. */
static bat_status fasten(const bat_wire *wire, size_t point_count, const double *points, bat_bound_wire *to) {
    fastening f;
    size_t room = 0;
    bat_status status = begin(wire, to, &f);
    for (size_t i = 0; i < point_count && status == BAT_OK; i++) {
        if (to->count == room) {
            room = 2 * room + 64;
            bat_influence *more = realloc(to->influences, room * sizeof *more);
            if (!more) {
                status = BAT_MEMORY;
                break;
            }
            to->influences = more;
        }
        bat_influence *next = &to->influences[to->count];
        if (!feel(to, &f, points + 3 * i, next)) continue;
        next->slot = (int)i;
        to->count++;
    }
    bat_finder_free(f.beside);
    bat_curve_free(f.domain);
    if (status == BAT_OK) status = order(to);
    to->turn = wire->turn;
    if (status == BAT_OK && to->turn == BAT_TURN_FRAMES && to->count > 0)
        status = bat_wire_frames_begin(to->reference, to->count, &to->influences->at, sizeof *to->influences,
                                       &to->frames);
    return status;
}

/* ---- several wires ---- */

double bat_wire_power(double x, double k) { return k == 1 ? x : x > 0 ? bat_exp(k * bat_log(x)) : 0; }

/* What a wire weighs, to the power of one. Points on a wire with the cross blend weigh by it alone. */
static double weight_of(const bat_wire_options *options, const bat_influence *i, bool any_on) {
    if (options->blend == BAT_BLEND_LOCAL) return i->strength;
    return any_on ? i->on : i->strength / (1 - i->strength);
}

/* Gives each point within reach a slot, in the order in which the first wire's influences need them, and each that feels
 * several wires a sum. slot, wires, on: of each point, zeros. */
static bat_status number_slots(bat_binding *b, const double *points, int *slot, int *wires, bool *on) {
    for (size_t w = 0; w < b->wire_count; w++)
        for (size_t i = 0; i < b->wires[w].count; i++) {
            const bat_influence *at = &b->wires[w].influences[i];
            if (wires[at->slot]++ == 0) slot[at->slot] = (int)b->slot_count++;
            on[at->slot] = on[at->slot] || at->on;
        }
    b->points = malloc((b->slot_count + 1) * sizeof *b->points);
    b->rest = malloc((3 * b->slot_count + 1) * sizeof *b->rest);
    if (!b->points || !b->rest) return BAT_MEMORY;
    for (size_t i = 0; i < b->point_count; i++) {
        if (!wires[i]) continue;
        b->points[slot[i]] = (int)i;
        memcpy(b->rest + 3 * slot[i], points + 3 * i, 3 * sizeof *points);
        wires[i] = wires[i] > 1 ? (int)b->sum_count++ : -1; /* from here on: its sum */
    }
    return BAT_OK;
}

/* Shares are powers of weights relative to the greatest one, so that no exponent overflows. most, total: of each sum,
 * zeros. */
static void share_out(bat_binding *b, const int *slot, const int *sums, const bool *on, double *most,
                      double *total) {
    for (int round = 0; round < 3; round++)
        for (size_t w = 0; w < b->wire_count; w++)
            for (size_t i = 0; i < b->wires[w].count; i++) {
                bat_influence *at = &b->wires[w].influences[i];
                if (round == 0) {
                    const int point = at->slot;
                    at->slot = slot[point], at->sum = sums[point];
                    if (at->sum >= 0) at->share = weight_of(&b->options, at, on[point]);
                }
                if (at->sum < 0) continue;
                if (round == 0)
                    most[at->sum] = fmax(most[at->sum], at->share);
                else if (round == 1)
                    total[at->sum] += at->share = bat_wire_power(at->share / most[at->sum],
                                                                 b->options.exponent);
                else
                    at->share /= total[at->sum];
            }
}

static bat_status join(bat_binding *b, const double *points) {
    const size_t n = b->point_count + 1;
    int *slot = calloc(2 * n, sizeof *slot);
    bool *on = calloc(n, sizeof *on);
    double *total = NULL;
    bat_status status = slot && on ? number_slots(b, points, slot, slot + n, on) : BAT_MEMORY;
    if (status == BAT_OK) {
        total = calloc(2 * b->sum_count + 1, sizeof *total);
        if (!total) status = BAT_MEMORY;
    }
    if (status == BAT_OK) share_out(b, slot, slot + n, on, total, total + b->sum_count);
    free(slot), free(on), free(total);
    return status;
}

bat_status bat_wires_bind(size_t wire_count, const bat_wire *wires, size_t point_count, const double *points,
                          const bat_wire_options *options, bat_binding **out, size_t *wrong) {
    bat_wire_options given = DEFAULTS;
    size_t place = 0;
    if (!wires || !out || (point_count > 0 && !points)) return BAT_ARGUMENT;
    bat_status status = bat_options_read(options, sizeof DEFAULTS, sizeof given, &given);
    if (status == BAT_OK) status = check(wire_count, wires, &given, point_count, points, &place);
    if (status != BAT_OK) {
        if (wrong) *wrong = place;
        return status;
    }
    bat_binding *b = calloc(1, sizeof *b);
    if (!b) return BAT_MEMORY;
    *b = (bat_binding){.options = given, .wire_count = wire_count, .point_count = point_count};
    b->wires = calloc(wire_count, sizeof *b->wires);
    if (!b->wires) status = BAT_MEMORY;
    for (size_t w = 0; w < wire_count && status == BAT_OK; w++)
        status = fasten(&wires[w], point_count, points, &b->wires[w]);
    if (status == BAT_OK) status = join(b, points);
    if (status == BAT_OK)
        *out = b;
    else
        bat_binding_free(b);
    return status;
}
