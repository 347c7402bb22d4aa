/* Hooks of a pen that lands or leaves, before any smoothing hides them (docs/math sketch 5.2). */
#include "hands/sketch/landing.h"
#include "base/real.h"

#include <math.h>

static const double least_turn = 12 * BAT_PI / 180;
static const double faint = 0.55; /* of the usual pressure */
static const double quick = 60;   /* ms */
static const double shortest = 0.4, chord = 2.5, chord_least = 3, sharp = 0.6;

typedef struct tip {
    const bat_stroke_path *path;
    bool at_end;
} tip;

static void place(const tip *t, double s, double *out) {
    bat_path_at(t->path, t->at_end ? t->path->arc[t->path->count - 1] - s : s, out);
}

static double turn_between(const tip *t, double a, double b, double c) {
    double x[3][BAT_DIMENSION_MAX];
    place(t, a, x[0]), place(t, b, x[1]), place(t, c, x[2]);
    return bat_path_turn(x[0], x[1], x[2], t->path->m);
}

/* How much more it turns at s than behind it, radians. 0 where it turns like a bow, half as much between half the chords. */
static double turns_away(const tip *t, double s) {
    const double h = fmax(chord * s, chord_least), turn = turn_between(t, 0, s, s + h);
    if (turn_between(t, 0.5 * s, s, s + 0.5 * h) < sharp * turn) return 0;
    return turn - turn_between(t, s, s + h, s + 2 * h);
}

/* Length up to where the pen presses; of one that presses slowly, as much as can be a hook. */
static double landing_length(const tip *t, const bat_press *press, double reach) {
    const bat_stroke_path *path = t->path;
    const double total = path->arc[path->count - 1];
    const double began = press->time[t->at_end ? path->count - 1 : 0];
    for (size_t i = 0; i < path->count; i++) {
        const size_t at = t->at_end ? path->count - 1 - i : i;
        const double s = t->at_end ? total - path->arc[at] : path->arc[at];
        if (s > reach || fabs(press->time[at] - began) > quick) return fmin(s, reach);
        if (press->pressure[at] >= faint * press->usual) return s;
    }
    return 0;
}

size_t bat_landing(const bat_stroke_path *path, const bat_press *press, bool at_end) {
    const tip t = {path, at_end};
    const double total = path->arc[path->count - 1];
    const double reach = fmin(8, 0.12 * total);
    const double pressed = landing_length(&t, press, reach);
    if (!(pressed > shortest)) return 0;
    double most = least_turn, cut = 0;
    for (int i = 0; i <= 12; i++) {
        const double s = fmin(pressed * (0.4 + 0.1 * i), reach), turn = turns_away(&t, s);
        if (turn > most) most = turn, cut = s;
    }
    size_t samples = 0;
    while (cut > 0 && samples + 4 < path->count &&
           (at_end ? total - path->arc[path->count - 1 - samples] : path->arc[samples]) < cut)
        samples++;
    return samples;
}

/* How far the points lead on beyond the first of three even places, along the tangent there. */
static double leads_on(const bat_landed *landed, double x[3][BAT_DIMENSION_MAX], size_t m) {
    double way[BAT_DIMENSION_MAX], square = 0, most = 0;
    for (size_t c = 0; c < m; c++) {
        way[c] = 3 * x[0][c] - 4 * x[1][c] + x[2][c];
        square += way[c] * way[c];
    }
    for (size_t i = 0; i < landed->count; i++) {
        double along = 0;
        for (size_t c = 0; c < m; c++) along += (landed->points[i * m + c] - x[0][c]) * way[c];
        most = fmax(most, along);
    }
    return square > 0 ? most / sqrt(square) : 0;
}

bool bat_lead_on(const bat_stroke_path *path, const bat_landed *landed, bool at_end, double *out) {
    const tip t = {path, at_end};
    const size_t m = path->m, count = landed->count;
    double x[3][BAT_DIMENSION_MAX];
    for (int i = 0; i < 3; i++) place(&t, i * landed->h, x[i]);
    const double far = fmin(leads_on(landed, x, m), landed->h);
    if (!(far > 0)) return false;
    for (size_t i = 1; i <= count; i++) {
        const double f = far / landed->h * (double)i / (double)count;
        double *p = out + (at_end ? i - 1 : count - i) * m;
        for (size_t c = 0; c < m; c++)
            p[c] = 0.5 * (1 + f) * (2 + f) * x[0][c] - f * (2 + f) * x[1][c] + 0.5 * f * (1 + f) * x[2][c];
    }
    return true;
}
