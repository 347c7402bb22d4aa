/* Reads STEP (ISO 10303-21): the B-spline curves and surfaces of a file, whatever its schema (AP203, AP214, AP242), in
 * millimetres. Trims, placements of parts and every other shape are counted and left out. */
#include "format/model/rational.h"
#include "format/step/step.h"
#include "text/json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct parser {
    bat_step_file file;
    double unit;
    bat_model *out;
    bat_problem *problem;
} parser;

static bat_status wrong(const parser *p, const bat_step_instance *at, bat_status status,
                        const char *message) {
    return bat_step_wrong(&at->body, status, message, p->problem);
}

/* ---- points ---- */

/* A CARTESIAN_POINT: its coordinates, of which there may be two. */
static bat_status read_point(const parser *p, const bat_step_instance *point, double out[3], int *size) {
    bat_step_place at = point->body;
    for (int k = 0; k < 4; k++) (void)bat_step_next(&at); /* CARTESIAN_POINT ( 'name' , */
    bat_step_token token = bat_step_next(&at);
    if (token.mark != '(') return wrong(p, point, BAT_SYNTAX, "expected coordinates, found something else");
    for (*size = 0; *size < 4;) {
        token = bat_step_next(&at);
        if (token.type != BAT_STEP_NUMBER || *size == 3)
            return wrong(p, point, BAT_SYNTAX, "expected two or three coordinates, found something else");
        if (!(fabs(token.number) <= BAT_COORDINATE_MAX))
            return wrong(p, point, BAT_NUMBER, "expected numbers up to 1e75, found a greater one");
        out[(*size)++] = token.number * p->unit;
        token = bat_step_next(&at);
        if (token.mark != ',') break;
    }
    if (token.mark == ')' && *size >= 2) return BAT_OK;
    return wrong(p, point, BAT_SYNTAX, "expected two or three coordinates, found something else");
}

/* *size: 3, or 2 for a curve in the parameters of a surface. */
static bat_status gather(const parser *p, const bat_step_instance *of, const bat_numbers *ids, double *points,
                         int *size) {
    for (size_t i = 0; i < ids->count; i++) {
        const bat_step_instance *point = bat_step_find(&p->file, ids->list[i]);
        if (!point || !(point->flags & BAT_STEP_POINT))
            return wrong(p, of, BAT_SYNTAX, "expected a CARTESIAN_POINT, found none such");
        bat_status status = read_point(p, point, points + 3 * i, size);
        if (status != BAT_OK) return status;
        if (*size == 2) return BAT_OK;
    }
    return BAT_OK;
}

/* ---- knots ---- */

static const char *check_degree(const bat_step_spline *s, const size_t count[2]) {
    for (int d = 0; d < s->directions; d++) {
        if (s->degree[d] != floor(s->degree[d]) || !(s->degree[d] >= 1 && s->degree[d] <= BAT_DEGREE_MAX))
            return "expected a degree from 1 to 7, found another";
        if ((double)count[d] <= s->degree[d]) return "expected more points than the degree, found fewer";
    }
    return NULL;
}

/* Knots that are not written: clamped and even, even throughout, or of Bézier pieces one beside the other. */
static bat_status imply_knots(char form, int degree, size_t count, bat_numbers *out) {
    const double last = form == 'B' ? (double)(count - 1) / degree : (double)count - degree;
    if (last != floor(last)) return BAT_KNOTS;
    for (size_t i = 0; i < count + (size_t)degree + 1; i++) {
        double at = (double)i - degree;
        if (form == 'B') at = ceil(((double)i - degree) / degree);
        if (form != 'U') at = fmin(fmax(at, 0), last);
        if (!bat_numbers_add(out, at)) return BAT_MEMORY;
    }
    return BAT_OK;
}

static bat_status repeat_knots(const bat_numbers *many, const bat_numbers *knots, size_t total,
                               bat_numbers *out) {
    if (many->count != knots->count) return BAT_KNOTS;
    for (size_t i = 0; i < many->count; i++) {
        if (!(many->list[i] >= 1 && many->list[i] <= BAT_DEGREE_MAX + 1)) return BAT_KNOTS;
        for (int k = 0; k < many->list[i]; k++)
            if (!bat_numbers_add(out, knots->list[i] + 0.0))
                return BAT_MEMORY; /* -0, of which one stands for all, is 0 */
    }
    return out->count == total ? BAT_OK : BAT_KNOTS;
}

static bat_status all_knots(const bat_step_spline *s, int d, size_t count, bat_numbers *out) {
    const int degree = (int)s->degree[d];
    if (s->knots[d].count == 0) return imply_knots(s->form, degree, count, out);
    return repeat_knots(&s->many[d], &s->knots[d], count + (size_t)degree + 1, out);
}

/* ---- curves and surfaces ---- */

