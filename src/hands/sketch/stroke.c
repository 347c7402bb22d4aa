#include "hands/sketch/stroke.h"
#include "hands/sketch/corners.h"
#include "hands/sketch/landing.h"
#include "hands/sketch/whittaker.h"
#include "base/order.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES_MAX = 6000, CORNERS_MAX = 1500, SMOOTH_MAX = 16384 };
/* While the pen is down: the last samples, which follow what is known better as more come; samples that are smoothed again
 * before them, samples that the noise is judged by, and how finely the whole is resampled. */
enum { LIVE_LOOSE = 256, LIVE_OVERLAP = 96, LIVE_NOISE = 256, LIVE_SAMPLES = 1500 };
static const double loose = 0.25; /* px that shown samples move by at most */
static const double sparse = 4;   /* px between samples, from which on they are few */
/* Of the grain: where an end goes on, it bends as twice so much of it does. */
static const double bend_share = 0.08;
static const double dot_length = 8, noise_cap = 1.5, noise_floor = 0.05;
/* A drawing of this grain (px) has the whole tolerance; a smaller one has its share of it, at least this. */
static const double full_grain = 50, least_share = 0.3, most_grain = 200;

/* Finite samples in pixels, repeats dropped; far too dense strokes averaged in groups. pressure: of each sample that is
 * left, where it is not NULL; behind them, from stroke->count on, their times. */
static size_t gather(const bat_stroke *stroke, const bat_clean_options *o, double *y, double *pressure) {
    const size_t m = (size_t)stroke->dimension;
    size_t count = 0;
    for (size_t i = 0; i < stroke->count; i++) {
        double *p = y + count * m;
        bool finite = true;
        for (size_t c = 0; c < m; c++) {
            p[c] = (stroke->points[i * m + c] - o->origin[c]) * o->scale;
            finite = finite && fabs(p[c]) < 1e100;
        }
        if (!finite || (count > 0 && bat_path_distance(p, p - m, m) <= 1e-9)) continue;
        if (pressure) {
            pressure[count] = isfinite(stroke->pressure[i]) ? stroke->pressure[i] : 0;
            pressure[stroke->count + count] = stroke->time ? stroke->time[i] : 0;
        }
        count++;
    }
    if (count <= SMOOTH_MAX) return count;
    double length = 0;
    for (size_t i = 1; i < count; i++) length += bat_path_distance(y + i * m, y + (i - 1) * m, m);
    const double room = 2 / (length / (double)count); /* samples in two pixels of path */
    size_t group = (count + SMOOTH_MAX - 1) / SMOOTH_MAX;
    if (room < (double)group) group = room > 1 ? (size_t)room : 1;
    if (group < 2) return count;
    size_t kept = 1; /* both ends stay where they are */
    for (size_t i = 1; i + 1 < count; i += group) {
        const size_t end = i + group < count - 1 ? i + group : count - 1;
        double sum[BAT_DIMENSION_MAX] = {0};
        for (size_t j = i; j < end; j++)
            for (size_t c = 0; c < m; c++) sum[c] += y[j * m + c];
        for (size_t c = 0; c < m; c++) y[kept * m + c] = sum[c] / (double)(end - i);
        kept++;
    }
    memmove(y + kept * m, y + (count - 1) * m, m * sizeof *y);
    return kept + 1;
}

void bat_clean_free(bat_clean *clean) {
    free(clean->points);
    free(clean->arc);
    free(clean->corners);
    memset(clean, 0, sizeof *clean);
}

