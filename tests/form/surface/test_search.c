/* Closest points and ray hits: closed forms, the equations they solve, sampling, hits counted against pure subdivision;
 * edges, seams, poles, tangent rays, rays within the surface, points on an axis; bad data. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include "form/surface/finder.h"
#include "base/vec.h"
#include "support/random_surface.h"
#include "support/rounds.h"
#include "support/solids.h"

static const double clamped[] = {0, 0, 0, 1, 1, 1}, two_spans[] = {0, 0, 0, 0.5, 1, 1, 1};

static bat_surface *make(const int degree[2], const bool closed[2], const int count[2], const double *u,
                         const double *v, const double *points) {
    const size_t n[2] = {(size_t)count[0], (size_t)count[1]};
    int knots[2];
    for (int d = 0; d < 2; d++) knots[d] = closed[d] ? count[d] + 1 : count[d] + degree[d] + 1;
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_create(degree, closed, n, points, knots, u, v, &s), BAT_OK);
    return s;
}

/* z = x^2 + y^2 over [-1, 1]^2, x = 2u - 1, y = 2v - 1; with two spans in each direction. */
static bat_surface *bowl(void) {
    const double x[4] = {-1, -0.5, 0.5, 1}, square[4] = {1, 0, 0, 1};
    double points[48];
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            const double p[3] = {x[i], x[j], square[i] + square[j]};
            memcpy(points + 3 * (4 * i + j), p, sizeof p);
        }
    return make((const int[2]){2, 2}, (const bool[2]){false, false}, (const int[2]){4, 4}, two_spans,
                two_spans, points);
}

/* A closed tube along z that ends in a pole at z = 1: cubic round, quadratic along. */
static bat_surface *bullet(void) {
    enum { N = 8 };
    double points[N * 3 * 3], u[N + 1];
    for (int i = 0; i <= N; i++) u[i] = i;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < 3; j++) {
            const double a = i * 2 * 3.14159265358979 / N, r = j == 2 ? 0 : 1;
            const double p[3] = {r * cos(a), r * sin(a), j == 0 ? 0 : 1};
            memcpy(points + 3 * (3 * i + j), p, sizeof p);
        }
    return make((const int[2]){3, 2}, (const bool[2]){true, false}, (const int[2]){N, 3}, u, clamped, points);
}

static size_t hits_of(const bat_surface *s, const double origin[3], const double direction[3],
                      bat_surface_point *out) {
    size_t count = 99;
    assert_int_equal(bat_surface_hits(s, origin, direction, 32, out, &count), BAT_OK);
    assert_true(count <= 32);
    const vec d = vec_unit(vec_load(direction, 3));
    for (size_t i = 0; i < count; i++) { /* on the ray, on the surface, in order */
        double at[3];
        bat_surface_eval(s, out[i].u, out[i].v, 0, at);
        const vec o = vec_load(origin, 3), p = vec_add(o, vec_scale(d, out[i].distance));
        const double size = bat_surface_size(s);
        assert_true(vec_norm(vec_sub(p, vec_load(out[i].point, 3))) < 1e-10 * size);
        assert_true(vec_norm(vec_sub(p, vec_load(at, 3))) < 1e-10 * size);
        assert_true(out[i].distance >= 0 && (i == 0 || out[i].distance >= out[i - 1].distance));
    }
    return count;
}

