/* POINTS: a STROKE, a GeoJSON LineString, or columns of numbers as spreadsheets and scripts write them. */
#include "format/json/points.h"

#include "format/json/curve.h"
#include "format/json/stroke.h"
#include "text/number.h"

#include <batten/sketch.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS_MAX = 64, SHOWN = 40, CELL = 64 };

/* ---- JSON ---- */

/* The geometry of a Feature, of the only Feature of a collection, or the node itself. */
static bat_status geometry_of(const bat_json *json, uint32_t *node, bat_problem *problem) {
    const uint32_t features = bat_json_member(json, *node, "features");
    if (features) {
        char message[96];
        const uint32_t count = bat_json_count(json, features);
        snprintf(message, sizeof message, "features: expected one, a LineString, found %u", (unsigned)count);
        if (count != 1) return bat_json_say(json, features, BAT_COUNT, message, problem);
        *node = bat_json_first(json, features);
    }
    const uint32_t own = bat_json_member(json, *node, "geometry");
    if (own) *node = own;
    return BAT_OK;
}

/* *places: the places of a GeoJSON LineString, however it is wrapped; 0: what is there is no GeoJSON. */
static bat_status coordinates_of(const bat_json *json, uint32_t *places, bat_problem *problem) {
    uint32_t node = 1;
    *places = 0;
    if (!bat_json_text(json, bat_json_member(json, 1, "type"))) return BAT_OK;
    const bat_status status = geometry_of(json, &node, problem);
    if (status != BAT_OK) return status;
    const char *type = bat_json_text(json, bat_json_member(json, node, "type"));
    const uint32_t found = bat_json_member(json, node, "coordinates");
    if (type && strcmp(type, "LineString") == 0 && found) {
        *places = found;
        return BAT_OK;
    }
    if (!found && bat_json_member(json, 1, "points")) return BAT_OK;
    char message[128];
    snprintf(message, sizeof message, "expected a LineString with coordinates, found %.40s%s",
             type ? type : "none", type && !found ? " without them" : "");
    return bat_json_say(json, node, BAT_SYNTAX, message, problem);
}

static bat_status check(size_t count, int dimension, const double *points, bat_problem *problem) {
    if (count > BAT_POINTS_MAX)
        return bat_problem_set(problem, BAT_COUNT, "", "expected at most 16777216 points, found more");
    for (size_t i = 0; i < count * (size_t)dimension; i++)
        if (!(fabs(points[i]) <= BAT_COORDINATE_MAX))
            return bat_problem_set(problem, BAT_NUMBER, "",
                                   "expected numbers up to 1e75, found a greater one");
    return BAT_OK;
}

static bat_status read_json(const char *text, size_t size, int *dimension, size_t *count, double **points,
                            bat_problem *problem) {
    bat_json json;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    uint32_t places = 0;
    double *all = NULL;
    status = coordinates_of(&json, &places, problem);
    if (status != BAT_OK) {
        /* said */
    } else if (places) {
        status = bat_points_from_json(&json, places, "coordinates", &all, count, dimension, problem);
    } else {
        bat_stroke stroke;
        void *block;
        status = bat_stroke_from_json(&json, 1, &stroke, &block, problem);
        if (status == BAT_OK) all = block, *count = stroke.count, *dimension = stroke.dimension;
    }
    bat_json_free(&json);
    if (status == BAT_OK) status = check(*count, *dimension, all, problem);
    if (status != BAT_OK) {
        free(all);
        return status;
    }
    *points = all;
    return BAT_OK;
}

/* ---- columns ---- */

typedef struct field {
    const char *text;
    size_t size;
} field;

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/* Semicolons, else commas, else tabs separate fields where a line has any; else blanks do. */
static char separator_of(const char *start, const char *end) {
    const size_t size = (size_t)(end - start);
    return memchr(start, ';', size)    ? ';'
           : memchr(start, ',', size)  ? ','
           : memchr(start, '\t', size) ? '\t'
                                       : ' ';
}

static int fields_of(const char *at, const char *end, char separator, field *out) {
    int count = 0;
    while (at < end && is_blank(end[-1])) end--;
    while (at <= end && count < COLUMNS_MAX) {
        while (at < end && is_blank(*at) && (*at != separator || separator == ' ')) at++;
        const char *stop = at;
        while (stop < end && *stop != separator && !(separator == ' ' && is_blank(*stop))) stop++;
        const char *last = stop;
        while (last > at && is_blank(last[-1])) last--;
        if (last - at >= 2 && *at == '"' && last[-1] == '"') at++, last--;
        out[count++] = (field){at, (size_t)(last - at)};
        at = stop + 1;
    }
    return count;
}

