/* Wavefront OBJ: B-spline curves ("cstype bspline" and "curv" of its free-form part), with their names. A
 * closed curve is written as OBJ files represent it, with as many points and knots repeated as its degree, and
 * is recognised as closed again when read. Everything else in a file is counted and left out. */
#include "document/format.h"
#include "curve/curve.h"
#include "kinds/kinds.h"
#include "text/json.h"
#include "text/number.h"
#include "text/text.h"

#include <batten/refine.h>

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- reading ---- */

typedef struct numbers {
    double *list;
    size_t count, room;
} numbers;

typedef struct made {
    bat_curve *curve;
    char *name; /* owned; NULL: none */
} made;

typedef struct parser {
    const char *at, *end; /* of the statement */
    long line;
    numbers vertices;       /* x y z w each */
    numbers indices, knots; /* of the curve being read; vertices are numbered from 0 */
    double domain[2];
    int degree;
    bool bspline, rational, reading;
    const char *name; /* borrowed from the text; NULL: none */
    size_t name_size;
    made *curves;
    int count, room;
    bat_svg_report *report;
    bat_problem *problem;
} parser;

static bat_status wrong(parser *p, bat_status status, const char *message) {
    char place[40];
    snprintf(place, sizeof place, "line %ld", p->line);
    return bat_problem_set(p->problem, status, place, message);
}

static bat_status add(parser *p, numbers *to, double value) {
    if (to->count == to->room) {
        size_t room = 2 * to->room + 64;
        double *list = realloc(to->list, room * sizeof *list);
        if (!list) return wrong(p, BAT_MEMORY, bat_status_message(BAT_MEMORY));
        to->list = list;
        to->room = room;
    }
    to->list[to->count++] = value;
    return BAT_OK;
}

/* Skips blanks, and line ends after a backslash. */
static void skip(parser *p) {
    while (p->at < p->end &&
           (*p->at == ' ' || *p->at == '\t' || *p->at == '\r' || *p->at == '\n' || *p->at == '\\')) {
        p->line += *p->at == '\n';
        p->at++;
    }
}

static bool number(parser *p, double *value) {
    skip(p);
    const char *after = p->at < p->end ? bat_number_scan(p->at, p->end, value) : NULL;
    if (!after) return false;
    p->at = after;
    return true;
}

/* Reads the next word of the statement. */
static size_t word(parser *p, const char **out) {
    skip(p);
    *out = p->at;
    while (p->at < p->end && !strchr(" \t\r\n\\", *p->at)) p->at++;
    return (size_t)(p->at - *out);
}

static bool is(const char *text, size_t size, const char *what) {
    return size == strlen(what) && memcmp(text, what, size) == 0;
}

static bat_status read_vertex(parser *p) {
    double v[4] = {0, 0, 0, 1};
    int count = 0;
    while (count < 4 && number(p, &v[count])) count++;
    if (count < 3) return wrong(p, BAT_SYNTAX, "v: expected three numbers, found fewer");
    bat_status status = BAT_OK;
    for (int i = 0; i < 4 && status == BAT_OK; i++) status = add(p, &p->vertices, v[i]);
    return status;
}

static bat_status read_type(parser *p) {
    const char *text;
    size_t size = word(p, &text);
    p->rational = is(text, size, "rat");
    if (p->rational) size = word(p, &text);
    p->bspline = is(text, size, "bspline");
    return BAT_OK;
}

static bat_status read_degree(parser *p) {
    double value = 0;
    if (!number(p, &value) || value != floor(value) || !(value >= 1 && value <= BAT_DEGREE_MAX))
        return wrong(p, BAT_DEGREE, "deg: expected a whole number from 1 to 7");
    p->degree = (int)value;
    return BAT_OK;
}