/* Along z one hit; along x two, symmetric; tangent to the bottom one; from above upwards none. */
static void rays_meet_a_bowl(void **state) {
    (void)state;
    bat_surface *s = bowl();
    bat_surface_point hit[32];
    for (int i = 0; i <= 20; i++)
        for (int j = 0; j <= 20; j++) { /* edges, corners and the middle lines between spans among them */
            const double x = 0.1 * i - 1, y = 0.1 * j - 1, from[3] = {x, y, 5}, down[3] = {0, 0, -2};
            assert_int_equal(hits_of(s, from, down, hit), 1);
            assert_true(fabs(hit[0].distance - (5 - x * x - y * y)) < 1e-13);
            assert_true(fabs(hit[0].u - (x + 1) / 2) < 1e-13 && fabs(hit[0].v - (y + 1) / 2) < 1e-13);
        }
    for (int i = 1; i <= 9; i++) {
        const double z = 0.1 * i, from[3] = {-3, 0, z}, way[3] = {1, 0, 0}, back[3] = {-1, 0, 0};
        assert_int_equal(hits_of(s, from, way, hit), 2);
        assert_true(fabs(hit[0].distance - (3 - sqrt(z))) < 1e-13 &&
                    fabs(hit[1].distance - (3 + sqrt(z))) < 1e-13);
        assert_int_equal(hits_of(s, from, back, hit), 0);
        assert_int_equal(hits_of(s, (const double[3]){0, 0, z}, way, hit), 1);
        assert_int_equal(hits_of(s, (const double[3]){0.3, 0.1, 0.1}, way, hit),
                         1); /* from the surface itself */
        assert_true(hit[0].distance == 0 || hit[0].distance < 1e-15);
    }
    /* touches where it meets the plane of a tangent: at (a, b), along any direction of it */
    for (int i = 0; i < 10; i++) {
        const double a = 0.07 * i - 0.3, b = 0.4 - 0.05 * i, d[3] = {1, 0.3, 2 * a + 0.6 * b};
        const double from[3] = {a - 4 * d[0], b - 4 * d[1], a * a + b * b - 4 * d[2]};
        const size_t count = hits_of(s, from, d, hit);
        assert_true(count <= 1); /* rounding decides whether it touches */
        if (count) assert_true(fabs(hit[0].u - (a + 1) / 2) < 1e-6);
    }
    assert_int_equal(hits_of(s, (const double[3]){-3, 0, 0}, (const double[3]){1, 0, 0}, hit), 1);
    bat_surface_free(s);
}

static void seams_and_poles_count_once(void **state) {
    (void)state;
    bat_surface *s = bullet();
    bat_surface_point hit[32];
    assert_int_equal(hits_of(s, (const double[3]){0, 0, 5}, (const double[3]){0, 0, -1}, hit),
                     1); /* the pole */
    assert_true(fabs(hit[0].distance - 4) < 1e-12);
    assert_int_equal(hits_of(s, (const double[3]){0.3, -0.2, 6}, (const double[3]){-0.06, 0.04, -1}, hit), 1);
    for (int i = 0; i < 16; i++) { /* through the axis: knots and seam on one side and on the other */
        const double a = i * 3.14159265358979 / 8, from[3] = {-3 * cos(a), -3 * sin(a), 0.4};
        assert_int_equal(hits_of(s, from, (const double[3]){cos(a), sin(a), 0}, hit), 2);
        assert_true(fabs(hit[0].distance + hit[1].distance - 6) < 1e-12);
    }
    bat_surface_free(s);
}

/* A ray that lies in a plane patch: it ends, with a point on both. */
static void a_ray_in_the_surface_ends(void **state) {
    (void)state;
    const double flat[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0}, knots[] = {0, 0, 1, 1};
    bat_surface *s = make((const int[2]){1, 1}, (const bool[2]){false, false}, (const int[2]){2, 2}, knots,
                          knots, flat);
    bat_surface_point hit[32];
    size_t count = 0;
    const double from[3] = {-1, 0.4, 0}, way[3] = {1, 0, 0};
    assert_int_equal(bat_surface_hits(s, from, way, 32, hit, &count), BAT_OK);
    assert_true(count >= 1);
    for (size_t i = 0; i < count && i < 32; i++) assert_true(fabs(hit[i].point[1] - 0.4) < 1e-6);
    bat_surface_free(s);
}

/* ---- Hits counted by boxes alone ---- */

enum { FINE = 40, PLACES = 4096, SURFACES = ROUNDS_OF(30) };

