/* batten curve flatten, arcs, intersect, distance. */
#include "curves.h"

#include <batten/relate.h>

#include <math.h>

/* By bat_contact_kind. */
static const char *const CONTACTS[] = {"crosses", "touches", "ends", "overlaps"};
static const double CORNER = 0.02; /* radians */

static int flatten(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    (void)b;
    double tolerance = 0, *points;
    size_t count;
    int failed = required_tolerance(arguments, "--tolerance", &tolerance);
    if (failed) return failed;
    const bat_status status = bat_curve_flatten(a, tolerance, &count, &points, NULL);
    if (status != BAT_OK) return fail_near(arguments, status);
    const int size = bat_curve_dimension(a);
    bat_text text = {0};
    bat_text_string(&text, "{\"points\":");
    put_points(&text, points, count, size, (size_t)size);
    bat_text_string(&text, "}");
    bat_free(points);
    return write_text(&text);
}

static void put_arc(bat_text *text, const bat_arc *arc) {
    bat_text_string(text, "{\"from\":");
    put_numbers(text, arc->from, 2);
    bat_text_string(text, ",\"to\":");
    put_numbers(text, arc->to, 2);
    if (arc->radius > 0) {
        bat_text_string(text, ",\"centre\":");
        put_numbers(text, arc->centre, 2);
        bat_text_string(text, ",\"radius\":");
        bat_text_number(text, arc->radius);
        bat_text_string(text, arc->ccw ? ",\"ccw\":true" : ",\"ccw\":false");
    }
    bat_text_string(text, "}");
}

static int arcs(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    (void)b;
    double tolerance = 0, error;
    bat_arc *all;
    size_t count;
    int failed = required_tolerance(arguments, "--tolerance", &tolerance);
    if (failed) return failed;
    if (bat_curve_dimension(a) != 2)
        return fail_data(arguments->operands[0], "points[0]",
                         "expected 2 numbers, for a curve in the plane, found 3");
    const bat_status status = bat_curve_arcs(a, tolerance, CORNER, &count, &all, &error);
    if (status != BAT_OK) return fail_near(arguments, status);
    bat_text text = {0};
    bat_text_string(&text, "{\"arcs\":[");
    for (size_t i = 0; i < count; i++) {
        if (i) bat_text_string(&text, ",\n");
        put_arc(&text, all + i);
    }
    bat_text_string(&text, "],\n\"max_error\":");
    bat_text_number(&text, error);
    bat_text_string(&text, "}");
    bat_free(all);
    return write_text(&text);
}

static void put_meeting(bat_text *text, const bat_meeting *meeting, size_t size) {
    bat_text_string(text, "{\"hits\":[");
    for (size_t i = 0; i < meeting->count; i++) {
        const bat_crossing *at = meeting->crossings + i;
        bat_text_string(text, i ? ",\n{\"u\":" : "{\"u\":");
        bat_text_number(text, at->u);
        bat_text_string(text, ",\"v\":");
        bat_text_number(text, at->v);
        bat_text_string(text, ",\"point\":");
        put_numbers(text, at->point, size);
        bat_text_string(text, ",\"kind\":\"");
        bat_text_string(text, CONTACTS[at->kind]);
        bat_text_string(text, "\"");
        if (at->sign) bat_text_string(text, at->sign > 0 ? ",\"sign\":1" : ",\"sign\":-1");
        bat_text_string(text, "}");
    }
    bat_text_string(text, "],\n\"overlaps\":[");
    for (size_t i = 0; i < meeting->overlap_count; i++) {
        const bat_overlap *o = meeting->overlaps + i;
        if (i) bat_text_string(text, ",");
        put_numbers(text, (const double[]){o->u[0], o->u[1], o->v[0], o->v[1]}, 4);
    }
    bat_text_string(text, "]}");
}

static int intersect(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    double tolerance = 1e-9 * size_of_both(a, b);
    int failed = arguments_number(arguments, "--tolerance", 0, BAT_COORDINATE_MAX, &tolerance);
    if (failed) return failed;
    if (!(tolerance > 0)) tolerance = 1e-300; /* points in one place: what rounding hides counts */
    bat_meeting meeting;
    const bat_status status = b ? bat_curve_intersect(a, b, tolerance, &meeting)
                                : bat_curve_self_intersect(a, tolerance, &meeting);
    if (status == BAT_COUNT)
        return fail_data(arguments->operands[0], NULL,
                         "expected curves that can be told apart, found too many places where "
                         "they come near; a greater --tolerance may do");
    if (status != BAT_OK) return fail_curve(arguments, status);
    bat_text text = {0};
    put_meeting(&text, &meeting, (size_t)bat_curve_dimension(a));
    bat_meeting_free(&meeting);
    return write_text(&text);
}

