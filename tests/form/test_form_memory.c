/* label: slow. Lines, pictures and edits of scenes in space: each call that allocates sees its allocations fail. What
 * cannot be done without is reported, nothing comes out then, and nothing leaks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <cmocka.h>
#include "support/alloc_paths.h"
#include "form/shade/shade.h"
#include "form/view/lift.h"
#include "form/view/ruling.h"
#include "support/solids.h"
#include <batten/batten.h>
#include <batten/sight.h>

enum { SURFACES = 3, SAMPLES = 40 };

static bat_surface *surfaces[SURFACES]; /* two tubes through each other, and a plane below */
static bat_surface *torus, *lids[2]; /* planes that touch it: where it crosses itself, and along a circle */
static bat_surface *sheet;
static bat_curve *curves[2]; /* in space; flat and closed */
static bat_viewpoint parallel, near;

static double hills(double x, double y) { return 0.2 * sin(2.1 * x) * cos(1.3 * y); }

static void make_scene(void) {
    surfaces[0] = solid_cylinder(0.5, 1.2, 4);
    surfaces[1] = solid_move(solid_cylinder(0.4, 1.2, 4), 0, 1.5, 0, 0, 0);
    surfaces[2] = solid_plane((const double[3]){0, 0, -0.2}, (const double[3]){0, 0.1, 1}, 1.5);
    torus = solid_torus(1, 0.4, 5, 4);
    lids[0] = solid_plane((const double[3]){0.6, 0, 0}, (const double[3]){1, 0, 0}, 2);
    lids[1] = solid_plane((const double[3]){0, 0, 0.4}, (const double[3]){0, 0, 1}, 2);
    sheet = solid_sheet(6, hills);
    const double bow[] = {-2, 0, 0.1, 0, 1, 2, 1, -1, -2, 2, 0, 0};
    const double ring[] = {3, 0, 0, 3, -3, 0, 0, -3, 2, -2}, knots[] = {0, 1, 2, 3, 4, 5};
    assert_int_equal(bat_curve_create_clamped(3, 3, 4, bow, &curves[0]), BAT_OK);
    assert_int_equal(bat_curve_create(2, 3, true, 5, ring, 6, knots, &curves[1]), BAT_OK);
    parallel = (bat_viewpoint){.eye = {4, -6, 5}, .up = {0, 0, 1}, .size = {60, 40}, .height = 5};
    near = (bat_viewpoint){.eye = {0.9, -1.2, 0.8}, .up = {0, 0, 1}, .size = {60, 40}, .fov = 70};
}

static void drop_scene(void) {
    for (int i = 0; i < SURFACES; i++) bat_surface_free(surfaces[i]);
    for (int i = 0; i < 2; i++) bat_curve_free(curves[i]), bat_surface_free(lids[i]);
    bat_surface_free(torus), bat_surface_free(sheet);
}

/* Makes something and frees it. *made: whether there was something. */
typedef bat_status work(int which, bool *made);

static bat_status lines(int which, bool *made) {
    const int first = which ? 2 : 0; /* tubes about the eye take long */
    const bat_line_scene scene = {(size_t)(SURFACES - first), (const bat_surface *const *)surfaces + first, 2,
                                  (const bat_curve *const *)curves};
    bat_line_drawing *drawing = NULL;
    const bat_status status = bat_line_drawing_create(which ? &near : &parallel, &scene, &drawing);
    *made = drawing != NULL;
    if (drawing) assert_true(bat_line_drawing_count(drawing) > 3);
    bat_line_drawing_free(drawing);
    return status;
}

static bat_status picture(int which, bool *made) {
    const bat_shaded all[SURFACES] = {
        {.surface = surfaces[0]}, {.surface = surfaces[1], .colour = 0x336699ff}, {.surface = surfaces[2]}};
    bat_shading *shading = NULL;
    const bat_status status = bat_shade(which & 1 ? &near : &parallel, SURFACES, all, (bat_look)(which / 2),
                                        &shading);
    *made = shading != NULL;
    bat_shading_free(shading);
    return status;
}

static bat_status meeting(int which, bool *made) {
    bat_tracks *tracks = NULL;
    bat_intersect_options options = bat_intersect_defaults();
    options.chord = 1e-3;
    bat_status status = bat_surface_intersect(surfaces[which], surfaces[(which + 1) % SURFACES], &options,
                                              &tracks);
    *made = tracks != NULL;
    for (size_t i = 0; status == BAT_OK && i < bat_tracks_count(tracks); i++) {
        bat_curve *curve = NULL;
        status = bat_tracks_curve(tracks, i, 1e-2, &curve);
        if (status == BAT_TOLERANCE) status = BAT_OK;
        bat_curve_free(curve);
        if (status != BAT_OK) *made = false;
    }
    bat_tracks_free(tracks);
    return status;
}

static bat_status touching(int which, bool *made) {
    bat_tracks *tracks = NULL;
    bat_intersect_options options = bat_intersect_defaults();
    options.chord = 1e-3;
    const bat_status status = bat_surface_intersect(torus, lids[which], &options, &tracks);
    *made = tracks != NULL;
    if (tracks) assert_true(bat_tracks_crossing_count(tracks) > 0);
    bat_tracks_free(tracks);
    return status;
}

static bat_status outlines(int which, bool *made) {
    bat_tracks *tracks = NULL;
    const bat_status status = which < 2
                                  ? bat_surface_silhouettes(surfaces[which], &near, &tracks)
                                  : bat_surface_section(surfaces[which - 2], (const double[3]){0, 0, 0.05},
                                                        (const double[3]){0.1, 0, 1}, 1e-2, &tracks);
    *made = tracks != NULL;
    bat_tracks_free(tracks);
    return status;
}

