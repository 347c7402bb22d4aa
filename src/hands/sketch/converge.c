#include "hands/sketch/converge.h"
#include "base/order.h"
#include "base/real.h"
#include "curve/banded.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double STEP = 4;                    /* px between the places of a stroke */
static const double KNOTS = 14, WAVE = 140;      /* px between knots; shorter waves are no shape */
static const double FEATHER = 60, FAINT = 0.003; /* px at a stroke's ends that count little, and how little */
static const double OWN = 0.36 * 30;             /* how freely a stroke lies beside the line, as a whole */
static const double LEAST_SCATTER = 0.5, MOST_SCATTER = 8;
enum { ROUNDS = 4, WINDOW = 10, PLACES_MOST = 4096 };

/* One stroke, in pixels. */
typedef struct hair {
    size_t count;
    double *at, *u, *weight; /* x y; place along the line; one block, which begins with at */
    double length, own[3];
    double first, last; /* least and greatest u */
    double on;          /* px of it that lie on the line */
    double again;       /* how long the line is when more of it may */
    bool placed, summed;
} hair;

typedef struct line {
    double from, to; /* its places along */
    size_t knots;    /* spans */
    double *points;  /* control points, knots + 3 of them */
    size_t dense;    /* places below */
    double *at, gap; /* x y, evenly from `from` to `to`; greatest step between them */
} line;

/* What the places of a span add to the equations, before it is known how many strokes lie there: cover, how many; a, b:
 * lower triangle by rows, and right-hand sides. Kept from one solve to the next, so that a stroke that is placed costs
 * what it brings. */
typedef struct span_sum {
    double cover, a[10], b[8];
} span_sum;

typedef struct sums {
    double from, to;
    size_t knots;
    span_sum *of;
} sums;

typedef struct tangle {
    size_t count;
    hair *hairs;
    line line;
    sums sums;
    double scatter;
} tangle;

/* ---- strokes ---- */

static double within(double value, double low, double high) { return fmin(fmax(value, low), high); }

static bool usable(const bat_stroke *s, size_t i, const double *origin, double pixel, double out[2]) {
    for (size_t k = 0; k < 2; k++) out[k] = (s->points[2 * i + k] - origin[k]) / pixel;
    return fabs(out[0]) < 1e7 && fabs(out[1]) < 1e7;
}

/* Evenly spaced places; weight holds the time there, or nothing. */
static void spread(hair *h, const bat_stroke *s, const double *origin, double pixel, size_t room,
                   double step) {
    double last[2] = {0, 0}, now[2], gone = 0, due = 0, before = 0;
    bool any = false;
    h->count = 0;
    for (size_t i = 0; i < s->count; i++) {
        if (!usable(s, i, origin, pixel, now)) continue;
        const double time = s->time ? s->time[i] : 0;
        const double piece = any ? bat_hypot(now[0] - last[0], now[1] - last[1]) : 0;
        for (; h->count < room && (piece > 0 || !any) && due <= gone + piece; due += step) {
            const double f = piece > 0 ? (due - gone) / piece : 0;
            for (size_t k = 0; k < 2; k++)
                h->at[2 * h->count + k] = any ? last[k] + f * (now[k] - last[k]) : now[k];
            h->weight[h->count++] = before + f * (time - before);
        }
        gone += piece;
        memcpy(last, now, sizeof last);
        before = time;
        any = true;
    }
    h->length = h->count ? (double)(h->count - 1) * step : 0;
}

/* The weight of a place: its share of the length, less at the feathered ends and where the pen was fast. */
static void weigh(hair *h, bool timed, double step, double press) {
    const double feather = fmin(FEATHER, h->length / 3);
    double *pace = h->u; /* not in use yet */
    for (size_t i = 0; i < h->count; i++) {
        const size_t a = i ? i - 1 : 0, b = i + 1 < h->count ? i + 1 : i;
        pace[i] = timed ? fmax(h->weight[b] - h->weight[a], 0) / (double)(b - a) : 1;
    }
    const double usual = bat_middle(pace, h->count);
    for (size_t i = 0; i < h->count; i++) {
        const double s = (double)i * step,
                     end = feather > 0 ? within(fmin(s, h->length - s) / feather, 0, 1) : 1;
        const double care = usual > 0 ? within(pace[i] / usual, 0.5, 2) : 1;
        h->weight[i] = step * press * care * (end * end * (3 - 2 * end) + FAINT);
    }
}

