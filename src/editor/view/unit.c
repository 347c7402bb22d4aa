#include "editor/view/unit.h"
#include "document/unit.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "text/number.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double SIZES[] = {1, 96 / 25.4, 96}; /* px, in the order of the property's values */

/* Document units per px. */
static double px_of(const bat_context *c) {
    return BAT_PX_MILLIMETRES / bat_document_scale(c->session->document);
}

double bat_unit_size(const bat_context *c) {
    return SIZES[(int)c->settings->values[BAT_PROPERTY_UNIT]] * px_of(c);
}

int bat_unit_way(bat_unit unit) {
    static const signed char ways[] = {[BAT_UNIT_MM] = 1, [BAT_UNIT_CM] = 1, [BAT_UNIT_IN] = 2,
                                       [BAT_UNIT_PT] = 1, [BAT_UNIT_PC] = 1, [BAT_UNIT_NONE] = 0};
    return ways[unit];
}

bat_unit bat_unit_in_force(const bat_context *c) {
    static const bat_unit units[] = {BAT_UNIT_PX, BAT_UNIT_MM, BAT_UNIT_IN};
    return units[(int)c->settings->values[BAT_PROPERTY_UNIT]];
}

bool bat_unit_is_shown_as(bat_unit unit, bat_unit shown) {
    return unit != BAT_UNIT_NONE && bat_unit_way(unit) == bat_unit_way(shown);
}

void bat_unit_adopt(bat_context *c) {
    const int way = bat_unit_way(bat_document_unit(c->session->document));
    if (way) c->settings->values[BAT_PROPERTY_UNIT] = way;
}

void bat_unit_number(double value, char out[BAT_UNIT_ROOM]) {
    if (fabs(value) >= 1e15) {
        snprintf(out, BAT_UNIT_ROOM, "%.6g", value);
        return;
    }
    snprintf(out, BAT_UNIT_ROOM, "%.3f", round(value * 1000) / 1000 + 0.0); /* no -0 */
    char *end = out + strlen(out);
    while (end[-1] == '0') *--end = 0;
    if (end[-1] == '.') end[-1] = 0;
}

/* A number, and the unit in force. */
static void put_unit(const bat_context *c, const char *number, char out[BAT_UNIT_ROOM]) {
    static const bat_string words[] = {BAT_STRING_UNIT_PX, BAT_STRING_UNIT_MM, BAT_STRING_UNIT_IN};
    snprintf(out, BAT_UNIT_ROOM, "%.22s %.8s", number,
             bat_word(c, words[(int)c->settings->values[BAT_PROPERTY_UNIT]]));
}

void bat_unit_write(const bat_context *c, double length, char out[BAT_UNIT_ROOM]) {
    char number[BAT_UNIT_ROOM];
    bat_unit_number(length / bat_unit_size(c), number);
    put_unit(c, number, out);
}

void bat_unit_about(const bat_context *c, double length, char out[BAT_UNIT_ROOM]) {
    char number[BAT_UNIT_ROOM];
    snprintf(number, sizeof number, "%.3g", length / bat_unit_size(c));
    put_unit(c, number, out);
}

void bat_unit_origin(const bat_context *c, double origin[2]) {
    double page[4];
    bat_document_page(c->session->document, page);
    bool there = page[2] > 0;
    origin[0] = there ? page[0] : 0;
    origin[1] = there ? page[1] : 0;
}

/* ---- reading ---- */

enum { DEEPEST = 16 };

typedef struct reading {
    const char *at;
    double unit; /* unit of plain numbers */
    double px;   /* document units per px */
    bool angle;
    int depth;
    bool wrong;
} reading;

/* A number, or a length in document units; and the unit it was written in. */
typedef struct quantity {
    double value, unit; /* 0: a number */
} quantity;

static quantity sum(reading *r);

static char peek(reading *r) {
    while (*r->at == ' ' || *r->at == '\t') r->at++;
    return *r->at;
}

static bool take(reading *r, char wanted) {
    if (peek(r) != wanted) return false;
    r->at++;
    return true;
}

static quantity number(reading *r) {
    static const struct {
        const char *name;
        double size;
    } units[] = {{"px", 1},         {"mm", 96 / 25.4}, {"cm", 96 / 2.54}, {"in", 96},
                 {"pt", 96.0 / 72}, {"pc", 16},        {"\"", 96}};
    char text[40];
    size_t size = 0;
    peek(r);
    for (; size < sizeof text - 1 && ((*r->at >= '0' && *r->at <= '9') || *r->at == '.' || *r->at == ',');
         size++)
        text[size] = (char)(*r->at == ',' ? '.' : *r->at), r->at++;
    quantity found = {0, 0};
    if (bat_number_scan(text, text + size, &found.value) != text + size) r->wrong = true;
    peek(r);
    if (r->angle) {
        if (!strncmp(r->at, "\xc2\xb0", 2)) r->at += 2;
        return found;
    }
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (!strncmp(r->at, units[i].name, strlen(units[i].name))) {
            r->at += strlen(units[i].name);
            return (quantity){found.value * (units[i].size * r->px), units[i].size * r->px};
        }
    return found;
}

static quantity factor(reading *r) {
    bool minus = false;
    while (peek(r) == '-' || *r->at == '+') minus ^= *r->at++ == '-';
    quantity found;
    if (take(r, '(')) {
        if (++r->depth > DEEPEST) r->wrong = true;
        found = r->wrong ? (quantity){0, 0} : sum(r);
        if (!take(r, ')')) r->wrong = true;
        r->depth--;
    } else {
        found = number(r);
    }
    if (minus) found.value = -found.value;
    return found;
}

static quantity product(reading *r) {
    quantity left = factor(r);
    while (!r->wrong) {
        bool times = take(r, '*');
        if (!times && !take(r, '/')) break;
        quantity right = factor(r);
        if (times) {
            if (left.unit > 0 && right.unit > 0) r->wrong = true;
            left = (quantity){left.value * right.value, fmax(left.unit, right.unit)};
        } else if (right.unit > 0 && left.unit == 0) { /* "1/4in" is a quarter of an inch */
            left = (quantity){left.value / (right.value / right.unit) * right.unit, right.unit};
        } else {
            left = (quantity){left.value / right.value, right.unit > 0 ? 0 : left.unit};
        }
    }
    return left;
}

static void as_length(const reading *r, quantity *q) {
    if (q->unit > 0) return;
    q->value *= r->unit;
    q->unit = r->unit;
}

static quantity sum(reading *r) {
    quantity left = product(r);
    while (!r->wrong) {
        bool plus = take(r, '+');
        if (!plus && !take(r, '-')) break;
        quantity right = product(r);
        if (left.unit > 0 || right.unit > 0) {
            as_length(r, &left);
            as_length(r, &right);
        }
        left.value += plus ? right.value : -right.value;
    }
    return left;
}

bat_status bat_unit_read(const bat_context *c, const char *text, bool angle, double *value) {
    reading r = {text, bat_unit_size(c), px_of(c), angle, 0, false};
    quantity found = sum(&r);
    if (r.wrong || peek(&r)) return BAT_SYNTAX;
    if (!angle) as_length(&r, &found);
    if (!isfinite(found.value)) return BAT_NUMBER;
    *value = found.value;
    return BAT_OK;
}