static bat_status make(const parser *p, const bat_step_spline *s, const size_t count[2], double *points,
                       const bat_numbers knots[2]) {
    const double *weights = s->weights.count > 0 ? s->weights.list : NULL;
    if (s->directions == 1) {
        bat_curve *curve;
        bat_status status = bat_weighted_curve((int)s->degree[0], count[0], points, weights, knots[0].list,
                                               NULL, &curve);
        return status == BAT_OK ? bat_model_add_curve(p->out, curve) : status;
    }
    bat_surface *surface;
    const int degree[2] = {(int)s->degree[0], (int)s->degree[1]};
    const double *const lists[2] = {knots[0].list, knots[1].list};
    bat_status status = bat_weighted_surface(degree, count, points, weights, lists, &surface);
    return status == BAT_OK ? bat_model_add_surface(p->out, surface) : status;
}

static bat_status check(const parser *p, const bat_step_instance *of, const bat_step_spline *s,
                        const size_t count[2]) {
    const bat_numbers *w = &s->weights;
    const char *fault = check_degree(s, count);
    if (fault) return wrong(p, of, BAT_DEGREE, fault);
    if (s->points.count > BAT_POINTS_MAX)
        return wrong(p, of, BAT_COUNT, "expected 16777216 points at most, found more");
    if (w->count > 0 && w->count != s->points.count)
        return wrong(p, of, BAT_COUNT, "expected as many weights as points, found others");
    return BAT_OK;
}

static bat_status add_spline(const parser *p, const bat_step_instance *of, const bat_step_spline *s) {
    const size_t count[2] = {s->directions == 1 ? s->points.count : s->rows,
                             s->directions == 1 ? 1 : s->points.count / s->rows};
    bat_numbers knots[2] = {{0}, {0}};
    int size = 3;
    bat_status status = check(p, of, s, count);
    if (status != BAT_OK) return status;
    double *points = malloc(3 * s->points.count * sizeof *points);
    status = points ? gather(p, of, &s->points, points, &size) : BAT_MEMORY;
    const bool said = points && status != BAT_OK, flat = status == BAT_OK && size == 2;
    for (int d = 0; d < s->directions && status == BAT_OK && !flat; d++)
        status = all_knots(s, d, count[d], &knots[d]);
    if (status == BAT_OK && !flat) status = make(p, s, count, points, knots);
    free(points);
    free(knots[0].list);
    free(knots[1].list);
    if (status == BAT_OK || said) return status;
    return wrong(p, of, status,
                 status == BAT_KNOTS ? "expected knots that fit the points and the degree, found others"
                 : status == BAT_NUMBER && s->weights.count > 0 ? BAT_WEIGHTS_EXPECTED
                                                                : bat_status_message(status));
}

static bat_status read_one(const parser *p, const bat_step_instance *instance) {
    bat_step_spline spline;
    bat_status status = bat_step_read_spline(instance, &spline, p->problem);
    if (status == BAT_OK) status = add_spline(p, instance, &spline);
    bat_step_spline_clear(&spline);
    return status;
}

/* Marks what edges refer to: it bounds a face. */
static void mark_bounds(const bat_step_file *file) {
    for (size_t i = 0; i < file->count; i++) {
        if (!(file->list[i].flags & BAT_STEP_BOUNDS)) continue;
        bat_step_place at = file->list[i].body;
        for (bat_step_token token = bat_step_next(&at); token.type > BAT_STEP_BAD && token.mark != ';';
             token = bat_step_next(&at)) {
            bat_step_instance *bound = token.type == BAT_STEP_OBJECT ? bat_step_find(file, token.number)
                                                                     : NULL;
            if (bound) bound->bounds = true;
        }
    }
}

static bat_status read_all(parser *p) {
    bat_status status = bat_step_unit(&p->file, &p->unit, p->problem);
    mark_bounds(&p->file);
    for (size_t i = 0; i < p->file.count && status == BAT_OK; i++) {
        const bat_step_instance *instance = &p->file.list[i];
        const bool spline = instance->flags & (BAT_STEP_CURVE | BAT_STEP_SURFACE);
        if (instance->bounds) continue;
        if (spline) status = read_one(p, instance);
        const bool trimmed = instance->flags & BAT_STEP_FACE && !bat_step_is_whole(&p->file, instance);
        p->out->left_out += instance->flags == 0 || trimmed;
    }
    if (status == BAT_OK && p->out->surface_count + p->out->curve_count == 0)
        status = bat_problem_set(p->problem, BAT_COUNT, "",
                                 "expected a B-spline curve or surface, found none");
    return status;
}

bat_status bat_step_read(const char *text, size_t size, bat_model *out, bat_problem *problem) {
    if (!text || !out) return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    bat_model made = {.mesh = NULL};
    parser p = {.out = &made, .problem = problem};
    bat_status status = bat_step_index(text, size, &p.file, problem);
    if (status != BAT_OK) return status;
    status = read_all(&p);
    free(p.file.list);
    if (status == BAT_OK)
        *out = made;
    else
        bat_model_clear(&made);
    return status;
}
