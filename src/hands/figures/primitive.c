#include "hands/figures/primitive.h"

#include "base/matrix.h"
#include "base/real.h"

#include <batten/bezier.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double SQUARE = 1e-9;     /* cosine of the angle between the axes of a rectangle */
static const double DEEPEST = 0.99;    /* share */
static const double LEAST_SWEEP = 0.1; /* degrees */
enum { SIDES_DRAGGED = 60 };

static double length_of(const double v[2]) { return bat_hypot(v[0], v[1]); }
static double clamp(double value, double low, double high) { return fmin(fmax(value, low), high); }

/* ---- made ---- */

bat_primitive bat_primitive_rectangle(const double box[4], double radius) {
    bat_primitive p = {.kind = BAT_RECTANGLE,
                       .place = {fabs(box[2] - box[0]), 0, 0, fabs(box[3] - box[1]), fmin(box[0], box[2]),
                                 fmin(box[1], box[3])}};
    (void)bat_primitive_set(&p, BAT_PRIMITIVE_RADIUS, radius);
    return p;
}

bat_primitive bat_primitive_ellipse(const double box[4]) {
    return (bat_primitive){.kind = BAT_ELLIPSE,
                           .place = {0.5 * fabs(box[2] - box[0]), 0, 0, 0.5 * fabs(box[3] - box[1]),
                                     0.5 * box[0] + 0.5 * box[2], 0.5 * box[1] + 0.5 * box[3]},
                           .sweep = 360};
}

bat_primitive bat_primitive_polygon(const double middle[2], const double corner[2], int sides) {
    const double x = corner[0] - middle[0], y = corner[1] - middle[1];
    return (bat_primitive){.kind = BAT_POLYGON, .place = {x, y, -y, x, middle[0], middle[1]}, .sides = sides};
}

