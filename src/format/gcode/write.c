/*
 * G-code (ISO 6983) for mills, plotters and laser cutters: lines and arcs in the plane, a tool that goes up and down. Places are
 * whole numbers of a unit of the last digit, so that where the machine thinks it is is known exactly: a full circle that
 * rounding would make a point, or the reverse, cannot be written.
 */
#include "base/options.h"
#include "base/real.h"
#include "document/nesting.h"
#include "document/scale.h"
#include "text/text.h"

#include <batten/measure.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/relate.h>
#include <math.h>
#include <string.h>

enum { DIGITS = 4, SCALE = 10000, TEMPLATE_MAX = 1000 };

static const double CORNER = 0.05;
static const double PIECE =
    2; /* radians: arcs are written in pieces of no more, where their ends give the centre well */
static const double WIDEST =
    1e6; /* of radii: wider arcs are written as lines that no digit tells from them */
static const double FARTHEST = 1e11;

static const bat_gcode_options DEFAULTS = {
    .tolerance = 0.01, .feed = 1000, .up = "G0 Z5", .down = "G1 Z-1 F300"};
#define LEAST (offsetof(bat_gcode_options, down) + sizeof DEFAULTS.down)

void bat_gcode_options_init(bat_gcode_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

/* A place in units of the last digit, y upwards. */
typedef struct place {
    int64_t x, y;
} place;

typedef struct writer {
    bat_text *text;
    const bat_gcode_options *options;
    double origin[2]; /* of the machine, in the document */
    double digits;    /* units of the last digit in one of the document */
    double tolerance; /* in the document's units */
    place at;
    bool placed, down, fed; /* fed: the feed is in force since the tool went down */
    bool far;               /* something lies beyond what a machine's numbers hold */
    size_t curves;
} writer;

static place place_of(writer *w, const double point[2]) {
    const double x = (point[0] - w->origin[0]) * w->digits, y = (w->origin[1] - point[1]) * w->digits;
    if (!(fabs(x) <= FARTHEST && fabs(y) <= FARTHEST)) {
        w->far = true;
        return (place){0, 0};
    }
    return (place){(int64_t)floor(x + 0.5), (int64_t)floor(y + 0.5)};
}

static bool same(place a, place b) { return a.x == b.x && a.y == b.y; }

static void put_word(writer *w, char letter, int64_t value) {
    const int64_t size = value < 0 ? -value : value;
    const char head[2] = {' ', letter};
    char decimals[DIGITS + 1] = ".";
    int rest = (int)(size % SCALE), length = 1;
    for (int unit = SCALE / 10; rest; unit /= 10) {
        decimals[length++] = (char)('0' + rest / unit);
        rest %= unit;
    }
    bat_text_add(w->text, head, sizeof head);
    if (value < 0) bat_text_string(w->text, "-");
    bat_text_integer(w->text, (uint64_t)(size / SCALE));
    if (length > 1) bat_text_add(w->text, decimals, (size_t)length);
}

static void put_line(writer *w, const char *words) {
    bat_text_string(w->text, words);
    bat_text_string(w->text, "\n");
}

static void put_to(writer *w, const char *code, place to) {
    bat_text_string(w->text, code);
    put_word(w, 'X', to.x), put_word(w, 'Y', to.y);
}

static void end_of_cut(writer *w) {
    if (!w->fed) {
        bat_text_string(w->text, " F");
        bat_text_number(w->text, w->options->feed);
    }
    w->fed = true;
    bat_text_string(w->text, "\n");
}

static void lift(writer *w) {
    if (w->down) put_line(w, w->options->up);
    w->down = false;
}

/* The tool is brought there, unless it is there and down. */
static void begin_at(writer *w, place to) {
    if (w->down && same(w->at, to)) return;
    lift(w);
    if (!w->placed || !same(w->at, to)) put_to(w, "G0", to), bat_text_string(w->text, "\n");
    put_line(w, w->options->down);
    w->at = to, w->placed = w->down = true, w->fed = false;
}

static void cut_to(writer *w, place to) {
    if (same(w->at, to)) return;
    put_to(w, "G1", to);
    end_of_cut(w);
    w->at = to;
}

/* The angle that the arc turns by, above 0. */
static double sweep_of(const bat_arc *arc, double *from) {
    *from = bat_atan2(arc->from[1] - arc->centre[1], arc->from[0] - arc->centre[0]);
    const double to = bat_atan2(arc->to[1] - arc->centre[1], arc->to[0] - arc->centre[0]);
    double angle = arc->ccw ? to - *from : *from - to;
    if (angle < 0) angle += 2 * BAT_PI;
    return angle;
}

/* y is turned round, so what is anticlockwise in the document is clockwise for the machine. */
static void cut_arc(writer *w, const bat_arc *arc) {
    double from, point[2];
    const double angle = sweep_of(arc, &from);
    const bool wide = arc->radius * w->digits > WIDEST * SCALE;
    const double most = wide ? sqrt(8 / (arc->radius * w->digits)) : PIECE;
    const int pieces = (int)fmax(1, ceil(angle / most));
    const double half = angle / pieces / 2, bow = arc->radius * (1 - bat_cos(half));
    for (int i = 1; i <= pieces; i++) {
        const double turned = from + (arc->ccw ? 1 : -1) * angle * i / pieces;
        point[0] = arc->centre[0] + arc->radius * bat_cos(turned);
        point[1] = arc->centre[1] + arc->radius * bat_sin(turned);
        const place to = place_of(w, i < pieces ? point : arc->to);
        if (same(w->at, to)) continue;
        if (bow * w->digits < 1 || wide) { /* as straight as the digits tell */
            cut_to(w, to);
            continue;
        }
        const place centre = place_of(w, arc->centre);
        put_to(w, arc->ccw ? "G2" : "G3", to);
        put_word(w, 'I', centre.x - w->at.x), put_word(w, 'J', centre.y - w->at.y);
        end_of_cut(w);
        w->at = to;
    }
}

static void cut_polyline(writer *w, const bat_curve *curve) {
    const size_t count = bat_curve_count(curve);
    const double *points = bat_curve_points(curve);
    begin_at(w, place_of(w, points));
    for (size_t i = 1; i < count; i++) cut_to(w, place_of(w, points + 2 * i));
    if (bat_curve_is_closed(curve)) cut_to(w, place_of(w, points));
}

static bat_status cut_curve(writer *w, const bat_curve *curve) {
    bat_arc *arcs = NULL;
    size_t count = 0;
    w->curves++;
    if (bat_curve_dimension(curve) != 2) return BAT_DIMENSION;
    if (bat_curve_degree(curve) == 1) {
        cut_polyline(w, curve);
        return BAT_OK;
    }
    double low[2],
        high[2]; /* looked at before the arcs are made, which would be as many as the curve is far too large */
    bat_curve_bounds(curve, low, high);
    place_of(w, low), place_of(w, high);
    if (w->far) return BAT_NUMBER;
    const bat_status status = bat_curve_arcs(curve, w->tolerance, CORNER, &count, &arcs, NULL);
    if (status != BAT_OK) return status;
    for (size_t i = 0; i < count; i++) {
        if (i == 0) begin_at(w, place_of(w, arcs[i].from));
        if (arcs[i].radius > 0)
            cut_arc(w, &arcs[i]);
        else
            cut_to(w, place_of(w, arcs[i].to));
    }
    bat_free(arcs);
    return BAT_OK;
}

static bat_status cut_all(writer *w, const bat_document *document) {
    bat_status status = BAT_OK;
    bat_nesting nesting = {.depth = 0};
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level;
        if (!bat_nesting_next(&nesting, object, &level) || level.hidden) continue;
        for (int k = 0; k < bat_object_curve_count(object) && status == BAT_OK; k++)
            status = cut_curve(w, bat_object_curve(object, k));
    }
    if (status != BAT_OK) return status;
    return w->curves == 0 ? BAT_COUNT : w->far ? BAT_NUMBER : BAT_OK;
}

