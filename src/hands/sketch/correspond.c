#include "hands/sketch/correspond.h"
#include "base/real.h"

#include <math.h>

enum { CANDIDATES = 6, PLACES = 24 };
static const double slack = 25;

typedef struct ends {
    double point[BAT_DIMENSION_MAX], direction[BAT_DIMENSION_MAX];
    bat_track_near near[CANDIDATES];
    double tangent[CANDIDATES][BAT_DIMENSION_MAX];
    int count;
    double trust; /* of the direction: little where the stroke ends far from the curve */
} ends;

static double product(const double *a, const double *b, size_t m) {
    double sum = 0;
    for (size_t c = 0; c < m; c++) sum += a[c] * b[c];
    return sum;
}

static void look(const bat_stroke_track *k, const bat_clean *stroke, double s, ends *e) {
    bat_clean_frame(stroke, s, 12, e->point, e->direction, NULL);
    e->count = bat_track_candidates(k, e->point, slack, CANDIDATES, e->near);
    for (int i = 0; i < e->count; i++) bat_track_tangent(k, bat_track_u(k, e->near[i].s), e->tangent[i]);
    const double far = fmax(40, 0.25 * stroke->length);
    e->trust = e->near[0].distance > far ? far / e->near[0].distance * 0.5 : 1;
}

bat_correspondence bat_correspond(const bat_stroke_track *k, const bat_clean *stroke, int sense) {
    const size_t m = (size_t)stroke->dimension;
    const double L = stroke->length, loop = k->length;
    const bool closed = k->curve->closed;
    ends a, b;
    look(k, stroke, 0, &a);
    look(k, stroke, L, &b);
    double h[PLACES + 1][BAT_DIMENSION_MAX];
    for (int i = 0; i <= PLACES; i++) bat_clean_at(stroke, L * i / PLACES, h[i]);

    bat_correspondence best = {.score = INFINITY};
    for (int i = 0; i < a.count; i++)
        for (int j = 0; j < b.count; j++)
            for (int way = 0; way < (closed ? 4 : 2); way++) {
                const double sign = way % 2 ? -1 : 1;
                if (sign * sense < 0) continue;
                double arc = (b.near[j].s - a.near[i].s) * sign; /* along the stroke's way */
                double loop_penalty = 0;
                if (closed) {
                    if (arc < 0) arc += loop;
                    if (way >= 2) {
                        if (arc > 0.25 * loop) continue;
                        arc += loop; /* all round and a little more */
                    }
                } else if (arc < 0) {
                    loop_penalty = 0.8 + 0.5 * fabs(arc) / (L + slack);
                }
                double apart = 0;
                for (int n = 0; n <= PLACES; n++) {
                    double y[BAT_DIMENSION_MAX], d = 0;
                    bat_stroke_track_point(k, a.near[i].s + sign * arc * n / PLACES, y);
                    for (size_t c = 0; c < m; c++) d += (y[c] - h[n][c]) * (y[c] - h[n][c]);
                    apart += sqrt(d);
                }
                apart /= PLACES + 1;
                const double J = (a.near[i].distance + b.near[j].distance) / slack +
                                 0.6 * (a.trust * (1 - sign * product(a.tangent[i], a.direction, m)) +
                                        b.trust * (1 - sign * product(b.tangent[j], b.direction, m))) +
                                 1.2 * apart / (L / 4 + slack) +
                                 0.35 * fabs(bat_log((fabs(arc) + slack) / (L + slack))) + loop_penalty;
                if (!(J < best.score)) continue;
                best.score = J;
                best.reversed = way % 2 == 1;
                best.loop = arc < 0;
                best.start = way % 2 ? b.near[j].s : a.near[i].s;
                best.end = best.start + arc;
                best.offset[0] = way % 2 ? b.near[j].distance : a.near[i].distance;
                best.offset[1] = way % 2 ? a.near[i].distance : b.near[j].distance;
            }
    return best;
}
