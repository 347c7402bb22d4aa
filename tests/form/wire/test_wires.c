/* Wires against the formulas of docs/math/surfaces.md, computed here point by point with closest points from dense
 * samples; points on wires, bits of points that do not move, rigid motions, blends, domains, tears; every allocation may
 * fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/nearest.h>
#include <batten/refine.h>
#include <batten/format_space.h>
#include "form/wire/turns.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { POINTS = 200 };

static bat_curve *space_curve(random_source *r, int kind) {
    const int degree = random_int(r, 2, 4);
    return random_curve(r, degree, 3, kind, random_int(r, 2, 6));
}

/* Without corners, where the closest point has two tangents. */
static bat_curve *smooth_curve(random_source *r, bool closed) {
    double points[30], knots[11];
    const int count = random_int(r, 5, 10);
    bat_curve *out = NULL;
    for (int i = 0; i < 3 * count; i++) points[i] = random_between(r, -10, 10);
    for (int i = 0; i <= count; i++) knots[i] = i;
    assert_int_equal(closed ? bat_curve_create(3, 3, true, (size_t)count, points, count + 1, knots, &out)
                            : bat_curve_create_clamped(3, 3, (size_t)count, points, &out),
                     BAT_OK);
    return out;
}

/* The curve with each control point moved by up to `most`. */
static bat_curve *shaken(random_source *r, const bat_curve *curve, double most) {
    const size_t count = bat_curve_count(curve);
    double *points = malloc(3 * count * sizeof *points);
    bat_curve *out = NULL;
    for (size_t i = 0; i < 3 * count; i++)
        points[i] = bat_curve_points(curve)[i] + random_between(r, -most, most);
    assert_int_equal(bat_curve_create(3, bat_curve_degree(curve), bat_curve_is_closed(curve), count, points,
                                      bat_curve_knot_count(curve), bat_curve_knots(curve), &out),
                     BAT_OK);
    free(points);
    return out;
}

static void fill(random_source *r, double *points, int count) {
    for (int i = 0; i < 3 * count; i++) points[i] = random_between(r, -12, 12);
}

static bat_wire wire_of(const bat_curve *reference, double radius) {
    return (bat_wire){reference, bat_function_of(radius), bat_function_of(1), NULL, BAT_TURN_TANGENT};
}

static bat_binding *bound(size_t count, const bat_wire *wires, const bat_wire_options *options, int points,
                          const double *at) {
    bat_binding *b = NULL;
    assert_int_equal(bat_wires_bind(count, wires, (size_t)points, at, options, &b, NULL), BAT_OK);
    return b;
}

