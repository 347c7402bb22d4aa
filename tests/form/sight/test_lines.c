/* What is seen of a scene: stretches against a ray every half pixel, the silhouettes of a sphere before its circle, a square
 * behind a square, curves; Bezier segments against the lines; bad data, failing allocations. label: slow */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include "curve/curve.h"
#include "form/sight/strand.h"
#include "support/alloc_fail.h"
#include "support/rounds.h"
#include "support/solids.h"
#include "support/views.h"

static const double APART = FEWER ? 4 : 0.5;            /* pixels between rays */
static const double APART_ON_OUTLINES = FEWER ? 16 : 4; /* rays that touch take long */
static const double origin[3] = {0, 0, 0};
static double wave(double x, double y) { return 0.2 * sin(4.1 * x + 0.3) * cos(3.3 * y - 0.2) + 0.05 * x; }

/* By a ray from the eye, through surfaces one by one. */
static bool is_hidden(const bat_sight_scene *s, const bat_bead *bead) {
    const vec way = bat_gaze_towards(&s->gaze, bead->at);
    const double far = s->gaze.focus > 0 ? vec_norm(vec_sub(bead->at, s->gaze.eye)) : 100;
    double from[3], along[3];
    vec_store(vec_sub(bead->at, vec_scale(way, far)), from);
    vec_store(way, along);
    for (size_t i = 0; i < s->scene->surface_count; i++) {
        bat_surface_point hits[64];
        size_t count = 0;
        assert_int_equal(bat_surface_finder_hits(s->finders[i], from, along, 64, hits, &count), BAT_OK);
        for (size_t k = 0; k < count && k < 64; k++)
            if (hits[k].distance < far - 0.02 * bat_gaze_pixel(&s->gaze, bead->at)) return true;
    }
    return false;
}

typedef struct lengths {
    double all, wrong;
    double far, farther; /* wrong, and more than .1 px, .3 px from the nearest change */
} lengths;

/* Adds the samples of the piece between two places, of which the first is `gone` pixels along a stretch of `whole`. */
static void sample(const bat_sight_scene *s, const bat_strand *strand, const bat_seen_stretch *stretch,
                   double a, double b, double gone, double wide, double whole, lengths *sum) {
    const double apart = strand->kind == BAT_LINE_SILHOUETTE ? APART_ON_OUTLINES : APART;
    for (double k = ceil(gone / apart - 0.5); (k + 0.5) * apart < gone + wide; k++) {
        const double here = (k + 0.5) * apart, inside = fmin(here, whole - here);
        bat_bead at;
        bat_strand_locate(s, strand, a + (b - a) * (here - gone) / wide, &at);
        sum->all += apart;
        if (is_hidden(s, &at) == stretch->hidden) continue;
        sum->wrong += apart;
        if (inside > 0.1) sum->far += apart;
        if (inside > 0.3) sum->farther += apart;
    }
}

/* At places along each stretch. */
static void compare(const bat_sight_scene *s, const bat_strand *strand, lengths *sum) {
    bat_seen_stretch *list = NULL;
    size_t count = 0;
    assert_int_equal(bat_strand_stretches(s, strand, &list, &count), BAT_OK);
    for (size_t i = 0; i < count; i++) {
        assert_true(list[i].from < list[i].to && (i == 0 || list[i].from == list[i - 1].to));
        double gone = 0, whole = 0;
        for (int pass = 0; pass < 2; pass++) {
            gone = 0;
            for (double k = floor(list[i].from); k < list[i].to; k++) {
                const double a = fmax(k, list[i].from), b = fmin(k + 1, list[i].to);
                bat_bead p, q;
                bat_strand_locate(s, strand, a, &p);
                bat_strand_locate(s, strand, b, &q);
                const double wide = bat_hypot(q.pixel[0] - p.pixel[0], q.pixel[1] - p.pixel[1]);
                if (pass == 1) sample(s, strand, &list[i], a, b, gone, wide, whole, sum);
                gone += wide;
            }
            whole = gone;
        }
    }
    free(list);
}