/* Resamples the smooth points evenly between the corners. */
static bat_status resample(const double *z, const double *arc, size_t count, size_t m, size_t raw,
                           const size_t *corners, size_t corner_count, double tolerance, size_t most,
                           bat_clean *out) {
    const double total = arc[count - 1];
    double step = total / (double)(raw > 1 ? raw - 1 : 1);
    step = fmax(fmin(step, fmax(2, 0.5 * tolerance)), fmin(0.5 * tolerance, 2));
    step = fmax(step, total / (double)most);
    const size_t room = (size_t)ceil(total / step) + corner_count + 8;
    out->points = malloc(room * m * sizeof *out->points);
    out->arc = malloc(room * sizeof *out->arc);
    out->corners = malloc((corner_count + 1) * sizeof *out->corners);
    if (!out->points || !out->arc || !out->corners) return BAT_MEMORY;
    const bat_stroke_path path = {z, arc, count, m};
    size_t n = 0;
    for (size_t k = 0; k <= corner_count; k++) {
        const double from = k == 0 ? 0 : arc[corners[k - 1]],
                     to = k == corner_count ? total : arc[corners[k]];
        size_t pieces = (size_t)ceil((to - from) / step);
        if (pieces < 1) pieces = 1;
        if (k == 0 && corner_count == 0 && pieces < 4) pieces = 4;
        for (size_t i = k == 0 ? 0 : 1; i <= pieces; i++)
            bat_path_at(&path, from + (to - from) * (double)i / (double)pieces, out->points + n++ * m);
        if (k < corner_count) out->corners[out->corner_count++] = n - 1;
    }
    out->count = n;
    bat_path_measure(out->points, n, m, out->arc);
    out->length = out->arc[n - 1];
    return BAT_OK;
}

/* Smooths each piece between corners by itself; a corner stays where the samples put it. */
static bat_status smooth_pieces(const double *y, size_t count, size_t m, double lambda, const size_t *corners,
                                size_t corner_count, double *work, double *z) {
    for (size_t k = 0; k <= corner_count; k++) {
        const size_t from = k == 0 ? 0 : corners[k - 1], to = k == corner_count ? count - 1 : corners[k];
        double *weight = work + count * 4;
        for (size_t i = from; i <= to; i++) weight[i - from] = 1;
        if (k > 0) weight[0] = 1e3;
        if (k < corner_count) weight[to - from] = 1e3;
        bat_status status = bat_whittaker(to - from + 1, (int)m, y + from * m, weight, lambda, work,
                                          z + from * m);
        if (status != BAT_OK) return status;
        if (k > 0) memcpy(z + from * m, y + from * m, m * sizeof *z);
    }
    return BAT_OK;
}

/* The filter over samples first.. of y; settled samples are taken from the memory, except for a stretch that
 * the rest depends on, so that a preview costs only what is new. */
static bat_status smooth_rest(const bat_clean_memory *memory, const double *y, size_t first, size_t count,
                              size_t m, double sigma, double *work, double *z, double *lambda) {
    size_t done = 0;
    if (memory && memory->fixed > first + LIVE_OVERLAP) done = memory->fixed - first - LIVE_OVERLAP;
    if (done + 16 > count) done = count > 16 ? count - 16 : 0;
    if (done > 0) memcpy(z, memory->points + first * m, done * m * sizeof *z);
    return bat_whittaker_sigma(count - done, (int)m, y + (first + done) * m, sigma, work, z + done * m,
                               lambda);
}

static bool make_room(bat_clean_memory *memory, size_t count, size_t m) {
    if (count <= memory->room) return true;
    const size_t room = 2 * count + 64;
    double *points = realloc(memory->points, room * m * sizeof *points);
    if (!points) return false;
    memory->points = points, memory->room = room;
    return true;
}

/* Brings p back to where it was shown, or as near to it as it may move. */
static void bring_back(double *p, const double *shown, size_t m, bool fixed) {
    const double way = bat_path_distance(p, shown, m), part = fixed ? 0 : way > loose ? loose / way : 1;
    for (size_t c = 0; c < m; c++) p[c] = shown[c] + part * (p[c] - shown[c]);
}

/* Puts samples back where they were shown, fades the difference out behind them, and remembers more. z[0] is sample
 * `first` of the stroke. */
static bat_status remember(bat_clean_memory *memory, double *z, size_t first, size_t count, size_t m) {
    enum { FADE = 16 };
    const size_t total = first + count;
    double step[BAT_DIMENSION_MAX] = {0};
    for (size_t i = first; i < total; i++) {
        double *p = z + (i - first) * m;
        if (i < memory->count) {
            memcpy(step, p, m * sizeof *step);
            bring_back(p, memory->points + i * m, m, i < memory->fixed);
            for (size_t c = 0; c < m; c++) step[c] = p[c] - step[c];
        } else if (i < memory->count + FADE) {
            const double f = (double)(i - memory->count + 1) / (FADE + 1);
            const double fade = 1 - f * f * (3 - 2 * f);
            for (size_t c = 0; c < m; c++) p[c] += fade * step[c];
        }
    }
    const size_t shown = total > memory->fresh ? total - memory->fresh : 0;
    const size_t fixed = shown > LIVE_LOOSE ? shown - LIVE_LOOSE : 0;
    if (shown <= memory->count) return BAT_OK;
    if (!make_room(memory, shown, m)) return BAT_MEMORY;
    for (size_t i = memory->fixed; i < shown; i++) {
        if (i >= fixed && i < memory->count) continue;
        /* A hook that was cut off keeps a place, never used again. */
        const size_t from = i < first ? 0 : i - first;
        memcpy(memory->points + i * m, z + from * m, m * sizeof *z);
    }
    memory->count = shown, memory->fixed = fixed > memory->fixed ? fixed : memory->fixed;
    return BAT_OK;
}