static bool box_has_zero(const double *net, int points) {
    for (int c = 0; c < 3; c++) {
        double low = INFINITY, high = -INFINITY;
        for (int i = 0; i < points; i++) low = fmin(low, net[3 * i + c]), high = fmax(high, net[3 * i + c]);
        if (c < 2 ? low > 0 || high < 0 : high < 0) return false;
    }
    return true;
}

/* The smallest boxes that may hold a hit, by their corners, in spans. */
static size_t boxes_of(const bat_surface *seen, double places[][2]) {
    static bat_cell stack[FINE + 2];
    const int degree[2] = {seen->axis[0].degree, seen->axis[1].degree};
    size_t count = 0;
    for (int i = degree[0]; i < seen->axis[0].spread; i++)
        for (int j = degree[1]; j < seen->axis[1].spread; j++) {
            if (!(seen->axis[0].knots[i] < seen->axis[0].knots[i + 1])) continue;
            if (!(seen->axis[1].knots[j] < seen->axis[1].knots[j + 1])) continue;
            const int span[2] = {i, j};
            int top = 0;
            bat_cell_of(seen, span, stack);
            while (top >= 0) {
                bat_cell *cell = stack + top--;
                if (!box_has_zero(cell->net, (degree[0] + 1) * (degree[1] + 1))) continue;
                if (cell->halvings < FINE) {
                    bat_cell_halve(degree, cell->halvings % 2, cell, cell + 1);
                    top += 2;
                    continue;
                }
                if (count < PLACES) places[count][0] = i + cell->low[0], places[count][1] = j + cell->low[1];
                count += count < PLACES;
            }
        }
    return count;
}

/* Boxes beside each other are one hit. *widest: how many spans such a hit is wide. */
static size_t count_by_boxes(const bat_surface *seen, double *widest) {
    static double places[PLACES][2];
    static size_t waiting[PLACES];
    static bool met[PLACES];
    const size_t count = boxes_of(seen, places);
    size_t hits = 0;
    memset(met, 0, sizeof met);
    *widest = count < PLACES ? 0 : 1;
    for (size_t i = 0; i < count; i++) {
        size_t many = 1;
        if (met[i]) continue;
        hits++, met[i] = true, waiting[0] = i;
        while (many > 0) {
            const double *at = places[waiting[--many]];
            *widest = fmax(*widest, fmax(fabs(at[0] - places[i][0]), fabs(at[1] - places[i][1])));
            for (size_t k = 0; k < count; k++)
                if (!met[k] && fabs(places[k][0] - at[0]) < 1.5e-5 && fabs(places[k][1] - at[1]) < 1.5e-5)
                    met[k] = true, waiting[many++] = k;
        }
    }
    return hits;
}

/* The surface in coordinates in which the ray begins in the origin and runs along z, and x is a direction across it. */
static bat_surface *before_the_eye(const bat_surface *s, const double from[3], const double way[3],
                                   vec across) {
    const vec z = vec_unit(vec_load(way, 3)), x = vec_unit(vec_reject(across, z)), y = vec_cross(z, x);
    const double axes[9] = {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z};
    double matrix[12];
    bat_surface *seen = NULL;
    for (int c = 0; c < 3; c++) {
        memcpy(matrix + 4 * c, axes + 3 * c, 3 * sizeof *axes);
        matrix[4 * c + 3] = -vec_dot(vec_load(axes + 3 * c, 3), vec_load(from, 3));
    }
    assert_int_equal(bat_surface_transform(s, matrix, &seen), BAT_OK);
    return seen;
}

static bat_surface *any_surface(random_source *r, int number) {
    const int degree[2] = {2 + number % 3, 2 + number / 3 % 3},
              kind[2] = {number % 2 * 2, number / 2 % 2 * 2};
    return random_surface(r, degree, kind, (const int[2]){4, 4});
}

