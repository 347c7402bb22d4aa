/* Reads OBJ: faces and points, and B-spline curves and surfaces ("cstype bspline") of the free-form part. A closed curve
 * or surface is written as one with as many points and knots repeated as its degree, and is recognised as closed again. */
#include "document/format.h"
#include "format/model/full.h"
#include "format/model/rational.h"
#include "format/obj/lines.h"
#include "format/obj/obj.h"
#include "text/json.h"
#include <batten/mesh.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum element { NOTHING, CURVE, SURFACE } element;

typedef struct parser {
    bat_obj_line line;
    bat_numbers vertices;        /* x y z w each */
    bat_numbers indices;         /* of the element being read; vertices are numbered from 0 */
    bat_numbers knots[2];        /* of the element being read */
    bat_numbers sizes, corners;  /* of faces */
    bat_numbers points, shaping; /* vertices that are points themselves; that shape curves and surfaces */
    double domain[4];
    int degree[2];
    bool bspline, rational;
    element reading;
    const char *name; /* borrowed from the text; NULL: none */
    size_t name_size;
    double back[9]; /* where x, y and z of the page come from; only with `turned` */
    bool turned;
    bat_obj *out;
    bat_problem *problem;
} parser;

static bat_status wrong(parser *p, bat_status status, const char *message) {
    char place[40];
    snprintf(place, sizeof place, "line %ld", p->line.number);
    return bat_problem_set(p->problem, status, place, message);
}

static bat_status no_memory(parser *p) { return wrong(p, BAT_MEMORY, bat_status_message(BAT_MEMORY)); }

static bat_status add(parser *p, bat_numbers *to, double value) {
    return bat_numbers_add(to, value) ? BAT_OK : no_memory(p);
}

/* ---- statements ---- */

static bat_status read_vertex(parser *p) {
    double v[4] = {0, 0, 0, 1};
    int count = 0;
    while (count < 4 && bat_obj_number(&p->line, &v[count])) count++;
    if (count < 3) return wrong(p, BAT_SYNTAX, "v: expected three numbers, found fewer");
    bat_status status = BAT_OK;
    for (int i = 0; i < 4 && status == BAT_OK; i++) {
        if (!(fabs(v[i]) <= BAT_COORDINATE_MAX))
            return wrong(p, BAT_NUMBER, "v: expected numbers up to 1e75, found a greater one");
        status = add(p, &p->vertices, p->turned && i < 3 ? bat_obj_turned(p->back, i, v) : v[i]);
    }
    return status;
}

static bat_status read_type(parser *p) {
    const char *text;
    size_t size = bat_obj_word(&p->line, &text);
    p->rational = bat_obj_is(text, size, "rat");
    if (p->rational) size = bat_obj_word(&p->line, &text);
    p->bspline = bat_obj_is(text, size, "bspline");
    return BAT_OK;
}

static bat_status read_degree(parser *p) {
    double value = 0;
    for (int d = 0; d < 2; d++) {
        if (!bat_obj_number(&p->line, &value) && d == 1) return BAT_OK;
        if (value != floor(value) || !(value >= 1 && value <= BAT_DEGREE_MAX))
            return wrong(p, BAT_DEGREE, "deg: expected a whole number from 1 to 7");
        p->degree[d] = (int)value;
    }
    return BAT_OK;
}

/* Reads the numbers of vertices: they count from 1, negative ones from the last vertex back. What follows a number after
 * a slash is skipped. */
static bat_status read_indices(parser *p, const char *what, bat_numbers *to) {
    const double count = (double)(p->vertices.count / 4);
    double value = 0;
    char message[80];
    bat_status status = BAT_OK;
    while (status == BAT_OK && bat_obj_number(&p->line, &value)) {
        const double index = value < 0 ? count + value : value - 1;
        if (index != floor(index) || !(index >= 0 && index < count)) {
            snprintf(message, sizeof message, "%s: expected the number of a vertex, found none such", what);
            return wrong(p, BAT_SYNTAX, message);
        }
        bat_obj_skip_word(&p->line);
        status = add(p, to, index);
    }
    return status;
}

static bat_status begin(parser *p, element what, const char *word, const char *message) {
    p->indices.count = p->knots[0].count = p->knots[1].count = 0;
    p->reading = what;
    for (int k = 0; k < (what == CURVE ? 2 : 4); k++)
        if (!bat_obj_number(&p->line, &p->domain[k])) return wrong(p, BAT_SYNTAX, message);
    return read_indices(p, word, &p->indices);
}