static double apart(const double *a, const double *b) {
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

/* ---- the formulas ---- */

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static void cross(const double *a, const double *b, double *out) {
    for (int c = 0; c < 3; c++) out[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

/* By samples and golden section; needs no more than evaluation. */
static double closest(const bat_curve *curve, const double *p, double *distance) {
    enum { SAMPLES = 2000 };
    double domain[2], best = 0, at[3];
    bat_curve_domain(curve, domain);
    const double step = (domain[1] - domain[0]) / SAMPLES;
    *distance = INFINITY;
    for (int i = 0; i <= SAMPLES; i++) {
        const double u = domain[0] + step * i;
        bat_curve_eval(curve, u, 0, at);
        if (apart(at, p) < *distance) *distance = apart(at, p), best = u;
    }
    const bool closed = bat_curve_is_closed(curve);
    double low = closed ? best - step : fmax(best - step, domain[0]),
           high = closed ? best + step : fmin(best + step, domain[1]);
    for (int k = 0; k < 90; k++) {
        const double a = high - 0.6180339887 * (high - low), b = low + 0.6180339887 * (high - low);
        double pa[3], pb[3];
        bat_curve_eval(curve, a, 0, pa), bat_curve_eval(curve, b, 0, pb);
        if (apart(pa, p) < apart(pb, p))
            high = b;
        else
            low = a;
    }
    best = 0.5 * (low + high);
    if (!closed && best - domain[0] < 1e-7 * step) best = domain[0];
    if (!closed && domain[1] - best < 1e-7 * step) best = domain[1];
    bat_curve_eval(curve, best, 0, at);
    *distance = apart(at, p);
    return best;
}

static double radius_of(const bat_wire *wire, double u, const double *foot, const double *away) {
    double domain[2], value[3], side[3], near, at[3];
    bat_curve_domain(wire->reference, domain);
    bat_function_eval(&wire->radius, (u - domain[0]) / (domain[1] - domain[0]), value);
    if (!wire->domain) return value[0];
    bat_curve_eval(wire->domain, closest(wire->domain, foot, &near), 0, at);
    for (int c = 0; c < 3; c++) side[c] = at[c] - foot[c];
    const double c = dot(side, away) / sqrt(dot(side, side) * dot(away, away));
    return c > 0 ? value[0] + (near - value[0]) * c * c * (3 - 2 * c) : value[0];
}

/* F, and what the wire alone does to the point. */
static double follow(const bat_wire *wire, const bat_curve *curve, const double *p, double *by) {
    double r[6], w[6], q[3], k[3], away[3], far, domain[2], scale[3];
    const double u = closest(wire->reference, p, &far);
    bat_curve_domain(wire->reference, domain);
    bat_curve_eval(wire->reference, u, 1, r), bat_curve_eval(curve, u, 1, w);
    for (int c = 0; c < 3; c++) away[c] = p[c] - r[c], by[c] = 0;
    const double radius = far == 0 ? 1 : radius_of(wire, u, r, away), x = far / radius;
    if (!(x >= 0 && x < 1)) return 0;
    const double f = (x * x - 1) * (x * x - 1);
    bat_function_eval(&wire->scale, (u - domain[0]) / (domain[1] - domain[0]), scale);
    for (int c = 0; c < 3; c++) q[c] = away[c] * (1 + (scale[0] - 1) * f);
    cross(r + 3, w + 3, k);
    const double sine = sqrt(dot(k, k)), angle = f * atan2(sine, dot(r + 3, w + 3));
    if (sine > 0) {
        double side[3];
        for (int c = 0; c < 3; c++) k[c] /= sine;
        cross(k, q, side);
        const double along = dot(k, q);
        for (int c = 0; c < 3; c++)
            q[c] = q[c] * cos(angle) + side[c] * sin(angle) + k[c] * along * (1 - cos(angle));
    }
    for (int c = 0; c < 3; c++) by[c] = q[c] - away[c] + (w[c] - r[c]) * f;
    return f;
}

static void blended(size_t count, const bat_wire *wires, bat_curve *const *curves,
                    const bat_wire_options *options, const double *p, double *out) {
    double total = 0, sum[3] = {0, 0, 0}, only[3] = {0, 0, 0};
    int felt = 0;
    for (size_t k = 0; k < count; k++) {
        double by[3];
        const double f = follow(&wires[k], curves[k], p, by);
        const double weight = options->blend == BAT_BLEND_CROSS   ? pow(f / (1 - f), options->exponent)
                              : options->blend == BAT_BLEND_LOCAL ? pow(f, options->exponent)
                                                                  : pow(sqrt(dot(by, by)), options->exponent);
        if (f == 0) continue;
        felt++;
        total += weight;
        for (int c = 0; c < 3; c++) sum[c] += weight * by[c], only[c] = by[c];
    }
    for (int c = 0; c < 3; c++) out[c] = p[c] + (felt == 1 ? only[c] : total > 0 ? sum[c] / total : 0);
}

/* Where closest points are ambiguous or functions steep, samples and the library may differ; elsewhere they agree. */
static void check_against_formulas(size_t count, const bat_wire *wires, bat_curve *const *curves,
                                   const bat_wire_options *options, random_source *r) {
    double points[3 * POINTS], moved[3 * POINTS];
    int wrong = 0, felt = 0;
    bat_wire_report report;
    fill(r, points, POINTS);
    memcpy(moved, points, sizeof moved);
    bat_binding *b = bound(count, wires, options, POINTS, points);
    assert_int_equal(bat_binding_apply(b, (const bat_curve *const *)curves, moved, &report, NULL), BAT_OK);
    for (int i = 0; i < POINTS; i++) {
        double want[3];
        blended(count, wires, curves, options, points + 3 * i, want);
        felt += apart(want, points + 3 * i) > 0;
        wrong += apart(want, moved + 3 * i) > 1e-5; /* the golden section finds a foot to 1e-8 */
    }
    assert_true(wrong <= felt / 50);
    assert_true(felt > 3 && report.moved + 2 >= (size_t)felt);
    bat_binding_free(b);
}

static bat_function slope_of(double from, double to) {
    const double knots[4] = {0, 0, 1, 1}, points[4] = {from, 0, to, 0};
    bat_function f = {0, NULL};
    assert_int_equal(bat_curve_create(2, 1, false, 2, points, 4, knots, &f.curve), BAT_OK);
    return f;
}

static void formulas(void **state) {
    (void)state;
    random_source r = {41};
    for (int run = 0; run < 24; run++) {
        enum { MOST = 3 };
        const size_t count = (size_t)(1 + run % MOST);
        bat_wire wires[MOST];
        bat_curve *references[MOST], *curves[MOST], *domain = space_curve(&r, 0);
        bat_wire_options options = bat_wire_defaults();
        options.blend = (bat_blend)(run / 3 % 3);
        if (run % 2) options.exponent = 2;
        for (size_t k = 0; k < count; k++) {
            const double low = random_between(&r, 3, 5), high = random_between(&r, 4, 9);
            references[k] = smooth_curve(&r, run % 4 == 3);
            curves[k] = shaken(&r, references[k], 3);
            wires[k] = (bat_wire){references[k], slope_of(low, high), slope_of(1, 0.5 + 0.1 * low), NULL,
                                  BAT_TURN_TANGENT};
            if (run % 5 == 4) wires[k].domain = domain;
        }
        check_against_formulas(count, wires, curves, &options, &r);
        for (size_t k = 0; k < count; k++) {
            bat_function_clear(&wires[k].radius), bat_function_clear(&wires[k].scale);
            bat_curve_free(references[k]), bat_curve_free(curves[k]);
        }
        bat_curve_free(domain);
    }
}

/* ---- exactness ---- */

/* W equal to R, also with other knots or a higher degree, moves no bit; so does undoing. */
static void what_stays_keeps_its_bits(void **state) {
    (void)state;
    random_source r = {42};
    for (int run = 0; run < 40; run++) {
        double points[3 * POINTS], moved[3 * POINTS], domain[2];
        bat_curve *reference = space_curve(&r, run % 3), *same = NULL, *other = shaken(&r, reference, 2);
        bat_curve_domain(reference, domain);
        const double knot = 0.3 * domain[0] + 0.7 * domain[1];
        if (run % 2)
            assert_int_equal(bat_curve_insert_knots(reference, 1, &knot, &same), BAT_OK);
        else if (run % 4)
            assert_int_equal(bat_curve_elevate(reference, bat_curve_degree(reference) + 1, &same), BAT_OK);
        else
            assert_int_equal(bat_curve_copy(reference, &same), BAT_OK);
        const bat_wire wire = wire_of(reference, 6);
        bat_wire_report report;
        fill(&r, points, POINTS);
        memcpy(moved, points, sizeof moved);
        bat_binding *b = bound(1, &wire, NULL, POINTS, points);
        assert_int_equal(bat_binding_apply(b, (const bat_curve *const *)&same, moved, &report, NULL), BAT_OK);
        assert_memory_equal(points, moved, sizeof moved);
        assert_true(report.moved == 0 && report.largest == 0 && report.kinks == 0);
        assert_int_equal(bat_binding_apply(b, (const bat_curve *const *)&other, moved, &report, NULL),
                         BAT_OK);
        assert_true(report.moved > 0 && report.moved <= bat_binding_count(b));
        assert_int_equal(report.kinks, run % 3 == 2 ? 0 : 2);
        size_t kept = 0;
        for (int i = 0; i < POINTS; i++)
            kept += memcmp(points + 3 * i, moved + 3 * i, 3 * sizeof *points) == 0;
        assert_int_equal(kept, POINTS - report.moved);
        assert_int_equal(bat_binding_apply(b, (const bat_curve *const *)&same, moved, NULL, NULL), BAT_OK);
        assert_memory_equal(points, moved, sizeof moved);
        bat_binding_free(b);
        bat_curve_free(reference), bat_curve_free(same), bat_curve_free(other);
    }
}

/* A wire that changes between two knots moves nothing whose closest point lies elsewhere. */
static void a_local_change_stays_local(void **state) {
    (void)state;
    random_source r = {43};
    double points[3 * POINTS], moved[3 * POINTS], control[60];
    bat_curve *reference = random_curve(&r, 3, 3, 0, 12), *curve = NULL;
    const size_t count = bat_curve_count(reference);
    memcpy(control, bat_curve_points(reference), 3 * count * sizeof *control);
    for (int c = 0; c < 3; c++) control[12 + c] += 2; /* point 4: spans 4 to 7 */
    const double *knots = bat_curve_knots(reference);
    assert_int_equal(
        bat_curve_create(3, 3, false, count, control, bat_curve_knot_count(reference), knots, &curve),
        BAT_OK);
    const bat_wire wire = wire_of(reference, 9);
    fill(&r, points, POINTS);
    memcpy(moved, points, sizeof moved);
    bat_binding *b = bound(1, &wire, NULL, POINTS, points);
    assert_int_equal(bat_binding_apply(b, (const bat_curve *const *)&curve, moved, NULL, NULL), BAT_OK);
    for (int i = 0; i < POINTS; i++) {
        bat_near near;
        assert_int_equal(bat_curve_nearest(reference, points + 3 * i, &near), BAT_OK);
        const bool within = near.u > knots[4] && near.u < knots[8] && near.distance < 9;
        assert_int_equal(memcmp(points + 3 * i, moved + 3 * i, 3 * sizeof *points) != 0, within);
    }
    bat_binding_free(b);
    bat_curve_free(reference), bat_curve_free(curve);
}

/* Points of a reference go to the wire; with the cross blend also where other wires reach. */
static void points_of_wires_go_to_them(void **state) {
    (void)state;
    random_source r = {44};
    for (int run = 0; run < 30; run++) {
        enum { WIRES = 3 };
        double points[3 * POINTS], moved[3 * POINTS], u[POINTS], domain[2];
        bat_curve *references[WIRES], *curves[WIRES];
        bat_wire wires[WIRES];
        const size_t count = run % 2 ? 1 : WIRES;
        bat_wire_options options = bat_wire_defaults();
        options.exponent = run % 4 ? 1 : 2;
        for (size_t k = 0; k < count; k++) {
            references[k] = space_curve(&r, run % 3);
            curves[k] = shaken(&r, references[k], 4);
            wires[k] = wire_of(references[k], 7);
            wires[k].scale = bat_function_of(1.5);
        }
        for (int i = 0; i < POINTS; i++) {
            const size_t k = (size_t)i % count;
            bat_curve_domain(references[k], domain);
            u[i] = random_between(&r, domain[0], domain[1]);
            bat_curve_eval(references[k], u[i], 0, points + 3 * i);
        }
        memcpy(moved, points, sizeof moved);
        bat_binding *b = bound(count, wires, &options, POINTS, points);
        assert_int_equal(bat_binding_count(b), POINTS);
        assert_int_equal(bat_binding_apply(b, (const bat_curve *const *)curves, moved, NULL, NULL), BAT_OK);
        for (int i = 0; i < POINTS; i++) {
            double want[3];
            bat_curve_eval(curves[(size_t)i % count], u[i], 0, want);
            assert_true(apart(want, moved + 3 * i) < 1e-11); /* coordinates are around 10 */
        }
        bat_binding_free(b);
        for (size_t k = 0; k < count; k++) bat_curve_free(references[k]), bat_curve_free(curves[k]);
    }
}

/* Where two wires meet and go different ways, a point goes to the middle, and that is told. */
static void wires_that_disagree(void **state) {
    (void)state;
    const double across[6] = {-1, 0, 0, 1, 0, 0}, up[6] = {0, -1, 0, 0, 1, 0};
    const double moved_across[6] = {-1, 0, 3, 1, 0, 3}, moved_up[6] = {0, -1, 1, 0, 1, 1};
    bat_curve *references[2], *curves[2];
    double points[6] = {0, 0, 0, 0.5, 0, 0};
    bat_wire_report report;
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, across, &references[0]), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, up, &references[1]), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, moved_across, &curves[0]), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, moved_up, &curves[1]), BAT_OK);
    const bat_wire wires[2] = {wire_of(references[0], 2), wire_of(references[1], 2)};
    bat_binding *b = bound(2, wires, NULL, 2, points);
    assert_int_equal(bat_binding_apply(b, (const bat_curve *const *)curves, points, &report, NULL), BAT_OK);
    assert_true(points[2] == 2 && points[5] == 3);
    assert_true(report.disagreeing == 1 && report.moved == 2 && report.largest == 3 && report.kinks == 4);
    bat_binding_free(b);
    for (int k = 0; k < 2; k++) bat_curve_free(references[k]), bat_curve_free(curves[k]);
}