static void hits_are_those_of_subdivision(void **state) {
    (void)state;
    random_source r = {12};
    int total = 0, differ = 0;
    double widest;
    for (int number = 0; number < SURFACES; number++) {
        bat_surface *s = any_surface(&r, number);
        for (int ray = 0; ray < 20; ray++) {
            double from[3], way[3];
            for (int c = 0; c < 3; c++)
                from[c] = random_between(&r, -12, 12), way[c] = random_between(&r, -1, 1);
            bat_surface_point hit[32];
            bat_surface *seen = before_the_eye(s, from, way, vec_any_normal(vec_load(way, 3)));
            const size_t found = hits_of(s, from, way, hit), want = count_by_boxes(seen, &widest);
            total += (int)want, differ += found != want;
            bat_surface_free(seen);
        }
        bat_surface_free(s);
    }
    assert_true(total > (FEWER ? 15 : 250));
    assert_int_equal(differ, 0);
}

/* Rays that run beside a silhouette, .1, 1e-3 and 1e-5 of a thousandth of the size from touching the surface, on the side on which
 * they meet it twice there and on the other. The normal across the ray keeps the boxes
 * thin near that fold; rays for which boxes pile up near another one are left out. */
static void hits_beside_silhouettes_are_those_of_subdivision(void **state) {
    (void)state;
    random_source r = {33};
    int total = 0, differ = 0, vague = 0, rays = 0;
    for (int number = 0; number < SURFACES; number++) {
        bat_surface *s = any_surface(&r, number);
        const double pixel = bat_surface_size(s) / 1000;
        for (int ray = 0; ray < 12; ray++) {
            const double beside = pixel * (double[]){0.1, 1e-3, 1e-5}[ray % 3] * (ray % 2 ? 1 : -1);
            const double u = random_parameter(&r, s, BAT_U), v = random_parameter(&r, s, BAT_V),
                         turn = random_between(&r, 0, 6.283185307179586);
            double jet[9], normal[3], from[3], way[3];
            if (bat_surface_normal(s, u, v, normal) != BAT_OK) continue;
            bat_surface_eval(s, u, v, 1, jet);
            const vec n = vec_load(normal, 3), a = vec_unit(vec_load(jet + 3, 3)), b = vec_cross(n, a);
            const vec along = vec_add(vec_scale(a, cos(turn)), vec_scale(b, sin(turn)));
            vec_store(along, way);
            vec_store(vec_sub(vec_add(vec_load(jet, 3), vec_scale(n, beside)), vec_scale(along, 40)), from);
            bat_surface_point hit[32];
            double widest;
            bat_surface *seen = before_the_eye(s, from, way, n);
            const size_t found = hits_of(s, from, way, hit), want = count_by_boxes(seen, &widest);
            const bool clear = widest < 2.5e-5;
            rays++, vague += !clear, total += (int)want, differ += clear && found != want;
            bat_surface_free(seen);
        }
        bat_surface_free(s);
    }
    assert_true(total > (FEWER ? 15 : 250) && 10 * vague < rays);
    assert_int_equal(differ, 0);
}

/* A finder answers as the one-shot calls do, also for the closest point; it refuses what they refuse. */
static void finders(void **state) {
    (void)state;
    random_source r = {19};
    for (int number = 0; number < SURFACES; number++) {
        bat_surface *s = random_surface(&r, (const int[2]){1 + number % 4, 3},
                                        (const int[2]){number % 3, number / 3 % 3},
                                        (const int[2]){number, 2 * number});
        bat_surface_finder *finder = NULL;
        assert_int_equal(bat_surface_finder_create(s, &finder), BAT_OK);
        for (int k = 0; k < 10; k++) {
            double from[3], way[3];
            bat_surface_point one[32], two[32];
            size_t ones = 0, twos = 0;
            for (int c = 0; c < 3; c++)
                from[c] = random_between(&r, -12, 12), way[c] = k == c ? 0 : random_between(&r, -1, 1);
            assert_int_equal(bat_surface_hits(s, from, way, 32, one, &ones), BAT_OK);
            assert_int_equal(bat_surface_finder_hits(finder, from, way, 32, two, &twos), BAT_OK);
            assert_true(ones == twos);
            assert_memory_equal(one, two, (ones < 32 ? ones : 32) * sizeof *one);
            assert_int_equal(bat_surface_nearest(s, from, one), BAT_OK);
            assert_int_equal(bat_surface_finder_nearest(finder, from, two), BAT_OK);
            assert_memory_equal(one, two, sizeof *one);
        }
        const double bad[3] = {NAN, 0, 0}, none[3] = {0, 0, 0};
        bat_surface_point out;
        size_t count;
        assert_int_equal(bat_surface_finder_nearest(finder, bad, &out), BAT_NUMBER);
        assert_int_equal(bat_surface_finder_hits(finder, bad, bad, 1, &out, &count), BAT_NUMBER);
        assert_int_equal(bat_surface_finder_hits(finder, none, none, 1, &out, &count), BAT_ARGUMENT);
        bat_surface_finder_free(finder), bat_surface_free(s);
    }
    bat_surface_finder_free(NULL);
    assert_int_equal(bat_surface_finder_create(NULL, NULL), BAT_ARGUMENT);
}