static bat_status read_curve(parser *p) {
    return begin(p, CURVE, "curv", "curv: expected where the curve begins and ends, two numbers");
}

static bat_status read_surface(parser *p) {
    return begin(p, SURFACE, "surf", "surf: expected where u and v begin and end, four numbers");
}

static bat_status read_face(parser *p) {
    const size_t before = p->corners.count;
    bat_status status = read_indices(p, "f", &p->corners);
    if (status != BAT_OK) return status;
    if (p->corners.count - before >= 3) return add(p, &p->sizes, (double)(p->corners.count - before));
    p->corners.count = before; /* a line or a point */
    p->out->model.left_out++;
    return BAT_OK;
}

static bat_status read_points(parser *p) { return read_indices(p, "p", &p->points); }

static bat_status read_knots(parser *p) {
    const char *text;
    double value;
    bat_status status = BAT_OK;
    const size_t size = bat_obj_word(&p->line, &text);
    const int d = bat_obj_is(text, size, "v");
    if (!d && !bat_obj_is(text, size, "u")) return BAT_OK;
    while (status == BAT_OK && bat_obj_number(&p->line, &value)) status = add(p, &p->knots[d], value);
    return status;
}

static bat_status read_name(parser *p) {
    p->name_size = bat_obj_rest(&p->line, &p->name);
    if (!p->name_size) p->name = NULL;
    return BAT_OK;
}

/* ---- curves and surfaces ---- */

/* An element's points, 3 numbers each, and weights; NULL: it has none. */
typedef struct net {
    size_t count;
    double *points, *weights;
} net;

static bat_status gather(parser *p, const net *n) {
    bat_status status = BAT_OK;
    for (size_t i = 0; i < n->count && status == BAT_OK; i++) {
        const double *v = p->vertices.list + 4 * (size_t)p->indices.list[i];
        memcpy(n->points + 3 * i, v, 3 * sizeof *v);
        if (n->weights) n->weights[i] = v[3];
        status = add(p, &p->shaping, p->indices.list[i]);
    }
    return status;
}

/* Says what is wrong with numbers that make no curve or surface. */
static bat_status refuse(parser *p, const net *n, const char *word, bat_status status) {
    char message[160];
    const bool weights = status == BAT_NUMBER && n->weights;
    if (status == BAT_PARAMETER) return wrong(p, status, "curv: expected a part of what the knots give");
    if (status == BAT_NUMBER && !weights)
        return wrong(p, status, "parm: expected knots up to 1e30, none of them too close, found others");
    if (status == BAT_KNOTS)
        return wrong(p, status, "parm: expected knots that neither fall nor repeat too often, found others");
    snprintf(message, sizeof message, "%s: %s", word,
             weights ? BAT_WEIGHTS_EXPECTED : bat_status_message(status));
    return wrong(p, status, weights ? message : bat_status_message(status));
}

static bat_status make_curve(parser *p, const net *n, bat_curve **out) {
    const size_t degree = (size_t)p->degree[0];
    if (n->count <= degree || p->knots[0].count != n->count + degree + 1)
        return wrong(p, BAT_KNOTS, "parm u: expected as many knots as points, degree and one together");
    const bat_status status = bat_weighted_curve(p->degree[0], n->count, n->points, n->weights,
                                                 p->knots[0].list, p->domain, out);
    return status == BAT_OK ? status : refuse(p, n, "curv", status);
}

/* In the file u runs first; rows: room for as many points and weights. */
static void turn(const net *n, const size_t count[2], const net *rows) {
    for (size_t i = 0; i < count[0]; i++)
        for (size_t j = 0; j < count[1]; j++) {
            const size_t to = i * count[1] + j, from = j * count[0] + i;
            memcpy(rows->points + 3 * to, n->points + 3 * from, 3 * sizeof *n->points);
            if (n->weights) rows->weights[to] = n->weights[from];
        }
}

static bat_status make_surface(parser *p, const net *n, const net *rows, bat_surface **out) {
    size_t count[2];
    for (int d = 0; d < 2; d++) {
        const size_t knots = p->knots[d].count, more = (size_t)p->degree[d] + 1;
        count[d] = knots > more ? knots - more : 0;
    }
    if (count[0] == 0 || count[1] == 0 || count[0] > n->count || count[0] * count[1] != n->count)
        return wrong(p, BAT_KNOTS, "parm: expected knots that fit the number of points and the degrees");
    turn(n, count, rows);
    const double *const knots[2] = {p->knots[0].list, p->knots[1].list};
    bat_status status = bat_weighted_surface(p->degree, count, rows->points, rows->weights, knots, out);
    if (status != BAT_OK) return refuse(p, n, "surf", status);
    if (bat_full_is_whole(*out, BAT_U, p->domain) && bat_full_is_whole(*out, BAT_V, p->domain + 2))
        return BAT_OK;
    bat_surface_free(*out);
    return wrong(p, BAT_UNSUPPORTED, "surf: expected the whole of a surface, found a part of it");
}