static bat_status read_curve(parser *p) {
    double value = 0, count = (double)(p->vertices.count / 4);
    bat_status status = BAT_OK;
    p->indices.count = p->knots.count = 0;
    p->reading = true;
    if (!number(p, &p->domain[0]) || !number(p, &p->domain[1]))
        return wrong(p, BAT_SYNTAX, "curv: expected where the curve begins and ends, two numbers");
    while (status == BAT_OK && number(p, &value)) {
        double index = value < 0 ? count + value : value - 1; /* counts from 1, or negative: from the end */
        if (index != floor(index) || !(index >= 0 && index < count))
            return wrong(p, BAT_SYNTAX, "curv: expected the number of a vertex, found none such");
        status = add(p, &p->indices, index);
    }
    return status;
}

static bat_status read_knots(parser *p) {
    const char *text;
    double value;
    bat_status status = BAT_OK;
    size_t size = word(p, &text);
    if (!is(text, size, "u")) return BAT_OK;
    while (status == BAT_OK && number(p, &value)) status = add(p, &p->knots, value);
    return status;
}

/* Whether points and knots are periodic: returns the number of distinct points, or 0 when they are not. */
static int period_of(const double *points, int size, int count, int degree, const double *knots) {
    int n = count - degree;
    if (n < 2 || !(knots[degree + n] > knots[degree])) return 0;
    double period = knots[degree + n] - knots[degree];
    for (int i = 0; i < degree * size; i++)
        if (points[i] != points[n * size + i]) return 0;
    for (int i = 0; i + n <= count + degree; i++)
        if (!(fabs(knots[i + n] - knots[i] - period) <= 4 * DBL_EPSILON * (fabs(knots[i + n]) + period)))
            return 0;
    return n;
}

/* Cuts the curve to its stated range of parameters, if that is not the whole domain. Takes the curve over. */
static bat_status cut(parser *p, bat_curve *curve, bat_curve **out) {
    double domain[2];
    bat_curve_domain(curve, domain);
    *out = curve;
    if (p->domain[0] <= domain[0] && p->domain[1] >= domain[1]) return BAT_OK;
    bat_status status = bat_curve_piece(curve, fmax(p->domain[0], domain[0]), fmin(p->domain[1], domain[1]),
                                        out);
    bat_curve_free(curve);
    return status == BAT_OK ? status : wrong(p, status, "curv: expected a part of what the knots give");
}

static bat_status make_curve(parser *p, double *points, bat_curve **out) {
    int count = (int)p->indices.count, size = 2;
    const double *knots = p->knots.list;
    for (int i = 0; i < count; i++) {
        const double *v = p->vertices.list + 4 * (size_t)p->indices.list[i];
        if (p->rational && v[3] != 1)
            return wrong(p, BAT_UNSUPPORTED, "curv: expected weights of 1, found a rational curve");
        if (v[2] != 0) size = 3;
    }
    for (int i = 0; i < count; i++)
        memcpy(points + i * size, p->vertices.list + 4 * (size_t)p->indices.list[i],
               (size_t)size * sizeof *points);
    if (count <= p->degree || p->knots.count != p->indices.count + (size_t)p->degree + 1)
        return wrong(p, BAT_KNOTS, "parm u: expected as many knots as points, degree and one together");
    int round = period_of(points, size, count, p->degree, knots), from = round ? p->degree : 0;
    int knot_count = round ? round + 1 : (int)p->knots.count;
    bat_status status = bat_curve_create(size, p->degree, round > 0, (size_t)(round ? round : count),
                                         points + from * size, knot_count, knots + from, out);
    if (status != BAT_OK) return wrong(p, status, bat_status_message(status));
    return cut(p, *out, out);
}

static bat_status keep(parser *p, bat_curve *curve) {
    if (p->count == p->room) {
        int room = 2 * p->room + 8;
        made *curves = realloc(p->curves, (size_t)room * sizeof *curves);
        if (!curves) {
            bat_curve_free(curve);
            return wrong(p, BAT_MEMORY, bat_status_message(BAT_MEMORY));
        }
        p->curves = curves;
        p->room = room;
    }
    made *at = &p->curves[p->count++];
    *at = (made){curve, NULL};
    if (!p->name) return BAT_OK;
    at->name = malloc(p->name_size + 1);
    if (!at->name) return wrong(p, BAT_MEMORY, bat_status_message(BAT_MEMORY));
    memcpy(at->name, p->name, p->name_size);
    at->name[p->name_size] = '\0';
    return BAT_OK;
}

