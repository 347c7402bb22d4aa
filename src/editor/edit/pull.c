#include "editor/edit/pull.h"
#include "base/real.h"
#include "curve/curve.h"
#include "editor/edit/smooth_node.h"
#include <math.h>
#include <string.h>

/* Rows: the pulls, the two ends, and one node for each control point reached and two beside them. */
enum { REACHED = BAT_PULLS_MAX * (BAT_DEGREE_MAX + 1), ROWS = 2 * REACHED, ENTRIES = BAT_DEGREE_MAX + 1 };

static const double SAME = 1e-12,
                    APART = 1e-8; /* squared sines: one row from the others; a pull from what must stay */

/* A linear equation for the control points' moves: sum weights[i] move[points[i]] = delta. */
typedef struct row {
    int node; /* the node that it keeps smooth; -1: none */
    int count, points[ENTRIES];
    double weights[ENTRIES], delta[BAT_DIMENSION_MAX];
    double size; /* sum of the squares of its weights, including those of pinned points */
} row;

typedef struct system {
    const bat_curve *curve;
    int pinned[2];                              /* control points at ends, which stay; -1: none */
    int pulls, reached[REACHED], reached_count; /* control points that the pulls depend on */
    int count;
    row rows[ROWS];
    double gram[ROWS][ROWS], share[ROWS][BAT_DIMENSION_MAX];
} system;

static bool is_reached(const system *s, int point) {
    for (int i = 0; i < s->reached_count; i++)
        if (s->reached[i] == point) return true;
    return false;
}

static void add_entry(const system *s, row *r, int point, double weight) {
    r->size += weight * weight;
    if (point == s->pinned[0] || point == s->pinned[1]) return;
    for (int i = 0; i < r->count; i++)
        if (r->points[i] == point) { /* a short closed curve can have a point several times in a row */
            r->weights[i] += weight;
            return;
        }
    r->points[r->count] = point;
    r->weights[r->count++] = weight;
}

static row *add_row(system *s) {
    row *r = &s->rows[s->count++];
    *r = (row){.node = -1};
    return r;
}

static row *add_place(system *s, double u) {
    row *r = add_row(s);
    double weights[BAT_DEGREE_MAX + 1];
    int first;
    bat_curve_basis(s->curve, u, &first, weights);
    for (int i = 0; i <= s->curve->degree; i++)
        if (weights[i] != 0) add_entry(s, r, (first + i) % s->curve->count, weights[i]);
    return r;
}

/* A handle that no pull reaches moves for one node; one shared by two nodes stays. */
static bool may_move(const system *s, int point, int node) {
    bat_smooth_node other;
    if (is_reached(s, point)) return true;
    int n = s->curve->count;
    for (int side = -1; side <= 1; side++) {
        int on = (point + side + n) % n;
        if (on != node && bat_smooth_node_at(s->curve, on, &other) &&
            (other.in == point || other.out == point))
            return false;
    }
    return true;
}

static void add_node(system *s, int on) {
    bat_smooth_node node;
    for (int i = 0; i < s->count; i++)
        if (s->rows[i].node == on) return;
    if (s->count == ROWS || !bat_smooth_node_at(s->curve, on, &node)) return;
    const int points[3] = {node.in, node.on, node.out};
    const double weights[3] = {node.ratio / (1 + node.ratio), -1, 1 / (1 + node.ratio)};
    row *r = add_row(s);
    r->node = on;
    for (int i = 0; i < 3; i++)
        if (may_move(s, points[i], on)) add_entry(s, r, points[i], weights[i]);
}

static void add_ends(system *s, const double *u) {
    double domain[2];
    bat_curve_domain(s->curve, domain);
    for (int side = 0; side < 2 && !s->curve->closed; side++) {
        bool pulled = false;
        for (int k = 0; k < s->pulls; k++) pulled = pulled || u[k] == domain[side];
        if (pulled || s->pinned[side] >= 0) continue;
        row *r = add_place(s, domain[side]);
        if (r->count != 1) continue;
        s->pinned[side] = r->points[0]; /* the end depends on one point */
        s->count--;
    }
}

static void gather(system *s, int count, const double *u, const double *delta, bool ends) {
    s->pulls = count;
    if (ends) { /* first, because the ends pin points */
        add_ends(s, u);
        s->count = 0;
    }
    for (int k = 0; k < count; k++) {
        row *r = add_place(s, u[k]);
        memcpy(r->delta, delta + s->curve->dimension * k, (size_t)s->curve->dimension * sizeof *delta);
        for (int i = 0; i < r->count; i++)
            if (!is_reached(s, r->points[i])) s->reached[s->reached_count++] = r->points[i];
    }
    if (ends) add_ends(s, u);
    int n = s->curve->count;
    for (int i = 0; i < s->reached_count; i++)
        for (int side = -1; side <= 1; side++) {
            int on = s->reached[i] + side;
            if (s->curve->closed || (on >= 0 && on < n)) add_node(s, (on + n) % n);
        }
}

static double product(const row *a, const row *b) {
    double sum = 0;
    for (int i = 0; i < a->count; i++)
        for (int j = 0; j < b->count; j++)
            if (a->points[i] == b->points[j]) sum += a->weights[i] * b->weights[j];
    return sum;
}

/* Cholesky, conditions first and pulls last (row k has position count - 1 - k); a condition that follows from others
 * is left out. */