/* A stroke being cleaned: y is as it was drawn, light is hardly smoothed, z is smoothed; samples first ..
 * first + count - 1 are left of it. */
typedef struct cleaning {
    const bat_clean_options *options;
    bat_clean_memory *memory;
    int dimension;
    size_t m, count, first, corner_count;
    size_t *corners;
    double sigma, lambda; /* noise; the weight of the smoothing, 0: none */
    double grain;
    double *y, *light, *z, *work, *arc;
    size_t landed[2]; /* samples that were taken away at its start and end, as the pen landed and left */
    double usual;     /* pressure that half of the samples are below; 0: not known */
    double *pressure, *time; /* of each sample, in one block; NULL: not known */
} cleaning;

static void cleaning_free(cleaning *k) {
    free(k->y);
    free(k->z);
    free(k->corners);
    free(k->pressure);
}

static bat_status cleaning_make(const bat_stroke *stroke, const bat_clean_options *o, cleaning *k) {
    const size_t m = (size_t)stroke->dimension;
    *k = (cleaning){.options = o, .dimension = stroke->dimension, .m = m};
    /* Far too dense strokes are averaged in groups that change with the count: nothing to remember then. */
    k->memory = stroke->count <= SMOOTH_MAX ? o->memory : NULL;
    if (stroke->count < 2) return BAT_DOT;
    k->y = malloc(stroke->count * m * sizeof *k->y);
    if (!k->y) return BAT_MEMORY;
    if (stroke->pressure && stroke->count <= SMOOTH_MAX) {
        k->pressure = malloc(2 * stroke->count * sizeof *k->pressure);
        if (!k->pressure) return BAT_MEMORY;
        k->time = k->pressure + stroke->count;
    }
    k->count = gather(stroke, o, k->y, k->pressure);
    if (k->count < 2) return BAT_DOT;
    k->z = malloc(k->count * (2 * m + 6) * sizeof *k->z);
    k->corners = malloc(k->count * sizeof *k->corners);
    if (!k->z || !k->corners) return BAT_MEMORY;
    k->light = k->z + k->count * m, k->work = k->light + k->count * m, k->arc = k->work + k->count * 5;
    return BAT_OK;
}

static bool noisy(const cleaning *k) { return k->sigma >= noise_floor && k->count >= 16; }

static void judge_grain(cleaning *k) {
    const double *light = k->light + k->first * k->m;
    bat_path_measure(light, k->count, k->m, k->arc);
    k->grain = bat_path_grain(&(bat_stroke_path){light, k->arc, k->count, k->m}, k->sigma, most_grain);
}

/* Without the worst of the noise the size of what is drawn shows, and so do corners, which the full smoothing
 * rounds off. */
static bat_status look(cleaning *k) {
    bat_status status = BAT_OK;
    memcpy(k->light, k->y, k->count * k->m * sizeof *k->light);
    if (noisy(k)) status = bat_whittaker(k->count, k->dimension, k->y, NULL, 2, k->work, k->light);
    if (status == BAT_OK) judge_grain(k);
    return status;
}

/* Takes away what the pen drew while it landed and left, where that is no part of the stroke. */
static void cut_landings(cleaning *k) {
    if (!k->pressure) return;
    k->usual = bat_middle(k->pressure, k->count);
    if (k->count < 16 || k->arc[k->count - 1] < dot_length) return;
    const bat_stroke_path path = {k->light, k->arc, k->count, k->m};
    const bat_press press = {k->pressure, k->time, k->usual};
    const size_t head = bat_landing(&path, &press, false), tail = bat_landing(&path, &press, true);
    if (head + tail == 0 || head + tail + 8 > k->count) return;
    k->landed[0] = head, k->landed[1] = tail;
    k->first += head, k->count -= head + tail;
    judge_grain(k);
}