static bat_status read_end(parser *p) {
    bat_curve *curve = NULL;
    if (!p->reading) return BAT_OK;
    p->reading = false;
    if (!p->bspline) {
        p->report->lost.count[BAT_LOSS_UNKNOWN]++;
        return BAT_OK;
    }
    double *points = malloc(3 * p->indices.count * sizeof *points + 1);
    if (!points) return wrong(p, BAT_MEMORY, bat_status_message(BAT_MEMORY));
    bat_status status = make_curve(p, points, &curve);
    free(points);
    return status == BAT_OK ? keep(p, curve) : status;
}

static bat_status read_name(parser *p) {
    skip(p);
    p->name = p->at;
    p->name_size = (size_t)(p->end - p->at);
    while (p->name_size && strchr(" \t\r\n", p->name[p->name_size - 1])) p->name_size--;
    if (!p->name_size) p->name = NULL;
    return BAT_OK;
}

static const struct {
    const char *name;
    bat_status (*read)(parser *p); /* NULL: it does not describe a curve */
} STATEMENTS[] = {{"v", read_vertex},   {"cstype", read_type}, {"deg", read_degree}, {"curv", read_curve},
                  {"parm", read_knots}, {"end", read_end},     {"o", read_name},     {"g", read_name},
                  {"vn", NULL},         {"vt", NULL},          {"vp", NULL},         {"s", NULL},
                  {"mtllib", NULL},     {"usemtl", NULL},      {"mg", NULL}};

static bat_status read_statement(parser *p) {
    const char *text;
    size_t size = word(p, &text);
    if (!size || *text == '#') return BAT_OK;
    for (size_t i = 0; i < sizeof STATEMENTS / sizeof *STATEMENTS; i++)
        if (is(text, size, STATEMENTS[i].name)) return STATEMENTS[i].read ? STATEMENTS[i].read(p) : BAT_OK;
    p->report->lost.count[BAT_LOSS_UNKNOWN]++;
    return BAT_OK;
}

/* The end of a statement: one line, or several joined by backslashes. */
static const char *statement_end(const char *at, const char *end) {
    for (; at < end; at++) {
        const char *before = at;
        if (*at != '\n') continue;
        if (before[-1] == '\r') before--;
        if (before[-1] != '\\') break;
    }
    return at;
}

static bat_status document_of(parser *p, bat_document **out) {
    bat_curve **curves = malloc(((size_t)p->count + 1) * sizeof *curves);
    const char **names = malloc(((size_t)p->count + 1) * sizeof *names);
    bat_status status = BAT_MEMORY;
    for (int i = 0; i < p->count && curves && names; i++)
        curves[i] = p->curves[i].curve, names[i] = p->curves[i].name;
    if (curves && names) {
        status = bat_document_of_curves(p->count, curves, names, out);
        for (int i = 0; i < p->count; i++) p->curves[i].curve = NULL;
    }
    free(curves);
    free(names);
    if (status == BAT_OK) return status;
    return bat_problem_set(p->problem, status, "",
                           status == BAT_ARGUMENT ? "o: expected UTF-8, found something else"
                                                  : bat_status_message(status));
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    parser p = {.degree = 3, .report = report, .problem = problem};
    bat_status status = BAT_OK;
    size_t start = bat_format_start(text, size);
    const char *at = text + start, *end = text + size;
    (void)how;
    for (size_t i = 0; i < start; i++) p.line += text[i] == '\n';
    while (at < end && status == BAT_OK) {
        p.line++;
        p.at = at;
        p.end = statement_end(at + (*at != '\n'), end);
        at = p.end + (p.end < end);
        const char *first = p.at;
        long line = p.line;
        status = read_statement(&p);
        for (p.line = line; first < p.end; first++) p.line += *first == '\n';
    }
    if (status == BAT_OK && !p.count)
        status = bat_problem_set(problem, BAT_UNSUPPORTED, "",
                                 "expected a curve (cstype bspline), found none");
    if (status == BAT_OK) status = document_of(&p, out);
    for (int i = 0; i < p.count; i++) {
        bat_curve_free(p.curves[i].curve);
        free(p.curves[i].name);
    }
    free(p.curves);
    free(p.vertices.list);
    free(p.indices.list);
    free(p.knots.list);
    return status;
}

