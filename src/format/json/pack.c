/*
 * A curve that was read from a drawing is mostly foreseen: its knots lie as far apart as its points, the handles of a straight
 * span are its thirds, and its points have few decimals. So each number is written by what it differs from the one that is
 * foreseen, in as few bytes as that takes; what is not foreseen at all takes nine.
 */
#include "format/json/pack.h"

#include "curve/curve.h"
#include "text/base64.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The lowest two bits of what is written for a number: how many doubles it is behind the one foreseen, how many decimal steps, the
 * bits themselves, or how many numbers in a row are as foreseen. */
enum { DOUBLES, DECIMALS, BITS, RUN };

enum { FINEST = 6, TRIED = 64 };
static const double steps[FINEST + 1] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
static const double WHOLE = 0x1p52; /* whole numbers up to here, and their differences, are exact */

/* The place of a double among all of them, by size; -0 stands before 0. */
static int64_t rank(double number) {
    int64_t bits;
    memcpy(&bits, &number, sizeof bits);
    return bits < 0 ? -(bits & INT64_MAX) - 1 : bits;
}

static double at_rank(int64_t place) {
    const uint64_t bits = place < 0 ? (uint64_t)(-(place + 1)) | (uint64_t)1 << 63 : (uint64_t)place;
    double number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static uint64_t fold(uint64_t difference) { return difference >> 63 ? ~(difference << 1) : difference << 1; }

static uint64_t unfold(uint64_t folded) { return folded & 1 ? ~(folded >> 1) : folded >> 1; }

/* The decimal step nearest to a number; 0 when it is too large to have one. */
static double step_of(double number, double step) {
    const double whole = round(number * step);
    return fabs(whole) < WHOLE ? whole : 0;
}

static bool is_decimal(double number, double step) {
    const double whole = round(number * step) + 0; /* -0 has none */
    return fabs(whole) < WHOLE && rank(whole / step) == rank(number);
}

/* ---- which numbers are foreseen by which ---- */

/* What the knots' multiplicities say of the points. */
typedef struct plan {
    size_t degree, count, dimension, distinct;
    bool closed;
    size_t *ends; /* of each distinct knot: the point that the curve passes through there; `count`: none */
    bool *
        plain; /* of each point: it is foreseen by the plain point before it, not by those that end its span */
} plan;

static void free_plan(plan *p) {
    free(p->ends);
    free(p->plain);
}

/* times: how often each distinct knot stands there. */
static void find_ends(plan *p, const size_t *times) {
    for (size_t k = 0, start = 0; k < p->distinct; start += times[k++]) {
        const size_t behind = start + times[k];
        const bool passes = times[k] >= p->degree && behind >= p->degree + (p->closed ? 0 : 1);
        size_t at = p->count;
        if (passes && start == 0) at = p->closed ? p->count - 1 : behind - 1 - p->degree;
        if (passes && start > 0) at = start - 1;
        p->ends[k] = at < p->count ? at : p->count;
        if (at < p->count) p->plain[at] = true;
    }
    if (!p->closed) p->plain[0] = p->plain[p->count - 1] = true;
}

/* Points between two ends that are further apart than those of a span are plain as well. */
static void fill_gaps(plan *p) {
    size_t first = 0, from = 0;
    while (first < p->count && !p->plain[first]) first++;
    for (size_t i = from = first; i < p->count; i++) {
        if (!p->plain[i]) continue;
        for (size_t k = from; i - from > p->degree && k < i; k++) p->plain[k] = true;
        from = i;
    }
    if (first == p->count || first + p->count - from > p->degree)
        for (size_t k = first == p->count ? 0 : from; k < p->count + (first < p->count ? first : 0); k++)
            p->plain[k % p->count] = true;
}

static bat_status make_plan(size_t degree, bool closed, size_t count, size_t dimension, size_t distinct,
                            const size_t *times, plan *out) {
    plan made = {degree, count, dimension, distinct, closed, NULL, NULL};
    made.ends = malloc(distinct * sizeof *made.ends);
    made.plain = calloc(count, sizeof *made.plain);
    if (!made.ends || !made.plain) {
        free_plan(&made);
        return BAT_MEMORY;
    }
    find_ends(&made, times);
    fill_gaps(&made);
    *out = made;
    return BAT_OK;
}

/* The points of a span between its ends. */
typedef struct between {
    size_t from, to, size;
} between;

/* The next run of points that are not plain, from `at` on; false: there is none. */
static bool next_between(const plan *p, size_t at, between *out) {
    while (at < p->count && p->plain[at]) at++;
    if (at == p->count) return false;
    size_t to = at, from = at > 0 ? at - 1 : p->count - 1;
    if (at == 0) /* the span over the seam, whose end may lie before it */
        while (!p->plain[from]) from--;
    while (to < p->count && !p->plain[to]) to++;
    while (!p->plain[to % p->count]) to++;
    *out = (between){from, to, (to + p->count - from) % p->count};
    if (out->size == 0) out->size = p->count; /* a closed curve of one span */
    return true;
}

/* A number `step` of `size` from one end of a span to the other, if it is straight: as bat_outline_line has it. */
static double on_line(double from, double to, size_t step, size_t size) {
    const double part = (to - from) / (double)size;
    return 2 * step <= size ? from + part * (double)step : to - part * (double)(size - step);
}

/* The knot after `knot`, which is that of the distinct one before k: spans are as long as their polygons. */
static double foresee(const plan *p, const double *points, size_t k, double knot, double rate,
                      double *length) {
    const size_t from = p->ends[k - 1], to = p->ends[k];
    *length = 0;
    if (from == p->count || to == p->count || (to + p->count - from) % p->count != p->degree) return knot;
    for (size_t i = from; i != to; i = (i + 1) % p->count)
        *length += bat_distance(points + i * p->dimension, points + (i + 1) % p->count * p->dimension,
                                (int)p->dimension);
    const double next = knot + rate * *length;
    return isfinite(next) ? next : knot;
}

/* ---- writing ---- */

typedef struct packer {
    bat_text bytes;
    double step;
    uint64_t run;
} packer;

static void put_whole(packer *p, uint64_t whole) {
    char bytes[10];
    size_t count = 0;
    for (; whole >= 128; whole >>= 7) bytes[count++] = (char)((whole & 127) | 128);
    bytes[count++] = (char)whole;
    bat_text_add(&p->bytes, bytes, count);
}

static void end_run(packer *p) {
    if (p->run > 0) put_whole(p, p->run << 2 | RUN);
    p->run = 0;
}

static void put_number(packer *p, double number, double foreseen) {
    const uint64_t doubles = fold((uint64_t)rank(number) - (uint64_t)rank(foreseen));
    uint64_t best = doubles >> 61 ? UINT64_MAX : doubles << 2 | DOUBLES;
    if (is_decimal(number, p->step)) {
        const double apart = round(number * p->step) - step_of(foreseen, p->step);
        const uint64_t decimals = fold((uint64_t)(int64_t)apart) << 2 | DECIMALS;
        if (decimals < best) best = decimals;
    }
    if (best >> 56) { /* of more than eight bytes */
        char bits[8];
        uint64_t own;
        memcpy(&own, &number, sizeof own);
        for (int k = 0; k < 8; k++) bits[k] = (char)(own >> (8 * k) & 255);
        put_whole(p, BITS);
        bat_text_add(&p->bytes, bits, sizeof bits);
    } else
        put_whole(p, best);
}

/* The same where many are as foreseen. */
static void put_foreseen(packer *p, double number, double foreseen) {
    if (rank(number) == rank(foreseen)) {
        p->run++;
        return;
    }
    end_run(p);
    put_number(p, number, foreseen);
}

/* How many decimals most of the first points have. */
static int decimals_of(const double *numbers, size_t count) {
    int best = 0, most = -1;
    for (int k = 0; k <= FINEST; k++) {
        int some = 0;
        for (size_t i = 0; i < count && i < TRIED; i++)
            some += is_decimal(numbers[i * (count / TRIED + 1) % count], steps[k]);
        if (some > most) best = k, most = some;
    }
    return best;
}

static void put_points(packer *p, const plan *l, const double *points) {
    const double nothing[BAT_DIMENSION_MAX] = {0}, *last = nothing;
    const size_t d = l->dimension;
    for (size_t i = 0; i < l->count; i++) {
        if (!l->plain[i]) continue;
        for (size_t c = 0; c < d; c++) put_number(p, points[i * d + c], last[c]);
        last = points + i * d;
    }
    between b;
    for (size_t at = 0; next_between(l, at, &b); at = b.to)
        for (size_t k = b.from + 1; k % l->count != b.to % l->count; k++)
            for (size_t c = 0; c < d; c++)
                put_foreseen(
                    p, points[k % l->count * d + c],
                    on_line(points[b.from * d + c], points[b.to % l->count * d + c], k - b.from, b.size));
    end_run(p);
}

/* How often each distinct knot stands there; returns how many there are. */
static size_t count_knots(const double *knots, size_t count, size_t *times) {
    size_t distinct = 0;
    for (size_t i = 0, from = 0; i < count; from = i) {
        while (i < count && rank(knots[i]) == rank(knots[from])) i++;
        times[distinct++] = i - from;
    }
    return distinct;
}

static void put_times(packer *p, const size_t *times, size_t distinct) {
    for (size_t k = 0, from = 0; k < distinct; from = k) {
        while (k < distinct && times[k] == times[from]) k++;
        put_whole(p, times[from]);
        put_whole(p, k - from);
    }
}

static void put_knots(packer *p, const plan *l, const double *points, const double *knots,
                      const size_t *times) {
    double knot = 0, rate = 0, length = 0;
    for (size_t k = 0, at = 0; k < l->distinct; at += times[k++]) {
        put_number(p, knots[at], k == 0 ? 0 : foresee(l, points, k, knot, rate, &length));
        if (length > 0) rate = (knots[at] - knot) / length;
        knot = knots[at];
    }
}

void bat_curve_pack(const bat_curve *curve, bat_text *text) {
    const size_t dimension = (size_t)bat_curve_dimension(curve), count = bat_curve_count(curve),
                 degree = (size_t)bat_curve_degree(curve), knot_count = (size_t)bat_curve_knot_count(curve);
    const double *points = bat_curve_points(curve), *knots = bat_curve_knots(curve);
    const int decimals = decimals_of(points, count * dimension);
    packer p = {.step = steps[decimals]};
    plan l = {0};
    size_t *times = calloc(knot_count, sizeof *times);
    const size_t distinct = times ? count_knots(knots, knot_count, times) : 0;
    if (!times ||
        make_plan(degree, bat_curve_is_closed(curve), count, dimension, distinct, times, &l) != BAT_OK) {
        free(times);
        text->failed = true;
        return;
    }
    put_whole(&p, dimension);
    put_whole(&p, (uint64_t)decimals);
    put_whole(&p, count);
    put_times(&p, times, distinct);
    put_points(&p, &l, points);
    put_knots(&p, &l, points, knots, times);
    bat_text_string(text, "\"");
    bat_base64_write(text, p.bytes.data, p.bytes.size);
    bat_text_string(text, "\"");
    text->failed = text->failed || p.bytes.failed;
    bat_text_free(&p.bytes);
    free_plan(&l);
    free(times);
}

/* ---- reading ---- */

typedef struct unpacker {
    const unsigned char *at, *end;
    double step;
    uint64_t run;
    bool bad;
} unpacker;

static uint64_t take_whole(unpacker *u) {
    uint64_t whole = 0;
    for (int shift = 0; shift < 64; shift += 7) {
        if (u->at == u->end) break;
        const unsigned char byte = *u->at++;
        whole |= (uint64_t)(byte & 127) << shift;
        if (byte < 128) return whole;
    }
    u->bad = true;
    return 0;
}

static double take_bits(unpacker *u) {
    uint64_t bits = 0;
    double number;
    if (u->end - u->at < 8) {
        u->bad = true;
        return 0;
    }
    for (int k = 7; k >= 0; k--) bits = bits << 8 | u->at[k];
    u->at += 8;
    memcpy(&number, &bits, sizeof number);
    return number;
}

/* What a number is that was written so. */
static double make_number(unpacker *u, uint64_t written, double foreseen) {
    double number = 0;
    if ((written & 3) == DOUBLES)
        number = at_rank((int64_t)((uint64_t)rank(foreseen) + unfold(written >> 2)));
    else if ((written & 3) == DECIMALS)
        number = (step_of(foreseen, u->step) + (double)(int64_t)unfold(written >> 2)) / u->step;
    else if (written == BITS)
        number = take_bits(u);
    else
        u->bad = true;
    u->bad = u->bad || !isfinite(number);
    return u->bad ? 0 : number;
}

static double take_number(unpacker *u, double foreseen) { return make_number(u, take_whole(u), foreseen); }

static double take_foreseen(unpacker *u, double foreseen) {
    if (u->run == 0) {
        const uint64_t written = take_whole(u);
        if ((written & 3) != RUN) return make_number(u, written, foreseen);
        u->run = written >> 2;
        u->bad = u->bad || u->run == 0;
    }
    u->run -= u->run > 0;
    return foreseen;
}

static void take_points(unpacker *u, const plan *l, double *points) {
    const double nothing[BAT_DIMENSION_MAX] = {0}, *last = nothing;
    const size_t d = l->dimension;
    for (size_t i = 0; i < l->count && !u->bad; i++) {
        if (!l->plain[i]) continue;
        for (size_t c = 0; c < d; c++) points[i * d + c] = take_number(u, last[c]);
        last = points + i * d;
    }
    between b;
    for (size_t at = 0; !u->bad && next_between(l, at, &b); at = b.to)
        for (size_t k = b.from + 1; k % l->count != b.to % l->count; k++)
            for (size_t c = 0; c < d; c++)
                points[k % l->count * d + c] = take_foreseen(
                    u, on_line(points[b.from * d + c], points[b.to % l->count * d + c], k - b.from, b.size));
    u->bad = u->bad || u->run > 0;
}

static size_t take_times(unpacker *u, size_t count, size_t *times) {
    size_t distinct = 0;
    for (size_t left = count; left > 0 && !u->bad;) {
        const uint64_t often = take_whole(u), same = take_whole(u);
        u->bad = u->bad || often == 0 || same == 0 || often > left || same > left / often;
        for (uint64_t k = 0; k < same && !u->bad; k++) times[distinct++] = (size_t)often;
        if (!u->bad) left -= (size_t)(often * same);
    }
    return distinct;
}

static void take_knots(unpacker *u, const plan *l, const double *points, const size_t *times, double *knots) {
    double knot = 0, rate = 0, length = 0;
    for (size_t k = 0; k < l->distinct && !u->bad; k++) {
        const double now = take_number(u, k == 0 ? 0 : foresee(l, points, k, knot, rate, &length));
        if (length > 0) rate = (now - knot) / length;
        knot = now;
        for (size_t i = 0; i < times[k]; i++) *knots++ = now;
    }
}

/* points: room for the points and, behind them, for `knot_count` knots; times: for as many. */
static bat_status take_numbers(unpacker *u, plan l, size_t knot_count, double *points, size_t *times,
                               bat_curve **out) {
    const size_t distinct = take_times(u, knot_count, times);
    double *knots = points + l.count * l.dimension;
    if (u->bad) return BAT_SYNTAX;
    bat_status status = make_plan(l.degree, l.closed, l.count, l.dimension, distinct, times, &l);
    if (status != BAT_OK) return status;
    take_points(u, &l, points);
    if (!u->bad) take_knots(u, &l, points, times, knots);
    free_plan(&l);
    if (u->bad || u->at != u->end) return BAT_SYNTAX;
    return bat_curve_create((int)l.dimension, (int)l.degree, l.closed, l.count, points, (int)knot_count,
                            knots, out);
}

static bat_status take_curve(unpacker *u, int degree, bool closed, bat_curve **out) {
    const uint64_t dimension = take_whole(u), decimals = take_whole(u), count = take_whole(u);
    const uint64_t left = (uint64_t)(u->end - u->at);
    if (u->bad || (dimension != 2 && dimension != 3) || decimals > FINEST || count > BAT_POINTS_MAX ||
        count < (closed ? 2 : (uint64_t)degree + 1))
        return BAT_SYNTAX;
    /* Each end of a span takes a byte for each of its numbers: more points than that allows are none. */
    if (count * dimension > left * (uint64_t)degree) return BAT_SYNTAX;
    const size_t knot_count = (size_t)count + (closed ? 1 : (size_t)degree + 1);
    double *points = calloc((size_t)(count * dimension) + knot_count, sizeof *points);
    size_t *times = calloc(knot_count, sizeof *times);
    u->step = steps[decimals];
    const plan l = {(size_t)degree, (size_t)count, (size_t)dimension, 0, closed, NULL, NULL};
    const bat_status status = points && times ? take_numbers(u, l, knot_count, points, times, out)
                                              : BAT_MEMORY;
    free(points);
    free(times);
    return status;
}

bat_status bat_curve_unpack(const char *text, int degree, bool closed, bat_curve **out) {
    if (degree < 1 || degree > BAT_DEGREE_MAX) return BAT_DEGREE;
    const size_t size = strlen(text);
    unsigned char *bytes = malloc(size + 4);
    size_t made = 0;
    if (!bytes) return BAT_MEMORY;
    bat_status status = bat_base64_read(text, size, bytes, &made);
    unpacker u = {.at = bytes, .end = bytes + made};
    if (status == BAT_OK) status = take_curve(&u, degree, closed, out);
    free(bytes);
    return status;
}
