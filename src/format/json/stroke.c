/* STROKE: JSON {"points":[[x,y],...], "pressure":[...], "time":[...]}, or CSV with a header
 * x,y[,pressure][,time]. */
#include "format/json/curve.h"
#include "text/number.h"
#include "format/json/stroke.h"
#include <batten/sketch.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Packs points, then pressure, then time into one block. */
static bat_status pack(size_t count, int dimension, const double *points, const double *pressure,
                       const double *time, bat_stroke *stroke, void **block) {
    size_t size = count * (size_t)dimension;
    double *all = malloc((size + 2 * count + 1) * sizeof *all);
    if (!all) return BAT_MEMORY;
    memcpy(all, points, size * sizeof *all);
    if (pressure) memcpy(all + size, pressure, count * sizeof *all);
    if (time) memcpy(all + size + count, time, count * sizeof *all);
    *stroke = (bat_stroke){.dimension = dimension,
                           .count = count,
                           .points = all,
                           .pressure = pressure ? all + size : NULL,
                           .time = time ? all + size + count : NULL};
    *block = all;
    return BAT_OK;
}

/* Reads an optional list with one number per point. */
static bat_status read_channel(const bat_json *json, uint32_t object, const char *name, size_t count,
                               double **out, bat_problem *problem) {
    uint32_t list = bat_json_member(json, object, name);
    if (!list) return BAT_OK;
    size_t found;
    bat_status status = bat_numbers_from_json(json, list, name, out, &found, problem);
    if (status != BAT_OK || found == count) return status;
    char message[120];
    snprintf(message, sizeof message, "%s: expected one number a point (%zu), found %zu", name, count, found);
    return bat_json_say(json, list, BAT_COUNT, message, problem);
}

bat_status bat_stroke_from_json(const bat_json *json, uint32_t node, bat_stroke *stroke, void **block,
                                bat_problem *problem) {
    double *points = NULL, *pressure = NULL, *time = NULL;
    size_t count = 0;
    int dimension = 2;
    uint32_t list = bat_json_member(json, node, "points");
    bat_status status = BAT_OK;
    if (!list)
        status = bat_json_say(json, node ? node : 1, BAT_SYNTAX,
                              "points: expected a list of points, found none", problem);
    else
        status = bat_points_from_json(json, list, "points", &points, &count, &dimension, problem);
    if (status == BAT_OK && count > BAT_POINTS_MAX)
        status = bat_json_say(json, list, BAT_COUNT, "points: expected at most 16777216, found more",
                              problem);
    for (size_t i = 0; status == BAT_OK && i < count * (size_t)dimension; i++)
        if (fabs(points[i]) > BAT_COORDINATE_MAX)
            status = bat_json_say(json, list, BAT_NUMBER,
                                  "points: expected numbers up to 1e75, found a greater one", problem);
    if (status == BAT_OK) status = read_channel(json, node, "pressure", count, &pressure, problem);
    if (status == BAT_OK) status = read_channel(json, node, "time", count, &time, problem);
    if (status == BAT_OK) {
        status = pack(count, dimension, points, pressure, time, stroke, block);
        if (status != BAT_OK) bat_problem_set(problem, status, "", bat_status_message(status));
    }
    free(points);
    free(pressure);
    free(time);
    return status;
}

static bat_status read_json(const char *text, size_t size, bat_stroke *stroke, void **block,
                            bat_problem *problem) {
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    status = bat_stroke_from_json(&json, 1, stroke, block, problem);
    bat_json_free(&json);
    return status;
}

/* ---- CSV ---- */

enum { X, Y, PRESSURE, TIME, FIELDS };

typedef struct table {
    int columns[FIELDS]; /* the field in column i */
    int width;
    bool has[FIELDS];
} table;

static bat_status complain(bat_problem *problem, bat_status status, size_t line, int column,
                           const char *expected, const char *found, size_t length) {
    char place[40], message[160];
    snprintf(place, sizeof place, "line %zu, field %d", line, column + 1);
    int n = length > 40 ? 40 : (int)length;
    if (n > 0)
        snprintf(message, sizeof message, "expected %s, found \"%.*s\"", expected, n, found);
    else
        snprintf(message, sizeof message, "expected %s, found nothing", expected);
    for (char *c = message; *c; c++)
        if ((unsigned char)*c < 32) *c = '?';
    return bat_problem_set(problem, status, place, message);
}

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/* The next field up to a comma, without blanks around it; *at moves past the comma. False after the last
 * field. */