/* ---- properties ---- */

/* Parts of angles against libm, for every size of sine and cosine. */
static void parts_of_angles(void **state) {
    (void)state;
    random_source r = {49};
    enum { COUNT = 4000 };
    double parts[COUNT], sine[COUNT], cosine[COUNT], angle[COUNT];
    for (int i = 0; i < COUNT; i++) {
        const double size = pow(10, random_between(&r, -60, 60));
        angle[i] = i < 3 ? 3.141592653589793 * i / 2 : random_between(&r, 0, 3.14159265);
        if (i % 5 == 4) angle[i] = pow(10, random_between(&r, -30, 0));
        parts[i] = i < 3 ? 1 : random_unit(&r);
        sine[i] = size * sin(angle[i]), cosine[i] = size * cos(angle[i]);
    }
    sine[3] = cosine[3] = angle[3] = 0;
    bat_turns(COUNT, parts, sine, cosine);
    for (int i = 0; i < COUNT; i++) {
        assert_true(fabs(sine[i] - sin(parts[i] * angle[i])) < 1e-15);
        assert_true(fabs(cosine[i] - cos(parts[i] * angle[i])) < 1e-15);
    }
}

/* Everything turned and moved together: the result is turned and moved. */
static void rigid_motions(void **state) {
    (void)state;
    random_source r = {45};
    const double c = cos(1), s = sin(1);
    const double matrix[12] = {c, -s, 0, 5, 0.6 * s, 0.6 * c, -0.8, -2, 0.8 * s, 0.8 * c, 0.6, 7};
    for (int run = 0; run < 30; run++) {
        double points[3 * POINTS], moved[3 * POINTS], turned[3 * POINTS];
        bat_curve *pair[2], *image[2];
        pair[0] = space_curve(&r, run % 3), pair[1] = shaken(&r, pair[0], 3);
        fill(&r, points, POINTS);
        for (int i = 0; i < POINTS; i++)
            for (int k = 0; k < 3; k++)
                turned[3 * i + k] = dot(matrix + 4 * k, points + 3 * i) + matrix[4 * k + 3];
        for (int k = 0; k < 2; k++) assert_int_equal(bat_curve_transform(pair[k], matrix, &image[k]), BAT_OK);
        memcpy(moved, points, sizeof moved);
        bat_wire wire = wire_of(pair[0], 6);
        wire.scale = bat_function_of(1.4);
        bat_binding *b = bound(1, &wire, NULL, POINTS, points);
        wire.reference = image[0];
        bat_binding *t = bound(1, &wire, NULL, POINTS, turned);
        assert_int_equal(bat_binding_apply(b, (const bat_curve *const *)&pair[1], moved, NULL, NULL), BAT_OK);
        assert_int_equal(bat_binding_apply(t, (const bat_curve *const *)&image[1], turned, NULL, NULL),
                         BAT_OK);
        int far = 0;
        for (int i = 0; i < POINTS; i++) {
            double want[3];
            for (int k = 0; k < 3; k++) want[k] = dot(matrix + 4 * k, moved + 3 * i) + matrix[4 * k + 3];
            far += apart(want, turned + 3 * i) > 1e-6; /* closest points where two are as close */
        }
        assert_true(far <= 1);
        bat_binding_free(b), bat_binding_free(t);
        for (int k = 0; k < 2; k++) bat_curve_free(pair[k]), bat_curve_free(image[k]);
    }
}

