/* Evidence: what a stretch of the stroke beside a line costs, and how far off still counts. Reach grows with what was
 * run side by side, and shrinks where other lines run beside. */
#include "hands/sketch/intent_parts.h"
#include "base/real.h"

#include <math.h>

enum { PROBES = 5, NEIGHBOURS = 64 };             /* so many lines beside one tell how far apart they lie */
static const double parallel = 0.906307787036650; /* cosine of 25 degrees */
static const double neighbour_most = 60, twin = 1.5; /* px; the first by the size of the stroke */
static const double as_long = 0.8; /* of the line: a stroke beside so much of it is rather a second one */
static const double touches = 0.1; /* of the smaller of stroke and line: so near they touch */

static const double astray = 0.05; /* of the smaller of both: so far off is a careless stroke over a line */

double bat_intent_fine(const bat_intent *intent, const bat_intent_near *near) {
    const double coarse = bat_intent_coarse(fmin(intent->size, bat_intent_size(near)));
    return intent->chosen ? fmax(1, coarse) : coarse;
}

static double reach(const bat_intent *intent, double size, double reach0, double ran) {
    return fmin(bat_intent_reach_most(intent, size), reach0 + INTENT_GROW * fabs(ran)) *
           (intent->chosen ? INTENT_CHOSEN : 1);
}

double bat_intent_reach(const bat_intent *intent, const bat_intent_near *near, double ran) {
    return reach(intent, bat_intent_size(near), intent->reach0 * bat_intent_fine(intent, near), ran);
}

double bat_intent_reach_whole(const bat_intent *intent) {
    return reach(intent, intent->size, intent->reach0 * bat_intent_coarse(intent->size), intent->length);
}

double bat_intent_e(const bat_foot *foot, double sense, double reach) {
    const double off = foot->d / reach;
    return fmin(INTENT_FREE, off * off + 2 * (1 - sense * foot->c));
}

double bat_intent_astray(const bat_intent *intent, const bat_intent_near *near) {
    return astray * fmin(intent->size, bat_intent_size(near));
}

double bat_intent_off(const bat_intent *intent, const bat_intent_near *near, double d) {
    const double on = intent->on * bat_intent_fine(intent, near);
    return fmin(d, 2 * on) - on;
}

double bat_intent_leave(const bat_intent *intent, const bat_foot *foot, int side) {
    if (!(foot->d > 0)) return 0;
    const double a = intent->hook + (side ? intent->length : 0);
    const double *p = intent->p + (side ? 2 * (size_t)(intent->places - 1) : 0);
    double u[2];
    bat_intent_heading(intent, a, fmin(10 * bat_intent_coarse(intent->size), intent->length / 3), u);
    const double sine = ((p[0] - foot->x[0]) * u[0] + (p[1] - foot->x[1]) * u[1]) / foot->d * (side ? 1 : -1);
    return 2 * fmin(foot->d, bat_intent_reach_most(intent, intent->size)) * fmax(0, sine);
}

/* Distance from p to the part of a line that runs along `way`, or `most`. */
static double parallel_distance(const bat_polyline *line, const double p[2], const double way[2],
                                double most) {
    double best = most * most;
    for (int i = 0; i + 1 < line->count; i++) {
        const double *a = line->x + 2 * (size_t)i, v[2] = {a[2] - a[0], a[3] - a[1]};
        const double w = v[0] * v[0] + v[1] * v[1], r[2] = {p[0] - a[0], p[1] - a[1]};
        if (!(w > 0)) continue;
        const double t = fmin(fmax((r[0] * v[0] + r[1] * v[1]) / w, 0), 1);
        const double x = r[0] - t * v[0], y = r[1] - t * v[1], d = x * x + y * y;
        const double dot = v[0] * way[0] + v[1] * way[1];
        if (d < best && d > twin * twin && dot * dot >= parallel * parallel * w) best = d;
    }
    return sqrt(best);
}

/* How far the next line lies that runs along this one, where the stroke is. */
static double spacing(const bat_intent *intent, int index) {
    const bat_intent_near *near = &intent->line[index];
    const double most = neighbour_most * bat_intent_coarse(intent->size);
    double found[PROBES];
    for (int k = 0; k < PROBES; k++) {
        const int i = (int)((intent->places - 1) * (0.1 + 0.2 * k) + 0.5);
        const bat_foot *foot = &near->track[near->best].foot[i];
        double way[2], least = most + 1;
        bat_polyline_chord(&near->line, foot->s, 5, way);
        const double size = bat_hypot(way[0], way[1]);
        way[0] /= size > 0 ? size : 1, way[1] /= size > 0 ? size : 1;
        for (int j = 0, looked = 0; j < intent->line_count && looked < NEIGHBOURS; j++) {
            if (j == index || bat_box_distance2(intent->line[j].box, foot->x) >= least * least) continue;
            least = parallel_distance(&intent->line[j].line, foot->x, way, least);
            looked++;
        }
        int at = k;
        for (; at > 0 && found[at - 1] > least; at--) found[at] = found[at - 1];
        found[at] = least;
    }
    return found[PROBES - 2] > most ? INFINITY : found[PROBES - 2];
}