static bool next_field(const char **at, const char *end, const char **field, size_t *length) {
    if (!*at) return false;
    const char *start = *at, *comma = memchr(start, ',', (size_t)(end - start)), *stop = comma ? comma : end;
    *at = comma ? comma + 1 : NULL;
    while (start < stop && is_space(*start)) start++;
    while (stop > start && is_space(stop[-1])) stop--;
    *field = start;
    *length = (size_t)(stop - start);
    return true;
}

static bat_status read_header(const char *start, const char *end, size_t line, table *t,
                              bat_problem *problem) {
    static const char *const names[FIELDS] = {"x", "y", "pressure", "time"};
    const char *field;
    size_t length;
    *t = (table){0};
    while (next_field(&start, end, &field, &length)) {
        int which = FIELDS;
        for (int i = 0; i < FIELDS; i++)
            if (strlen(names[i]) == length && memcmp(names[i], field, length) == 0 && !t->has[i]) which = i;
        if (which == FIELDS || t->width == FIELDS)
            return complain(problem, BAT_SYNTAX, line, t->width, "a header of x, y, pressure, time", field,
                            length);
        t->columns[t->width++] = which;
        t->has[which] = true;
    }
    if (t->has[X] && t->has[Y]) return BAT_OK;
    return complain(problem, BAT_SYNTAX, line, t->width, "x and y in the header", "", 0);
}

static bat_status read_row(const char *start, const char *end, size_t line, const table *t,
                           double values[FIELDS], bat_problem *problem) {
    const char *field;
    size_t length;
    int column = 0;
    while (next_field(&start, end, &field, &length)) {
        double value = 0;
        if (column == t->width)
            return complain(problem, BAT_SYNTAX, line, column, "the end of the line", field, length);
        if (bat_number_scan(field, field + length, &value) != field + length || length == 0)
            return complain(problem, BAT_SYNTAX, line, column, "a number", field, length);
        if (!(fabs(value) <= BAT_COORDINATE_MAX))
            return complain(problem, BAT_NUMBER, line, column, "a number up to 1e75", field, length);
        values[t->columns[column++]] = value;
    }
    if (column < t->width) return complain(problem, BAT_SYNTAX, line, column, "a number", "", 0);
    return BAT_OK;
}

static bool is_blank(const char *start, const char *end) {
    while (start < end && is_space(*start)) start++;
    return start == end;
}

static bat_status read_csv(const char *text, size_t size, bat_stroke *stroke, void **block,
                           bat_problem *problem) {
    size_t room = 1;
    for (size_t i = 0; i < size; i++) room += text[i] == '\n';
    if (room > (size_t)BAT_POINTS_MAX + 1024)
        return bat_problem_set(problem, BAT_COUNT, "", "expected at most 16777216 lines, found more");
    double *columns = malloc(room * 4 * sizeof *columns); /* x y of all, then pressure, then time */
    if (!columns) return bat_problem_set(problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
    double *pressure = columns + 2 * room, *time = pressure + room;
    table t = {0};
    size_t count = 0, line = 0;
    bat_status status = BAT_OK;
    for (const char *at = text, *end = text + size; at < end && status == BAT_OK;) {
        const char *stop = memchr(at, '\n', (size_t)(end - at));
        if (!stop) stop = end;
        line++;
        double values[FIELDS] = {0};
        if (is_blank(at, stop)) {
            /* Blank lines are ignored everywhere. */
        } else if (t.width == 0)
            status = read_header(at, stop, line, &t, problem);
        else {
            status = read_row(at, stop, line, &t, values, problem);
            columns[2 * count] = values[X];
            columns[2 * count + 1] = values[Y];
            pressure[count] = values[PRESSURE];
            time[count] = values[TIME];
            count++;
        }
        at = stop < end ? stop + 1 : end;
    }
    if (status == BAT_OK && t.width == 0)
        status = bat_problem_set(problem, BAT_SYNTAX, "line 1",
                                 "expected a stroke as JSON or CSV, found nothing");
    if (status == BAT_OK) {
        status = pack(count, 2, columns, t.has[PRESSURE] ? pressure : NULL, t.has[TIME] ? time : NULL, stroke,
                      block);
        if (status != BAT_OK) bat_problem_set(problem, status, "", bat_status_message(status));
    }
    free(columns);
    return status;
}

bat_status bat_stroke_read(const char *text, size_t size, bat_stroke *stroke, void **block,
                           bat_problem *problem) {
    if (!text || !stroke || !block)
        return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    size_t start = size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    text += start, size -= start;
    size_t first = 0;
    while (first < size && (is_space(text[first]) || text[first] == '\n')) first++;
    if (first < size && (text[first] == '{' || text[first] == '['))
        return read_json(text, size, stroke, block, problem);
    return read_csv(text, size, stroke, block, problem);
}