/* Along a line that leaves the tube between the end planes, the movement has a continuous slope. */
static void smooth_where_the_reach_ends(void **state) {
    (void)state;
    random_source r = {46};
    enum { STEPS = 4000 };
    const double straight[12] = {-9, 0, 0, -3, 0, 0, 3, 0, 0, 9, 0, 0};
    bat_curve *reference = NULL;
    assert_int_equal(bat_curve_create_clamped(3, 3, 4, straight, &reference), BAT_OK);
    bat_curve *curve = shaken(&r, reference, 2);
    double points[3 * (STEPS + 1)], moved[3 * (STEPS + 1)], before = 0, jump = 0;
    for (int i = 0; i <= STEPS; i++)
        points[3 * i] = 1.5, points[3 * i + 1] = 8.0 * i / STEPS - 4, points[3 * i + 2] = 0.3;
    memcpy(moved, points, sizeof moved);
    const bat_wire wire = wire_of(reference, 3);
    bat_binding *b = bound(1, &wire, NULL, STEPS + 1, points);
    assert_int_equal(bat_binding_apply(b, (const bat_curve *const *)&curve, moved, NULL, NULL), BAT_OK);
    for (int i = 1; i <= STEPS; i++) {
        const double slope = (moved[3 * i + 2] - moved[3 * i - 1]) * STEPS / 8;
        if (i > 1) jump = fmax(jump, fabs(slope - before));
        before = slope;
    }
    assert_true(jump < 0.02); /* proportional to the steps' length: a kink would stay */
    assert_true(memcmp(moved, points, 3 * sizeof *points) == 0);
    bat_binding_free(b);
    bat_curve_free(reference), bat_curve_free(curve);
}