static bool number_of(field f, double *out) {
    return f.size > 0 && bat_number_scan(f.text, f.text + f.size, out) == f.text + f.size;
}

/* Between semicolons a comma may be what stands before decimals, as spreadsheets of many countries write it. */
static bool cell_of(field f, char separator, double *out) {
    char copy[CELL];
    const char *comma = separator == ';' && f.size < CELL ? memchr(f.text, ',', f.size) : NULL;
    if (!comma) return number_of(f, out);
    memcpy(copy, f.text, f.size);
    copy[comma - f.text] = '.';
    return number_of((field){copy, f.size}, out);
}

static bat_status complain(bat_problem *problem, bat_status status, size_t line, int column,
                           const char *expected, field found) {
    char place[40], message[160];
    const int n = found.size > SHOWN ? SHOWN : (int)found.size;
    snprintf(place, sizeof place, "line %zu, field %d", line, column + 1);
    if (n)
        snprintf(message, sizeof message, "expected %s, found \"%.*s\"", expected, n, found.text);
    else
        snprintf(message, sizeof message, "expected %s, found nothing", expected);
    for (char *c = message; *c; c++)
        if ((unsigned char)*c < 32) *c = '?';
    return bat_problem_set(problem, status, place, message);
}

typedef struct table {
    int dimension;
    int columns[BAT_DIMENSION_MAX]; /* where x, y and z are */
    int group;                      /* the column called "curve"; -1: none */
    bool named;                     /* a header says where x and y are */
    char separator;
    field last; /* of the column "curve" */
    size_t count, part_count, part_room;
    double *points;
    size_t *starts;
} table;

static bool is_named(field f, char name) { return f.size == 1 && (f.text[0] | 32) == name; }

static bool is_group(field f) {
    static const char word[] = "curve";
    size_t i = 0;
    while (i < f.size && word[i] && (f.text[i] | 32) == word[i]) i++;
    return i == f.size && i == sizeof word - 1;
}

/* From the first line that holds anything: a header when it names x and y, or when no field is a number. Columns called x, y
 * and z, else the first ones; what is empty at the end is none. Returns whether it was a header. */
static bool begin(table *t, const field *fields, int count) {
    double ignored;
    int named = 0, numbers = 0;
    for (int i = 0; i < count; i++) numbers += cell_of(fields[i], t->separator, &ignored);
    for (int c = 0; c < BAT_DIMENSION_MAX && named == c; c++)
        for (int i = 0; i < count && named == c; i++)
            if (is_named(fields[i], (char)('x' + c))) t->columns[c] = i, named++;
    t->named = named >= 2;
    const bool header = t->named || numbers == 0;
    t->group = -1;
    for (int i = 0; i < count && header; i++)
        if (is_group(fields[i])) t->group = i;
    while (count > 0 && fields[count - 1].size == 0) count--;
    t->dimension = named >= 2 ? named : count < 2 ? 0 : count == 3 ? 3 : 2;
    if (!t->named)
        for (int c = 0; c < BAT_DIMENSION_MAX; c++) t->columns[c] = c;
    return header;
}