/* Looks at the first line that is not a comment: its first word must be one that we know. */
static int sniff(const char *text, size_t size) {
    parser p = {.at = text + bat_format_start(text, size), .end = text + size};
    while (p.at < p.end) {
        const char *first;
        size_t length = word(&p, &first);
        for (size_t i = 0; i < sizeof STATEMENTS / sizeof *STATEMENTS; i++)
            if (is(first, length, STATEMENTS[i].name)) return 60;
        if (!length || *first != '#') return 0;
        while (p.at < p.end && *p.at != '\n') p.at++;
    }
    return 0;
}

/* ---- writing ---- */

/* Writes a blank and the number; the line is broken after every `row` numbers. */
static void put(bat_text *text, int i, int row, double number) {
    bat_text_string(text, i && i % row == 0 ? " \\\n " : " ");
    bat_text_number(text, number);
}

/* The name must stay on one line: line ends become blanks, and a final backslash, which would join the next
 * line, a slash. */
static void put_name(bat_text *text, const char *name) {
    if (!*name) return;
    bat_text_string(text, "o ");
    for (; *name; name++) {
        bool last = !name[1] && *name == '\\';
        bat_text_add(text, last ? "/" : (unsigned char)*name < ' ' ? " " : name, 1);
    }
    bat_text_string(text, "\n");
}

/* vertices: how many were written before. */
static int put_curve(bat_text *text, const bat_curve *curve, int vertices) {
    enum { ROW = 10 };
    int p = bat_curve_degree(curve), n = bat_point_count(curve), size = bat_curve_dimension(curve);
    bool closed = bat_curve_is_closed(curve);
    const double *points = bat_curve_points(curve), *knots = bat_curve_knots(curve);
    int before = closed ? p : 0, count = n + before;
    double domain[2], period = closed ? knots[n] - knots[0] : 0;
    bat_curve_domain(curve, domain);
    for (int i = 0; i < count; i++) {
        const double *point = points + ((i - before) % n + n) % n * size;
        bat_text_string(text, "v");
        for (int d = 0; d < 3; d++) put(text, 0, ROW, d < size ? point[d] : 0);
        bat_text_string(text, "\n");
    }
    bat_text_string(text, "cstype bspline\ndeg ");
    bat_text_integer(text, (uint64_t)p);
    bat_text_string(text, "\ncurv");
    for (int i = 0; i < 2; i++) put(text, 0, ROW, domain[i]);
    for (int i = 0; i < count; i++) put(text, i + 2, ROW, vertices + i + 1);
    bat_text_string(text, "\nparm u");
    for (int i = 0; i < count + p + 1; i++) {
        int k = i - before, turns = 0;
        for (; closed && k < 0; k += n) turns--;
        for (; closed && k > n; k -= n) turns++;
        put(text, i + 1, ROW, knots[k] + turns * period);
    }
    bat_text_string(text, "\nend\n");
    return vertices + count;
}

static bat_status write(const bat_document *document, char **out, size_t *size, bat_problem *problem) {
    bat_text text = {0};
    int vertices = 0;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        for (int k = 0; k < bat_object_curve_count(object); k++) {
            put_name(&text, bat_object_name(object));
            vertices = put_curve(&text, bat_object_curve(object, k), vertices);
        }
    }
    if (!vertices) {
        bat_text_free(&text);
        return bat_problem_set(problem, BAT_COUNT, "",
                               "an .obj file holds curves, expected 1 at least, found none");
    }
    bat_status status = bat_text_finish(&text, out, size);
    return status == BAT_OK ? status : bat_problem_set(problem, status, "", bat_status_message(status));
}

const bat_format bat_format_of_obj = {"obj", "model/obj", false, sniff, read, write};
