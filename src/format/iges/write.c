/* Writes IGES 5.3: B-spline curves (126) and surfaces (128), in millimetres. */
#include "format/iges/iges.h"
#include "format/model/full.h"
#include "format/model/model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 64, LINES_MOST = 9999999 };

typedef struct output {
    bat_text directory, parameters;
    int lines, entities; /* written */
    bool full;           /* more lines than a file has numbers for */
    char line[WIDTH + 1];
    int used;
} output;

/* The word, filled with blanks to so many columns. */
static void put_padded(bat_text *text, const char *word, size_t width) {
    bat_text_string(text, word);
    for (size_t i = strlen(word); i < width; i++) bat_text_add(text, " ", 1);
}

static void end_line(output *o) {
    char line[96];
    if (o->used == 0) return;
    o->full = o->full || ++o->lines > LINES_MOST;
    put_padded(&o->parameters, o->line, WIDTH);
    snprintf(line, sizeof line, "%8dP%7d\n", 2 * o->entities + 1, o->lines % (LINES_MOST + 1));
    bat_text_string(&o->parameters, line);
    o->line[0] = '\0', o->used = 0;
}

static void put(output *o, const char *word, char after) {
    const int length = (int)strlen(word) + 1;
    if (o->used + length > WIDTH) end_line(o);
    o->used += snprintf(o->line + o->used, sizeof o->line - (size_t)o->used, "%s%c", word, after);
}

static void put_whole(output *o, int number) {
    char word[16];
    snprintf(word, sizeof word, "%d", number);
    put(o, word, ',');
}

static void put_number(output *o, double number, char after) {
    char word[40];
    bat_full_number(number, word);
    put(o, word, after);
}

static void put_knots(output *o, const bat_full_axis *axis) {
    for (int i = 0; i < axis->count + axis->degree + 1; i++) put_number(o, bat_full_knot(axis, i), ',');
}

/* Ends an entity: its two lines in section D. `first`: how many lines of P came before it. */
static void end_entity(output *o, int type, int first) {
    char lines[192];
    end_line(o);
    const int at = 2 * o->entities + 1;
    o->full = o->full || at + 1 > LINES_MOST;
    snprintf(lines, sizeof lines, "%8d%8d%8d%8d%8d%8d%8d%8d%08dD%7d\n%8d%8d%8d%8d%8d%8s%8s%8s%8dD%7d\n", type,
             first + 1, 0, 0, 0, 0, 0, 0, 0, at % (LINES_MOST + 1), type, 0, 0, o->lines - first, 0, "", "",
             "", 0, (at + 1) % (LINES_MOST + 1));
    bat_text_string(&o->directory, lines);
    o->entities++;
}

static void put_curve(output *o, const bat_curve *curve) {
    const bat_full_axis axis = bat_full_axis_of_curve(curve);
    const int size = bat_curve_dimension(curve), first = o->lines, closed = bat_curve_is_closed(curve);
    double domain[2];
    bat_curve_domain(curve, domain);
    put_whole(o, BAT_IGES_CURVE);
    put_whole(o, axis.count - 1), put_whole(o, axis.degree);
    put_whole(o, size == 2), put_whole(o, closed), put_whole(o, 1), put_whole(o, closed);
    put_knots(o, &axis);
    for (int i = 0; i < axis.count; i++) put_number(o, 1, ',');
    for (int i = 0; i < axis.count; i++) {
        const double *point = bat_curve_points(curve) + bat_full_point(&axis, i) * size;
        for (int c = 0; c < 3; c++) put_number(o, c < size ? point[c] : 0, ',');
    }
    put_number(o, domain[0], ','), put_number(o, domain[1], ',');
    put_number(o, 0, ','), put_number(o, 0, ','), put_number(o, size == 2, ';'); /* the plane's normal */
    end_entity(o, BAT_IGES_CURVE, first);
}

