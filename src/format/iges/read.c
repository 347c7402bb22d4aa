/* Reads IGES 5.3: rational B-spline curves (126) and surfaces (128), moved by the matrices (124) that they name; with weights
 * that differ they are approximated. Lengths become millimetres. Curves that bound trimmed surfaces, and curves in the
 * parameters of one, belong to the trims, which are left out. */
#include "format/iges/iges.h"
#include "format/model/rational.h"
#include "format/model/full.h"
#include "format/model/model.h"
#include "text/json.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CHAIN = 8, WIDTH = 64, COMPOSITE = 102, ON_BOUNDARY = 141, ON_SURFACE = 142, EDGES = 504 };

typedef struct parser {
    bat_iges_file file;
    size_t entities, lines_read;
    bool *bounds; /* of each entity: whether it is part of a trim */
    char delimiter, record;
    double unit; /* millimetres */
    bat_iges_reader at;
    bat_numbers numbers;
    bat_model *out;
    bat_problem *problem;
} parser;

static bat_status wrong(parser *p, long line, bat_status status, const char *message) {
    char place[40];
    snprintf(place, sizeof place, "line %ld", line);
    return bat_problem_set(p->problem, status, place, message);
}

static bat_status wrong_here(parser *p, bat_status status, const char *message) {
    return wrong(p, bat_iges_line_number(&p->at), status, message);
}

/* ---- the global section ---- */

static double unit_named(const char *name) {
    static const struct {
        const char *name;
        double millimetres;
    } units[] = {{"MM", 1},   {"M", 1000},     {"IN", 25.4}, {"INCH", 25.4},  {"CM", 10},      {"FT", 304.8},
                 {"KM", 1e6}, {"MI", 1609344}, {"UM", 1e-3}, {"MIL", 0.0254}, {"UIN", 2.54e-5}};
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strcmp(name, units[i].name) == 0) return units[i].millimetres;
    return 0;
}

static double unit_of(double flag, const char *name) {
    static const char *const flags[] = {"IN", "IN", "MM",  NULL, "FT", "MI",
                                        "M",  "KM", "MIL", "UM", "CM", "UIN"};
    const int i = flag >= 0 && flag <= 11 ? (int)flag : 3;
    return unit_named(flags[i] ? flags[i] : name);
}

static bat_status read_globals(parser *p) {
    enum { SCALE = 13, FLAG = 14, NAME = 15 };
    double scale = 1, flag = 1;
    bat_iges_value value = {.kind = BAT_IGES_DEFAULT};
    p->at = bat_iges_reader_of(&p->file, p->file.globals, 72);
    if (!bat_iges_delimiters(&p->at))
        return wrong_here(p, BAT_SYNTAX, "expected delimiters (1H,,1H;,), found something else");
    p->delimiter = p->at.delimiter, p->record = p->at.record;
    for (int i = 3; i <= NAME && !p->at.ended; i++) {
        value = bat_iges_next(&p->at);
        if (value.kind == BAT_IGES_BAD)
            return wrong_here(p, BAT_SYNTAX, "expected a global parameter, found something else");
        if (i == SCALE && value.kind == BAT_IGES_NUMBER && value.number != 0) scale = value.number;
        if (i == FLAG && value.kind == BAT_IGES_NUMBER) flag = value.number;
    }
    p->unit = unit_of(flag, value.text) / scale;
    if (p->unit > 0 && p->unit <= 1e12) return BAT_OK;
    return wrong_here(p, BAT_UNSUPPORTED, "expected a unit of length, found one that is not known");
}

/* ---- entities ---- */

/* The first line of an entity in section D. */
static const bat_iges_line *entry(const parser *p, size_t entity) {
    return p->file.lines + p->file.directory.first + 2 * entity;
}