/* A wavy sheet of 40 x 40 spans, more than one block of a finder either way: every ray straight down hits once, below its
 * origin; the closest point is no farther than any of a grid. */
static void a_large_sheet(void **state) {
    (void)state;
    enum { SIDE = 43, GRID = 120 };
    static double points[SIDE * SIDE * 3], grid[GRID * GRID * 3];
    double knots[SIDE + 4], at[GRID];
    random_source r = {23};
    for (int i = 0; i < SIDE + 4; i++) knots[i] = i;
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            double *p = points + 3 * (SIDE * i + j);
            p[0] = i, p[1] = j, p[2] = random_between(&r, -1, 1);
        }
    bat_surface *s = NULL;
    bat_surface_finder *finder = NULL;
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){false, false},
                                        (const size_t[2]){SIDE, SIDE}, points,
                                        (const int[2]){SIDE + 4, SIDE + 4}, knots, knots, &s),
                     BAT_OK);
    assert_int_equal(bat_surface_finder_create(s, &finder), BAT_OK);
    bat_surface_spread(s, BAT_U, GRID, at);
    assert_int_equal(bat_surface_eval_grid(s, GRID, at, GRID, at, 0, grid), BAT_OK);
    for (int k = 0; k < 400; k++) {
        double from[3] = {random_between(&r, 1, 41), random_between(&r, 1, 41), random_between(&r, 2, 4)};
        const double down[3] = {0, 0, -2};
        bat_surface_point hit, near;
        size_t count = 0;
        assert_int_equal(bat_surface_finder_hits(finder, from, down, 1, &hit, &count), BAT_OK);
        assert_true(count == 1 && fabs(hit.point[0] - from[0]) < 1e-12 &&
                    fabs(hit.point[1] - from[1]) < 1e-12);
        assert_true(fabs(hit.u - from[0] - 2) < 1e-9 && fabs(hit.v - from[1] - 2) < 1e-9);
        assert_int_equal(bat_surface_finder_nearest(finder, from, &near), BAT_OK);
        assert_true(near.distance <= hit.distance + 1e-12);
        for (int i = 0; i < GRID * GRID; i++) {
            const double x = grid[3 * i] - from[0], y = grid[3 * i + 1] - from[1],
                         z = grid[3 * i + 2] - from[2];
            assert_true(x * x + y * y + z * z >= near.distance * near.distance * (1 - 1e-12));
        }
    }
    bat_surface_finder_free(finder), bat_surface_free(s);
}

/* ---- Closest points ---- */

