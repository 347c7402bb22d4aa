/* transform, viewBox, preserveAspectRatio and lengths (SVG 2, 8; CSS Values 6). */
#include "base/matrix.h"
#include "base/real.h"
#include "text/number.h"
#include "format/svg/svg.h"

#include <math.h>
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
        bat_svg_skip(&at, end);
    }
    for (int i = 0; i < 6; i++)
        if (!isfinite(whole[i])) return false;
    memcpy(m, whole, sizeof whole);
    return true;
}

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