/* Begins to read the parameters of an entity, the first of which must be its type. */
static bat_status begin(parser *p, size_t entity) {
    const bat_iges_line *line = entry(p, entity);
    const long first = bat_iges_field(line, 1), count = bat_iges_field(line + 1, 3);
    if (first < 1 || count < 1 || (size_t)first > p->file.parameters.count ||
        (size_t)count > p->file.parameters.count - (size_t)first + 1)
        return wrong(p, line->number, BAT_SYNTAX, "expected lines of section P, found none such");
    p->lines_read += (size_t)count;
    if (p->lines_read > p->file.parameters.count + 64 * p->entities)
        return wrong(p, line->number, BAT_SYNTAX, "expected lines of its own, found those of other entities");
    p->at = bat_iges_reader_of(
        &p->file, (bat_iges_run){p->file.parameters.first + (size_t)first - 1, (size_t)count}, WIDTH);
    p->at.delimiter = p->delimiter, p->at.record = p->record;
    const bat_iges_value type = bat_iges_next(&p->at);
    if (type.kind != BAT_IGES_NUMBER || type.number != (double)bat_iges_field(line, 0))
        return wrong_here(p, BAT_SYNTAX, "expected the type of the entity, as in section D, found another");
    return BAT_OK;
}

/* One more number; `usual` where it is left out. */
static bat_status read_number(parser *p, double usual, double *out) {
    const bat_iges_value value = bat_iges_next(&p->at);
    *out = usual;
    if (value.kind == BAT_IGES_DEFAULT) return BAT_OK;
    if (value.kind != BAT_IGES_NUMBER)
        return wrong_here(p, BAT_SYNTAX, "expected a number, found something else");
    if (!(fabs(value.number) <= BAT_COORDINATE_MAX))
        return wrong_here(p, BAT_NUMBER, "expected numbers up to 1e75, found a greater one");
    *out = value.number;
    return BAT_OK;
}

static bat_status read_numbers(parser *p, size_t count, double usual) {
    bat_status status = BAT_OK;
    p->numbers.count = 0;
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        double value;
        if (p->at.ended)
            return wrong_here(p, BAT_COUNT, "expected as many numbers as the entity says, found fewer");
        status = read_number(p, usual, &value);
        if (status == BAT_OK && !bat_numbers_add(&p->numbers, value))
            status = wrong_here(p, BAT_MEMORY, bat_status_message(BAT_MEMORY));
    }
    return status;
}

/* A whole number from low to high. */
static bat_status whole(parser *p, double low, double high, const char *message, int *out) {
    double value;
    bat_status status = read_number(p, 0, &value);
    if (status != BAT_OK) return status;
    if (value != floor(value) || !(value >= low && value <= high))
        return wrong_here(p, low == 1 && high == BAT_DEGREE_MAX ? BAT_DEGREE : BAT_COUNT, message);
    *out = (int)value;
    return BAT_OK;
}

/* What a pointer to an entity means: its place, or -1 for none. */
static bat_status pointer(parser *p, long *out) {
    double value;
    bat_status status = read_number(p, 0, &value);
    if (status != BAT_OK) return status;
    value = fabs(value);
    if (value != floor(value) || value > 2 * (double)p->entities || (value > 0 && fmod(value, 2) != 1))
        return wrong_here(p, BAT_SYNTAX, "expected the number of an entity (odd), found something else");
    *out = value > 0 ? ((long)value - 1) / 2 : -1;
    return BAT_OK;
}

/* ---- matrices ---- */

/* out: 3 rows of 4, in the file's units: those that an entity names, the first applied first. */
static bat_status read_matrix(parser *p, size_t entity, double out[12]) {
    static const double none[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    memcpy(out, none, sizeof none);
    for (int k = 0; k <= CHAIN; k++) {
        const bat_iges_line *line = entry(p, entity);
        const long at = bat_iges_field(line, 6);
        if (at == 0) return BAT_OK;
        if (k == CHAIN || at < 0 || at % 2 == 0 || (size_t)at > 2 * p->entities ||
            bat_iges_field(entry(p, (size_t)(at - 1) / 2), 0) != BAT_IGES_MATRIX)
            return wrong(p, line->number, BAT_SYNTAX, "expected a matrix (124) in field 7, found none such");
        entity = (size_t)(at - 1) / 2;
        bat_status status = begin(p, entity);
        if (status == BAT_OK) status = read_numbers(p, 12, 0);
        if (status != BAT_OK) return status;
        double made[12];
        const double *m = p->numbers.list;
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 4; j++)
                made[4 * i + j] = m[4 * i] * out[j] + m[4 * i + 1] * out[4 + j] + m[4 * i + 2] * out[8 + j] +
                                  (j == 3 ? m[4 * i + 3] : 0);
        memcpy(out, made, sizeof made);
    }
    return BAT_OK;
}