static void judge_noise(cleaning *k) {
    const size_t judged = k->memory && k->count > LIVE_NOISE ? LIVE_NOISE : k->count;
    k->sigma = fmin(bat_noise(judged, k->dimension, k->y + (k->count - judged) * k->m, k->work), noise_cap);
}

/* Where samples are few, what lies between the hook and the next one is no hook: sample i goes to where it begins. */
static void begin_at(cleaning *k, const bat_stroke_path *path, size_t i, double s) {
    double x[BAT_DIMENSION_MAX];
    bat_path_at(path, s, x);
    memcpy(k->y + (k->first + i) * k->m, x, k->m * sizeof *x);
}

/* The length of a hook at that end; 0 where the pen pressed as usual in its first half: then it is meant. */
static double hook_at(const cleaning *k, const bat_stroke_path *path, bool at_end) {
    const double hook = bat_hook(path, k->grain, at_end), total = k->arc[k->count - 1];
    for (size_t n = 0; n < k->count && k->pressure && k->usual > 0; n++) {
        const size_t i = at_end ? k->count - 1 - n : n;
        if ((at_end ? total - k->arc[i] : k->arc[i]) > 0.5 * hook) break;
        if (k->pressure[k->first + i] >= 0.75 * k->usual) return 0;
    }
    return hook;
}

/* False: there is none, or nothing that could have one. */
static bool cut_hooks(cleaning *k) {
    const double total = k->arc[k->count - 1];
    if (total < dot_length) return false;
    const bat_stroke_path path = {k->z, k->arc, k->count, k->m};
    const double head = hook_at(k, &path, false), tail = hook_at(k, &path, true);
    if (head <= 0 && tail <= 0) return false;
    const size_t whole = k->count;
    while (k->count > 4 && k->arc[k->count - 1] > total - tail) k->count--;
    if (k->count < whole && total - tail - k->arc[k->count - 1] > sparse)
        begin_at(k, &path, k->count++, total - tail);
    size_t drop = 0;
    while (drop + 4 < k->count && k->arc[drop] < head) drop++;
    if (drop > 0 && k->arc[drop] - head > sparse) begin_at(k, &path, --drop, head);
    if (drop > 0) k->landed[0] = 0;
    if (k->count < whole) k->landed[1] = 0;
    k->first += drop, k->count -= drop;
    return true;
}

static bat_status smooth_once(cleaning *k) {
    bat_status status = BAT_OK;
    k->lambda = 0;
    memcpy(k->z, k->y + k->first * k->m, k->count * k->m * sizeof *k->z);
    if (noisy(k))
        status = smooth_rest(k->memory, k->y, k->first, k->count, k->m, k->sigma, k->work, k->z, &k->lambda);
    bat_path_measure(k->z, k->count, k->m, k->arc);
    return status;
}

/* Hooks are found in the smoothed stroke and must not bend what follows them: then it is smoothed afresh. */
static bat_status smooth_without_hooks(cleaning *k) {
    bat_status status = smooth_once(k);
    if (status == BAT_OK && cut_hooks(k)) status = smooth_once(k);
    if (status == BAT_OK && k->memory && k->count > 1) {
        status = remember(k->memory, k->z, k->first, k->count, k->m);
        bat_path_measure(k->z, k->count, k->m, k->arc);
    }
    return status;
}

/* Too short; or a resting pen, which trembles along a path of any length but stays in one place. */
static bool is_dot(const cleaning *k) {
    const size_t m = k->m;
    double low[BAT_DIMENSION_MAX], high[BAT_DIMENSION_MAX];
    memcpy(low, k->z, m * sizeof *low);
    memcpy(high, k->z, m * sizeof *high);
    for (size_t i = 0; i < k->count; i++)
        for (size_t c = 0; c < m; c++) {
            low[c] = fmin(low[c], k->z[i * m + c]);
            high[c] = fmax(high[c], k->z[i * m + c]);
        }
    return k->arc[k->count - 1] < dot_length || bat_path_distance(low, high, m) < fmax(4, 5 * k->sigma);
}

