/* Triangles become watertight: volumes of prisms whose ends are filled, against the areas of their outlines; what stays open;
 * seams; every allocation may fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/mesh.h>
#include "format/model/fill.h"
#include "format/model/model.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { MOST = 64 };

typedef struct outline {
    int count;
    double at[2 * MOST];
} outline;

static double area_of(const outline *o) {
    double area = 0;
    for (int i = 0; i < o->count; i++) {
        const double *a = o->at + 2 * i, *b = o->at + 2 * ((i + 1) % o->count);
        area += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    return area;
}

/* A closed surface of degree 1 in u over the outline, open in v from z = 0 to z = 1; tilted, so that nothing is along an axis. */
static bat_surface *prism(const outline *o, bool backwards, bool closed) {
    const int count = closed ? o->count : o->count + 1;
    const int degree[2] = {1, 1}, knot_count[2] = {closed ? count + 1 : count + 2, 4};
    const bool is_closed[2] = {closed, false};
    const size_t counts[2] = {(size_t)count, 2};
    double points[6 * (MOST + 1)], u[MOST + 3];
    const double v[4] = {0, 0, 1, 1};
    bat_surface *made = NULL;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 2; k++) {
            const double *p = o->at + 2 * ((backwards ? 2 * o->count - i : i) % o->count);
            const double x = p[0], y = 0.6 * p[1] - 0.8 * k, z = 0.8 * p[1] + 0.6 * k;
            memcpy(points + 3 * (2 * i + k), (double[3]){x, y, z}, 3 * sizeof *points);
        }
    for (int i = 0; i < knot_count[0]; i++) u[i] = closed ? i : fmin(fmax(i - 1, 0), count - 1);
    assert_int_equal(bat_surface_create(degree, is_closed, counts, points, knot_count, u, v, &made), BAT_OK);
    return made;
}

static double volume_of(const bat_parts *parts) {
    double sum = 0;
    for (size_t i = 0; i < parts->count; i++)
        for (size_t t = 0; t < parts->part[i].triangle_count; t++) {
            const double *p[3];
            for (size_t k = 0; k < 3; k++)
                p[k] = parts->part[i].points + 3 * (size_t)parts->part[i].triangles[3 * t + k];
            sum += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
                   p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
                   p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
        }
    return sum / 6;
}

static bool is_same(const double *a, const double *b) { return memcmp(a, b, 3 * sizeof *a) == 0; }

/* Whether two corners of the triangle that has side s are at one place. */
static bool is_line(const bat_part *part, size_t s) {
    const int *corners = part->triangles + (s - s % 3);
    const double *p[3];
    for (int k = 0; k < 3; k++) p[k] = part->points + 3 * (size_t)corners[k];
    return is_same(p[0], p[1]) || is_same(p[1], p[2]) || is_same(p[2], p[0]);
}

enum { SIDE = 6 }; /* numbers of a side: where it begins and where it ends */

static int compare_sides(const void *a, const void *b) { return memcmp(a, b, SIDE * sizeof(double)); }