bat_status bat_primitive_check(const bat_primitive *p) {
    const double *m = p->place, a = length_of(m), b = length_of(m + 2);
    for (int i = 0; i < 6; i++)
        if (!(fabs(m[i]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    if (!(a > 0 && b > 0 && fabs(m[0] * m[3] - m[1] * m[2]) > 1e-12 * a * b)) return BAT_COUNT;
    switch (p->kind) {
    case BAT_RECTANGLE:
        if (!(fabs(m[0] * m[2] + m[1] * m[3]) <= SQUARE * a * b)) return BAT_NUMBER;
        return p->radii[0] >= 0 && p->radii[1] >= 0 && p->radii[0] <= 0.5 * a * (1 + 1e-9) &&
                       p->radii[1] <= 0.5 * b * (1 + 1e-9)
                   ? BAT_OK
                   : BAT_NUMBER;
    case BAT_ELLIPSE:
        return p->start >= 0 && p->start < 360 && p->sweep >= LEAST_SWEEP && p->sweep <= 360 &&
                       p->ends < BAT_ARC_ENDS
                   ? BAT_OK
                   : BAT_NUMBER;
    case BAT_POLYGON:
        if (p->sides < BAT_SIDES_MIN || p->sides > BAT_SIDES_MAX) return BAT_COUNT;
        return p->depth >= 0 && p->depth <= DEEPEST && p->roundness >= 0 && p->roundness <= 1 ? BAT_OK
                                                                                              : BAT_NUMBER;
    default: return BAT_NUMBER;
    }
}

bool bat_primitive_map(const bat_primitive *p, const double matrix[6], bat_primitive *out) {
    bat_primitive made = *p;
    bat_matrix_compose(matrix, p->place, made.place);
    for (int k = 0; k < 2; k++) {
        const double before = length_of(p->place + 2 * k), after = length_of(made.place + 2 * k);
        made.radii[k] = fmin(p->radii[k] * (after / before), 0.5 * after);
    }
    if (bat_primitive_check(&made) != BAT_OK) return false;
    *out = made;
    return true;
}

/* ---- the curve: cubics one after another; each begins where the one before ended ---- */

typedef struct outline {
    const double *place;
    double *points;
    int segments;
} outline;

static void put(const outline *o, double s, double t, double *at) {
    const double *m = o->place;
    at[0] = m[0] * s + m[2] * t + m[4];
    at[1] = m[1] * s + m[3] * t + m[5];
}

static bool begin(outline *o, const bat_primitive *p, int segments, double s, double t) {
    *o = (outline){p->place, malloc((6 * (size_t)segments + 2) * sizeof *o->points), 0};
    if (o->points) put(o, s, t, o->points);
    return o->points != NULL;
}

static void line_to(outline *o, double s, double t) {
    double *p = o->points + 6 * o->segments++, end[2];
    put(o, s, t, end);
    for (int k = 1; k <= 3; k++)
        for (int d = 0; d < 2; d++) p[2 * k + d] = k == 3 ? end[d] : p[d] + (end[d] - p[d]) * k / 3;
}

static void cubic_to(outline *o, const double own[6]) {
    double *p = o->points + 6 * o->segments++;
    for (int k = 0; k < 3; k++) put(o, own[2 * k], own[2 * k + 1], p + 2 * k + 2);
}

/* An arc of an ellipse about a middle, angles in radians from the first axis towards the second. */
static void arc_to(outline *o, const double middle[2], const double half[2], double from, double to) {
    const double handle = 4.0 / 3 * bat_tan((to - from) / 4), c = bat_cos(from), s = bat_sin(from),
                 d = bat_cos(to), r = bat_sin(to);
    cubic_to(o, (double[]){middle[0] + half[0] * (c - handle * s), middle[1] + half[1] * (s + handle * c),
                           middle[0] + half[0] * (d + handle * r), middle[1] + half[1] * (r - handle * d),
                           middle[0] + half[0] * d, middle[1] + half[1] * r});
}

static bat_status finish(outline *o, bool closed, bat_curve **out) {
    static const double corner = 1e-3; /* radians: tangents that turn by more are one */
    if (closed) memcpy(o->points + 6 * o->segments, o->points, 2 * sizeof *o->points);
    const bat_status status = bat_curve_from_bezier(2, 3, closed, o->segments, o->points, corner, 0, out,
                                                    NULL);
    free(o->points);
    return status;
}

static bat_status rectangle(const bat_primitive *p, bat_curve **out) {
    const double r[2] = {fmin(0.5, p->radii[0] / length_of(p->place)),
                         fmin(0.5, p->radii[1] / length_of(p->place + 2))};
    const bool round = r[0] > 0 && r[1] > 0;
    outline o;
    if (!begin(&o, p, 8, round ? r[0] : 0, 0)) return BAT_MEMORY;
    for (int k = 0; k < 4;
         k++) { /* the corner at which side k ends, from the first axis towards the second */
        const int right = k == 0 || k == 1, low = k == 1 || k == 2;
        const double middle[2] = {right ? 1 - r[0] : r[0], low ? 1 - r[1] : r[1]};
        if (!round)
            line_to(&o, right, low);
        else if (r[k % 2] < 0.5)
            line_to(&o, k % 2 == 0 ? middle[0] : right, k % 2 == 0 ? low : middle[1]);
        if (round) arc_to(&o, middle, r, (k - 1) * BAT_PI / 2, k * BAT_PI / 2);
    }
    return finish(&o, true, out);
}

static bat_status ellipse(const bat_primitive *p, bat_curve **out) {
    static const double middle[2] = {0, 0}, one[2] = {1, 1};
    const bool whole = p->sweep >= 360;
    /* All of it goes round as files of other programs say. */
    const double from = -p->start * BAT_PI / 180, sweep = (whole ? 1 : -1) * p->sweep * BAT_PI / 180;
    const int count = (int)ceil(p->sweep / 90 - 1e-9);
    outline o;
    if (!begin(&o, p, count + 2, bat_cos(from), bat_sin(from))) return BAT_MEMORY;
    for (int i = 0; i < count; i++)
        arc_to(&o, middle, one, from + sweep * i / count, from + sweep * (i + 1) / count);
    if (!whole && p->ends == BAT_ARC_PIE) line_to(&o, 0, 0);
    if (!whole && p->ends != BAT_ARC_OPEN) line_to(&o, bat_cos(from), bat_sin(from));
    return finish(&o, whole || p->ends != BAT_ARC_OPEN, out);
}

/* Corner i of a polygon, of a star those between, too. */
static void corner_of(const bat_primitive *p, int i, double out[2]) {
    const bool star = p->depth > 0;
    const double angle = (star ? BAT_PI : 2 * BAT_PI) * i / p->sides,
                 radius = star && i % 2 ? (1 - p->depth) * bat_cos(BAT_PI / p->sides) : 1;
    out[0] = radius * bat_cos(angle);
    out[1] = radius * bat_sin(angle);
}

static bat_status polygon(const bat_primitive *p, bat_curve **out) {
    const int count = p->depth > 0 ? 2 * p->sides : p->sides;
    double last[2], at[2], next[2], first[2] = {0, 0};
    outline o = {0};
    for (int i = 0; i < count; i++) {
        corner_of(p, (i + count - 1) % count, last);
        corner_of(p, i, at);
        corner_of(p, (i + 1) % count, next);
        double in[2] = {at[0] - last[0], at[1] - last[1]}, away[2] = {next[0] - at[0], next[1] - at[1]};
        const double side = length_of(in), half = 0.5 * p->roundness * side;
        for (int d = 0; d < 2; d++) in[d] /= side, away[d] /= side;
        const double turn = fabs(
            bat_atan2(in[0] * away[1] - in[1] * away[0], in[0] * away[0] + in[1] * away[1]));
        const double handle = half * 4.0 / 3 * bat_tan(turn / 4) / bat_tan(turn / 2);
        const double from[2] = {at[0] - half * in[0], at[1] - half * in[1]},
                     to[2] = {at[0] + half * away[0], at[1] + half * away[1]};
        if (i == 0) memcpy(first, from, sizeof first);
        if (i == 0 && !begin(&o, p, 2 * count + 1, from[0], from[1])) return BAT_MEMORY;
        if (i > 0 && p->roundness < 1) line_to(&o, from[0], from[1]);
        if (half > 0)
            cubic_to(&o, (double[]){from[0] + handle * in[0], from[1] + handle * in[1],
                                    to[0] - handle * away[0], to[1] - handle * away[1], to[0], to[1]});
    }
    if (!o.points) return BAT_COUNT; /* no sides at all */
    if (p->roundness < 1) line_to(&o, first[0], first[1]);
    return finish(&o, true, out);
}

bat_status bat_primitive_curve(const bat_primitive *p, bat_curve **out) {
    const bat_status status = bat_primitive_check(p);
    if (status != BAT_OK) return status;
    return p->kind == BAT_RECTANGLE ? rectangle(p, out)
           : p->kind == BAT_ELLIPSE ? ellipse(p, out)
                                    : polygon(p, out);
}

/* ---- numbers ---- */

static bool has(const bat_primitive *p, bat_primitive_number number) {
    static const bat_primitive_kind of[] = {BAT_RECTANGLE, BAT_ELLIPSE, BAT_ELLIPSE,
                                            BAT_POLYGON,   BAT_POLYGON, BAT_POLYGON};
    return number < BAT_PRIMITIVE_NUMBERS && of[number] == p->kind;
}

static double whole_turns(double degrees) {
    const double rest = degrees - 360 * floor(degrees / 360);
    return rest < 360 ? rest : 0;
}

static double end_of(const bat_primitive *p) {
    const double end = whole_turns(p->start + p->sweep);
    return end > 0 ? end : 360;
}

static void set_arc(bat_primitive *p, double start, double end) {
    const double sweep = whole_turns(end - start);
    p->start = whole_turns(start);
    p->sweep = sweep >= LEAST_SWEEP ? sweep : 360;
    if (p->sweep == 360) p->start = 0;
}

bool bat_primitive_get(const bat_primitive *p, bat_primitive_number number, double *value) {
    if (!has(p, number)) return false;
    const double values[] = {p->radii[0], p->start, end_of(p), p->sides, 100 * p->depth, 100 * p->roundness};
    *value = values[number];
    return true;
}

bool bat_primitive_set(bat_primitive *p, bat_primitive_number number, double value) {
    if (!has(p, number) || !isfinite(value)) return false;
    switch (number) {
    case BAT_PRIMITIVE_RADIUS:
        p->radii[0] = p->radii[1] = clamp(value, 0, 0.5 * fmin(length_of(p->place), length_of(p->place + 2)));
        break;
    case BAT_PRIMITIVE_START: set_arc(p, value, end_of(p)); break;
    case BAT_PRIMITIVE_END: set_arc(p, p->start, value); break;
    case BAT_PRIMITIVE_SIDES: p->sides = (int)clamp(round(value), BAT_SIDES_MIN, BAT_SIDES_MAX); break;
    case BAT_PRIMITIVE_DEPTH: p->depth = clamp(value / 100, 0, DEEPEST); break;
    default: p->roundness = clamp(value / 100, 0, 1); break;
    }
    return true;
}

/* ---- dragged ---- */

static void place_at(const bat_primitive *p, double s, double t, double at[2]) {
    put(&(outline){.place = p->place}, s, t, at);
}

/* Towards the middle of a polygon or an ellipse by that length. */
static void draw_in(const bat_primitive *p, double by, double at[2]) {
    const double *middle = p->place + 4, away[2] = {at[0] - middle[0], at[1] - middle[1]};
    const double share = fmax(0, 1 - by / fmax(length_of(away), 1e-300));
    for (int d = 0; d < 2; d++) at[d] = middle[d] + share * away[d];
}

bool bat_primitive_handle(const bat_primitive *p, bat_primitive_number number, double inset, double at[2]) {
    if (!has(p, number)) return false;
    const double angle = -(number == BAT_PRIMITIVE_START ? p->start : end_of(p)) * BAT_PI / 180;
    double corner[2];
    switch (number) {
    case BAT_PRIMITIVE_RADIUS: /* at the corner where the first axis ends */
        place_at(p, 1 - fmin(0.5, fmax(p->radii[0], inset) / length_of(p->place)),
                 fmin(0.5, fmax(p->radii[1], inset) / length_of(p->place + 2)), at);
        return true;
    case BAT_PRIMITIVE_START:
    case BAT_PRIMITIVE_END:
        if (number == BAT_PRIMITIVE_START && p->sweep >= 360) return false;
        place_at(p, bat_cos(angle), bat_sin(angle), at);
        break;
    case BAT_PRIMITIVE_SIDES: /* the corner before the first one, which moves with their number */
        corner_of(p, p->depth > 0 ? 2 * p->sides - 2 : p->sides - 1, corner);
        place_at(p, corner[0], corner[1], at);
        break;
    case BAT_PRIMITIVE_DEPTH: /* the middle of the first side */
        if (p->depth > 0)
            corner_of(p, 1, corner);
        else
            for (int d = 0; d < 2; d++)
                corner[d] = bat_cos(BAT_PI / p->sides) *
                            (d ? bat_sin(BAT_PI / p->sides) : bat_cos(BAT_PI / p->sides));
        place_at(p, corner[0], corner[1], at);
        return true;
    default: /* in from the first corner */
        place_at(p, 1, 0, at);
        draw_in(p, inset + 0.5 * p->roundness * length_of(p->place), at);
        return true;
    }
    draw_in(p, inset, at);
    return true;
}

/* The place in own units. */
static void own_place(const bat_primitive *p, const double at[2], double own[2]) {
    const double *m = p->place, area = m[0] * m[3] - m[1] * m[2], x = at[0] - m[4], y = at[1] - m[5];
    own[0] = (m[3] * x - m[2] * y) / area;
    own[1] = (m[0] * y - m[1] * x) / area;
}

void bat_primitive_drag(bat_primitive *p, bat_primitive_number number, const double from[2],
                        const double to[2]) {
    double a[2], b[2], value = 0;
    if (!bat_primitive_get(p, number, &value)) return;
    own_place(p, from, a);
    own_place(p, to, b);
    const double angle = -bat_atan2(b[1], b[0]) * 180 / BAT_PI;
    const double along = length_of(b) - length_of(a);
    switch (number) {
    case BAT_PRIMITIVE_RADIUS: /* the mean of how far it came along both sides */
        value += 0.5 * ((a[0] - b[0]) * length_of(p->place) + (b[1] - a[1]) * length_of(p->place + 2));
        break;
    case BAT_PRIMITIVE_START:
    case BAT_PRIMITIVE_END: value = angle; break;
    case BAT_PRIMITIVE_SIDES: /* the angle to the first corner is a side's */
        value = fmin(SIDES_DRAGGED, fabs(angle) > 0 ? 360 / fabs(angle) : SIDES_DRAGGED);
        break;
    case BAT_PRIMITIVE_DEPTH: value -= 100 * along / bat_cos(BAT_PI / p->sides); break;
    default: value -= 200 * along; break; /* half of the way to the middle is all */
    }
    (void)bat_primitive_set(p, number, number == BAT_PRIMITIVE_RADIUS ? value : round(value));
}