static void place(const parser *p, const double matrix[12], double *points, size_t count, bool moved) {
    for (size_t i = 0; i < count; i++) {
        double *at = points + 3 * i, made[3];
        for (int c = 0; c < 3; c++) {
            const double *row = matrix + 4 * c;
            made[c] = moved ? row[0] * at[0] + row[1] * at[1] + row[2] * at[2] + row[3] : at[c];
        }
        for (int c = 0; c < 3; c++) at[c] = made[c] * p->unit;
    }
}

/* ---- curves and surfaces ---- */

/* A curve, or a surface: what comes before its weights. */
typedef struct head {
    size_t count[2];
    int degree[2], directions;
    double *knots[2], *points, *weights;
} head;

static bat_status read_head(parser *p, int directions, size_t room, head *out) {
    static const char says[] = "expected as many points as the entity holds, found another count";
    const double most = fmin((double)room, BAT_POINTS_MAX);
    int last[2] = {0, 0};
    bat_status status = BAT_OK;
    out->directions = directions, out->count[1] = 1, out->degree[1] = 0;
    for (int d = 0; d < directions && status == BAT_OK; d++) status = whole(p, 1, most, says, &last[d]);
    for (int d = 0; d < directions && status == BAT_OK; d++)
        status = whole(p, 1, BAT_DEGREE_MAX, "expected a degree from 1 to 7, found another", &out->degree[d]);
    double skipped;
    for (int i = 0; i < (directions == 1 ? 4 : 5) && status == BAT_OK; i++)
        status = read_number(p, 0, &skipped);
    for (int d = 0; d < directions; d++) out->count[d] = (size_t)last[d] + 1;
    if (status == BAT_OK && (double)out->count[0] * (double)out->count[1] > most)
        status = wrong_here(p, BAT_COUNT, says);
    for (int d = 0; d < directions && status == BAT_OK; d++)
        if (out->count[d] <= (size_t)out->degree[d])
            status = wrong_here(p, BAT_COUNT, "expected more points than the degree, found fewer");
    return status;
}

/* Room for the knots, points and weights of the head, one after the other. */
static bat_status make_room(parser *p, head *h) {
    size_t knots = 0;
    for (int d = 0; d < h->directions; d++) knots += h->count[d] + (size_t)h->degree[d] + 1;
    const size_t count = h->count[0] * h->count[1];
    h->knots[0] = malloc((knots + 4 * count) * sizeof *h->points);
    if (!h->knots[0]) return wrong_here(p, BAT_MEMORY, bat_status_message(BAT_MEMORY));
    h->knots[1] = h->knots[0] + h->count[0] + h->degree[0] + 1;
    h->points = h->knots[0] + knots;
    h->weights = h->points + 3 * count;
    return BAT_OK;
}

/* Reads so many numbers to that place. */
static bat_status read_to(parser *p, size_t count, double *to) {
    bat_status status = read_numbers(p, count, 0);
    if (status == BAT_OK) memcpy(to, p->numbers.list, count * sizeof *to);
    return status;
}

/* Weights that are left out are 1. */
static bat_status read_weights(parser *p, head *h) {
    const size_t count = h->count[0] * h->count[1];
    bat_status status = read_numbers(p, count, 1);
    if (status == BAT_OK) memcpy(h->weights, p->numbers.list, count * sizeof *h->weights);
    return status;
}