static double raw_length(const bat_stroke *s, const double *origin, double pixel) {
    double last[2] = {0, 0}, now[2], length = 0;
    bool any = false;
    for (size_t i = 0; i < s->count; i++) {
        if (!usable(s, i, origin, pixel, now)) continue;
        if (any) length += bat_hypot(now[0] - last[0], now[1] - last[1]);
        memcpy(last, now, sizeof last);
        any = true;
    }
    return length;
}

static bat_status take(hair *h, const bat_stroke *s, const double *origin, double pixel, double usual) {
    const double length = raw_length(s, origin, pixel), step = fmax(STEP, length / (PLACES_MOST - 2));
    const size_t room = (size_t)(length / step) + 2;
    h->at = malloc(room * 4 * sizeof *h->at);
    if (!h->at) return BAT_MEMORY;
    h->u = h->at + 2 * room, h->weight = h->at + 3 * room;
    spread(h, s, origin, pixel, room, step);
    const double press = s->pressure && usual > 0 ? within(bat_middle(s->pressure, s->count) / usual, 0.5, 2)
                                                  : 1;
    weigh(h, s->time != NULL, step, press);
    return BAT_OK;
}

/* ---- the line ---- */

static void basis(double t, double b[4]) {
    const double r = 1 - t;
    b[0] = r * r * r / 6, b[3] = t * t * t / 6;
    b[1] = (3 * t * t * t - 6 * t * t + 4) / 6, b[2] = 1 - b[0] - b[1] - b[3];
}

static size_t span_of(const line *l, double u, double *t) {
    const double step = (l->to - l->from) / (double)l->knots,
                 at = within((u - l->from) / step, 0, (double)l->knots);
    const size_t k = at >= (double)l->knots ? l->knots - 1 : (size_t)at;
    *t = at - (double)k;
    return k;
}

static void place_on(const line *l, double u, double out[2]) {
    double t, b[4];
    const size_t k = span_of(l, u, &t);
    basis(t, b);
    out[0] = out[1] = 0;
    for (size_t j = 0; j < 4; j++)
        for (size_t c = 0; c < 2; c++) out[c] += b[j] * l->points[2 * (k + j) + c];
}

static bool draw(line *l) {
    const size_t dense = (size_t)((l->to - l->from) / STEP) + 2;
    double *at = realloc(l->at, dense * 2 * sizeof *at);
    if (!at) return false;
    l->at = at, l->dense = dense;
    l->gap = 0;
    for (size_t i = 0; i < dense; i++) {
        double *p = at + 2 * i;
        place_on(l, l->from + (l->to - l->from) * (double)i / (double)(dense - 1), p);
        if (i) l->gap = fmax(l->gap, bat_hypot(p[0] - p[-2], p[1] - p[-1]));
    }
    return true;
}

/* The unit normal of the line at a place. */
static void normal_at(const line *l, double u, double out[2]) {
    double a[2], b[2];
    place_on(l, u - 1, a);
    place_on(l, u + 1, b);
    const double x = b[0] - a[0], y = b[1] - a[1], length = fmax(bat_hypot(x, y), 1e-12);
    out[0] = -y / length, out[1] = x / length;
}

static double own_part(const hair *h, size_t i) {
    const double f = h->count > 1 ? (double)i / (double)(h->count - 1) - 0.5 : 0;
    return h->own[0] + h->own[1] * 2 * f + h->own[2] * (6 * f * f - 0.5);
}

/* Adds a stroke's places to the sums. */
static void sum_up(sums *sum, const hair *h) {
    const line l = {.from = sum->from, .to = sum->to, .knots = sum->knots};
    const double step = (sum->to - sum->from) / (double)sum->knots;
    for (size_t i = 0; i < h->count; i++) {
        double f, e[4];
        span_sum *s = &sum->of[span_of(&l, h->u[i], &f)];
        double *a = s->a;
        basis(f, e);
        s->cover += h->weight[i] / step;
        for (size_t r = 0; r < 4; r++) {
            const double weight = h->weight[i] * e[r];
            for (size_t k = 0; k <= r; k++) *a++ += weight * e[k];
            for (size_t c = 0; c < 2; c++) s->b[2 * r + c] += weight * h->at[2 * i + c];
        }
    }
}