/* What lies between corners is smoothed by itself. */
static bat_status keep_corners(cleaning *k) {
    const size_t m = k->m, count = k->count;
    const double *light = k->light + k->first * m;
    bat_path_measure(light, count, m, k->arc);
    k->corner_count = bat_corners(&(bat_stroke_path){light, k->arc, count, m}, k->sigma, k->grain,
                                  CORNERS_MAX, k->corners);
    bat_status status = BAT_OK;
    if (k->corner_count > 0 && k->lambda > 0)
        status = smooth_pieces(k->y + k->first * m, count, m, k->lambda, k->corners, k->corner_count, k->work,
                               k->z);
    bat_path_measure(k->z, count, m, k->arc);
    return status;
}

/* What of a hook led on along the stroke belongs to it, but for its way to the side. */
static void lead_on(cleaning *k, bool at_end) {
    const size_t m = k->m, count = k->landed[at_end];
    const double *landed = k->y + (at_end ? k->first + k->count : k->first - count) * m;
    double *z = at_end ? k->z + k->count * m : k->z, straight = k->arc[k->count - 1];
    if (k->corner_count > 0)
        straight = at_end ? straight - k->arc[k->corners[k->corner_count - 1]] : k->arc[k->corners[0]];
    const bat_stroke_path path = {k->z, k->arc, k->count, m};
    const bat_landed led = {landed, count, fmin(bend_share * k->grain, 0.5 * straight)};
    if (count == 0 || !bat_lead_on(&path, &led, at_end, k->work)) return;
    if (!at_end) {
        memmove(k->z + count * m, k->z, k->count * m * sizeof *k->z);
        for (size_t i = 0; i < k->corner_count; i++) k->corners[i] += count;
    }
    memcpy(z, k->work, count * m * sizeof *z);
    k->count += count;
    bat_path_measure(k->z, k->count, m, k->arc);
}

/* Of small things the whole tolerance would leave little. */
static double share_of_tolerance(const cleaning *k) {
    const double size = fmin(k->grain, 2 * k->arc[k->count - 1]);
    return fmin(1, fmax(size / full_grain, fmax(2 * k->sigma, least_share)));
}

bat_status bat_clean_stroke(const bat_stroke *stroke, const bat_clean_options *o, bat_clean *out) {
    cleaning k;
    memset(out, 0, sizeof *out);
    out->dimension = stroke->dimension;
    bat_status status = cleaning_make(stroke, o, &k);
    if (status == BAT_OK) {
        judge_noise(&k);
        out->sigma = k.sigma;
        status = look(&k);
        if (status == BAT_OK) cut_landings(&k);
        if (status == BAT_OK) status = smooth_without_hooks(&k);
        if (status == BAT_OK) out->share = share_of_tolerance(&k), out->grain = k.grain;
    }
    if (status == BAT_OK && is_dot(&k)) status = BAT_DOT;
    if (status == BAT_OK && o->corners) status = keep_corners(&k);
    if (status == BAT_OK) lead_on(&k, true), lead_on(&k, false);
    if (status == BAT_OK)
        status = resample(k.z, k.arc, k.count, k.m, k.count, k.corners, k.corner_count,
                          out->share * o->tolerance, o->memory ? LIVE_SAMPLES : SAMPLES_MAX, out);
    cleaning_free(&k);
    if (status != BAT_OK) {
        const double sigma = out->sigma;
        bat_clean_free(out);
        out->sigma = sigma;
    }
    return status;
}

void bat_clean_reverse(bat_clean *clean) {
    const size_t m = (size_t)clean->dimension;
    for (size_t i = 0, j = clean->count - 1; i < j; i++, j--)
        for (size_t c = 0; c < m; c++) {
            const double swap = clean->points[i * m + c];
            clean->points[i * m + c] = clean->points[j * m + c];
            clean->points[j * m + c] = swap;
        }
    for (size_t i = 0; i < clean->corner_count; i++) clean->corners[i] = clean->count - 1 - clean->corners[i];
    for (size_t i = 0, j = clean->corner_count; i + 1 < j; i++) {
        const size_t swap = clean->corners[i];
        clean->corners[i] = clean->corners[--j];
        clean->corners[j] = swap;
    }
    bat_path_measure(clean->points, clean->count, m, clean->arc);
    clean->length = clean->arc[clean->count - 1]; /* to the last bit: what lies beyond it is left out */
}

