/* Reads the records of one B-spline. */
#include "format/step/step.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct parser {
    bat_step_place at;
    bat_step_spline *out;
    bat_problem *problem;
} parser;

static bat_status wrong(parser *p, const char *message) {
    return bat_step_wrong(&p->at, BAT_SYNTAX, message, p->problem);
}

static bat_status expect(parser *p, char mark) {
    const bat_step_token token = bat_step_next(&p->at);
    char message[] = "expected ., found something else";
    message[9] = mark;
    return token.mark == mark ? BAT_OK : wrong(p, message);
}

static bat_status one(parser *p, bat_step_type type, bat_numbers *to) {
    const bat_step_token token = bat_step_next(&p->at);
    if (token.type != type)
        return wrong(p, type == BAT_STEP_NUMBER ? "expected a number, found something else"
                                                : "expected a point (#), found something else");
    if (type == BAT_STEP_NUMBER && !(fabs(token.number) <= BAT_COORDINATE_MAX))
        return bat_step_wrong(&p->at, BAT_NUMBER, "expected numbers up to 1e75, found a greater one",
                              p->problem);
    if (bat_numbers_add(to, token.number)) return BAT_OK;
    return bat_step_wrong(&p->at, BAT_MEMORY, bat_status_message(BAT_MEMORY), p->problem);
}

/* (a, b, ...) */
static bat_status list(parser *p, bat_step_type type, bat_numbers *to) {
    bat_status status = expect(p, '(');
    while (status == BAT_OK) {
        status = one(p, type, to);
        if (status != BAT_OK) break;
        const bat_step_token token = bat_step_next(&p->at);
        if (token.mark == ')') return BAT_OK;
        if (token.mark != ',') return wrong(p, "expected , or ), found something else");
    }
    return status;
}

/* ((a, b), (c, d), ...): rows of one length. */
static bat_status lists(parser *p, bat_step_type type, bat_numbers *to, size_t *rows) {
    bat_status status = expect(p, '(');
    size_t length = 0;
    *rows = 0;
    while (status == BAT_OK) {
        const size_t before = to->count;
        status = list(p, type, to);
        if (status != BAT_OK) break;
        if (++*rows == 1) length = to->count;
        if (to->count - before != length) return wrong(p, "expected rows of one length, found another");
        const bat_step_token token = bat_step_next(&p->at);
        if (token.mark == ')') return BAT_OK;
        if (token.mark != ',') return wrong(p, "expected , or ), found something else");
    }
    return status;
}

/* Degrees, points, and what is said about form, which is not needed. */
static bat_status read_head(parser *p) {
    bat_step_spline *s = p->out;
    bat_numbers degree = {0};
    bat_status status = BAT_OK;
    for (int d = 0; d < s->directions && status == BAT_OK; d++) {
        degree.count = 0;
        status = one(p, BAT_STEP_NUMBER, &degree);
        if (status == BAT_OK && degree.list) s->degree[d] = degree.list[0], status = expect(p, ',');
    }
    free(degree.list);
    s->points.count = 0;
    if (status == BAT_OK)
        status = s->directions == 1 ? list(p, BAT_STEP_OBJECT, &s->points)
                                    : lists(p, BAT_STEP_OBJECT, &s->points, &s->rows);
    for (int k = 0; k < (s->directions == 1 ? 3 : 4) && status == BAT_OK; k++) {
        status = expect(p, ',');
        if (status == BAT_OK) (void)bat_step_next(&p->at); /* form, closed, (closed,) intersects itself */
    }
    return status;
}

/* Multiplicities and knots. */
static bat_status read_knots(parser *p) {
    bat_status status = BAT_OK;
    const int n = p->out->directions;
    for (int k = 0; k < 2 * n && status == BAT_OK; k++) {
        bat_numbers *to = k < n ? &p->out->many[k] : &p->out->knots[k - n];
        to->count = 0;
        if (k > 0) status = expect(p, ',');
        if (status == BAT_OK) status = list(p, BAT_STEP_NUMBER, to);
    }
    return status;
}

static bool ends_in(const bat_step_token *name, const char *ending) {
    const size_t size = strlen(ending);
    return name->type == BAT_STEP_NAME && name->size >= size &&
           memcmp(name->text + name->size - size, ending, size) == 0;
}

/* What follows the name of a record; `alone`: it holds everything, beginning with the instance's own name. */
static bat_status read_record(parser *p, const bat_step_token *name, bool alone) {
    const bool knots = ends_in(name, "_WITH_KNOTS");
    bat_status status = BAT_OK;
    size_t rows;
    if (ends_in(name, "BEZIER_CURVE") || ends_in(name, "BEZIER_SURFACE")) p->out->form = 'B';
    if (bat_step_is(name, "UNIFORM_CURVE") || bat_step_is(name, "UNIFORM_SURFACE")) p->out->form = 'U';
    if (alone) {
        (void)bat_step_next(&p->at);
        status = expect(p, ',');
    }
    if (status == BAT_OK &&
        (alone || bat_step_is(name, "B_SPLINE_CURVE") || bat_step_is(name, "B_SPLINE_SURFACE")))
        status = read_head(p);
    if (status == BAT_OK && alone && knots) status = expect(p, ',');
    if (status == BAT_OK && knots) status = read_knots(p);
    if (status == BAT_OK && bat_step_is(name, "RATIONAL_B_SPLINE_CURVE"))
        status = list(p, BAT_STEP_NUMBER, &p->out->weights);
    if (status == BAT_OK && bat_step_is(name, "RATIONAL_B_SPLINE_SURFACE"))
        status = lists(p, BAT_STEP_NUMBER, &p->out->weights, &rows);
    return status;
}

/* Skips to the end of a record whose first ( has been read. */
static bat_status skip_record(parser *p) {
    for (int depth = 1; depth > 0;) {
        const bat_step_token token = bat_step_next(&p->at);
        if (token.type <= BAT_STEP_BAD || token.mark == ';') return wrong(p, "expected ), found the end");
        depth += (token.mark == '(') - (token.mark == ')');
    }
    return BAT_OK;
}

bat_status bat_step_read_spline(const bat_step_instance *instance, bat_step_spline *out,
                                bat_problem *problem) {
    parser p = {instance->body, out, problem};
    *out = (bat_step_spline){.directions = instance->flags & BAT_STEP_SURFACE ? 2 : 1, .form = 'Q'};
    bat_status status = BAT_OK;
    bat_step_token token = bat_step_next(&p.at);
    if (token.type == BAT_STEP_NAME) {
        status = expect(&p, '(');
        return status == BAT_OK ? read_record(&p, &token, true) : status;
    }
    for (token = bat_step_next(&p.at); token.type == BAT_STEP_NAME && status == BAT_OK;
         token = bat_step_next(&p.at)) {
        status = expect(&p, '(');
        const bat_step_place from = p.at;
        if (status == BAT_OK) status = read_record(&p, &token, false);
        if (status == BAT_OK) p.at = from, status = skip_record(&p);
        if (status != BAT_OK) return status;
    }
    if (token.mark != ')') return wrong(&p, "expected records in parentheses, found something else");
    return out->points.count > 0 ? status : wrong(&p, "expected a B-spline with points, found none");
}

void bat_step_spline_clear(bat_step_spline *spline) {
    free(spline->points.list);
    free(spline->weights.list);
    for (int d = 0; d < 2; d++) {
        free(spline->many[d].list);
        free(spline->knots[d].list);
    }
}