/* The pixels of the line from a to b in space, bent upwards in the image. */
static bat_stroke stroke_over(const bat_viewpoint *view, int count, double (*points)[3], double bulge,
                              double *pixels) {
    for (int i = 0; i < count; i++) {
        assert_int_equal(bat_viewpoint_project(view, points[i], pixels + 2 * i, NULL), BAT_OK);
        const double t = (double)i / (count - 1);
        pixels[2 * i + 1] -= bulge * 16 * t * t * (1 - t) * (1 - t);
    }
    return (bat_stroke){.dimension = 2, .count = (size_t)count, .points = pixels};
}

static bat_status lifts(int which, bool *made) {
    double points[SAMPLES][3] = {{0}}, pixels[2 * SAMPLES], domain[2];
    bat_curve *out = NULL;
    size_t dropped;
    bat_curve_domain(curves[which], domain);
    for (int i = 0; i < SAMPLES; i++)
        bat_curve_eval(curves[which], domain[0] + (domain[1] - domain[0]) * i / SAMPLES, 0, points[i]);
    const bat_stroke stroke = stroke_over(&parallel, SAMPLES, points, 3, pixels);
    const bat_status status = bat_lift(&parallel, &stroke, curves[which], 0.01, &out, &dropped);
    *made = out != NULL;
    bat_curve_free(out);
    return status;
}

/* A sheet's line at u or v; the plane's, whose degree is raised. */
static bat_status line_drawn(int which, bool *made) {
    bat_surface *out = NULL;
    const bat_surface *on = which & 2 ? surfaces[2] : sheet;
    const bat_direction d = which & 1 ? BAT_V : BAT_U, other = which & 1 ? BAT_U : BAT_V;
    bat_surface_sketch_options options = bat_surface_sketch_defaults();
    options.tolerance = 0.05;
    if (which & 4) options.keep[0] = 2, options.keep[1] = 1;
    double points[SAMPLES][3], pixels[2 * SAMPLES], along[2], across[2], weights[16], way[3];
    bool turned;
    bat_surface_domain(on, d, across), bat_surface_domain(on, other, along);
    const double at = 0.5 * (across[0] + across[1]);
    for (int i = 0; i < SAMPLES; i++) {
        const double t = along[0] + (along[1] - along[0]) * (0.25 + 0.5 * i / (SAMPLES - 1));
        bat_surface_eval(on, which & 1 ? t : at, which & 1 ? at : t, 0, points[i]);
    }
    const bat_stroke stroke = stroke_over(&parallel, SAMPLES, points, 1, pixels);
    bat_status status = bat_surface_ruling(on, d, at, &parallel, options.along, way, &turned);
    if (status == BAT_OK)
        status = bat_surface_sketch(on, d, at, &parallel, &stroke, &options, &out, weights, NULL);
    *made = out != NULL;
    bat_surface_free(out);
    return status;
}

/* A frame with mitres, open at a corner of the path, and closed. */
static bat_status frames(int which, bool *made) {
    const double points[12] = {0, 0, 0, 5, 0, 1, 5, 4, 0, 1, 3, 2}, flat[6] = {0, 0, 0.4, 0.1, 0, 0.3};
    const double knots[6] = {0, 0, 1, 2, 3, 3}, loop[5] = {0, 1, 2, 3, 4}, loops[4] = {0, 1, 2, 3};
    bat_curve *path = NULL, *profile = NULL;
    bat_sweep *sweep = NULL;
    bat_surface *out = NULL;
    bat_status status = bat_curve_create(3, 1, which == 1, 4, points, which ? 5 : 6, which ? loop : knots,
                                         &path);
    if (status == BAT_OK) status = bat_curve_create(2, 1, true, 3, flat, 4, loops, &profile);
    if (status == BAT_OK) status = bat_sweep_create(path, profile, NULL, &sweep);
    if (status == BAT_OK) status = bat_sweep_surface(sweep, 1e-2, &out, NULL);
    *made = out != NULL;
    bat_surface_free(out), bat_sweep_free(sweep);
    bat_curve_free(path), bat_curve_free(profile);
    return status;
}

typedef struct job {
    const char *name;
    work *work;
    int count;  /* kinds of it */
    bool spare; /* a failure may be made up for */
} job;

static const job jobs[] = {
    {"lines", lines, 2, true},
    {"a picture", picture, 2 * BAT_LOOK_COUNT, false},
    {"meeting", meeting, 3, true},
    {"touching", touching, 2, false},
    {"outlines", outlines, 4, false},
    {"lifts", lifts, 2, false},
    {"a line drawn", line_drawn, 8, true},
    {"frames", frames, 2, false},
};

static void memory_may_end_in_any_work(void **state) {
    (void)state;
    int failed = 0;
    make_scene();
    for (size_t i = 0; i < sizeof jobs / sizeof *jobs; i++)
        for (int which = 0; which < jobs[i].count; which++) {
            bool made = false;
            const long held = alloc_live();
            const bat_status done = jobs[i].work(which, &made);
            if (done != BAT_OK || !made)
                fail_msg("%s, %d: status %d with all memory", jobs[i].name, which, (int)done);
            for (bool again = true; again; failed++) {
                alloc_fail_new(failed % 2);
                const bat_status status = jobs[i].work(which, &made);
                again = alloc_fail_reached();
                if (made != (status == BAT_OK) ||
                    (again ? status != BAT_MEMORY && !(jobs[i].spare && status == BAT_OK) : status != BAT_OK))
                    fail_msg("%s, %d: status %d", jobs[i].name, which, (int)status);
                if (alloc_live() != held) fail_msg("%s, %d: a leak", jobs[i].name, which);
            }
        }
    drop_scene();
    assert_true(failed > 100);
    print_message("%d times out of memory\n", failed);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(memory_may_end_in_any_work)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
