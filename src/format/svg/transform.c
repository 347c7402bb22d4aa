/* transform, viewBox, preserveAspectRatio and lengths (SVG 2, 8; CSS Values 6). */
#include "base/matrix.h"
#include "base/real.h"
#include "text/number.h"
#include "format/svg/geometry.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/* Cosine and sine of an angle; exact for multiples of a quarter turn. */
static void turn(double degrees, double *c, double *s) {
    double rest = fmod(degrees, 360);
    if (rest < 0) rest += 360;
    if (rest == 0 || rest == 90 || rest == 180 || rest == 270) {
        *c = rest == 0 ? 1 : rest == 180 ? -1 : 0;
        *s = rest == 90 ? 1 : rest == 270 ? -1 : 0;
    } else {
        *c = bat_cos(rest * (BAT_PI / 180));
        *s = bat_sin(rest * (BAT_PI / 180));
    }
}

/* The matrix of one transform function with its n arguments; false when the name or their number is wrong. */
static bool primitive(const char *name, size_t length, int n, const double *v, double m[6]) {
    static const char *const names[] = {"matrix", "translate", "scale", "rotate", "skewX", "skewY"};
    int kind = 0;
    while (kind < 6 && (strlen(names[kind]) != length || memcmp(names[kind], name, length) != 0)) kind++;
    bat_matrix_identity(m);
    double c, s;
    switch (kind) {
    case 0:
        if (n == 6) memcpy(m, v, 6 * sizeof *m);
        return n == 6;
    case 1: m[4] = v[0], m[5] = n == 2 ? v[1] : 0; return n == 1 || n == 2;
    case 2: m[0] = v[0], m[3] = n == 2 ? v[1] : v[0]; return n == 1 || n == 2;
    case 3:
        turn(v[0], &c, &s);
        m[0] = c, m[1] = s, m[2] = -s, m[3] = c;
        if (n == 3) {
            m[4] = v[1] - c * v[1] + s * v[2];
            m[5] = v[2] - s * v[1] - c * v[2];
        }
        return n == 1 || n == 3;
    case 4: m[2] = bat_tan(fmod(v[0], 180) * (BAT_PI / 180)); return n == 1;
    case 5: m[1] = bat_tan(fmod(v[0], 180) * (BAT_PI / 180)); return n == 1;
    default: return false;
    }
}

bool bat_svg_transform(const char *text, double m[6]) {
    const char *at = text, *end = text + strlen(text);
    double whole[6];
    bat_matrix_identity(whole);
    bat_matrix_identity(m);
    while (at < end && is_space(*at)) at++;
    if (strcmp(at, "none") == 0) return true;
    while (at < end) {
        const char *name = at;
        while (at < end && ((*at >= 'a' && *at <= 'z') || (*at >= 'A' && *at <= 'Z'))) at++;
        size_t length = (size_t)(at - name);
        while (at < end && is_space(*at)) at++;
        if (at == end || *at++ != '(') return false;
        while (at < end && is_space(*at)) at++;
        double v[6] = {0}, one[6];
        int n = 0;
        while (at < end && *at != ')') {
            if (n == 6) return false;
            at = bat_number_scan(at, end, &v[n]);
            if (!at || !isfinite(v[n])) return false;
            n++;
            bat_svg_skip(&at, end);
        }
        if (at == end || !primitive(name, length, n, v, one)) return false;
        at++;
        double next[6];
        bat_matrix_compose(whole, one, next);
        memcpy(whole, next, sizeof whole);
        const char *behind = at;
        bat_svg_skip(&at, end);
        if (at == end && memchr(behind, ',', (size_t)(end - behind))) return false;
    }
    for (int i = 0; i < 6; i++)
        if (!isfinite(whole[i])) return false;
    memcpy(m, whole, sizeof whole);
    return true;
}

/* ---- as CSS has them (CSS Transforms 1, 12 and 2, 13): with units, percentages and commas. Those that turn out of the plane are not
 * known. ---- */

enum { VALUES = 6, WORD = 40 };

static char lower(char c) { return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c; }