/* Share of a line that the stroke lies beside, its hooks included. */
static double share(const bat_intent *intent, const bat_intent_near *near) {
    const bat_foot *foot = near->track[near->best].foot;
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < intent->places; i++) low = fmin(low, foot[i].s), high = fmax(high, foot[i].s);
    return (high - low) * (1 + 2 * intent->hook / intent->length) / bat_polyline_length(&near->line);
}

/* Whether the first third of the stroke stays away from the line, or the last: it does not come back to it. While it is
 * drawn it may still do so. */
static bool comes_away(const bat_intent *intent, const bat_intent_near *near, double touching, bool long_as) {
    const bat_foot *foot = near->track[near->best].foot;
    const double within = fmax(long_as ? touching / 2 : touching, bat_intent_astray(intent, near));
    const int n = intent->places;
    double least[2] = {INFINITY, INFINITY};
    if (!intent->whole || (near->line.closed && long_as)) return false; /* all round has no ends */
    for (int i = 0; 3 * i < n; i++)
        least[0] = fmin(least[0], foot[i].d), least[1] = fmin(least[1], foot[n - 1 - i].d);
    return fmax(least[0], least[1]) > within;
}

/* Whether the stroke keeps its distance from the line, as the second of double lines does; a careless one comes and goes. */
static bool even(const bat_intent *intent, const bat_intent_near *near) {
    const bat_foot *foot = near->track[near->best].foot;
    double most = 0;
    for (int i = 0; i < intent->places; i++) most = fmax(most, foot[i].d);
    return intent->whole && !near->line.closed && most < 1.75 * near->least;
}

/* Whether the stroke goes all round: beside a line that it does not touch it is one inside another. */
static bool goes_round(const bat_intent *intent) {
    double all;
    return intent->whole && bat_intent_winding(intent, &all) >= 230;
}

static double total(const bat_intent *intent, const bat_intent_near *near, double reach) {
    const bat_foot *foot = near->track[near->best].foot;
    const double sense = near->ran < 0 ? -1 : 1;
    double sum = 0;
    for (int i = 0; i < intent->places; i++) sum += bat_intent_e(&foot[i], sense, reach) * intent->ds[i];
    return sum;
}

void bat_intent_evidence(bat_intent *intent, int index) {
    bat_intent_near *near = &intent->line[index];
    const bat_foot *foot = near->track[near->best].foot;
    const double parallel_most = INTENT_BESIDE * bat_intent_reach_most(intent, intent->size);
    near->ran = 0, near->least = INFINITY;
    for (int i = 0; i < intent->places; i++) {
        if (foot[i].d < parallel_most) near->ran += foot[i].c * intent->ds[i];
        near->least = fmin(near->least, foot[i].d);
    }
    double reach = bat_intent_reach(intent, near, near->ran);
    near->sum = total(intent, near, reach);
    const double on = fmin(INTENT_ON, touches * fmin(intent->size, bat_intent_size(near))),
                 touching = fmax(on, 0.5 * bat_intent_astray(intent, near));
    /* A stroke beside it all the way, or that does not come back to it, is rather a further line. What is too far in
     * any case need not be looked at. */
    if (near->sum < 1.2 * intent->length + 40) {
        const bool long_as = share(intent, near) > as_long, beside = near->least > touching;
        if (beside && !intent->chosen) reach = fmin(reach, INTENT_SPACING * spacing(intent, index));
        if (!intent->chosen &&
            (beside ? long_as || goes_round(intent) : comes_away(intent, near, touching, long_as)))
            reach = fmin(reach, touching);
        if (!intent->chosen && long_as && near->least > on && even(intent, near)) reach = fmin(reach, on);
        near->sum = total(intent, near, reach);
    }
    near->reach = reach;
}

bool bat_intent_open(bat_intent *intent, int index, int end) {
    bat_intent_near *near = &intent->line[index];
    if (near->line.closed) return false;
    if (near->among[end] == intent->line_count) return near->open[end];
    const double *x = near->line.x + (end ? 2 * (size_t)(near->line.count - 1) : 0);
    const double *other = near->line.x + (end ? 0 : 2 * (size_t)(near->line.count - 1));
    const double joint = INTENT_JOINT * bat_intent_coarse(bat_intent_size(near));
    bool open = bat_hypot(x[0] - other[0], x[1] - other[1]) > joint;
    for (int j = 0; j < intent->line_count && open; j++) {
        const bat_polyline *line = &intent->line[j].line;
        if (j == index || bat_box_distance2(intent->line[j].box, x) > joint * joint) continue;
        for (int i = 0; i + 1 < line->count && open; i++) {
            const double *a = line->x + 2 * (size_t)i, v[2] = {a[2] - a[0], a[3] - a[1]};
            const double w = v[0] * v[0] + v[1] * v[1], r[2] = {x[0] - a[0], x[1] - a[1]};
            const double t = w > 0 ? fmin(fmax((r[0] * v[0] + r[1] * v[1]) / w, 0), 1) : 0;
            open = bat_hypot(r[0] - t * v[0], r[1] - t * v[1]) > joint;
        }
    }
    near->open[end] = open;
    near->among[end] = intent->line_count;
    return open;
}