static void put_surface(output *o, const bat_surface *surface) {
    bat_full_axis axis[2];
    double domain[4];
    const int first = o->lines;
    int closed[2];
    for (bat_direction d = BAT_U; d <= BAT_V; d++) {
        axis[d] = bat_full_axis_of_surface(surface, d);
        closed[d] = bat_surface_is_closed(surface, d);
        bat_surface_domain(surface, d, domain + 2 * d);
    }
    put_whole(o, BAT_IGES_SURFACE);
    put_whole(o, axis[0].count - 1), put_whole(o, axis[1].count - 1);
    put_whole(o, axis[0].degree), put_whole(o, axis[1].degree);
    put_whole(o, closed[0]), put_whole(o, closed[1]), put_whole(o, 1);
    put_whole(o, closed[0]), put_whole(o, closed[1]);
    put_knots(o, &axis[0]), put_knots(o, &axis[1]);
    for (int i = 0; i < axis[0].count; i++)
        for (int j = 0; j < axis[1].count; j++) put_number(o, 1, ',');
    for (int j = 0; j < axis[1].count; j++)
        for (int i = 0; i < axis[0].count; i++) {
            const double *point = bat_surface_row(surface, bat_full_point(&axis[0], i)) +
                                  3 * bat_full_point(&axis[1], j);
            for (int c = 0; c < 3; c++) put_number(o, point[c], ',');
        }
    for (int k = 0; k < 4; k++) put_number(o, domain[k], k < 3 ? ',' : ';');
    end_entity(o, BAT_IGES_SURFACE, first);
}

/* Lines of 72 columns with the letter and number of a section. Returns how many. */
static int put_section(bat_text *text, char letter, const char *const *lines, int count) {
    char line[128];
    for (int i = 0; i < count; i++) {
        put_padded(text, lines[i], 72);
        snprintf(line, sizeof line, "%c%7d\n", letter, i + 1);
        bat_text_string(text, line);
    }
    return count;
}

/* The library knows neither the time nor who writes: the date is that of no day, the names are the program's. */
static int put_globals(bat_text *text, double size) {
    char limits[96], least[40], most[40];
    bat_full_number(size > 0 ? 1e-9 * size : 1e-9, least);
    bat_full_number(size, most);
    snprintf(limits, sizeof limits, "%s,%s,", least, most);
    const char *const lines[] = {"1H,,1H;,6HBatten,11Hbatten.iges,6HBatten,6HBatten,32,38,6,308,15,",
                                 "6HBatten,1.,2,2HMM,1,1.,15H20000101.000000,", limits,
                                 "6HBatten,6HBatten,11,0,15H20000101.000000;"};
    return put_section(text, 'G', lines, 4);
}

bat_status bat_iges_write(const bat_model *model, char **bytes, size_t *size) {
    if (!model || !bytes || !size) return BAT_ARGUMENT;
    if (model->surface_count + model->curve_count == 0) return BAT_COUNT;
    static const char *const start[] = {"B-spline curves and surfaces, in millimetres"};
    output o = {.used = 0};
    bat_text text = {0};
    char ending[96];
    put_section(&text, 'S', start, 1);
    const int globals = put_globals(&text, bat_model_size(model));
    for (size_t i = 0; i < model->surface_count && !o.full; i++) put_surface(&o, model->surfaces[i]);
    for (size_t i = 0; i < model->curve_count && !o.full; i++) put_curve(&o, model->curves[i]);
    text.failed = text.failed || o.directory.failed || o.parameters.failed;
    if (!text.failed && !o.full) {
        bat_text_add(&text, o.directory.data, o.directory.size);
        bat_text_add(&text, o.parameters.data, o.parameters.size);
        snprintf(ending, sizeof ending, "S%7dG%7dD%7dP%7d%40sT%7d\n", 1, globals, 2 * o.entities, o.lines, "",
                 1);
        bat_text_string(&text, ending);
    }
    bat_text_free(&o.directory);
    bat_text_free(&o.parameters);
    if (!o.full) return bat_text_finish(&text, bytes, size);
    bat_text_free(&text);
    return BAT_UNSUPPORTED;
}