/* Makes room in a list of names and puts the present name into it. */
static bat_status keep_name(parser *p, char ***names, size_t count) {
    if ((count & (count - 1)) == 0) {
        char **list = realloc(*names, (count > 0 ? 2 * count : 1) * sizeof(char *));
        if (!list) return no_memory(p);
        *names = list;
    }
    (*names)[count] = NULL;
    if (!p->name) return BAT_OK;
    char *name = malloc(p->name_size + 1);
    if (!name) return no_memory(p);
    memcpy(name, p->name, p->name_size);
    name[p->name_size] = '\0';
    (*names)[count] = name;
    return BAT_OK;
}

static bat_status end_curve(parser *p, const net *n) {
    bat_model *model = &p->out->model;
    bat_curve *curve = NULL;
    bat_status status = make_curve(p, n, &curve);
    if (status != BAT_OK) return status;
    status = keep_name(p, &p->out->curve_names, model->curve_count);
    if (status == BAT_OK && bat_model_add_curve(model, curve) == BAT_OK) return BAT_OK;
    if (status != BAT_OK) {
        bat_curve_free(curve);
        return status;
    }
    free(p->out->curve_names[model->curve_count]);
    return no_memory(p);
}

static bat_status end_surface(parser *p, const net *n, const net *rows) {
    bat_model *model = &p->out->model;
    bat_surface *surface = NULL;
    bat_status status = make_surface(p, n, rows, &surface);
    if (status != BAT_OK) return status;
    status = keep_name(p, &p->out->surface_names, model->surface_count);
    if (status == BAT_OK && bat_model_add_surface(model, surface) == BAT_OK) return BAT_OK;
    if (status != BAT_OK) {
        bat_surface_free(surface);
        return status;
    }
    free(p->out->surface_names[model->surface_count]);
    return no_memory(p);
}

static bat_status read_end(parser *p) {
    const element what = p->reading;
    p->reading = NOTHING;
    if (what == NOTHING) return BAT_OK;
    if (!p->bspline) {
        p->out->model.left_out++;
        return BAT_OK;
    }
    if (p->indices.count > BAT_POINTS_MAX)
        return wrong(p, BAT_COUNT, "end: expected 16777216 points at most, found more");
    const size_t count = p->indices.count;
    double *numbers = malloc(8 * count * sizeof *numbers + 1);
    if (!numbers) return no_memory(p);
    double *weights = numbers + 6 * count;
    const net n = {count, numbers, p->rational ? weights : NULL};
    const net rows = {count, numbers + 3 * count, p->rational ? weights + count : NULL};
    bat_status status = gather(p, &n);
    if (status == BAT_OK) status = what == CURVE ? end_curve(p, &n) : end_surface(p, &n, &rows);
    free(numbers);
    return status;
}

/* ---- the mesh ---- */

/* The vertices of the mesh, and where each vertex of the file is among them (-1: it only shapes a curve or surface). */
static size_t choose(const parser *p, int *place, double *vertices) {
    const size_t count = p->vertices.count / 4;
    size_t kept = 0;
    memset(place, 0, count * sizeof *place);
    for (size_t i = 0; i < p->shaping.count; i++) place[(size_t)p->shaping.list[i]] = -1;
    for (size_t i = 0; i < p->points.count; i++) place[(size_t)p->points.list[i]] = 0;
    for (size_t i = 0; i < p->corners.count; i++) place[(size_t)p->corners.list[i]] = 0;
    for (size_t i = 0; i < count; i++) {
        if (place[i] < 0) continue;
        memcpy(vertices + 3 * kept, p->vertices.list + 4 * i, 3 * sizeof *vertices);
        place[i] = (int)kept++;
    }
    return kept;
}