static bat_status read_body(parser *p, head *h, double range[4]) {
    bat_status status = make_room(p, h);
    for (int d = 0; d < h->directions && status == BAT_OK; d++)
        status = read_to(p, h->count[d] + (size_t)h->degree[d] + 1, h->knots[d]);
    if (status == BAT_OK) status = read_weights(p, h);
    if (status == BAT_OK) status = read_to(p, 3 * h->count[0] * h->count[1], h->points);
    for (int k = 0; k < 2 * h->directions && status == BAT_OK; k++)
        status = read_number(p, k % 2 ? INFINITY : -INFINITY, &range[k]);
    for (int d = 0; d < h->directions && status == BAT_OK; d++) /* left out, as numbers that are all 0 */
        if (range[2 * d] == range[2 * d + 1]) range[2 * d] = -INFINITY, range[2 * d + 1] = INFINITY;
    return status;
}

static bat_status refuse(parser *p, long line, bat_status status) {
    return wrong(p, line, status, status == BAT_NUMBER ? BAT_WEIGHTS_EXPECTED : bat_status_message(status));
}

static bat_status make_curve(parser *p, long line, const head *h, const double range[2]) {
    bat_curve *curve;
    bat_status status = bat_weighted_curve(h->degree[0], h->count[0], h->points, h->weights, h->knots[0],
                                           range, &curve);
    if (status == BAT_PARAMETER) return wrong(p, line, status, "126: expected a part of what the knots give");
    if (status != BAT_OK) return refuse(p, line, status);
    status = bat_model_add_curve(p->out, curve);
    return status == BAT_OK ? status : wrong(p, line, status, bat_status_message(status));
}

/* In the file the points run along u first. */
static bat_status make_surface(parser *p, long line, const head *h, const double range[4]) {
    const size_t *n = h->count;
    const double *const knots[2] = {h->knots[0], h->knots[1]};
    bat_surface *surface;
    double *rows = malloc(4 * n[0] * n[1] * sizeof *rows), *weights = rows ? rows + 3 * n[0] * n[1] : NULL;
    if (!rows) return wrong(p, line, BAT_MEMORY, bat_status_message(BAT_MEMORY));
    for (size_t i = 0; i < n[0]; i++)
        for (size_t j = 0; j < n[1]; j++) {
            memcpy(rows + 3 * (i * n[1] + j), h->points + 3 * (j * n[0] + i), 3 * sizeof *rows);
            weights[i * n[1] + j] = h->weights[j * n[0] + i];
        }
    bat_status status = bat_weighted_surface(h->degree, n, rows, weights, knots, &surface);
    free(rows);
    if (status != BAT_OK) return refuse(p, line, status);
    if (!bat_full_is_whole(surface, BAT_U, range) || !bat_full_is_whole(surface, BAT_V, range + 2)) {
        bat_surface_free(surface);
        return wrong(p, line, BAT_UNSUPPORTED, "128: expected the whole of a surface, found a part of it");
    }
    status = bat_model_add_surface(p->out, surface);
    return status == BAT_OK ? status : wrong(p, line, status, bat_status_message(status));
}

static bat_status read_spline(parser *p, size_t entity, int directions) {
    head h = {.directions = directions};
    double matrix[12], range[4];
    bat_status status = read_matrix(p, entity, matrix);
    if (status == BAT_OK) status = begin(p, entity);
    const long line = status == BAT_OK ? bat_iges_line_number(&p->at) : 0;
    if (status == BAT_OK) status = read_head(p, directions, (size_t)(p->at.end - p->at.line) * WIDTH, &h);
    if (status == BAT_OK) status = read_body(p, &h, range);
    if (status == BAT_OK) {
        place(p, matrix, h.points, h.count[0] * h.count[1], bat_iges_field(entry(p, entity), 6) != 0);
        status = directions == 1 ? make_curve(p, line, &h, range) : make_surface(p, line, &h, range);
    }
    free(h.knots[0]); /* the block of all three */
    return status;
}

/* ---- trims ---- */

static bat_status mark(parser *p) {
    long at = -1;
    bat_status status = pointer(p, &at);
    if (status == BAT_OK && at >= 0) p->bounds[at] = true;
    return status;
}

static bat_status skip(parser *p, int count) {
    bat_status status = BAT_OK;
    for (double value; count > 0 && status == BAT_OK; count--) status = read_number(p, 0, &value);
    return status;
}