static int distance(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    bat_apart apart;
    const double size = size_of_both(a, b);
    const bat_status status = bat_curve_hausdorff(a, b, size > 0 ? 1e-9 * size : 1e-300, &apart);
    if (status == BAT_TOLERANCE)
        return fail_data(arguments->operands[0], NULL,
                         "the distance is %.17g at least; it was not found to 1e-9 of the size",
                         apart.distance);
    if (status != BAT_OK) return fail_curve(arguments, status);
    bat_text text = {0};
    bat_text_string(&text, "{\"distance\":");
    bat_text_number(&text, apart.distance);
    bat_text_string(&text, ",\"u\":");
    bat_text_number(&text, apart.u);
    bat_text_string(&text, ",\"v\":");
    bat_text_number(&text, apart.v);
    bat_text_string(&text, "}");
    return write_text(&text);
}

static int with_tolerance(const cli_arguments *arguments, curve_work *work) {
    double ignored;
    const int failed = required_tolerance(arguments, "--tolerance", &ignored); /* before any file is read */
    return failed ? failed : with_curves(arguments, work);
}

static int run_flatten(const cli_arguments *arguments) { return with_tolerance(arguments, flatten); }
static int run_arcs(const cli_arguments *arguments) { return with_tolerance(arguments, arcs); }
static int run_intersect(const cli_arguments *arguments) {
    double ignored = 0;
    const int failed = arguments_number(arguments, "--tolerance", 0, BAT_COORDINATE_MAX, &ignored);
    return failed ? failed : with_curves(arguments, intersect);
}
static int run_distance(const cli_arguments *arguments) { return with_curves(arguments, distance); }

const cli_command command_curve_flatten = {
    .name = "curve flatten",
    .usage = "CURVE --tolerance T",
    .summary = "A polyline from which no point of a curve is further than a tolerance.",
    .details = "The result is {\"points\"}; they lie on the curve.",
    .example = "batten curve flatten curve.json --tolerance 0.01",
    .operands = 1,
    .options = {{"--tolerance", "T", "greatest distance of the curve from the polyline, document units"}},
    .lines = true,
    .run = run_flatten,
};

const cli_command command_curve_arcs = {
    .name = "curve arcs",
    .usage = "CURVE --tolerance T",
    .summary = "A planar curve as arcs of circles and straight lines.",
    .details = "The result is {\"arcs\", \"max_error\"}: {\"from\", \"to\", \"centre\", \"radius\", "
               "\"ccw\"}, or {\"from\", \"to\"}, a "
               "line,\none after another. They meet on one tangent wherever the curve does.",
    .example = "batten curve arcs curve.json --tolerance 0.01",
    .operands = 1,
    .options = {{"--tolerance", "T", "greatest distance of the curve from them, document units"}},
    .lines = true,
    .run = run_arcs,
};

const cli_command command_curve_intersect = {
    .name = "curve intersect",
    .usage = "CURVE [CURVE] [--tolerance T]",
    .summary = "Where two curves meet, or one meets itself.",
    .details =
        "The result is {\"hits\", \"overlaps\"}: {\"u\", \"v\", \"point\", \"kind\"} for each contact, and "
        "[u0, u1, v0, v1]\n"
        "for each stretch over which they run together. The kind is crosses, with the sign 1 where the "
        "first\n"
        "goes to the left of the second and -1 where it goes to the right, touches, ends (a curve ends "
        "there),\n"
        "or overlaps (all of a curve is there).",
    .example = "batten curve intersect first.json second.json",
    .operands = 1,
    .more = 1,
    .options = {{"--tolerance", "T", "how near they must come, 1e-9 of the size by default"}},
    .lines = true,
    .run = run_intersect,
};

const cli_command command_curve_distance = {
    .name = "curve distance",
    .usage = "CURVE CURVE",
    .summary = "How far two curves are apart: Hausdorff's distance.",
    .details = "The result is {\"distance\", \"u\", \"v\"}, to 1e-9 of the size: no point of either curve is "
               "further from the other\n"
               "one; u on the first and v on the second are so far apart.",
    .example = "batten curve distance first.json second.json",
    .operands = 2,
    .run = run_distance,
};
