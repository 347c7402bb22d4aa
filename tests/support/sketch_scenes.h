/* Every call of the sketch hand on small curves: an open one, one to its right, a ring, and strokes over and between
 * them. */
#ifndef BATTEN_TESTS_SKETCH_SCENES_H
#define BATTEN_TESTS_SKETCH_SCENES_H

#include "support/sketch_cases.h"

enum { SAMPLES = 60 };

typedef struct sketch_scene {
    bat_curve *open, *ring, *right;
    double bump[2 * SAMPLES], round[2 * SAMPLES], bridge[2 * SAMPLES];
    bat_sketch_options options;
} sketch_scene;

static inline bat_stroke scene_stroke_of(const double *points, size_t count) {
    return (bat_stroke){.dimension = 2, .count = count, .points = points};
}

/* Degree 3 clamped, or degree 2 closed; even knots. */
static inline bat_curve *scene_even(bool closed, int count, const double *points) {
    double knots[32];
    const int p = closed ? 2 : 3;
    for (int i = 0; i <= count + p; i++) knots[i] = closed ? i : fmin(fmax(i - p, 0), count - p);
    bat_curve *curve;
    assert_int_equal(bat_curve_create(2, p, closed, (size_t)count, points, closed ? count + 1 : count + p + 1,
                                      knots, &curve),
                     BAT_OK);
    return curve;
}

static inline bat_curve *scene_wave(double x0, double y0) {
    double points[20];
    for (int i = 0; i < 10; i++) points[2 * i] = x0 + 30 * i, points[2 * i + 1] = y0 + 12 * sin(i);
    return scene_even(false, 10, points);
}

static inline void scene_make(sketch_scene *s) {
    double points[20];
    s->options = bat_sketch_defaults();
    s->open = scene_wave(0, 0), s->right = scene_wave(330, 20);
    for (int i = 0; i < 10; i++)
        points[2 * i] = 100 * cos(i * 3.14159265358979324 / 5),
                   points[2 * i + 1] = 100 * sin(i * 3.14159265358979324 / 5);
    s->ring = scene_even(true, 10, points); /* is raised to degree 3 */
    for (int i = 0; i < SAMPLES; i++) {
        const double t = (double)i / (SAMPLES - 1), a = 2 * 3.14159265358979324 * t,
                     noise = 0.3 * sin(71.0 * i);
        s->bump[2 * i] = 80 + 100 * t, s->bump[2 * i + 1] = 14 * sin(3.14159265358979324 * t) + noise;
        s->round[2 * i] = 112 * cos(a), s->round[2 * i + 1] = 108 * sin(a) + noise;
        s->bridge[2 * i] = 240 + 120 * t,
                      s->bridge[2 * i + 1] = 15 * sin(2 * 3.14159265358979324 * t) + noise;
    }
}

static inline void scene_drop(sketch_scene *s) {
    bat_curve_free(s->open), bat_curve_free(s->ring), bat_curve_free(s->right);
}

static inline bat_status scene_redraw(const sketch_scene *s, bat_curve **out) {
    const bat_stroke stroke = scene_stroke_of(s->bump, SAMPLES);
    return bat_sketch(s->open, &stroke, &s->options, out, NULL);
}
static inline bat_status scene_redraw_arc(const sketch_scene *s, bat_curve **out) {
    const bat_stroke stroke = scene_stroke_of(s->round, SAMPLES / 3);
    return bat_sketch(s->ring, &stroke, &s->options, out, NULL);
}
static inline bat_status scene_redraw_most(const sketch_scene *s,
                                           bat_curve **out) { /* the kept arc is given knots */
    const bat_stroke stroke = scene_stroke_of(s->round, SAMPLES - 9);
    return bat_sketch(s->ring, &stroke, &s->options, out, NULL);
}
static inline bat_status scene_redraw_all(const sketch_scene *s, bat_curve **out) {
    const bat_stroke stroke = scene_stroke_of(s->round, SAMPLES);
    return bat_sketch(s->ring, &stroke, &s->options, out, NULL);
}
static inline bat_status scene_fresh(const sketch_scene *s, bat_curve **out) {
    const bat_stroke stroke = scene_stroke_of(s->bump, SAMPLES);
    return bat_sketch_new(&stroke, false, &s->options, out, NULL);
}
static inline bat_status scene_fresh_cornered(const sketch_scene *s, bat_curve **out) {
    double points[2 * SAMPLES];
    for (int i = 0; i < SAMPLES; i++)
        points[2 * i] = 3 * i, points[2 * i + 1] = 3 * fabs(i - SAMPLES / 2.0) + 0.3 * sin(71.0 * i);
    const bat_stroke stroke = scene_stroke_of(points, SAMPLES);
    return bat_sketch_new(&stroke, false, &s->options, out, NULL);
}
static inline bat_status scene_fresh_ring(const sketch_scene *s, bat_curve **out) {
    const bat_stroke stroke = scene_stroke_of(s->round, SAMPLES);
    return bat_sketch_new(&stroke, true, &s->options, out, NULL);
}
static inline bat_status scene_smooth(const sketch_scene *s, bat_curve **out) {
    const bat_stroke stroke = scene_stroke_of(s->bump, SAMPLES);
    return bat_sketch_smooth(s->open, &stroke, &s->options, out, NULL);
}
static inline bat_status scene_join(const sketch_scene *s, bat_curve **out) {
    const bat_stroke stroke = scene_stroke_of(s->bridge, SAMPLES);
    return bat_sketch_join(s->open, s->right, &stroke, &s->options, out, NULL);
}

typedef bat_status sketch_call(const sketch_scene *, bat_curve **);
static sketch_call *const sketch_calls[] = {scene_redraw,     scene_redraw_arc, scene_redraw_most,
                                            scene_redraw_all, scene_fresh,      scene_fresh_cornered,
                                            scene_fresh_ring, scene_smooth,     scene_join};
enum { SKETCH_CALLS = sizeof sketch_calls / sizeof *sketch_calls };

#endif