/* Where the column "curve" says something else than in the row before, a part begins. */
static bat_status divide(table *t, const field *fields, int count, bat_problem *problem) {
    const field now = t->group >= 0 && t->group < count ? fields[t->group] : (field){"", 0};
    const bool begins = t->count == 0 || now.size != t->last.size ||
                        memcmp(now.text, t->last.text, now.size) != 0;
    t->last = now;
    if (!begins) return BAT_OK;
    if (t->part_count + 1 >= t->part_room) {
        const size_t room = 2 * t->part_room + 8;
        size_t *more = realloc(t->starts, room * sizeof *more);
        if (!more) return bat_problem_set(problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
        t->starts = more, t->part_room = room;
    }
    t->starts[t->part_count++] = t->count;
    return BAT_OK;
}

static bat_status read_row(table *t, const field *fields, int count, size_t line, bat_problem *problem) {
    double *point = t->points + t->count * (size_t)t->dimension;
    for (int c = 0; c < t->dimension; c++) {
        const int i = t->columns[c];
        if (i >= count) return complain(problem, BAT_SYNTAX, line, count, "a number", (field){"", 0});
        if (!cell_of(fields[i], t->separator, point + c))
            return complain(problem, BAT_SYNTAX, line, i, "a number", fields[i]);
        if (!(fabs(point[c]) <= BAT_COORDINATE_MAX))
            return complain(problem, BAT_NUMBER, line, i, "a number up to 1e75", fields[i]);
    }
    t->count++;
    return BAT_OK;
}

static bat_status read_columns(const char *text, size_t size, table *t, bat_problem *problem) {
    size_t line = 0;
    bat_status status = BAT_OK;
    for (const char *at = text, *end = text + size; at < end && status == BAT_OK;) {
        const char *stop = memchr(at, '\n', (size_t)(end - at)), *next = stop ? stop + 1 : end;
        if (!stop) stop = end;
        line++;
        while (at < stop && is_blank(*at)) at++;
        field fields[COLUMNS_MAX];
        if (at < stop && *at != '#') {
            if (!t->separator) t->separator = separator_of(at, stop);
            const int count = fields_of(at, stop, t->separator, fields);
            const bool header = t->dimension == 0 && begin(t, fields, count);
            if (t->dimension == 0)
                status = complain(problem, BAT_SYNTAX, line, 1, "columns of two or three numbers",
                                  (field){"", 0});
            else if (!header)
                status = divide(t, fields, count, problem);
            if (status == BAT_OK && !header) status = read_row(t, fields, count, line, problem);
        }
        at = next;
    }
    if (status == BAT_OK && t->dimension == 0)
        return bat_problem_set(problem, BAT_SYNTAX, "line 1",
                               "expected points as JSON or columns of numbers, found nothing");
    return status;
}

bat_status bat_point_rows_read(const char *text, size_t size, bat_point_rows *out, bat_problem *problem) {
    size_t lines = 1;
    for (size_t i = 0; i < size; i++) lines += text[i] == '\n';
    if (lines > (size_t)BAT_POINTS_MAX)
        return bat_problem_set(problem, BAT_COUNT, "", "expected at most 16777216 lines, found more");
    table t = {.points = malloc(lines * BAT_DIMENSION_MAX * sizeof(double))};
    if (!t.points) return bat_problem_set(problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
    const bat_status status = read_columns(text, size, &t, problem);
    if (status != BAT_OK) {
        free(t.points), free(t.starts);
        return status;
    }
    if (t.starts) t.starts[t.part_count] = t.count;
    *out = (bat_point_rows){t.dimension, t.count, t.part_count, t.points, t.starts};
    return BAT_OK;
}

void bat_point_rows_clear(bat_point_rows *rows) {
    free(rows->points), free(rows->starts);
    *rows = (bat_point_rows){.dimension = 0};
}

bool bat_point_rows_are(const char *text, size_t size) {
    for (const char *at = text, *end = text + size; at < end;) {
        const char *stop = memchr(at, '\n', (size_t)(end - at)), *next = stop ? stop + 1 : end;
        if (!stop) stop = end;
        while (at < stop && is_blank(*at)) at++;
        if (at < stop && *at != '#') {
            field fields[COLUMNS_MAX];
            table t = {.separator = separator_of(at, stop)};
            const int count = fields_of(at, stop, t.separator, fields);
            double ignored;
            bool numbers = !begin(&t, fields, count) && t.dimension >= 2;
            for (int c = 0; c < t.dimension && numbers; c++)
                numbers = cell_of(fields[c], t.separator, &ignored);
            return t.named || numbers;
        }
        at = next;
    }
    return false;
}

static bat_status read_table(const char *text, size_t size, int *dimension, size_t *count, double **points,
                             bat_problem *problem) {
    bat_point_rows rows;
    const bat_status status = bat_point_rows_read(text, size, &rows, problem);
    if (status != BAT_OK) return status;
    free(rows.starts);
    *dimension = rows.dimension, *count = rows.count, *points = rows.points;
    return BAT_OK;
}

bat_status bat_points_read(const char *text, size_t size, int *dimension, size_t *count, double **points,
                           bat_problem *problem) {
    if (!text || !dimension || !count || !points)
        return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    const size_t mark = size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    text += mark, size -= mark;
    size_t first = 0;
    while (first < size && (is_blank(text[first]) || text[first] == '\n')) first++;
    const bool json = first < size && (text[first] == '{' || text[first] == '[');
    int found = 0;
    size_t total = 0;
    double *all = NULL;
    const bat_status status = json ? read_json(text, size, &found, &total, &all, problem)
                                   : read_table(text, size, &found, &total, &all, problem);
    if (status != BAT_OK) return status;
    *dimension = found, *count = total, *points = all;
    return BAT_OK;
}