static void check(const char *name, size_t count, bat_surface **surfaces, random_source *r) {
    lengths sum = {0, 0, 0, 0}, outlines = sum; /* rays that touch are the hardest: counted apart */
    const bat_line_scene scene = {count, (const bat_surface *const *)surfaces, 0, NULL};
    for (int number = 0; number < 2; number++) {
        bat_viewpoint view = some_view(r, number, origin, 8);
        bat_sight_scene s;
        if (view.fov > 0)
            view.fov = 17;
        else
            view.height = view.size[1] / 250;
        assert_int_equal(bat_sight_open(&s, &view, &scene), BAT_OK);
        assert_true(s.whole);
        for (size_t i = 0; i < s.count; i++)
            compare(&s, &s.strands[i], s.strands[i].kind == BAT_LINE_SILHOUETTE ? &outlines : &sum);
        bat_sight_close(&s);
    }
    printf("%s: %.0f px, wrong %.4f %%, more than .1 px from a change %.4f %%, .3 px %.4f %%; outlines %.0f "
           "px, wrong "
           "%.4f %%\n",
           name, sum.all, 100 * sum.wrong / sum.all, 100 * sum.far / sum.all, 100 * sum.farther / sum.all,
           outlines.all, 100 * outlines.wrong / outlines.all);
    assert_true(sum.all > 1000 && sum.wrong < 2e-4 * sum.all && sum.far < 2e-5 * sum.all && sum.farther == 0);
    assert_true(sum.wrong + outlines.wrong < 2e-4 * (sum.all + outlines.all));
    for (size_t i = 0; i < count; i++) bat_surface_free(surfaces[i]);
}

static void stretches_agree_with_rays(void **state) {
    (void)state;
    random_source r = {17};
    check("torus", 1, (bat_surface *[]){solid_torus(1, 0.4, 12, 8)}, &r);
    check("torus and sphere", 2,
          (bat_surface *[]){solid_torus(1, 0.4, 12, 8),
                            solid_move(solid_sphere(0.7, 12, 6), 0, 0.4, 0.9, 0.3, 0.2)},
          &r);
    check("cylinders", 2,
          (bat_surface *[]){solid_cylinder(0.5, 1.2, 12),
                            solid_move(solid_cylinder(0.4, 1.2, 12), 0, 1.5, 0, 0, 0)},
          &r);
    check("sheets", 2,
          (bat_surface *[]){solid_sheet(10, wave), solid_move(solid_sheet(9, wave), 0, 1.2, 0.1, 0.1, 0.1)},
          &r);
}

static double length_of(const bat_line_drawing *drawing, bat_line_kind kind, bool hidden) {
    double sum = 0;
    for (size_t i = 0; i < bat_line_drawing_count(drawing); i++) {
        bat_seen_line line;
        bat_line_drawing_at(drawing, i, &line);
        if (line.kind != kind || line.hidden != hidden) continue;
        for (int k = 0; k < 40 * line.segments; k++) {
            double at[2][2];
            for (int e = 0; e < 2; e++) {
                const int n = (k + e) / 40 < line.segments ? (k + e) / 40 : line.segments - 1;
                const double t = (k + e) / 40. - n, *p = line.points + 6 * n, u = 1 - t;
                for (int c = 0; c < 2; c++)
                    at[e][c] = u * u * u * p[c] + 3 * u * u * t * p[2 + c] + 3 * u * t * t * p[4 + c] +
                               t * t * t * p[6 + c];
            }
            sum += bat_hypot(at[1][0] - at[0][0], at[1][1] - at[0][1]);
        }
    }
    return sum;
}

/* A square of side 2 in front of a square of side 2 that is moved by 1 to the side, 100 px a unit, and a line behind. */
static void squares_hide_each_other(void **state) {
    (void)state;
    const double up[3] = {0, 0, 1}, first[3] = {0, 0, 1}, second[3] = {1, 0, 0};
    bat_surface *surfaces[] = {solid_plane(first, up, 1), solid_plane(second, up, 1)};
    const double line[] = {-3, 0.1, -1, 3, 0.1, -1}, knots[] = {0, 0, 1, 1};
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(3, 1, false, 2, line, 4, knots, &curve), BAT_OK);
    const bat_viewpoint view = {.eye = {0, 0, 9}, .up = {0, 1, 0}, .size = {800, 600}, .height = 6};
    const bat_line_scene scene = {2, (const bat_surface *const *)surfaces, 1,
                                  (const bat_curve *const *)&curve};
    bat_line_drawing *drawing = NULL;
    assert_int_equal(bat_line_drawing_create(&view, &scene, &drawing), BAT_OK);
    assert_true(bat_line_drawing_is_whole(drawing));
    assert_true(fabs(length_of(drawing, BAT_LINE_EDGE, false) - 1200) < 0.2);
    assert_true(fabs(length_of(drawing, BAT_LINE_EDGE, true) - 400) < 0.2);
    assert_true(fabs(length_of(drawing, BAT_LINE_CURVE, false) - 300) < 0.2);
    assert_true(fabs(length_of(drawing, BAT_LINE_CURVE, true) - 300) < 0.2);
    assert_true(length_of(drawing, BAT_LINE_SILHOUETTE, false) == 0);
    bat_line_drawing_free(drawing);
    bat_surface_free(surfaces[0]);
    bat_surface_free(surfaces[1]);
    bat_curve_free(curve);
}