/* A wire that runs backwards turns by half a turn about a normal: lengths stay. */
static void opposite_tangents(void **state) {
    (void)state;
    const double line[6] = {0, 0, 0, 4, 0, 0}, back[6] = {4, 0, 0, 0, 0, 0};
    bat_curve *reference = NULL, *curve = NULL;
    double points[6] = {1, 1e-9, 0, 2, 0, 0.5};
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, line, &reference), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, back, &curve), BAT_OK);
    const bat_wire wire = wire_of(reference, 2);
    bat_binding *b = bound(1, &wire, NULL, 2, points);
    assert_int_equal(bat_binding_apply(b, (const bat_curve *const *)&curve, points, NULL, NULL), BAT_OK);
    assert_true(fabs(points[0] - 3) < 1e-8 && hypot(points[1], points[2]) < 1.1e-9);
    const double middle[3] = {2, 0, 0};
    assert_true(fabs(apart(points + 3, middle) - 0.5) < 1e-12);
    bat_binding_free(b);
    bat_curve_free(reference), bat_curve_free(curve);
}

/* Great and small exponents give finite points between those of the wires. */
static void any_exponent(void **state) {
    (void)state;
    random_source r = {47};
    static const double exponents[] = {1e-3, 0.5, 3, 50, 1e4, 1e300};
    bat_curve *references[2], *curves[2];
    double points[3 * POINTS];
    fill(&r, points, POINTS);
    for (int k = 0; k < 2; k++) references[k] = space_curve(&r, 0), curves[k] = shaken(&r, references[k], 3);
    const bat_wire wires[2] = {wire_of(references[0], 8), wire_of(references[1], 8)};
    for (int run = 0; run < 18; run++) {
        double moved[3 * POINTS];
        bat_wire_options options = bat_wire_defaults();
        options.exponent = exponents[run % 6], options.blend = (bat_blend)(run / 6);
        memcpy(moved, points, sizeof moved);
        bat_binding *b = bound(2, wires, &options, POINTS, points);
        assert_int_equal(bat_binding_apply(b, (const bat_curve *const *)curves, moved, NULL, NULL), BAT_OK);
        for (int i = 0; i < POINTS; i++) {
            double by[2][3], most = 0;
            for (int k = 0; k < 2; k++)
                (void)follow(&wires[k], curves[k], points + 3 * i, by[k]),
                    most = fmax(most, sqrt(dot(by[k], by[k])));
            assert_true(apart(points + 3 * i, moved + 3 * i) <= most + 1e-3);
        }
        bat_binding_free(b);
    }
    for (int k = 0; k < 2; k++) bat_curve_free(references[k]), bat_curve_free(curves[k]);
}