/* Takes from the right-hand sides what is the strokes' own, across the line as it is. */
static void leave_own(tangle *t) {
    const line *l = &t->line;
    for (size_t j = 0; j < t->count; j++) {
        const hair *h = &t->hairs[j];
        for (size_t i = 0; i < h->count && h->placed; i++) {
            double f, e[4], across[2];
            span_sum *s = &t->sums.of[span_of(l, h->u[i], &f)];
            basis(f, e);
            normal_at(l, h->u[i], across);
            const double own = h->weight[i] * own_part(h, i);
            for (size_t r = 0; r < 4; r++)
                for (size_t c = 0; c < 2; c++) s->b[2 * r + c] -= own * e[r] * across[c];
        }
    }
}

/* The sums over all that has been placed, on knots for these places. */
static bool sum_all(tangle *t, double from, double to) {
    sums *s = &t->sums;
    if (from != s->from || to != s->to || !s->of) {
        const size_t knots = (size_t)fmax(ceil((to - from) / KNOTS), 3);
        span_sum *of = realloc(s->of, knots * sizeof *of);
        if (!of) return false;
        memset(of, 0, knots * sizeof *of);
        *s = (sums){from, to, knots, of};
        for (size_t j = 0; j < t->count; j++) t->hairs[j].summed = false;
    }
    for (size_t j = 0; j < t->count; j++) {
        hair *h = &t->hairs[j];
        if (!h->placed || h->summed) continue;
        sum_up(s, h);
        h->summed = true;
    }
    return true;
}

/* Equations of the smoothest line through the places. */
static void assemble(const sums *sum, double *a, double *b) {
    const size_t n = sum->knots + 3;
    const double step = (sum->to - sum->from) / (double)sum->knots, wave = WAVE / (2 * BAT_PI);
    const double cubed = wave * wave * wave, stiff = 0.5 * cubed * cubed / (step * step * step * step * step);
    static const double third[4] = {-1, 3, -3, 1};
    memset(a, 0, n * 4 * sizeof *a);
    memset(b, 0, n * 2 * sizeof *b);
    for (size_t k = 0; k < sum->knots; k++) {
        const span_sum *s = &sum->of[k];
        const double lift = 1 / fmin(fmax(s->cover, 1e-6), 1), *from = s->a;
        for (size_t r = 0; r < 4; r++) {
            for (size_t i = 0; i <= r; i++)
                a[(k + r) * 4 + r - i] += stiff * third[r] * third[i] + lift * *from++;
            for (size_t c = 0; c < 2; c++) b[2 * (k + r) + c] += lift * s->b[2 * r + c];
        }
    }
}

/* Fits the line to all that has been placed. own: without the strokes' own parts, if the line from which they are
 * measured has these places. */
static bat_status solve(tangle *t, bool own) {
    line *l = &t->line;
    double from = INFINITY, to = -INFINITY;
    for (size_t j = 0; j < t->count; j++)
        if (t->hairs[j].placed) from = fmin(from, t->hairs[j].first), to = fmax(to, t->hairs[j].last);
    if (!(to - from > STEP)) return BAT_DOT;
    if (!sum_all(t, from, to)) return BAT_MEMORY;
    if (own && from == l->from && to == l->to) leave_own(t);
    line made = {.from = from, .to = to, .knots = t->sums.knots, .at = l->at};
    const size_t n = made.knots + 3;
    double *block = malloc(n * 6 * sizeof *block);
    if (!block) return BAT_MEMORY;
    double *a = block, *b = block + 4 * n;
    assemble(&t->sums, a, b);
    bat_status status = bat_banded_factor(a, (int)n, 3);
    if (status == BAT_OK) {
        bat_banded_solve(a, (int)n, 3, b, 2);
        memmove(block, b, 2 * n * sizeof *block);
        free(l->points);
        made.points = block, made.dense = l->dense;
        *l = made;
        return draw(l) ? BAT_OK : BAT_MEMORY;
    }
    free(block);
    return status;
}

/* ---- places of strokes on the line ---- */

