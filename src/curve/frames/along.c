/*
 * Frames at given parameters, each one step from the sample before it. Few of them lie in a span, so those of several
 * spans are gathered, each with the cubic of its span, and take their steps together.
 */
#include "curve/frames/along.h"

#include "base/lanes.h"

enum { ROOM = BAT_FRAME_ROOM, Y = BAT_FRAME_PLANE, Z = 2 * BAT_FRAME_PLANE };

/* Frames that are asked for: where they are, what they step from, and the cubics of their spans. */
typedef struct gathered {
    int count, met;      /* of these; of those that have taken their steps */
    bat_frame_met *take; /* told the results */
    void *context;
    double at[ROOM];
    bat_rows from_x, from_t, from_s, xs, ts, ss;
    int span[ROOM], part[ROOM]; /* the run that each lies in */
    bool at_end[ROOM];
    double middle[ROOM], slow[ROOM], c[4][3][ROOM];
} gathered;

/* As bat_frame_span_eval, each with its own cubic. */
BAT_CLONES static bool eval(gathered *restrict g) {
    long long fault = 0;
    const int count = g->count;
    for (int i = 0; i < count; i++) {
        double s = g->at[i] - g->middle[i], v[3], w[3];
        for (int d = 0; d < 3; d++) v[d] = g->c[3][d][i], w[d] = 3 * g->c[3][d][i];
        for (int k = 2; k > 0; k--)
            for (int d = 0; d < 3; d++) v[d] = v[d] * s + g->c[k][d][i], w[d] = w[d] * s + k * g->c[k][d][i];
        double square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2], one = 1 / sqrt(square);
        fault |= !(square > g->slow[i]);
        g->xs[i] = v[0] * s, g->xs[Y + i] = v[1] * s, g->xs[Z + i] = v[2] * s;
        g->ts[i] = w[0] * one, g->ts[Y + i] = w[1] * one, g->ts[Z + i] = w[2] * one;
    }
    return !fault;
}

/* The steps of the run that lies at `first` on, by itself. */
static void step_alone(gathered *g, const bat_frame_walk *walk, const bat_frame_span *piece, int first,
                       int count, bool slow) {
    double *xs = g->xs + first, *ts = g->ts + first, *ss = g->ss + first;
    const double *from_x = g->from_x + first, *from_t = g->from_t + first, *from_s = g->from_s + first;
    if (!slow && bat_frame_steps(piece, walk->curve->dimension, count, g->at + first, from_x, from_t, from_s,
                                 xs, ts, ss))
        return;
    for (int i = 0; i < count; i++) {
        const bat_frame_node from = {.span = piece->span,
                                     .x = bat_rows_get(from_x, i),
                                     .t = bat_rows_get(from_t, i),
                                     .s = bat_rows_get(from_s, i)};
        bat_frame_node node = {.u = g->at[first + i]};
        bat_frame_step(walk->curve, walk->rule, piece, &from, g->at_end[first + i], &node);
        bat_rows_put(ts, i, node.t);
        bat_rows_put(ss, i, node.s);
    }
}

static void hand_out(gathered *g) {
    for (int i = 0; i < g->count; i++, g->met++)
        g->take(g->context, g->met, bat_rows_get(g->ts, i), bat_rows_get(g->ss, i));
    g->count = 0;
}

/* All take their steps together; where that is not possible, those of each run do. */
static void step_together(gathered *g, const bat_frame_walk *walk) {
    if (!eval(g) || !bat_rows_reflect(g->count, g->from_x, g->from_t, g->from_s, g->xs, g->ts, g->ss))
        for (int i = 0, next; i < g->count; i = next) {
            bat_frame_span piece;
            for (next = i + 1; next < g->count && g->part[next] == g->part[i];) next++;
            bat_frame_span_make(walk->curve, g->span[i], &piece);
            step_alone(g, walk, &piece, i, next - i, false);
        }
    hand_out(g);
}

/* How many of u[0..count) lie in the run, ROOM at most. */
static int inside(const bat_frame_walk *walk, int count, const double *u) {
    int n = 0, last = walk->count - 1;
    bool final = walk->left == 0 && walk->done + last == walk->steps;
    double low = bat_frame_walk_u(walk, 0), high = bat_frame_walk_u(walk, last);
    while (n < ROOM && n < count && u[n] >= low && (u[n] < high || (final && u[n] == high))) n++;
    return n;
}

/* Adds u[0..n) of the present run; k: a sample, from which the one before each is looked for. */
static void gather(gathered *g, const bat_frame_walk *walk, int part, int n, const double *u, int *k,
                   double *lengths) {
    const int last = walk->count - 1;
    for (int j = 0; j < n; j++) {
        const int i = g->count++;
        while (*k < last && bat_frame_walk_u(walk, *k + 1) <= u[j]) ++*k;
        while (*k > 0 && bat_frame_walk_u(walk, *k) > u[j]) --*k;
        g->at[i] = u[j], g->span[i] = walk->piece.span, g->part[i] = part;
        g->at_end[i] = u[j] == bat_frame_walk_u(walk, last);
        bat_rows_put(g->from_x, i, bat_frame_walk_get(walk, walk->xs, *k));
        bat_rows_put(g->from_t, i, bat_frame_walk_get(walk, walk->ts, *k));
        bat_rows_put(g->from_s, i, bat_frame_walk_get(walk, walk->ss, *k));
        g->middle[i] = walk->piece.middle, g->slow[i] = walk->piece.slow;
        for (int c = 1; c <= 3; c++)
            for (int d = 0; d < 3; d++) g->c[c][d][i] = walk->piece.c[c][d];
        if (lengths)
            lengths[j] = walk->lengths[*k] + bat_frame_length(&walk->piece, bat_frame_walk_u(walk, *k), u[j]);
    }
}

int bat_frame_walk_along(bat_frame_walk *walk, int count, const double *u, bat_frame_met *met, void *context,
                         double *lengths) {
    const bool cubic = walk->curve->degree == 3 && walk->curve->dimension == 3;
    gathered g;
    int done = 0;
    g.count = g.met = 0, g.take = met, g.context = context;
    for (int part = 0; done < count && bat_frame_walk_next(walk);) {
        int k = 0, n;
        while ((n = inside(walk, count - done, u + done)) > 0) {
            const bool alone = !cubic || walk->slow;
            if (g.count + n > ROOM || alone) step_together(&g, walk);
            gather(&g, walk, part++, n, u + done, &k, lengths ? lengths + done : NULL);
            if (alone) {
                step_alone(&g, walk, &walk->piece, 0, n, walk->slow);
                hand_out(&g);
            }
            done += n;
        }
    }
    step_together(&g, walk);
    return done;
}