/* Lines of printable ASCII. */
static bool is_template(const char *text) {
    if (!text || strlen(text) > TEMPLATE_MAX) return false;
    for (; *text; text++)
        if (*text != '\n' && (*text < ' ' || *text > '~')) return false;
    return true;
}

bat_status bat_gcode_write(const bat_document *document, const bat_gcode_options *options, char **text,
                           size_t *size) {
    bat_gcode_options chosen = DEFAULTS;
    bat_text all = {0};
    if (!document || !text || !size) return BAT_ARGUMENT;
    bat_status status = bat_options_read(options, LEAST, sizeof chosen, &chosen);
    if (status != BAT_OK) return status;
    if (!(chosen.tolerance > 0 && chosen.tolerance <= BAT_COORDINATE_MAX && chosen.feed > 0 &&
          chosen.feed <= 1e9) ||
        !is_template(chosen.up) || !is_template(chosen.down))
        return BAT_ARGUMENT;
    writer w = {.text = &all, .options = &chosen};
    const double scale = bat_unit_corner(document, w.origin);
    w.digits = scale * SCALE, w.tolerance = chosen.tolerance / scale;
    bat_text_string(&all, "G21\nG90\nG17\n"); /* millimetres, absolute, arcs in x and y */
    put_line(&w, chosen.up);
    status = cut_all(&w, document);
    lift(&w);
    put_line(&w, "M2");
    if (status == BAT_OK) return bat_text_finish(&all, text, size);
    bat_text_free(&all);
    return status;
}