void bat_clean_at(const bat_clean *clean, double s, double *point) {
    const bat_stroke_path path = {clean->points, clean->arc, clean->count, (size_t)clean->dimension};
    bat_path_at(&path, s, point);
}

void bat_clean_frame(const bat_clean *clean, double s, double window, double *point, double *direction,
                     double *curvature) {
    const size_t m = (size_t)clean->dimension;
    double from = s - 0.5 * window, to = s + 0.5 * window;
    if (from < 0) to = fmin(to - from, clean->length), from = 0;
    if (to > clean->length) from = fmax(0, from - (to - clean->length)), to = clean->length;
    /* Least squares of a + b t + c t^2, t = (arc - s) / window, at 17 even places: equal weights will do. */
    double A[3][3] = {{0}}, b[3][BAT_DIMENSION_MAX] = {{0}};
    const double width = fmax(to - from, 1e-6);
    for (int i = 0; i <= 16; i++) {
        const double where = from + width * i / 16, t = (where - s) / width;
        double p[BAT_DIMENSION_MAX];
        bat_clean_at(clean, where, p);
        const double f[3] = {1, t, t * t};
        for (int r = 0; r < 3; r++) {
            for (int k = 0; k < 3; k++) A[r][k] += f[r] * f[k];
            for (size_t c = 0; c < m; c++) b[r][c] += f[r] * p[c];
        }
    }
    for (int k = 0; k < 3; k++) /* positive definite: no pivoting */
        for (int r = k + 1; r < 3; r++) {
            const double f = A[r][k] / A[k][k];
            for (int j = k; j < 3; j++) A[r][j] -= f * A[k][j];
            for (size_t c = 0; c < m; c++) b[r][c] -= f * b[k][c];
        }
    for (int k = 2; k >= 0; k--)
        for (size_t c = 0; c < m; c++) {
            for (int j = k + 1; j < 3; j++) b[k][c] -= A[k][j] * b[j][c];
            b[k][c] /= A[k][k];
        }
    double speed = 0, along = 0;
    for (size_t c = 0; c < m; c++) speed += b[1][c] * b[1][c];
    speed = sqrt(speed);
    if (point) bat_clean_at(clean, s, point);
    for (size_t c = 0; c < m; c++) direction[c] = speed > 0 ? b[1][c] / speed : (c == 0);
    if (!curvature) return;
    for (size_t c = 0; c < m; c++) along += 2 * b[2][c] * direction[c];
    for (size_t c = 0; c < m; c++)
        curvature[c] = speed > 1e-9 ? (2 * b[2][c] - along * direction[c]) / (speed * speed) : 0;
}

double bat_clean_turning(const bat_clean *clean) {
    const size_t m = (size_t)clean->dimension;
    const double step = fmax(4, clean->length / 400);
    double sum = 0;
    for (double s = step; s + step <= clean->length; s += step) {
        double a[BAT_DIMENSION_MAX], b[BAT_DIMENSION_MAX], c[BAT_DIMENSION_MAX];
        bat_clean_at(clean, s - step, a);
        bat_clean_at(clean, s, b);
        bat_clean_at(clean, s + step, c);
        sum += bat_path_turn(a, b, c, m);
    }
    return sum;
}

void bat_clean_cut(bat_clean *clean, size_t first, size_t last) {
    const size_t m = (size_t)clean->dimension, n = last - first + 1;
    memmove(clean->points, clean->points + first * m, n * m * sizeof *clean->points);
    size_t kept = 0;
    for (size_t i = 0; i < clean->corner_count; i++)
        if (clean->corners[i] > first && clean->corners[i] < last)
            clean->corners[kept++] = clean->corners[i] - first;
    clean->corner_count = kept;
    clean->count = n;
    bat_path_measure(clean->points, n, m, clean->arc);
    clean->length = clean->arc[n - 1];
}

bool bat_clean_closes(const bat_clean *clean) {
    const size_t m = (size_t)clean->dimension;
    const double gap = bat_path_distance(clean->points, clean->points + (clean->count - 1) * m, m);
    return gap <= fmax(15 * clean->share, 0.04 * clean->length) && gap < 0.25 * clean->length &&
           bat_clean_turning(clean) > 1.5 * BAT_PI;
}