/* ---- tears ---- */

/* A hairpin of two lines, y = 1 and y = -1, closed off at x = 10: edges across y = 0 are torn; those that stay on a
 * side are not. */
static void torn_edges(void **state) {
    (void)state;
    enum { SIDE = 21 };
    const double hairpin[12] = {0, 1, 0, 10, 1, 0, 10, -1, 0, 0, -1, 0};
    bat_curve *reference = NULL;
    double points[3 * SIDE * SIDE];
    int edges[8 * SIDE * SIDE], torn[2 * SIDE], count = 0, wanted = 0;
    size_t found = 0;
    assert_int_equal(bat_curve_create_clamped(3, 1, 4, hairpin, &reference), BAT_OK);
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            double *p = points + 3 * (i * SIDE + j);
            p[0] = 8.9 * i / (SIDE - 1) + 0.01, p[1] = 0.22 * (j - 10) + 0.1, p[2] = 0.05;
            const int at = i * SIDE + j;
            if (j + 1 < SIDE) {
                for (int k = 0; k < 2; k++)
                    edges[2 * count] = at, edges[2 * count++ + 1] = at + 1; /* twice */
                wanted += p[1] < 0 && p[1] + 0.22 > 0;
            }
            if (i + 1 < SIDE) edges[2 * count] = at + SIDE, edges[2 * count++ + 1] = at;
        }
    const bat_wire wire = wire_of(reference, 1.8);
    bat_binding *b = bound(1, &wire, NULL, SIDE * SIDE, points);
    assert_int_equal(bat_binding_torn(b, (size_t)count, edges, SIDE, torn, &found), BAT_OK);
    assert_int_equal(found, wanted);
    for (size_t i = 0; i < found; i++) {
        assert_true(torn[2 * i + 1] == torn[2 * i] + 1);
        assert_true(points[3 * torn[2 * i] + 1] < 0 && points[3 * torn[2 * i + 1] + 1] > 0);
        if (i > 0) assert_true(torn[2 * i] > torn[2 * i - 2]);
    }
    edges[1] = SIDE * SIDE;
    assert_int_equal(bat_binding_torn(b, 1, edges, 0, NULL, &found), BAT_PARAMETER);
    bat_binding_free(b);
    bat_curve_free(reference);
}

