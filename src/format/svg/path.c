/* Path data (SVG 2, 9.3). */
#include "text/number.h"
#include "format/svg/svg.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct parser {
    const char *data, *at, *end;
    const char *move; /* the one before, when nothing has been drawn since; NULL */
    bat_outline *outline;
    bat_svg_segments *segments; /* NULL: nobody asks */
    double handle[2];           /* the last control point, for S and T */
    char before;                /* the last command, upper case */
} parser;

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

void bat_svg_skip(const char **at, const char *end) {
    while (*at < end && is_space(**at)) ++*at;
    if (*at < end && **at == ',') ++*at;
    while (*at < end && is_space(**at)) ++*at;
}

static bool read_number(parser *p, double *value) {
    const char *stop = bat_number_scan(p->at, p->end, value);
    if (!stop || !(fabs(*value) <= 1e75)) return false;
    p->at = stop;
    return true;
}

static bool read_flag(parser *p, double *value) {
    if (p->at == p->end || (*p->at != '0' && *p->at != '1')) return false;
    *value = *p->at++ == '1';
    return true;
}

static bool read_arguments(parser *p, char command, int count, double *v) {
    for (int i = 0; i < count; i++) {
        if (i > 0) bat_svg_skip(&p->at, p->end);
        if (!(command == 'A' && (i == 3 || i == 4) ? read_flag(p, &v[i]) : read_number(p, &v[i])))
            return false;
    }
    return true;
}

static void segment(parser *p, char command, bool relative, const double *v) {
    bat_outline *o = p->outline;
    double x = relative ? o->at[0] : 0, y = relative ? o->at[1] : 0, hx = o->at[0], hy = o->at[1];
    switch (command) {
    case 'M': bat_outline_move(o, x + v[0], y + v[1]); break;
    case 'L': bat_outline_line(o, x + v[0], y + v[1]); break;
    case 'H': bat_outline_line(o, x + v[0], o->at[1]); break;
    case 'V': bat_outline_line(o, o->at[0], y + v[0]); break;
    case 'C':
        p->handle[0] = x + v[2], p->handle[1] = y + v[3];
        bat_outline_cubic(o, x + v[0], y + v[1], x + v[2], y + v[3], x + v[4], y + v[5]);
        break;
    case 'S':
        if (p->before == 'C' || p->before == 'S') hx = 2 * hx - p->handle[0], hy = 2 * hy - p->handle[1];
        p->handle[0] = x + v[0], p->handle[1] = y + v[1];
        bat_outline_cubic(o, hx, hy, x + v[0], y + v[1], x + v[2], y + v[3]);
        break;
    case 'Q':
        p->handle[0] = x + v[0], p->handle[1] = y + v[1];
        bat_outline_quadratic(o, x + v[0], y + v[1], x + v[2], y + v[3]);
        break;
    case 'T':
        if (p->before == 'Q' || p->before == 'T') hx = 2 * hx - p->handle[0], hy = 2 * hy - p->handle[1];
        p->handle[0] = hx, p->handle[1] = hy;
        bat_outline_quadratic(o, hx, hy, x + v[0], y + v[1]);
        break;
    case 'A': bat_outline_arc(o, v[0], v[1], v[2], v[3] != 0, v[4] != 0, x + v[5], y + v[6]); break;
    default: bat_outline_close(o); break;
    }
    p->before = command;
}

/* The cubics that the outline has. */
static size_t cubics_of(const bat_outline *o) { return (o->count - (size_t)o->subpath_count) / 3; }

/* Says where the cubics come from that the outline has got. */
static void note_segments(const parser *p, bat_svg_segment what) {
    bat_svg_segments *all = p->segments;
    while (!all->failed && all->count < cubics_of(p->outline)) {
        if (all->count == all->room) {
            const size_t room = all->room < 64 ? 64 : 2 * all->room;
            bat_svg_segment *grown = realloc(all->list, room * sizeof *grown);
            all->failed = !grown;
            if (!grown) return;
            all->list = grown;
            all->room = room;
        }
        all->list[all->count++] = what;
    }
}

/* place: where its command stands, or its arguments where the command is left out. */
static void placed_segment(parser *p, const char *place, char command, bool relative, bool implied,
                           const double *v) {
    const int before = p->outline->subpath_count;
    const char letter = (char)(relative ? command - 'A' + 'a' : command);
    segment(p, command, relative, v);
    if (p->segments)
        note_segments(
            p, (bat_svg_segment){(size_t)(place - p->data), (size_t)(p->at - p->data), letter, implied});
    if (p->outline->subpath_count > before) {
        bat_subpath *made = &p->outline->subpaths[before];
        made->from = (size_t)((p->move ? p->move : place) - p->data);
        made->drawn = (size_t)(place - p->data);
        made->implied = implied ? letter : '\0';
    }
    p->move = command == 'M' ? place : NULL;
}

bool bat_svg_path(const char *data, size_t size, bat_outline *outline) {
    return bat_svg_path_segments(data, size, outline, NULL);
}

bool bat_svg_path_segments(const char *data, size_t size, bat_outline *outline, bat_svg_segments *segments) {
    static const char commands[] = "MLHVCSQTAZ";
    static const int counts[] = {2, 2, 1, 1, 6, 4, 4, 2, 7, 0};
    parser p = {.data = data, .at = data, .end = data + size, .outline = outline, .segments = segments};
    bool first = true;
    for (;;) {
        while (p.at < p.end && is_space(*p.at)) p.at++;
        if (p.at == p.end) return true;
        bool relative = *p.at >= 'a' && *p.at <= 'z';
        char command = relative ? (char)(*p.at - 'a' + 'A') : *p.at;
        const char *known = command ? strchr(commands, command) : NULL;
        if (!known || (first && command != 'M')) return false;
        first = false;
        const char *place = p.at++;
        int count = counts[known - commands];
        if (count == 0) {
            placed_segment(&p, place, 'Z', relative, false, NULL);
            continue;
        }
        while (p.at < p.end && is_space(*p.at)) p.at++;
        for (bool more = true, implied = false; more; implied = true) {
            double v[7];
            if (implied) place = p.at;
            if (!read_arguments(&p, command, count, v)) return false;
            placed_segment(&p, place, command, relative, implied, v);
            if (command == 'M') command = 'L'; /* further pairs of numbers are lines */
            const char *mark = p.at;
            bat_svg_skip(&p.at, p.end);
            more = p.at < p.end && (strchr("+-.0123456789", *p.at) && *p.at);
            if (!more && memchr(mark, ',', (size_t)(p.at - mark))) return false; /* a comma, then nothing */
        }
    }
}