static bat_status make_mesh(parser *p) {
    const size_t count = p->vertices.count / 4, faces = p->sizes.count, corners = p->corners.count;
    const bool free_forms = p->out->model.curve_count + p->out->model.surface_count > 0;
    if (count == 0 || (faces == 0 && p->points.count == 0 && free_forms)) return BAT_OK;
    double *vertices = malloc(3 * count * sizeof *vertices);
    int *list = malloc((count + faces + corners) * sizeof *list);
    bat_status status = BAT_MEMORY;
    if (vertices && list) {
        int *sizes = list + count, *corner = sizes + faces;
        const size_t kept = choose(p, list, vertices);
        for (size_t i = 0; i < faces; i++) sizes[i] = (int)p->sizes.list[i];
        for (size_t i = 0; i < corners; i++) corner[i] = list[(size_t)p->corners.list[i]];
        status = bat_polymesh_create(kept, vertices, faces, sizes, corner, &p->out->model.mesh, NULL);
    }
    free(vertices);
    free(list);
    if (status == BAT_OK) return status;
    return bat_problem_set(p->problem, status, "", bat_status_message(status));
}

/* ---- the file ---- */

static const struct {
    const char *name;
    bat_status (*read)(parser *p); /* NULL: it says how something looks */
} STATEMENTS[] = {{"v", read_vertex},    {"f", read_face},     {"fo", read_face},    {"p", read_points},
                  {"cstype", read_type}, {"deg", read_degree}, {"curv", read_curve}, {"surf", read_surface},
                  {"parm", read_knots},  {"end", read_end},    {"o", read_name},     {"g", read_name},
                  {"vn", NULL},          {"vt", NULL},         {"vp", NULL},         {"s", NULL},
                  {"mtllib", NULL},      {"usemtl", NULL},     {"mg", NULL}};

static bat_status read_statement(parser *p) {
    const char *text;
    size_t size = bat_obj_word(&p->line, &text);
    if (!size || *text == '#') return BAT_OK;
    for (size_t i = 0; i < sizeof STATEMENTS / sizeof *STATEMENTS; i++)
        if (bat_obj_is(text, size, STATEMENTS[i].name))
            return STATEMENTS[i].read ? STATEMENTS[i].read(p) : BAT_OK;
    p->out->model.left_out++;
    return BAT_OK;
}

static void clear_names(bat_obj *obj) {
    for (size_t i = 0; i < obj->model.curve_count; i++) free(obj->curve_names[i]);
    for (size_t i = 0; i < obj->model.surface_count; i++) free(obj->surface_names[i]);
    free(obj->curve_names);
    free(obj->surface_names);
}

void bat_obj_clear(bat_obj *obj) {
    clear_names(obj);
    bat_model_clear(&obj->model);
}

bat_status bat_obj_parse(const char *text, size_t size, const double *way, bat_obj *out,
                         bat_problem *problem) {
    bat_obj made = {.curve_names = NULL};
    parser p = {.line = bat_obj_lines(text, size, bat_format_start(text, size)),
                .degree = {3, 3},
                .out = &made,
                .turned = way != NULL,
                .problem = problem};
    bat_status status = BAT_OK;
    for (int i = 0; way && i < 9; i++) p.back[3 * (i % 3) + i / 3] = way[i];
    while (status == BAT_OK && bat_obj_next(&p.line)) status = read_statement(&p);
    if (status == BAT_OK) status = make_mesh(&p);
    bat_numbers *const lists[] = {&p.vertices, &p.indices, &p.knots[0], &p.knots[1],
                                  &p.sizes,    &p.corners, &p.points,   &p.shaping};
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++) free(lists[i]->list);
    if (status == BAT_OK)
        *out = made;
    else
        bat_obj_clear(&made);
    return status;
}

bat_status bat_obj_read(const char *text, size_t size, bat_model *out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_obj obj;
    bat_status status = bat_obj_parse(text, size, NULL, &obj, problem);
    if (status != BAT_OK) return status;
    clear_names(&obj);
    if (!obj.model.mesh && obj.model.surface_count + obj.model.curve_count == 0)
        return bat_problem_set(problem, BAT_COUNT, "",
                               "expected a mesh, a surface or a curve (cstype bspline), found none");
    *out = obj.model;
    return BAT_OK;
}

/* Looks at the first line that is not a comment: its first word must be one that we know. */
int bat_obj_sniff(const char *text, size_t size) {
    bat_obj_line line = bat_obj_lines(text, size, bat_format_start(text, size));
    while (bat_obj_next(&line)) {
        const char *first;
        const size_t length = bat_obj_word(&line, &first);
        for (size_t i = 0; i < sizeof STATEMENTS / sizeof *STATEMENTS; i++)
            if (bat_obj_is(first, length, STATEMENTS[i].name)) return 60;
        if (length && *first != '#') return 0;
    }
    return 0;
}