/* ---- what is refused ---- */

/* A wire that reaches nothing moves nothing, and what it does has no kinks. */
static void bound_to_nothing(void **state) {
    (void)state;
    random_source r = {49};
    for (int turn = BAT_TURN_TANGENT; turn <= BAT_TURN_FRAMES; turn++) {
        bat_curve *reference = space_curve(&r, 0), *wire = shaken(&r, reference, 3);
        double points[6] = {1e5, 0, 0, -1e5, 2e5, 0}, before[6];
        bat_wire one = wire_of(reference, 6);
        bat_wire_report report;
        one.turn = (bat_wire_turn)turn;
        memcpy(before, points, sizeof before);
        bat_binding *b = bound(1, &one, NULL, 2, points);
        assert_int_equal(bat_binding_count(b), 0);
        assert_int_equal(bat_binding_apply(b, (const bat_curve *const *)&wire, points, &report, NULL),
                         BAT_OK);
        assert_memory_equal(points, before, sizeof before);
        assert_true(report.moved == 0 && report.kinks == 0 && report.largest == 0);
        bat_binding_free(b), bat_curve_free(reference), bat_curve_free(wire);
    }
}

static void refusals(void **state) {
    (void)state;
    random_source r = {48};
    bat_curve *open = space_curve(&r, 0), *closed = space_curve(&r, 2), *longer = NULL;
    double points[6] = {0, 0, 0, 1, 1, NAN}, domain[2];
    bat_wire wires[2] = {wire_of(open, 1), wire_of(open, 0)};
    bat_binding *b = NULL;
    size_t wrong = 9;
    bat_curve_domain(open, domain);
    assert_int_equal(bat_curve_reparametrise(open, domain[0], domain[1] + 1, &longer), BAT_OK);
    assert_int_equal(bat_wires_bind(2, wires, 1, points, NULL, &b, &wrong), BAT_PARAMETER);
    assert_int_equal(wrong, 1);
    wires[1] = wire_of(open, NAN);
    assert_int_equal(bat_wires_bind(2, wires, 1, points, NULL, &b, NULL), BAT_NUMBER);
    wires[1].radius = slope_of(1, -0.1);
    assert_int_equal(bat_wires_bind(2, wires, 1, points, NULL, &b, NULL), BAT_PARAMETER);
    bat_function_clear(&wires[1].radius);
    assert_int_equal(bat_wires_bind(1, wires, 2, points, NULL, &b, &wrong), BAT_NUMBER);
    assert_int_equal(wrong, 1);
    assert_int_equal(bat_wires_bind(0, wires, 1, points, NULL, &b, NULL), BAT_COUNT);
    bat_wire_options options = bat_wire_defaults();
    options.exponent = 0;
    assert_int_equal(bat_wires_bind(1, wires, 1, points, &options, &b, NULL), BAT_ARGUMENT);
    options.exponent = 1, options.blend = (bat_blend)3;
    assert_int_equal(bat_wires_bind(1, wires, 1, points, &options, &b, NULL), BAT_ARGUMENT);
    assert_null(b);
    b = bound(1, wires, NULL, 1, points);
    const bat_curve *others[2] = {closed, longer};
    assert_int_equal(bat_binding_apply(b, &others[0], points, NULL, &wrong), BAT_ARGUMENT);
    assert_int_equal(wrong, 0);
    assert_int_equal(bat_binding_apply(b, &others[1], points, NULL, NULL), BAT_PARAMETER);
    bat_binding_free(b);
    b = bound(1, wires, NULL, 0, NULL);
    const bat_curve *same = open;
    assert_int_equal(bat_binding_apply(b, &same, points, NULL, NULL), BAT_OK);
    bat_binding_free(b), bat_binding_free(NULL);
    bat_curve_free(open), bat_curve_free(closed), bat_curve_free(longer);
}