/* The gap is square to the surface, but at a border where it points outwards. */
static void check_nearest(const bat_surface *s, const double point[3], const bat_surface_point *near) {
    double jet[9];
    bat_surface_eval(s, near->u, near->v, 1, jet);
    const vec gap = vec_sub(vec_load(jet, 3), vec_load(point, 3));
    const double size = bat_surface_size(s), at[2] = {near->u, near->v};
    assert_true(fabs(vec_norm(gap) - near->distance) < 1e-12 * (size + near->distance));
    for (int d = 0; d < 2; d++) {
        double domain[2];
        bat_surface_domain(s, (bat_direction)d, domain);
        const double slope = vec_dot(gap, vec_unit(vec_load(jet + 3 + 3 * d, 3)));
        const bool closed = bat_surface_is_closed(s, (bat_direction)d);
        if (!closed && at[d] == domain[0])
            assert_true(slope >= -1e-10 * size);
        else if (!closed && at[d] == domain[1])
            assert_true(slope <= 1e-10 * size);
        else
            assert_true(fabs(slope) < 1e-10 * size);
    }
}

static void nothing_is_nearer(void **state) {
    (void)state;
    enum { SIDE = 40 };
    static double u[SIDE], v[SIDE], points[SIDE * SIDE * 3];
    random_source r = {4};
    for (int number = 0; number < ROUNDS_OF(42); number++) {
        /* simple knots: no creases, where the gap need not be square to the surface */
        double knots[2][16], net[8 * 8 * 3];
        const int degree[2] = {2 + number % 6, 2 + number / 6 % 6};
        const bool closed[2] = {number % 3 == 1, number % 3 == 2};
        for (int d = 0; d < 2; d++)
            for (int i = 0; i < 16; i++) knots[d][i] = i + random_between(&r, 0, 0.5);
        for (int i = 0; i < 192; i++) net[i] = random_between(&r, -10, 10);
        bat_surface *s = make(degree, closed, (const int[2]){8, 8}, knots[0], knots[1], net);
        bat_surface_spread(s, BAT_U, SIDE, u);
        bat_surface_spread(s, BAT_V, SIDE, v);
        assert_int_equal(bat_surface_eval_grid(s, SIDE, u, SIDE, v, 0, points), BAT_OK);
        for (int k = 0; k < 12; k++) {
            double p[3];
            const double reach = k % 3 == 0 ? 1 : k % 3 == 1 ? 12 : 200;
            for (int c = 0; c < 3; c++) p[c] = random_between(&r, -reach, reach);
            if (k == 5) bat_surface_eval(s, u[7], v[9], 0, p);
            bat_surface_point near;
            assert_int_equal(bat_surface_nearest(s, p, &near), BAT_OK);
            check_nearest(s, p, &near);
            for (int i = 0; i < SIDE * SIDE; i++)
                assert_true(vec_norm(vec_sub(vec_load(points + 3 * i, 3), vec_load(p, 3))) >=
                            near.distance - 1e-12);
            if (k == 5) assert_true(near.distance < 1e-13);
        }
        bat_surface_free(s);
    }
}

/* Pieces that are looked at, from places on surfaces that cross themselves and from the middle of a sphere: counted. */
static void few_pieces_are_halved(void **state) {
    (void)state;
    enum { SIDE = 7 };
    random_source r = {8};
    for (int i = 0; i < 20; i++) {
        bat_surface *s = some_surface(&r, i);
        bat_surface_finder *finder = NULL;
        bat_surface_point near;
        double u[SIDE], v[SIDE];
        size_t all = 0;
        assert_int_equal(bat_surface_finder_create(s, &finder), BAT_OK);
        bat_surface_spread(s, BAT_U, SIDE, u);
        bat_surface_spread(s, BAT_V, SIDE, v);
        for (int k = 0; k < SIDE * SIDE; k++) {
            double p[3];
            size_t pieces = 0;
            bool found;
            const bat_near_hints hints = {INFINITY, NULL, &pieces};
            bat_surface_eval(s, u[k / SIDE], v[k % SIDE], 0, p);
            assert_int_equal(bat_finder_near(finder, p, &hints, &near, &found), BAT_OK);
            assert_true(found && near.distance <= 1e-14 * bat_surface_size(s));
            assert_true(pieces <= 10000);
            all += pieces;
        }
        assert_true(all <= 400 * SIDE * SIDE);
        bat_surface_finder_free(finder), bat_surface_free(s);
    }
    bat_surface *ball = solid_sphere(1, 32, 16);
    bat_surface_finder *finder = NULL;
    bat_surface_point near;
    size_t pieces = 0;
    bool found;
    const bat_near_hints hints = {INFINITY, NULL, &pieces};
    assert_int_equal(bat_surface_finder_create(ball, &finder), BAT_OK);
    assert_int_equal(bat_finder_near(finder, (const double[3]){0, 0, 0}, &hints, &near, &found), BAT_OK);
    assert_true(found && fabs(near.distance - 1) < 1e-4 && pieces <= 2 * BAT_NEAR_CELLS + 512);
    bat_surface_finder_free(finder), bat_surface_free(ball);
}