/* Of 72 inner knots (one of them double) an even choice of 63 is drawn; seen from above, each line in one piece. */
static void of_many_knots_some_are_drawn(void **state) {
    (void)state;
    enum { ROWS = 76, KNOTS = ROWS + 3 };
    double points[ROWS][2][3], u[KNOTS];
    const double v[] = {0, 0, 1, 1};
    for (int i = 0; i < KNOTS; i++) u[i] = fmin(fmax(i - 2, 0), ROWS - 2) - (i > 40 && i < ROWS);
    u[KNOTS - 1] = u[KNOTS - 2] = u[KNOTS - 3] = u[KNOTS - 4] + 1;
    for (int i = 0; i < ROWS; i++)
        for (int j = 0; j < 2; j++)
            points[i][j][0] = i / 40. - 1, points[i][j][1] = j - 0.5, points[i][j][2] = 0;
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_create((const int[2]){2, 1}, (const bool[2]){false, false},
                                        (const size_t[2]){ROWS, 2}, &points[0][0][0],
                                        (const int[2]){KNOTS, 4}, u, v, &s),
                     BAT_OK);
    const bat_viewpoint view = {.eye = {0, 0, 9}, .up = {0, 1, 0}, .size = {800, 600}, .height = 3};
    const bat_line_scene scene = {1, (const bat_surface *const *)&s, 0, NULL};
    bat_line_drawing *drawing = NULL;
    assert_int_equal(bat_line_drawing_create(&view, &scene, &drawing), BAT_OK);
    assert_true(fabs(length_of(drawing, BAT_LINE_PARAMETER, false) - 63 * 200) < 1);
    assert_true(length_of(drawing, BAT_LINE_PARAMETER, true) == 0);
    bat_line_drawing_free(drawing);
    bat_surface_free(s);
}

static double away_from_chord(const double a[2], const double b[2], const double p[2]) {
    const double x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
    const double f = square > 0 ? fmin(fmax((x * (p[0] - a[0]) + y * (p[1] - a[1])) / square, 0), 1) : 0;
    return bat_hypot(a[0] + f * x - p[0], a[1] + f * y - p[1]);
}