/* ---- JSON, failing allocations ---- */

#define RING "{\"degree\":2,\"closed\":true,\"knots\":[0,1,2,3,4],\"points\":[[2,0],[0,2],[-2,0],[0,-2]]}"
#define LINE(z) "{\"degree\":1,\"knots\":[0,0,1,1],\"points\":[[0,0," z "],[4,0," z "]]}"
static const char WIRES[] = "{\"wires\":[{\"reference\":" LINE("0") ",\"curve\":" LINE(
    "1") ",\"radius\":2},{"
         "\"reference\":" RING ",\"curve\":" RING ",\"radius\":{\"degree\":1,\"knots\":[0,0,1,1],"
         "\"values\":[1,3]},\"scale\":2,\"domain\":" LINE(
             "5") "}],"
                  "\"blend\":{\"kind\":\"local\",\"exponent\":2}}";

static bat_status work(void) {
    double points[12] = {1, 0, 0, 2, 0.5, 0, 1, 1, 0, 3, -1, 0};
    const int edges[6] = {0, 1, 1, 2, 2, 3};
    bat_wires_source source;
    bat_binding *b = NULL;
    size_t torn;
    bat_status status = bat_wires_read(WIRES, sizeof WIRES - 1, &source, NULL);
    if (status != BAT_OK) return status;
    status = bat_wires_bind(source.count, source.wires, 4, points, &source.options, &b, NULL);
    if (status == BAT_OK) status = bat_binding_torn(b, 3, edges, 0, NULL, &torn);
    if (status == BAT_OK)
        status = bat_binding_apply(b, (const bat_curve *const *)source.curves, points, NULL, NULL);
    bat_binding_free(b);
    bat_wires_source_clear(&source);
    return status;
}

static void each_allocation(void **state) {
    (void)state;
    const long before = alloc_live();
    for (long n = 1;; n++) {
        alloc_fail_at(n);
        const bat_status status = work();
        const bool reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        assert_int_equal(alloc_live(), before);
        if (!reached) break;
        assert_true(n < 1000);
    }
}

static void what_json_says(void **state) {
    (void)state;
    static const struct {
        const char *text, *says;
    } cases[] = {
        {"[]", "an object"},
        {"{}", "a list of wires"},
        {"{\"wires\":[]}", "a list of wires"},
        {"{\"wires\":[{\"curve\":" RING ",\"radius\":1}]}", "reference"},
        {"{\"wires\":[{\"reference\":" RING ",\"radius\":1}]}", "curve"},
        {"{\"wires\":[{\"reference\":" RING ",\"curve\":" RING "}]}", "radius"},
        {"{\"wires\":[{\"reference\":" RING ",\"curve\":" RING ",\"radius\":0}]}", "above 0"},
        {"{\"wires\":[{\"reference\":" RING ",\"curve\":" LINE("1") ",\"radius\":1}]}",
         "closed as the reference"},
        {"{\"wires\":[{\"reference\":" RING ",\"curve\":" RING ",\"radius\":1}],\"blend\":{\"kind\":\"x\"}}",
         "local"},
        {"{\"wires\":[{\"reference\":" RING ",\"curve\":" RING ",\"radius\":1}],\"blend\":{\"exponent\":0}}",
         "above 0"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_wires_source source = {.count = 7};
        bat_problem problem = {.place = ""};
        assert_true(bat_wires_read(cases[i].text, strlen(cases[i].text), &source, &problem) != BAT_OK);
        assert_int_equal(source.count, 7);
        assert_non_null(strstr(problem.message, cases[i].says));
    }
    bat_wires_source_clear(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(formulas),
        cmocka_unit_test(what_stays_keeps_its_bits),
        cmocka_unit_test(a_local_change_stays_local),
        cmocka_unit_test(points_of_wires_go_to_them),
        cmocka_unit_test(wires_that_disagree),
        cmocka_unit_test(parts_of_angles),
        cmocka_unit_test(rigid_motions),
        cmocka_unit_test(smooth_where_the_reach_ends),
        cmocka_unit_test(opposite_tangents),
        cmocka_unit_test(any_exponent),
        cmocka_unit_test(torn_edges),
        cmocka_unit_test(bound_to_nothing),
        cmocka_unit_test(refusals),
        cmocka_unit_test(what_json_says),
        cmocka_unit_test(each_allocation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