/* What each of its values is: a length along x, y or z, an angle, a number, or a share that may be a percentage. */
static const struct function {
    char name[12], values[VALUES + 1];
    int least;
} functions[] = {
    {"matrix", "nnnnnn", 6}, {"translate", "xy", 1},    {"translatex", "x", 1}, {"translatey", "y", 1},
    {"translatez", "z", 1},  {"translate3d", "xyz", 3}, {"scale", "ss", 1},     {"scalex", "s", 1},
    {"scaley", "s", 1},      {"scalez", "s", 1},        {"scale3d", "sss", 3},  {"rotate", "a", 1},
    {"rotatez", "a", 1},     {"skew", "aa", 1},         {"skewx", "a", 1},      {"skewy", "a", 1},
};

/* A length with a unit, which zero may lack. */
static bool read_length(const char *word, double whole, bool plain, double *out) {
    const char last = word[0] ? word[strlen(word) - 1] : '\0';
    if (!bat_svg_length(word, whole, out)) return false;
    return plain || *out == 0 || last == '%' || (last >= 'A' && last <= 'Z') || (last >= 'a' && last <= 'z');
}

static bool read_angle(const char *word, double *out) {
    static const struct {
        char name[5];
        double degrees;
    } units[] = {{"deg", 1}, {"grad", 0.9}, {"rad", 180 / BAT_PI}, {"turn", 360}};
    const char *unit = bat_number_scan(word, word + strlen(word), out);
    if (!unit || !isfinite(*out)) return false;
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strcmp(unit, units[i].name) == 0) {
            *out *= units[i].degrees;
            return true;
        }
    return !*unit && *out == 0;
}

static bool read_number(const char *word, bool share, double *out) {
    const char *unit = bat_number_scan(word, word + strlen(word), out);
    if (!unit || !isfinite(*out)) return false;
    if (share && strcmp(unit, "%") == 0) {
        *out /= 100;
        return true;
    }
    return !*unit;
}

static bool read_value(char what, const char *word, const double sides[2], double *out) {
    switch (what) {
    case 'x': return read_length(word, sides[0], false, out);
    case 'y': return read_length(word, sides[1], false, out);
    case 'z': return !strchr(word, '%') && read_length(word, 0, false, out);
    case 'a': return read_angle(word, out);
    default: return read_number(word, what == 's', out);
    }
}

/* Copies [from, to) in small letters, without the blanks around it. */
static bool copy(const char *from, const char *to, char word[WORD]) {
    while (from < to && is_space(*from)) from++;
    while (to > from && is_space(to[-1])) to--;
    if (to == from || to - from >= WORD) return false;
    for (const char *at = from; at < to; at++) word[at - from] = lower(*at);
    word[to - from] = '\0';
    return true;
}

static double tangent(double degrees) { return bat_tan(fmod(degrees, 180) * (BAT_PI / 180)); }

/* kind: the first letters of the function's name; axis: the last one. */
static bool make(const char *name, int count, const double v[VALUES], double m[6]) {
    const char axis = name[strlen(name) - 1];
    const double second = count > 1 ? v[1] : 0;
    char text[2 * WORD];
    bat_matrix_identity(m);
    switch (name[0]) {
    case 'm': memcpy(m, v, 6 * sizeof *m); return true;
    case 't':
        if (axis != 'z') m[4] = axis == 'y' ? 0 : v[0], m[5] = axis == 'y' ? v[0] : second;
        return true;
    case 'r': /* exact for quarter turns */
        snprintf(text, sizeof text, "rotate(%.17g)", v[0]);
        return bat_svg_transform(text, m);
    default:
        if (name[1] == 'k') {
            m[2] = axis == 'y' ? 0 : tangent(v[0]);
            m[1] = axis == 'y' ? tangent(v[0]) : tangent(second);
        } else if (axis != 'z') {
            m[0] = axis == 'y' ? 1 : v[0];
            m[3] = axis == 'x' ? 1 : axis == 'y' || count == 1 ? v[0] : v[1];
        }
        return true;
    }
}