static double distance2(const double *a, const double *b) {
    return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

/* The nearest of all places of the line. From one that is farther off than the best so far, as many are passed over as
 * cannot come nearer. */
static size_t nearest_of_all(const line *l, const double *p, size_t guess) {
    size_t best = guess < l->dense ? guess : 0;
    double least = bat_hypot(p[0] - l->at[2 * best], p[1] - l->at[2 * best + 1]);
    for (size_t i = 0, skip; i < l->dense; i += skip) {
        const double far = bat_hypot(p[0] - l->at[2 * i], p[1] - l->at[2 * i + 1]);
        if (far < least || (far == least && i < best)) least = far, best = i;
        const double steps = (far - least) / l->gap;
        skip = !(steps > 1) ? 1 : steps < (double)l->dense ? (size_t)steps : l->dense;
    }
    return best;
}

static size_t nearest_between(const line *l, const double *p, size_t low, size_t high) {
    size_t best = low;
    for (size_t i = low + 1; i <= high; i++)
        if (distance2(p, l->at + 2 * i) < distance2(p, l->at + 2 * best)) best = i;
    return best;
}

/* The nearest of the line's places near the last one, refined between its neighbours. Returns u; *beyond: -1,
 * 0, 1. */
static double foot(const line *l, const double *p, size_t *near, bool anywhere, int *beyond) {
    const size_t best = anywhere
                            ? nearest_of_all(l, p, *near)
                            : nearest_between(l, p, *near < WINDOW ? 0 : *near - WINDOW,
                                              *near + WINDOW >= l->dense ? l->dense - 1 : *near + WINDOW);
    *near = best;
    const double step = (l->to - l->from) / (double)(l->dense - 1);
    const size_t a = best ? best - 1 : 0, b = best + 1 < l->dense ? best + 1 : best;
    const double *pa = l->at + 2 * a, *pb = l->at + 2 * b, *pm = l->at + 2 * best;
    const double x = pb[0] - pa[0], y = pb[1] - pa[1], long2 = fmax(x * x + y * y, 1e-12);
    const double f = ((p[0] - pm[0]) * x + (p[1] - pm[1]) * y) / long2 * (double)(b - a);
    *beyond = best == 0 && f < 0 ? -1 : best + 1 == l->dense && f > 0 ? 1 : 0;
    return l->from + step * ((double)best + (*beyond ? 0 : within(f, -1, 1)));
}

static void range(hair *h) {
    h->first = INFINITY, h->last = -INFINITY;
    for (size_t i = 0; i < h->count; i++)
        h->first = fmin(h->first, h->u[i]), h->last = fmax(h->last, h->u[i]);
}

/* Beyond the places on the line it goes on by its own length. */
static void go_on(hair *h, size_t first, size_t last, double step) {
    double *u = h->u;
    const double start = u[first], end = u[last], way = end >= start ? step : -step;
    for (size_t i = first; i-- > 0;) u[i] = start - way * (double)(first - i);
    for (size_t i = last + 1; i < h->count; i++) u[i] = end + way * (double)(i - last);
}

/* Lays a stroke along the line. */
static void lay(const line *l, hair *h) {
    const double step = h->count > 1 ? h->length / (double)(h->count - 1) : 0;
    size_t near = 0, inside = 0, first = h->count, last = 0;
    double off = INFINITY; /* from the nearer end, squared */
    int beyond = 0;
    for (size_t i = 0; i < h->count; i++) {
        h->u[i] = foot(l, h->at + 2 * i, &near, i == 0 || beyond, &beyond);
        if (beyond) {
            off = fmin(off, distance2(h->at + 2 * i, l->at + 2 * near));
            continue;
        }
        inside++;
        if (first == h->count) first = i;
        last = i;
    }
    if (inside) go_on(h, first, last, step);
    h->on = (double)inside * step;
    h->again = inside == h->count ? INFINITY : l->to - l->from + (inside ? 0 : 0.5 * sqrt(off));
    range(h);
}

/* A stroke's offset, tilt and bow, held back by how even all strokes are. */
static void fit_own(const tangle *t, hair *h) {
    const double s = within(t->scatter, LEAST_SCATTER, MOST_SCATTER), hold = OWN / (s * s);
    double a[9] = {hold, 0, 0, 0, 2 * hold, 0, 0, 0, 4 * hold}, b[3] = {0};
    for (size_t i = 0; i < h->count; i++) {
        const double f = h->count > 1 ? (double)i / (double)(h->count - 1) - 0.5 : 0;
        const double row[3] = {1, 2 * f, 6 * f * f - 0.5};
        double on[2], n[2];
        if (h->u[i] < t->line.from || h->u[i] > t->line.to) continue;
        place_on(&t->line, h->u[i], on);
        normal_at(&t->line, h->u[i], n);
        const double off = (h->at[2 * i] - on[0]) * n[0] + (h->at[2 * i + 1] - on[1]) * n[1];
        for (int r = 0; r < 3; r++) {
            for (int k = 0; k < 3; k++) a[3 * r + k] += h->weight[i] * row[r] * row[k];
            b[r] += h->weight[i] * row[r] * off;
        }
    }
    for (int k = 0; k < 3; k++) /* positive definite: no pivots */
        for (int i = k + 1; i < 3; i++) {
            const double f = a[3 * i + k] / a[3 * k + k];
            for (int j = k; j < 3; j++) a[3 * i + j] -= f * a[3 * k + j];
            b[i] -= f * b[k];
        }
    for (int k = 2; k >= 0; k--) {
        for (int j = k + 1; j < 3; j++) b[k] -= a[3 * k + j] * h->own[j];
        h->own[k] = b[k] / a[3 * k + k];
    }
}

static void measure(tangle *t) {
    double sum = 0, weight = 1e-12;
    for (size_t j = 0; j < t->count; j++)
        for (size_t i = 0; i < t->hairs[j].count && t->hairs[j].placed; i++) {
            const hair *h = &t->hairs[j];
            double on[2];
            if (h->u[i] < t->line.from || h->u[i] > t->line.to) continue;
            place_on(&t->line, h->u[i], on);
            sum += h->weight[i] * distance2(h->at + 2 * i, on);
            weight += h->weight[i];
        }
    t->scatter = sqrt(sum / weight);
}

/* Whichever lies most on the line of those that are not placed yet. They are laid along it only where it may have come
 * nearer to them: most are laid a few times, however many there are. */
static hair *next_one(tangle *t) {
    const double length = t->line.to - t->line.from;
    hair *best = NULL;
    for (size_t j = 0; j < t->count; j++) {
        hair *h = &t->hairs[j];
        if (h->placed) continue;
        if (length > h->again) lay(&t->line, h);
        if (h->on > (best ? best->on : 0)) best = h;
    }
    if (best) lay(&t->line, best);
    return best;
}

/* The longest stroke first, then whichever lies most on the line so far. */
static bat_status gather(tangle *t) {
    size_t longest = 0;
    for (size_t j = 1; j < t->count; j++)
        if (t->hairs[j].length > t->hairs[longest].length) longest = j;
    hair *h = &t->hairs[longest];
    if (h->count < 4) return BAT_DOT;
    for (size_t i = 0; i < h->count; i++) h->u[i] = h->length * (double)i / (double)(h->count - 1);
    range(h);
    h->placed = true;
    bat_status status = solve(t, false);
    while (status == BAT_OK && (h = next_one(t))) {
        h->placed = true;
        status = solve(t, false);
    }
    return status;
}

static bat_status settle(tangle *t) {
    bat_status status = gather(t);
    for (int round = 0; round < ROUNDS && status == BAT_OK; round++) {
        for (size_t j = 0; j < t->count; j++)
            if (t->hairs[j].placed) lay(&t->line, &t->hairs[j]);
        t->sums.from = NAN; /* all has moved */
        measure(t);
        for (size_t j = 0; j < t->count; j++)
            if (t->hairs[j].placed) fit_own(t, &t->hairs[j]);
        /* Places may have moved beyond the line's ends: it is laid out anew over them, then freed of own parts. */
        status = solve(t, false);
        if (status == BAT_OK) status = solve(t, true);
    }
    if (status == BAT_OK) measure(t);
    return status;
}

bat_status bat_converge(size_t count, const bat_stroke *strokes, double pixel, bat_average *out) {
    double origin[2] = {0, 0}, usual = 0;
    if (!count || !strokes || !out || !(pixel > 0)) return BAT_ARGUMENT;
    for (size_t j = 0; j < count; j++) {
        if (strokes[j].dimension != 2) return BAT_DIMENSION;
        if (strokes[j].pressure && strokes[j].count)
            usual += bat_middle(strokes[j].pressure, strokes[j].count) / (double)count;
    }
    for (size_t i = 0; i < 2 && strokes[0].count; i++)
        if (fabs(strokes[0].points[i]) < 1e150) origin[i] = strokes[0].points[i];
    tangle t = {.count = count, .hairs = calloc(count, sizeof *t.hairs)};
    bat_status status = t.hairs ? BAT_OK : BAT_MEMORY;
    for (size_t j = 0; j < count && status == BAT_OK; j++)
        status = take(&t.hairs[j], &strokes[j], origin, pixel, usual);
    if (status == BAT_OK) status = settle(&t);
    if (status == BAT_OK) {
        for (size_t i = 0; i < 2 * t.line.dense; i++) t.line.at[i] = origin[i & 1] + pixel * t.line.at[i];
        *out = (bat_average){t.line.dense, t.line.at, t.scatter * pixel};
        t.line.at = NULL;
    }
    for (size_t j = 0; j < count && t.hairs; j++) free(t.hairs[j].at);
    free(t.hairs);
    free(t.sums.of);
    free(t.line.points);
    free(t.line.at);
    return status;
}