static bat_status solve(system *s) {
    int n = s->count;
    for (int j = 0; j < n; j++)
        for (int i = j; i < n; i++) s->gram[i][j] = product(&s->rows[n - 1 - i], &s->rows[n - 1 - j]);
    for (int j = 0; j < n; j++) {
        double left = s->gram[j][j];
        for (int k = 0; k < j; k++) left -= s->gram[j][k] * s->gram[j][k];
        bool pull = n - 1 - j < s->pulls;
        bool gone = !(left > (pull ? APART : SAME) * s->rows[n - 1 - j].size);
        if (pull && gone) return BAT_SINGULAR;
        double root = gone ? 1 : sqrt(left);
        for (int i = j + 1; i < n; i++) {
            double sum = s->gram[i][j];
            for (int k = 0; k < j; k++) sum -= s->gram[i][k] * s->gram[j][k];
            s->gram[i][j] = gone ? 0 : sum / root;
        }
        if (gone)
            for (int k = 0; k < j; k++) s->gram[j][k] = 0;
        s->gram[j][j] = root;
    }
    for (int c = 0; c < s->curve->dimension; c++) {
        for (int i = 0; i < n; i++) {
            double sum = s->rows[n - 1 - i].delta[c];
            for (int k = 0; k < i; k++) sum -= s->gram[i][k] * s->share[k][c];
            s->share[i][c] = sum / s->gram[i][i];
        }
        for (int i = n - 1; i >= 0; i--) {
            for (int k = i + 1; k < n; k++) s->share[i][c] -= s->gram[k][i] * s->share[k][c];
            s->share[i][c] /= s->gram[i][i];
        }
    }
    return BAT_OK;
}

/* A copy whose points may still be changed. */
static bat_status begin(const bat_curve *curve, bat_curve **out) {
    bat_status status = bat_curve_allocate(curve->degree, curve->dimension, curve->closed, curve->count, out);
    if (status != BAT_OK) return status;
    memcpy(bat_curve_own_knots(*out), bat_curve_knots(curve),
           (size_t)bat_curve_knot_count(curve) * sizeof(double));
    memcpy(bat_curve_own_points(*out), bat_curve_points(curve),
           (size_t)curve->dimension * (size_t)curve->count * sizeof(double));
    return BAT_OK;
}

bat_status bat_pull(const bat_curve *curve, int count, const double *u, const double *delta,
                    bat_curve **out) {
    system s;
    bat_status status = BAT_SINGULAR;
    for (int ends = 1; ends >= 0 && status == BAT_SINGULAR;
         ends--) { /* all but the one at the end being pulled */
        s = (system){.curve = curve, .pinned = {-1, -1}};
        gather(&s, count, u, delta, ends != 0);
        status = solve(&s);
    }
    bat_curve *moved = NULL;
    if (status == BAT_OK) status = begin(curve, &moved);
    if (status != BAT_OK) return status;
    const int size = curve->dimension;
    double *points = bat_curve_own_points(moved);
    for (int k = 0; k < s.count; k++) {
        const row *r = &s.rows[k];
        const double *share = s.share[s.count - 1 - k];
        bool moves = false;
        for (int c = 0; c < size; c++) moves = moves || share[c] != 0;
        for (int i = 0; i < r->count && moves; i++)
            for (int c = 0; c < size; c++) points[size * r->points[i] + c] += r->weights[i] * share[c];
    }
    return bat_curve_finish(moved, out);
}

/* Turns the opposite handle into line with the one that has moved, keeping its length. */
static void turn_opposite(int size, double *points, int moved, int on, int opposite) {
    double *far = points + size * opposite, *at = points + size * on, *near = points + size * moved;
    double away[BAT_DIMENSION_MAX], length = 0, kept = 0;
    for (int c = 0; c < size; c++) {
        away[c] = at[c] - near[c];
        length = bat_hypot(length, away[c]);
        kept = bat_hypot(kept, far[c] - at[c]);
    }
    if (!(length > 0)) return;
    for (int c = 0; c < size; c++) far[c] = at[c] + away[c] * (kept / length);
}

bat_status bat_pull_point(const bat_curve *curve, int index, const double *delta, bool alone,
                          bat_curve **out) {
    bat_smooth_node node;
    bat_curve *moved = NULL;
    if (index < 0 || index >= curve->count) return BAT_ARGUMENT;
    bat_status status = begin(curve, &moved);
    if (status != BAT_OK) return status;
    double *points = bat_curve_own_points(moved);
    bool tied = !alone && bat_smooth_node_of(curve, index, &node);
    const int size = curve->dimension;
    for (int c = 0; c < size; c++) points[size * index + c] += delta[c];
    if (tied && index == node.on) {
        for (int c = 0; c < size; c++) {
            points[size * node.in + c] += delta[c];
            points[size * node.out + c] += delta[c];
        }
    } else if (tied) {
        turn_opposite(size, points, index, node.on, index == node.in ? node.out : node.in);
    }
    return bat_curve_finish(moved, out);
}

bat_status bat_pull_points(const bat_curve *curve, const unsigned char *marks, const double *delta,
                           bat_curve **out) {
    bat_curve *moved = NULL;
    const bat_status status = begin(curve, &moved);
    if (status != BAT_OK) return status;
    double *points = bat_curve_own_points(moved);
    const int size = curve->dimension;
    for (int i = 0; i < curve->count; i++)
        for (int k = 0; k < size && marks[i]; k++) points[(ptrdiff_t)size * i + k] += delta[k];
    return bat_curve_finish(moved, out);
}

bat_status bat_pull_along(const bat_curve *curve, int axis, const double *by, bat_curve **out) {
    bat_curve *moved = NULL;
    const bat_status status = begin(curve, &moved);
    if (status != BAT_OK) return status;
    double *points = bat_curve_own_points(moved);
    for (int i = 0; i < curve->count; i++) points[(ptrdiff_t)curve->dimension * i + axis] += by[i];
    return bat_curve_finish(moved, out);
}