/* The function at *at, which moves behind it. */
static bool read_function(const char **at, const double sides[2], double m[6]) {
    const char *open = strchr(*at, '('), *close = open ? strchr(open, ')') : NULL;
    char word[WORD];
    double v[VALUES] = {0};
    size_t which = 0;
    int count = 0;
    if (!close || !copy(*at, open, word)) return false;
    while (which < sizeof functions / sizeof *functions && strcmp(functions[which].name, word) != 0) which++;
    if (which == sizeof functions / sizeof *functions) return false;
    const struct function *f = &functions[which];
    for (const char *from = open + 1, *to; from <= close; from = to + 1) {
        to = memchr(from, ',', (size_t)(close - from));
        if (!to) to = close;
        if (!f->values[count] || !copy(from, to, word) ||
            !read_value(f->values[count], word, sides, &v[count]))
            return false;
        count++;
    }
    *at = close + 1;
    return count >= f->least && make(f->name, count, v, m);
}

bool bat_svg_functions(const char *text, const double sides[2], double m[6]) {
    double whole[6], one[6], next[6];
    const char *at = text;
    bat_matrix_identity(whole);
    bat_matrix_identity(m);
    if (strcmp(text, "none") == 0) return true;
    while (is_space(*at)) at++;
    if (!*at) return false;
    while (*at) {
        if (!read_function(&at, sides, one)) return false;
        bat_matrix_compose(whole, one, next);
        memcpy(whole, next, sizeof whole);
        while (is_space(*at)) at++;
    }
    for (int i = 0; i < 6; i++)
        if (!isfinite(whole[i])) return false;
    memcpy(m, whole, sizeof whole);
    return true;
}

bool bat_svg_function_of(const char *name, const char *values, const double sides[2], double m[6]) {
    char text[4 * WORD];
    int count = 0;
    bat_matrix_identity(m);
    if (strcmp(values, "none") == 0) return true;
    if (strlen(values) >= (size_t)3 * WORD) return false;
    for (const char *at = values; *at; at++) count += !is_space(*at) && (at == values || is_space(at[-1]));
    size_t size = (size_t)snprintf(text, sizeof text, "%s%s(", name, count == 3 ? "3d" : "");
    for (const char *at = values; *at; at++) {
        if (is_space(*at) && is_space(at[1])) continue;
        text[size++] = (char)(is_space(*at) ? ',' : *at);
    }
    text[size++] = ')', text[size] = '\0';
    return bat_svg_functions(text, sides, m);
}

bool bat_svg_origin(const char *text, const double sides[2], bool plain, double at[2]) {
    static const struct {
        char name[7];
        int axis; /* 2: of either */
        double share;
    } words[] = {{"left", 0, 0}, {"right", 0, 1}, {"top", 1, 0}, {"bottom", 1, 1}, {"center", 2, 0.5}};
    enum { MOST = 3 };
    char word[WORD];
    double values[MOST], share[MOST];
    int axes[MOST], count = 0;
    for (const char *from = text, *to; *from; from = to) {
        while (is_space(*from)) from++;
        to = from + strcspn(from, " \t\r\n\f");
        if (from == to) break;
        if (count == MOST || !copy(from, to, word)) return false;
        size_t k = 0;
        while (k < sizeof words / sizeof *words && strcmp(words[k].name, word) != 0) k++;
        const bool known = k < sizeof words / sizeof *words;
        axes[count] = known ? words[k].axis : -1;
        share[count] = known ? words[k].share : 0;
        if (!known && !read_length(word, sides[count == 1], plain, &values[count])) return false;
        count++;
    }
    if (count == 0 || (count == MOST && axes[2] >= 0)) return false;
    const bool turned = axes[0] == 1 || (count > 1 && axes[1] == 0);
    if (count == 1) axes[1] = 2, share[1] = 0.5;
    for (int k = 0; k < 2; k++) {
        const int i = turned ? 1 - k : k;
        if (axes[i] == 1 - k || (turned && axes[i] < 0)) return false; /* of the other axis */
        at[k] = axes[i] < 0 ? values[i] : share[i] * sides[k];
    }
    return true;
}

/* ---- boxes and lengths ---- */

bool bat_svg_view_box(const char *text, double box[4]) {
    const char *at = text, *end = text + strlen(text);
    double v[4];
    while (at < end && is_space(*at)) at++;
    for (int i = 0; i < 4; i++) {
        if (i > 0) bat_svg_skip(&at, end);
        at = bat_number_scan(at, end, &v[i]);
        if (!at || !(fabs(v[i]) <= 1e75)) return false;
    }
    while (at < end && is_space(*at)) at++;
    if (at != end || v[2] < 0 || v[3] < 0) return false;
    memcpy(box, v, sizeof v);
    return true;
}