/* How many of sorted sides are this one. */
static size_t times(const double *sorted, size_t count, const double *side) {
    size_t low = 0, high = count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (compare_sides(sorted + SIDE * middle, side) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    size_t found = 0;
    while (low + found < count && compare_sides(sorted + SIDE * (low + found), side) == 0) found++;
    return found;
}

/* Sides of triangles that no other triangle has the other way round, at the same places. */
static size_t open_of_part(const bat_part *part) {
    size_t count = 0, open = 0;
    double *sides = malloc((3 * part->triangle_count + 1) * SIDE * sizeof *sides);
    assert_non_null(sides);
    for (size_t s = 0; s < 3 * part->triangle_count; s++) {
        if (is_line(part, s)) continue;
        double *side = sides + SIDE * count++;
        memcpy(side, part->points + 3 * (size_t)part->triangles[s], 3 * sizeof *side);
        memcpy(side + 3, part->points + 3 * (size_t)part->triangles[s - s % 3 + (s + 1) % 3],
               3 * sizeof *side);
    }
    qsort(sides, count, SIDE * sizeof *sides, compare_sides);
    for (size_t s = 0; s < count; s++) {
        double back[SIDE];
        memcpy(back, sides + SIDE * s + 3, 3 * sizeof *back);
        memcpy(back + 3, sides + SIDE * s, 3 * sizeof *back);
        open += times(sides, count, back) != 1;
    }
    free(sides);
    return open;
}

static size_t open_of(const bat_parts *parts) {
    size_t open = 0;
    for (size_t i = 0; i < parts->count; i++) open += open_of_part(&parts->part[i]);
    return open;
}

/* Normals of a part point to the same side as its triangles. */
static void check_normals(const bat_part *part) {
    for (size_t t = 0; t < part->triangle_count; t++) {
        const int *corners = part->triangles + 3 * t;
        double a[3], b[3], n[3], along = 0;
        for (int k = 0; k < 3; k++) {
            a[k] = part->points[3 * corners[1] + k] - part->points[3 * corners[0] + k];
            b[k] = part->points[3 * corners[2] + k] - part->points[3 * corners[0] + k];
        }
        for (int k = 0; k < 3; k++) n[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
        assert_true(n[0] != 0 || n[1] != 0 || n[2] != 0);
        for (int k = 0; k < 3; k++) along += n[k] * part->normals[3 * corners[0] + k];
        assert_true(along > 0);
    }
}

static void check_prism(const outline *o) {
    for (int run = 0; run < 4; run++) {
        bat_surface *surface = prism(o, run % 2, run < 2);
        bat_model model = {.surface_count = 1, .surfaces = &surface};
        for (int cap = 0; cap < 2; cap++) {
            bat_parts parts;
            size_t open;
            assert_int_equal(bat_parts_create(&model, 0, &parts), BAT_OK);
            assert_int_equal(bat_parts_close(&parts, &model, 0, cap, &open), BAT_OK);
            assert_int_equal(open, open_of(&parts));
            if (cap) {
                assert_int_equal(open, 0);
                assert_true(fabs(volume_of(&parts) / fabs(area_of(o)) - 1) < 1e-12);
                check_normals(&parts.part[0]);
            } else {
                assert_true(open > 0);
            }
            bat_parts_clear(&parts);
        }
        bat_surface_free(surface);
    }
}

static void prisms(void **state) {
    (void)state;
    static const outline square = {8, {0, 0, 1, 0, 2, 0, 2, 1, 2, 2, 1, 2, 0, 2, 0, 1}};
    static const outline comb = {
        14, {0, 0, 7, 0, 7, 3, 6, 3, 6, 1, 5, 1, 5, 3, 4, 3, 4, 1, 2, 1, 2, 3, 1, 3, 1, 1, 0, 1}};
    static const outline dart = {5, {0, 0, 4, 0, 2, 0.5, 4, 4, 1, 1}};
    check_prism(&square);
    check_prism(&comb);
    check_prism(&dart);
    random_source r = {5};
    for (int run = 0; run < 30; run++) { /* stars about the origin, some of whose middles do not see all */
        outline o = {random_int(&r, 3, MOST), {0}};
        for (int i = 0; i < o.count; i++) {
            const double angle = 6.283185307179586 * i / o.count, reach = random_between(&r, 0.2, 3);
            o.at[2 * i] = reach * cos(angle), o.at[2 * i + 1] = reach * sin(angle);
        }
        check_prism(&o);
    }
}

/* Ears are cut where no middle sees all: area and sides are those of the outline, whatever lies on one line. */
static void outlines(void **state) {
    (void)state;
    random_source r = {9};
    for (int run = 0; run < 200; run++) {
        enum { TEETH = 8 };
        outline o = {0, {0}};
        for (int i = 0; i <= TEETH; i++) { /* a saw of two blades; points of a blade may lie on a line */
            o.at[2 * o.count] = i, o.at[2 * o.count++ + 1] = random_int(&r, -3, -1);
        }
        for (int i = TEETH; i >= 0; i--)
            o.at[2 * o.count] = i, o.at[2 * o.count++ + 1] = random_int(&r, 0, 3);
        int next[MOST], triangles[3 * MOST];
        size_t count;
        double middle[2], area = 0;
        assert_true(bat_fill((size_t)o.count, o.at, next, triangles, &count, middle));
        memcpy(o.at + 2 * o.count, middle, sizeof middle);
        assert_true(count == (size_t)o.count || count == (size_t)o.count - 2);
        for (size_t t = 0; t < count; t++) {
            const double *a = o.at + 2 * triangles[3 * t], *b = o.at + 2 * triangles[3 * t + 1],
                         *c = o.at + 2 * triangles[3 * t + 2];
            const double part = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            assert_true(part > 0);
            area += part / 2;
        }
        assert_true(fabs(area / area_of(&o) - 1) < 1e-12);
    }
    static const double bow[] = {0, 0, 2, 2, 2, 0, 0, 3}, back[] = {0, 0, 0, 1, 1, 0},
                        twice[] = {1, 0, -0.8, 0.6, 0.3, -0.95, 0.3, 0.95, -0.8, -0.6};
    int next[5], triangles[15];
    size_t count;
    double middle[2];
    assert_false(bat_fill(4, bow, next, triangles, &count, middle));
    assert_false(bat_fill(3, back, next, triangles, &count, middle));
    assert_false(bat_fill(5, twice, next, triangles, &count, middle));
}

/* Both ends of a tube are filled although one goes up and down; by symmetry it holds as much as if it did not. */
static void an_end_that_waves(void **state) {
    (void)state;
    enum { SIDES = 12 };
    outline o = {SIDES, {0}};
    for (int i = 0; i < SIDES; i++) {
        const double angle = 6.283185307179586 * i / SIDES;
        o.at[2 * i] = cos(angle), o.at[2 * i + 1] = sin(angle);
    }
    for (int run = 0; run < 4; run++) {
        bat_surface *even = prism(&o, run % 2, run < 2), *surface = NULL;
        double points[6 * (SIDES + 1)];
        const int degree[2] = {1, 1}, knots[2] = {bat_surface_knot_count(even, BAT_U), 4};
        const size_t counts[2] = {bat_surface_count(even, BAT_U), 2};
        const bool closed[2] = {run < 2, false};
        for (size_t i = 0; i < counts[0]; i++) {
            double *p = memcpy(points + 6 * i, bat_surface_row(even, (int)i), 6 * sizeof *points);
            const double wave = i % 2 ? 0.2 : -0.2;
            p[4] -= 0.8 * wave, p[5] += 0.6 * wave;
        }
        assert_int_equal(bat_surface_create(degree, closed, counts, points, knots,
                                            bat_surface_knots(even, BAT_U), bat_surface_knots(even, BAT_V),
                                            &surface),
                         BAT_OK);
        bat_model model = {.surface_count = 1, .surfaces = &surface};
        bat_parts parts;
        size_t open;
        assert_int_equal(bat_parts_create(&model, 1e-3, &parts), BAT_OK);
        assert_int_equal(bat_parts_close(&parts, &model, 1e-3, true, &open), BAT_OK);
        assert_int_equal(open, open_of(&parts));
        assert_int_equal(open == 0,
                         run < 2); /* nothing says that a surface that only meets itself is a tube */
        if (run < 2) {
            assert_true(fabs(volume_of(&parts) / area_of(&o) - 1) < 1e-3);
            check_normals(&parts.part[0]);
        }
        bat_parts_clear(&parts);
        bat_surface_free(even);
        bat_surface_free(surface);
    }
}

/* A sheet in a plane, and a rim that does not lie in one, stay as they are. */
static void what_stays_open(void **state) {
    (void)state;
    const double flat[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0},
                 bent[] = {0, 0, 0, 1, 0, 0.5, 1, 1, 0, 0, 1, 0.5};
    const int sizes[] = {4}, corners[] = {0, 1, 2, 3};
    for (int run = 0; run < 2; run++) {
        bat_model model = {.mesh = NULL};
        bat_parts parts;
        size_t open;
        assert_int_equal(bat_polymesh_create(4, run ? bent : flat, 1, sizes, corners, &model.mesh, NULL),
                         BAT_OK);
        assert_int_equal(bat_parts_create(&model, 0, &parts), BAT_OK);
        assert_int_equal(bat_parts_close(&parts, &model, 0, true, &open), BAT_OK);
        assert_int_equal(open, 4);
        assert_int_equal(parts.part[0].triangle_count, 2);
        bat_parts_clear(&parts);
        bat_model_clear(&model);
    }
}

/* A seam whose sides differ by rounding becomes one, and so does a pole that is nearly a point. */
static void seams(void **state) {
    (void)state;
    enum { SIDES = 12, ROWS = 5 };
    double at[3 * ROWS * (SIDES + 1)];
    int sizes[ROWS * SIDES], corners[4 * ROWS * SIDES], count = 0;
    for (int i = 0; i < ROWS; i++)
        for (int k = 0; k <= SIDES; k++) {
            const double angle = 6.283185307179586 * (k % SIDES) / SIDES;
            const double radius = fmax(sin(3.141592653589793 * i / (ROWS - 1)), 1e-9);
            double *p = at + 3 * (i * (SIDES + 1) + k);
            p[0] = radius * cos(angle) + (k == SIDES ? 1e-10 : 0), p[1] = radius * sin(angle);
            p[2] = cos(3.141592653589793 * i / (ROWS - 1));
        }
    for (int i = 0; i + 1 < ROWS; i++)
        for (int k = 0; k < SIDES; k++) {
            const int a = i * (SIDES + 1) + k;
            memcpy(corners + 4 * count, (int[4]){a, a + SIDES + 1, a + SIDES + 2, a + 1},
                   4 * sizeof *corners);
            sizes[count++] = 4;
        }
    bat_model model = {.mesh = NULL};
    bat_parts parts;
    size_t open;
    assert_int_equal(
        bat_polymesh_create(ROWS * (SIDES + 1), at, (size_t)count, sizes, corners, &model.mesh, NULL),
        BAT_OK);
    assert_int_equal(bat_parts_create(&model, 0, &parts), BAT_OK);
    assert_true(open_of(&parts) > 0);
    assert_int_equal(bat_parts_close(&parts, &model, 0, false, &open), BAT_OK);
    assert_int_equal(open, 0);
    assert_true(volume_of(&parts) > 2);
    bat_parts_clear(&parts);
    bat_model_clear(&model);
}

static void each_allocation(void **state) {
    (void)state;
    static const outline dart = {5, {0, 0, 4, 0, 2, 0.5, 4, 4, 1, 1}};
    bat_surface *surface = prism(&dart, false, true);
    bat_model model = {.surface_count = 1, .surfaces = &surface};
    const long before = alloc_live();
    for (long n = 1;; n++) {
        bat_parts parts;
        size_t open;
        assert_int_equal(bat_parts_create(&model, 0, &parts), BAT_OK);
        alloc_fail_at(n);
        const bat_status status = bat_parts_close(&parts, &model, 0, true, &open);
        const bool reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        bat_parts_clear(&parts);
        assert_int_equal(alloc_live(), before);
        if (!reached) break;
    }
    bat_surface_free(surface);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(prisms),          cmocka_unit_test(outlines), cmocka_unit_test(an_end_that_waves),
        cmocka_unit_test(what_stays_open), cmocka_unit_test(seams),    cmocka_unit_test(each_allocation)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