static bat_status mark_list(parser *p, int type) {
    int count = 0, curves = 0;
    bat_status status = whole(p, 0, 1e9, "expected a count, found something else", &count);
    for (int i = 0; i < count && status == BAT_OK && !p->at.ended; i++) {
        status = mark(p);
        if (type == EDGES && status == BAT_OK) status = skip(p, 4);
        if (type != ON_BOUNDARY || status != BAT_OK) continue;
        status = skip(p, 1);
        if (status == BAT_OK) status = whole(p, 0, 1e9, "expected a count, found something else", &curves);
        for (int k = 0; status == BAT_OK && k < curves && !p->at.ended; k++) status = mark(p);
    }
    return status;
}

/* Marks the curves that a boundary, or a part of one, consists of. */
static bat_status mark_parts(parser *p, size_t entity, int type) {
    bat_status status = begin(p, entity);
    if (status != BAT_OK) return status;
    if (type == ON_SURFACE) {
        status = skip(p, 2);
        if (status == BAT_OK) status = mark(p);
        return status == BAT_OK ? mark(p) : status;
    }
    if (type == ON_BOUNDARY) status = skip(p, 3);
    return status == BAT_OK ? mark_list(p, type) : status;
}

static bat_status mark_bounds(parser *p) {
    bat_status status = BAT_OK;
    for (int pass = 0; pass < 2; pass++)
        for (size_t i = 0; i < p->entities && status == BAT_OK; i++) {
            const long type = bat_iges_field(entry(p, i), 0);
            const bool composite = type == COMPOSITE && p->bounds[i];
            if (pass == 0 ? type == ON_SURFACE || type == ON_BOUNDARY || type == EDGES : composite)
                status = mark_parts(p, i, (int)type);
        }
    return status;
}

/* ---- the file ---- */

/* Whether an entity of this type is something to be seen, rather than a property, a colour, a part of a trim. */
static bool is_seen(long type) {
    static const int none[] = {0,           BAT_IGES_MATRIX,
                               ON_BOUNDARY, ON_SURFACE,
                               COMPOSITE,   302,
                               304,         306,
                               310,         312,
                               314,         316,
                               322,         402,
                               404,         406,
                               410,         502,
                               EDGES,       508};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        if (type == none[i]) return false;
    return true;
}

static bat_status read_entity(parser *p, size_t entity) {
    const bat_iges_line *line = entry(p, entity);
    const long type = bat_iges_field(line, 0), flat = bat_iges_field(line, 8) / 100 % 100;
    const bool bounds = p->bounds[entity] || flat == 5; /* 5: a curve in the parameters of a surface */
    if (type == BAT_IGES_SURFACE) return read_spline(p, entity, 2);
    if (type == BAT_IGES_CURVE && !bounds) return read_spline(p, entity, 1);
    p->out->left_out += !bounds && is_seen(type);
    return BAT_OK;
}

bat_status bat_iges_read(const char *text, size_t size, bat_model *out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_model made = {.mesh = NULL};
    parser p = {.out = &made, .problem = problem};
    bat_status status = bat_iges_split(text, size, &p.file, problem);
    if (status != BAT_OK) return status;
    p.entities = p.file.directory.count / 2;
    p.bounds = calloc(p.entities + 1, sizeof *p.bounds);
    if (!p.bounds) {
        free(p.file.lines);
        return bat_problem_set(problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
    }
    status = read_globals(&p);
    if (status == BAT_OK) status = mark_bounds(&p);
    for (size_t i = 0; i < p.entities && status == BAT_OK; i++) status = read_entity(&p, i);
    if (status == BAT_OK && made.surface_count + made.curve_count == 0)
        status = bat_problem_set(problem, BAT_COUNT, "",
                                 "expected a B-spline curve or surface (126, 128), found none");
    free(p.numbers.list);
    free(p.bounds);
    free(p.file.lines);
    if (status == BAT_OK)
        *out = made;
    else
        bat_model_clear(&made);
    return status;
}