void bat_svg_fit(const double box[4], double x, double y, double w, double h, const char *ratio,
                 double m[6]) {
    double sx = w / box[2], sy = h / box[3], ax = 0.5, ay = 0.5;
    if (!ratio) ratio = "";
    if (strncmp(ratio, "defer", 5) == 0) ratio += 5;
    while (is_space(*ratio)) ratio++;
    if (strncmp(ratio, "none", 4) == 0) {
        ax = ay = 0;
    } else {
        if (strncmp(ratio, "xMin", 4) == 0 || strncmp(ratio, "xMax", 4) == 0) ax = ratio[2] == 'i' ? 0 : 1;
        const char *vertical = strlen(ratio) >= 8 ? ratio + 4 : "";
        if (strncmp(vertical, "YMin", 4) == 0 || strncmp(vertical, "YMax", 4) == 0)
            ay = vertical[2] == 'i' ? 0 : 1;
        bool slice = strstr(ratio, "slice") != NULL;
        sx = sy = slice ? fmax(sx, sy) : fmin(sx, sy);
    }
    m[0] = sx, m[1] = 0, m[2] = 0, m[3] = sy;
    m[4] = x - sx * box[0] + ax * (w - sx * box[2]);
    m[5] = y - sy * box[1] + ay * (h - sy * box[3]);
}

double bat_svg_pixel(const double page[4], const char *width, const char *height, const char *ratio) {
    double w = 0, h = 0, m[6];
    const bool wide = width && !strchr(width, '%') && bat_svg_length(width, 0, &w) && w > 0,
               high = height && !strchr(height, '%') && bat_svg_length(height, 0, &h) && h > 0;
    if (!(page[2] > 0 && page[3] > 0) || !(wide || high)) return 1;
    if (!wide) w = h * page[2] / page[3];
    if (!high) h = w * page[3] / page[2];
    bat_svg_fit(page, 0, 0, w, h, ratio, m);
    const double pixel = 1 / sqrt(m[0] * m[3]);
    return pixel > 0 && isfinite(pixel) ? pixel : 1;
}

bool bat_svg_length(const char *text, double whole, double *value) {
    static const struct {
        const char *name;
        double pixels;
    } units[] = {{"", 1},           {"px", 1},         {"pt", 96.0 / 72}, {"pc", 16},
                 {"mm", 96 / 25.4}, {"cm", 96 / 2.54}, {"in", 96},        {"q", 96 / 101.6},
                 {"em", 16},        {"rem", 16},       {"ex", 8},         {"ch", 8}};
    const char *at = text, *end = text + strlen(text);
    double number, factor = 0;
    while (at < end && is_space(*at)) at++;
    while (end > at && is_space(end[-1])) end--;
    at = bat_number_scan(at, end, &number);
    if (!at) return false;
    char unit[4] = "";
    size_t length = (size_t)(end - at);
    if (length > 3) return false;
    for (size_t i = 0; i < length; i++)
        unit[i] = at[i] >= 'A' && at[i] <= 'Z' ? (char)(at[i] - 'A' + 'a') : at[i];
    if (strcmp(unit, "%") == 0)
        factor = whole / 100;
    else {
        size_t i = 0, count = sizeof units / sizeof *units;
        while (i < count && strcmp(units[i].name, unit) != 0) i++;
        if (i == count) return false;
        factor = units[i].pixels;
    }
    number *= factor;
    if (!(fabs(number) <= 1e75)) return false;
    *value = number;
    return true;
}

bool bat_svg_inverse(const double m[6], double out[6]) {
    const double det = m[0] * m[3] - m[1] * m[2];
    if (!(fabs(det) > 0) || !isfinite(1 / det)) return false;
    const double a = m[3] / det, b = -m[1] / det, c = -m[2] / det, d = m[0] / det;
    const double made[6] = {a, b, c, d, -(a * m[4] + c * m[5]), -(b * m[4] + d * m[5])};
    memcpy(out, made, sizeof made);
    return true;
}