/* The least distance of a pixel from what is drawn, 16 chords a segment. */
static double away_from(const bat_line_drawing *drawing, const double pixel[2]) {
    double least = INFINITY;
    for (size_t i = 0; i < bat_line_drawing_count(drawing); i++) {
        bat_seen_line line;
        bat_line_drawing_at(drawing, i, &line);
        double from[2] = {line.points[0], line.points[1]}, at[2];
        for (int k = 1; k <= 16 * line.segments; k++) {
            const double *b = line.points + 6 * ((k - 1) / 16), t = ((k - 1) % 16 + 1) / 16.0, s = 1 - t;
            const double c[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
            for (int d = 0; d < 2; d++)
                at[d] = c[0] * b[d] + c[1] * b[2 + d] + c[2] * b[4 + d] + c[3] * b[6 + d];
            least = fmin(least, away_from_chord(from, at, pixel));
            from[0] = at[0], from[1] = at[1];
        }
    }
    return least;
}

/* A loop that leaves the window and goes as far as you like: in the window it is where it belongs and nothing else is; what
 * is drawn hardly grows with the distance. */
static void what_is_far_off_is_coarse(void **state) {
    (void)state;
    const bat_viewpoint view = {.eye = {0, 0, 9}, .up = {0, 1, 0}, .size = {400, 300}, .height = 3};
    const double knots[] = {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4};
    size_t segments[2] = {0, 0};
    for (int far = 0; far < 2; far++) {
        const double x = far ? 3e6 : 3e3;
        const double points[] = {-1, -1,      0,  -0.5, 1, 0,    0.8, 0.9, 0,   x, x,
                                 1,  0.3 * x, -x, 2,    1, -0.9, 0,   -1,  0.2, 0};
        bat_curve *curve = NULL;
        bat_line_drawing *drawing = NULL;
        assert_int_equal(bat_curve_create(3, 3, false, 7, points, 11, knots, &curve), BAT_OK);
        const bat_line_scene scene = {0, NULL, 1, (const bat_curve *const *)&curve};
        assert_int_equal(bat_line_drawing_create(&view, &scene, &drawing), BAT_OK);
        int within = 0;
        for (int side = 0; side < 2; side++)
            for (double t = 1e-9; t < 2; t *= 1.01) {
                double at[3], pixel[2];
                bat_curve_eval(curve, side ? 4 - t : t, 0, at);
                assert_int_equal(bat_viewpoint_project(&view, at, pixel, NULL), BAT_OK);
                if (!(pixel[0] > 0 && pixel[0] < 400 && pixel[1] > 0 && pixel[1] < 300)) continue;
                const double away = away_from(drawing, pixel);
                if (!(away < 0.2)) fail_msg("%g: %g, %g is %g off", x, pixel[0], pixel[1], away);
                within++;
            }
        assert_true(within > 1000);
        for (size_t i = 0; i < bat_line_drawing_count(drawing); i++) {
            bat_seen_line line;
            bat_line_drawing_at(drawing, i, &line);
            segments[far] += (size_t)line.segments;
            for (int k = 0; k <= 3 * line.segments; k += 3) {
                const double *p = line.points + 2 * k;
                double most = INFINITY;
                if (!(p[0] > 0 && p[0] < 400 && p[1] > 0 && p[1] < 300)) continue;
                for (int side = 0; side < 2; side++)
                    for (double t = 1e-9; t < 2; t *= 1.001) {
                        double at[3], pixel[2];
                        bat_curve_eval(curve, side ? 4 - t : t, 0, at);
                        assert_int_equal(bat_viewpoint_project(&view, at, pixel, NULL), BAT_OK);
                        most = fmin(most, bat_hypot(pixel[0] - p[0], pixel[1] - p[1]));
                    }
                assert_true(most < 0.5);
            }
        }
        bat_line_drawing_free(drawing);
        bat_curve_free(curve);
    }
    printf("far off: %zu and %zu segments\n", segments[0], segments[1]);
    assert_true(segments[1] < 2 * segments[0]);
}

/* What lies on itself is touched everywhere; what is far beside it changes nothing. */
static void a_scene_that_is_not_whole_says_so(void **state) {
    (void)state;
    const double up[3] = {0, 0, 1}, beside[3] = {50, 0, 0}, before[3] = {-50, 0, 0};
    bat_surface *surfaces[] = {solid_plane(origin, up, 1), solid_plane(beside, up, 1),
                               solid_plane(before, up, 1), solid_plane(origin, up, 1)};
    const bat_viewpoint view = {.eye = {0, 0, 9}, .up = {0, 1, 0}, .size = {800, 600}, .height = 6};
    for (size_t count = 1; count <= 4; count++) {
        const bat_line_scene scene = {count, (const bat_surface *const *)surfaces, 0, NULL};
        bat_line_drawing *drawing = NULL;
        assert_int_equal(bat_line_drawing_create(&view, &scene, &drawing), BAT_OK);
        assert_true(bat_line_drawing_is_whole(drawing) == (count < 4));
        if (count < 4)
            assert_true(fabs(length_of(drawing, BAT_LINE_EDGE, false) - 800 * (double)count) < 0.2);
        bat_line_drawing_free(drawing);
    }
    for (int i = 0; i < 4; i++) bat_surface_free(surfaces[i]);
}

static void a_sphere_is_its_circle(void **state) {
    (void)state;
    const bat_surface *sphere = solid_sphere(1, 24, 12);
    const bat_viewpoint view = {.eye = {4, 3, 2}, .up = {0, 0, 1}, .size = {800, 800}, .height = 8. / 3};
    const bat_line_scene scene = {1, &sphere, 0, NULL};
    bat_line_drawing *drawing = NULL;
    assert_int_equal(bat_line_drawing_create(&view, &scene, &drawing), BAT_OK);
    assert_true(fabs(length_of(drawing, BAT_LINE_SILHOUETTE, false) - 600 * solid_pi) < 1);
    assert_true(length_of(drawing, BAT_LINE_SILHOUETTE, true) < 0.5);
    const double seen = length_of(drawing, BAT_LINE_PARAMETER, false),
                 hidden = length_of(drawing, BAT_LINE_PARAMETER, true);
    assert_true(fabs(seen - hidden) < 1e-3 * seen); /* the back is the front's mirror image */
    for (size_t i = 0; i < bat_line_drawing_count(drawing); i++) {
        bat_seen_line line;
        bat_line_drawing_at(drawing, i, &line);
        for (int k = 0; k <= line.segments && line.kind == BAT_LINE_SILHOUETTE; k++)
            assert_true(fabs(bat_hypot(line.points[6 * k] - 400, line.points[6 * k + 1] - 400) - 300) < 0.1);
    }
    bat_line_drawing_free(drawing);
    bat_surface_free((bat_surface *)sphere);
}

static void bad_data_are_refused(void **state) {
    (void)state;
    bat_viewpoint view = {.eye = {4, 3, 2}, .up = {0, 0, 1}, .size = {800, 800}, .height = 3};
    const bat_surface *none = NULL;
    const bat_line_scene empty = {0, NULL, 0, NULL}, wrong = {1, NULL, 0, NULL},
                         missing = {1, &none, 0, NULL};
    bat_line_drawing *drawing = NULL;
    assert_int_equal(bat_line_drawing_create(NULL, &empty, &drawing), BAT_ARGUMENT);
    assert_int_equal(bat_line_drawing_create(&view, NULL, &drawing), BAT_ARGUMENT);
    assert_int_equal(bat_line_drawing_create(&view, &wrong, &drawing), BAT_ARGUMENT);
    assert_int_equal(bat_line_drawing_create(&view, &missing, &drawing), BAT_ARGUMENT);
    assert_int_equal(bat_line_drawing_create(&view, &empty, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_line_drawing_create(&view, &empty, &drawing), BAT_OK);
    assert_int_equal(bat_line_drawing_count(drawing), 0);
    bat_line_drawing_free(drawing);
    bat_line_drawing_free(NULL);
    drawing = NULL;
    view.eye[1] = NAN;
    assert_int_equal(bat_line_drawing_create(&view, &empty, &drawing), BAT_NUMBER);
    assert_null(drawing);
}

static void failing_allocations_are_reported(void **state) {
    (void)state;
    const double up[3] = {0, 0, 1}, tilted[3] = {0, 1, 1};
    bat_surface *surfaces[] = {solid_plane(origin, up, 1), solid_plane(origin, tilted, 0.5)};
    const bat_viewpoint view = {.eye = {1, 2, 9}, .up = {0, 1, 0}, .size = {80, 60}, .fov = 40};
    const bat_line_scene scene = {2, (const bat_surface *const *)surfaces, 0, NULL};
    for (int n = 1;; n++) {
        const long before = alloc_live();
        bat_line_drawing *drawing = NULL;
        alloc_fail_at(n);
        const bat_status status = bat_line_drawing_create(&view, &scene, &drawing);
        if (!alloc_fail_reached()) {
            assert_int_equal(status, BAT_OK);
            bat_line_drawing_free(drawing);
            break;
        }
        assert_true(status == BAT_MEMORY || status == BAT_OK); /* the fit does with less */
        bat_line_drawing_free(drawing);
        assert_int_equal(alloc_live(), before);
    }
    for (int i = 0; i < 2; i++) bat_surface_free(surfaces[i]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stretches_agree_with_rays),
        cmocka_unit_test(squares_hide_each_other),
        cmocka_unit_test(a_sphere_is_its_circle),
        cmocka_unit_test(what_is_far_off_is_coarse),
        cmocka_unit_test(bad_data_are_refused),
        cmocka_unit_test(of_many_knots_some_are_drawn),
        cmocka_unit_test(a_scene_that_is_not_whole_says_so),
        cmocka_unit_test(failing_allocations_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