/* From the axis of the bowl the vertex is nearest up to its centre of curvature, 1/2. From the axis of a tube all points
 * of a ring are nearly as close, and the search ends all the same. */
static void closed_forms(void **state) {
    (void)state;
    bat_surface *s = bowl();
    bat_surface_point near;
    for (double z = -1; z < 2; z += 0.125) {
        const double p[3] = {0, 0, z}, want = z <= 0.5 ? fabs(z) : sqrt(z - 0.25);
        assert_int_equal(bat_surface_nearest(s, p, &near), BAT_OK);
        assert_true(fabs(near.distance - want) < 1e-12);
    }
    assert_int_equal(bat_surface_nearest(s, (const double[3]){3, 3, 2}, &near), BAT_OK); /* a corner */
    assert_true(near.u == 1 && near.v == 1 && fabs(near.distance - sqrt(8)) < 1e-14);
    bat_surface_free(s);
    s = bullet();
    assert_int_equal(bat_surface_nearest(s, (const double[3]){0, 0, -0.5}, &near), BAT_OK);
    assert_true(near.v == 0);
    check_nearest(s, (const double[3]){0, 0, -0.5}, &near);
    assert_int_equal(bat_surface_nearest(s, (const double[3]){0, 0, 3}, &near), BAT_OK); /* the pole */
    assert_true(fabs(near.distance - 2) < 1e-12);
    bat_surface_free(s);
}

static void bad_data(void **state) {
    (void)state;
    bat_surface *s = bowl();
    bat_surface_point near;
    size_t count = 7;
    const double nan[3] = {0, NAN, 0}, far[3] = {0, 0, INFINITY}, zero[3] = {0, 0, 0}, up[3] = {0, 0, 1};
    assert_int_equal(bat_surface_nearest(s, nan, &near), BAT_NUMBER);
    assert_int_equal(bat_surface_nearest(s, far, &near), BAT_NUMBER);
    assert_int_equal(bat_surface_nearest(NULL, up, &near), BAT_ARGUMENT);
    assert_int_equal(bat_surface_hits(s, zero, zero, 1, &near, &count), BAT_ARGUMENT);
    assert_int_equal(bat_surface_hits(s, nan, up, 1, &near, &count), BAT_NUMBER);
    assert_int_equal(bat_surface_hits(s, zero, far, 1, &near, &count), BAT_NUMBER);
    assert_int_equal(bat_surface_hits(s, zero, up, 1, NULL, &count), BAT_ARGUMENT);
    assert_int_equal(count, 7);
    assert_int_equal(bat_surface_hits(s, (const double[3]){0.1, 0, -1}, up, 0, NULL, &count), BAT_OK);
    assert_int_equal(count, 1);
    bat_surface_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(few_pieces_are_halved),
        cmocka_unit_test(finders),
        cmocka_unit_test(a_large_sheet),
        cmocka_unit_test(rays_meet_a_bowl),
        cmocka_unit_test(seams_and_poles_count_once),
        cmocka_unit_test(a_ray_in_the_surface_ends),
        cmocka_unit_test(hits_are_those_of_subdivision),
        cmocka_unit_test(hits_beside_silhouettes_are_those_of_subdivision),
        cmocka_unit_test(nothing_is_nearer),
        cmocka_unit_test(closed_forms),
        cmocka_unit_test(bad_data),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
