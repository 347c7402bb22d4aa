/* Arc length along a path, tabulated (docs/math/camera.md, math 4). */
#include "form/camera/pace.h"

#include "base/bisect.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

static const double precision = 1e-13;
enum { DEPTH = 40, CELLS_MOST = 1 << 22 };

void bat_pace_clear(bat_pace *pace) {
    free(pace->hodographs), free(pace->cells), free(pace->lengths);
    *pace = (bat_pace){.count = 0};
}

/* Appends a cell from u on that is so long. */
static bat_status append(bat_pace *pace, size_t span, double u, double length) {
    if (pace->count + 2 > pace->room) {
        const size_t room = pace->room > 0 ? 2 * pace->room : 64;
        bat_pace_cell *cells = room <= CELLS_MOST ? realloc(pace->cells, room * sizeof *cells) : NULL;
        if (cells) pace->cells = cells;
        double *lengths = cells ? realloc(pace->lengths, room * sizeof *lengths) : NULL;
        if (!lengths) return BAT_MEMORY;
        pace->lengths = lengths, pace->room = room;
    }
    const size_t i = pace->count++;
    if (i == 0) pace->lengths[0] = 0;
    pace->cells[i] = (bat_pace_cell){span, u};
    pace->lengths[i + 1] = pace->lengths[i] + length;
    return BAT_OK;
}

/* Halves a..b until two halves agree with the whole. */
static bat_status divide(bat_pace *pace, size_t span, double a, double b, double whole, int depth) {
    const bat_hodograph *h = &pace->hodographs[span];
    const double middle = 0.5 * (a + b);
    const double left = bat_hodograph_gauss(h, a, middle), right = bat_hodograph_gauss(h, middle, b);
    const double gap = fabs(left + right - whole);
    if (depth == 0 || !(middle > a && middle < b) ||
        !(gap > precision * (left + right) && gap > (h->density + h->noise) * (b - a)))
        return append(pace, span, a, h->scale * (left + right));
    const bat_status status = divide(pace, span, a, middle, left, depth - 1);
    return status == BAT_OK ? divide(pace, span, middle, b, right, depth - 1) : status;
}

bat_status bat_pace_make(const bat_curve *path, bat_pace *out) {
    const double *t = path->knots;
    const double density = bat_hodograph_density(path, precision);
    *out = (bat_pace){.count = 0};
    out->hodographs = malloc((size_t)path->spread * sizeof *out->hodographs);
    if (!out->hodographs) return BAT_MEMORY;
    bat_status status = BAT_OK;
    for (int i = path->degree; i < path->spread && status == BAT_OK; i++) {
        if (!(t[i + 1] > t[i])) continue;
        bat_hodograph *h = &out->hodographs[out->spans];
        bat_hodograph_of(path, i - path->degree, density, h);
        status = divide(out, out->spans++, t[i], t[i + 1], bat_hodograph_gauss(h, t[i], t[i + 1]), DEPTH);
    }
    if (status == BAT_OK) out->cells[out->count] = (bat_pace_cell){out->spans - 1, t[path->spread]};
    return status;
}

double bat_pace_length(const bat_pace *pace) { return pace->lengths[pace->count]; }

/* Newton's steps, bracketed, so that halving takes over where the path stands still. */
double bat_pace_at(const bat_pace *pace, double length) {
    if (!(length > 0)) return pace->cells[0].u;
    if (length >= pace->lengths[pace->count]) return pace->cells[pace->count].u;
    const size_t i = bat_bisect(pace->lengths, pace->count + 1, length);
    const bat_hodograph *h = &pace->hodographs[pace->cells[i].span];
    const double a = pace->cells[i].u, all = pace->lengths[i + 1] - pace->lengths[i];
    const double wanted = (length - pace->lengths[i]) / h->scale, near = 4 * DBL_EPSILON * all / h->scale;
    double low = a, high = pace->cells[i + 1].u, u = a + (high - a) * ((length - pace->lengths[i]) / all);
    for (int step = 0; step < 100; step++) {
        if (!(u > low && u < high)) u = 0.5 * (low + high);
        if (!(u > low && u < high)) break;
        const double miss = wanted - bat_hodograph_gauss(h, a, u);
        if (fabs(miss) <= near) break;
        if (miss > 0)
            low = u;
        else
            high = u;
        const double speed = bat_hodograph_speed(h, u);
        if (fabs(miss) <= DBL_EPSILON * fabs(u) * speed) break; /* no number is nearer */
        u = speed > 0 ? u + miss / speed : high;
    }
    return u;
}

double bat_pace_until(const bat_pace *pace, double u) {
    size_t low = 0, high = pace->count;
    if (u >= pace->cells[high].u) return pace->lengths[high];
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (pace->cells[middle].u <= u)
            low = middle;
        else
            high = middle;
    }
    const bat_hodograph *h = &pace->hodographs[pace->cells[low].span];
    return pace->lengths[low] +
           h->scale * bat_hodograph_gauss(h, pace->cells[low].u, fmax(u, pace->cells[low].u));
}
