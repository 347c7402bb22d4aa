/* Joins the pieces of tracks, cell by cell as they were found, to whole ones. */
#include "form/trace/contour.h"

#include <math.h>
#include <stdlib.h>

/* Ends this close are one, relative to the span; those that are nearly equal are joined first. */
static const double nearly[] = {1e-11, 1e-8, 3e-6};

typedef struct end {
    double at[2], slack[2]; /* parameters, and how wide the span is */
    int number;             /* of the piece, times 2, plus 1 at its end */
    int partner;            /* the number of the end it is joined to, or -1 */
} end;

static end end_of(const bat_tracks *pieces, const bat_surface *surface, int number) {
    const bat_track *track = &pieces->list[number / 2];
    const bat_track_point *p = &track->points[number % 2 ? track->count - 1 : 0];
    end e = {.number = number, .partner = -1};
    for (int d = 0; d < 2; d++) {
        const bat_curve *axis = &surface->axis[d];
        const double first = axis->knots[axis->degree], last = axis->knots[axis->spread];
        const int span = bat_span(axis, fmin(fmax(p->uv[d], first), last), -1);
        e.at[d] = p->uv[d];
        e.slack[d] = axis->knots[span + 1] - axis->knots[span];
        if (axis->closed && e.at[d] > last - 4e-6 * e.slack[d]) e.at[d] -= last - first;
    }
    return e;
}

static int by_place(const void *a, const void *b) {
    const end *p = a, *q = b;
    if (p->at[0] != q->at[0]) return p->at[0] < q->at[0] ? -1 : 1;
    return (p->number > q->number) - (p->number < q->number);
}

/* Joins each end to the nearest one that is still free; ends: sorted by u. */
static void pair(end *ends, int count, double slack) {
    for (int i = 0; i < count; i++) {
        if (ends[i].partner >= 0) continue;
        int best = -1;
        double least = INFINITY;
        for (int k = i + 1; k < count && ends[k].at[0] - ends[i].at[0] <= slack * ends[i].slack[0]; k++) {
            const double u = (ends[k].at[0] - ends[i].at[0]) / ends[i].slack[0];
            const double v = fabs(ends[k].at[1] - ends[i].at[1]) / ends[i].slack[1];
            if (ends[k].partner >= 0 || v > slack || u + v >= least) continue;
            if (ends[k].number / 2 == ends[i].number / 2 && slack > nearly[0]) continue;
            best = k, least = u + v;
        }
        if (best < 0) continue;
        ends[i].partner = ends[best].number, ends[best].partner = ends[i].number;
    }
}

/* Adds a piece from one of its ends to the other. */
static bat_status append(const bat_tracks *pieces, int from, bat_track *to) {
    const bat_track *piece = &pieces->list[from / 2];
    bat_status status = BAT_OK;
    for (size_t k = to->count > 0; k < piece->count && status == BAT_OK; k++)
        status = bat_track_add(to, &piece->points[from % 2 ? piece->count - 1 - k : k]);
    return status;
}

/* The whole track that begins at an end. A piece without length that meets itself is a point, and no track. */
static bat_status follow(const bat_tracks *pieces, const int *partner, bool *used, int from,
                         bat_tracks *out) {
    bat_track *track = bat_tracks_begin(out);
    if (!track) return BAT_MEMORY;
    bat_status status = BAT_OK;
    int at = from;
    while (status == BAT_OK && at >= 0 && !used[at / 2]) {
        used[at / 2] = true;
        status = append(pieces, at, track);
        at = partner[at ^ 1];
    }
    track->closed = at == from;
    if (track->closed && track->count < 3) bat_tracks_drop(out);
    return status;
}

bat_status bat_tracks_join(bat_tracks *pieces, const bat_surface *surface, bat_tracks *out) {
    const int count = 2 * (int)pieces->count;
    end *ends = malloc(((size_t)count + 1) * sizeof *ends);
    int *partner = malloc(((size_t)count + 1) * sizeof *partner);
    bool *used = calloc(pieces->count + 1, sizeof *used);
    bat_status status = ends && partner && used ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        for (int i = 0; i < count; i++) ends[i] = end_of(pieces, surface, i);
        qsort(ends, (size_t)count, sizeof *ends, by_place); /* no ties */
        for (size_t k = 0; k < sizeof nearly / sizeof nearly[0]; k++) pair(ends, count, nearly[k]);
        for (int i = 0; i < count; i++) partner[ends[i].number] = ends[i].partner;
        for (int i = 0; i < count && status == BAT_OK; i++)
            if (partner[i] < 0 && !used[i / 2]) status = follow(pieces, partner, used, i, out);
        for (int i = 0; i < count && status == BAT_OK; i++)
            if (!used[i / 2]) status = follow(pieces, partner, used, i, out);
        for (size_t i = 0; i < pieces->crossing_count && status == BAT_OK; i++)
            status = bat_tracks_cross(out, &pieces->crossings[i]);
    }
    free(ends);
    free(partner);
    free(used);
    return status;
}
