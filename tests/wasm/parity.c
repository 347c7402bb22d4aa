/* The vectors. Curves and strokes are random but seeded; what comes out is not judged here, only compared. */
#include "curve/curve.h"
#include "wasm/parity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <batten/batten.h>
#include "base/real.h"
#include "hands/sketch/intent.h"
#include "support/random_surface.h"
#include "support/views.h"

static void put(parity_sink *sink, double value) {
    if (sink->count < sink->room) sink->values[sink->count] = value;
    sink->count++;
}

static void put_many(parity_sink *sink, size_t count, const double *values) {
    for (size_t i = 0; i < count; i++) put(sink, values[i]);
}

static void put_curve(parity_sink *sink, bat_status status, bat_curve *curve) {
    put(sink, status);
    if (status != BAT_OK && status != BAT_TOLERANCE) return;
    put(sink, bat_point_count(curve));
    put_many(sink, (size_t)bat_curve_knot_count(curve), bat_curve_knots(curve));
    put_many(sink, (size_t)(bat_point_count(curve) * bat_curve_dimension(curve)), bat_curve_points(curve));
    bat_curve_free(curve);
}

static void elementary(parity_sink *sink) {
    random_source r = {1};
    for (int i = 0; i < 500; i++) {
        double x = random_between(&r, -20, 20), y = random_between(&r, -1, 1);
        put(sink, bat_hypot(x, y)), put(sink, bat_exp(x)), put(sink, bat_log(fabs(x))), put(sink, bat_sin(x));
        put(sink, bat_cos(x)), put(sink, bat_atan2(x, y)), put(sink, bat_acos(y)), put(sink, sqrt(fabs(x)));
    }
}

/* Numbers to text and back: every journal and document passes through this. */
static void text(parity_sink *sink) {
    random_source r = {2};
    for (int i = 0; i < 500; i++) {
        char digits[40];
        int exponent = random_int(&r, -300, 300), precision = random_int(&r, 3, 17);
        double x = ldexp(random_between(&r, -1, 1), exponent);
        snprintf(digits, sizeof digits, "%.*g", precision, x);
        put(sink, (double)strlen(digits));
        for (const char *c = digits; *c; c++) put(sink, *c);
        put(sink, strtod(digits, NULL));
    }
}

static void each_curve(parity_sink *sink, uint64_t seed,
                       void (*run)(parity_sink *, random_source *, bat_curve *)) {
    random_source r = {seed};
    for (int degree = 1; degree <= BAT_DEGREE_MAX; degree++)
        for (int dimension = 2; dimension <= 3; dimension++)
            for (int kind = 0; kind < 3; kind++) {
                bat_curve *curve = random_curve(&r, degree, dimension, kind, 9);
                run(sink, &r, curve);
                bat_curve_free(curve);
            }
}

static void eval_one(parity_sink *sink, random_source *r, bat_curve *curve) {
    double domain[2], out[3 * BAT_DIMENSION_MAX], many[20 * BAT_DIMENSION_MAX], u[20];
    size_t m = (size_t)bat_curve_dimension(curve);
    bat_curve_domain(curve, domain);
    for (int i = 0; i < 20; i++) {
        bat_curve_eval(curve, random_between(r, domain[0], domain[1]), 2, out);
        put_many(sink, 3 * m, out);
    }
    bat_curve_spread(curve, 20, u);
    put(sink, bat_curve_eval_many(curve, 20, u, 0, many));
    put_many(sink, 20 * m, many);
}
static void eval(parity_sink *sink) { each_curve(sink, 3, eval_one); }

static void insert_one(parity_sink *sink, random_source *r, bat_curve *curve) {
    double domain[2], u[5];
    bat_curve_domain(curve, domain);
    for (int i = 0; i < 5; i++) u[i] = domain[0] + (domain[1] - domain[0]) * (i + random_unit(r)) / 5;
    bat_curve *finer = NULL;
    bat_status status = bat_curve_insert_knots(curve, 5, u, &finer);
    put_curve(sink, status, finer);
}
static void insert(parity_sink *sink) { each_curve(sink, 4, insert_one); }

static void nearest_one(parity_sink *sink, random_source *r, bat_curve *curve) {
    for (int i = 0; i < 10; i++) {
        double point[3];
        for (int c = 0; c < 3; c++) point[c] = random_between(r, -5, 5);
        bat_near near = {0};
        put(sink, bat_curve_nearest(curve, point, &near));
        put(sink, near.u), put(sink, near.distance);
    }
}
static void nearest(parity_sink *sink) { each_curve(sink, 5, nearest_one); }

static void measure_one(parity_sink *sink, random_source *r, bat_curve *curve) {
    double domain[2], box[2 * BAT_DIMENSION_MAX], turns[32];
    bat_curve_domain(curve, domain);
    double length = bat_curve_length(curve, domain[0], domain[1], 1e-12);
    put(sink, length);
    for (int i = 0; i < 5; i++) {
        double u = bat_curve_at_length(curve, domain[0], length * random_unit(r), 1e-10);
        put(sink, u), put(sink, bat_curve_curvature(curve, u));
    }
    bat_curve_bounds(curve, box, box + bat_curve_dimension(curve));
    put_many(sink, 2 * (size_t)bat_curve_dimension(curve), box);
    int count = bat_curve_dimension(curve) == 2 ? (int)bat_curve_inflections(curve, 32, turns) : 0;
    put(sink, count), put_many(sink, (size_t)(count < 32 ? count : 32), turns);
}
static void measure(parity_sink *sink) { each_curve(sink, 6, measure_one); }

static void surgery_one(parity_sink *sink, random_source *r, bat_curve *curve) {
    double domain[2], error = 0;
    bat_curve_domain(curve, domain);
    double cut = domain[0] + (domain[1] - domain[0]) * random_between(r, 0.3, 0.7);
    bat_curve *piece = NULL, *raised = NULL, *simple = NULL;
    bat_status cut_off = bat_curve_piece(curve, domain[0], cut, &piece);
    put_curve(sink, cut_off, piece);
    if (bat_curve_degree(curve) < BAT_DEGREE_MAX) {
        bat_status status = bat_curve_elevate(curve, bat_curve_degree(curve) + 1, &raised);
        put_curve(sink, status, raised);
    }
    bat_status status = bat_curve_simplify(curve, 0.05, 0.1, &simple, &error);
    put_curve(sink, status, simple), put(sink, error);
    status = bat_curve_refit_g1(curve, 0.05, 0.1, &simple, &error);
    put_curve(sink, status, simple), put(sink, error);
    int segments = bat_curve_segment_count(curve);
    size_t room = (size_t)segments * (size_t)(bat_curve_degree(curve) + 1) *
                  (size_t)bat_curve_dimension(curve);
    double *points = malloc(room * sizeof *points);
    put(sink, points ? bat_curve_to_bezier(curve, points, NULL) : BAT_MEMORY);
    if (points) put_many(sink, room, points);
    free(points);
}
static void surgery(parity_sink *sink) { each_curve(sink, 7, surgery_one); }

/* A stroke that wavers about a circle's arc. */
static void arc_stroke(random_source *r, size_t count, double radius, double turn, double *points) {
    for (size_t i = 0; i < count; i++) {
        double angle = turn * (double)i / (double)(count - 1);
        double away = radius + random_between(r, -0.4, 0.4);
        points[2 * i] = away * bat_cos(angle), points[2 * i + 1] = away * bat_sin(angle);
    }
}

static void fit(parity_sink *sink) {
    enum { COUNT = 300 };
    random_source r = {9};
    double points[2 * COUNT];
    for (int k = 0; k < 4; k++) {
        arc_stroke(&r, COUNT, 100 + 50 * k, 1 + k, points);
        bat_fit_options options = bat_fit_defaults();
        bat_fit_report report = {0};
        bat_curve *curve = NULL;
        bat_status status = bat_fit(2, COUNT, points, &options, &curve, &report);
        put_curve(sink, status, curve);
        put(sink, report.max_error), put(sink, report.knots), put(sink, report.solves);
    }
}

static void put_sketch(parity_sink *sink, bat_status status, bat_curve *curve,
                       const bat_sketch_report *report) {
    put_curve(sink, status, curve);
    put(sink, report->max_error), put(sink, report->noise), put(sink, report->solves);
    put_many(sink, 2, report->changed), put_many(sink, 2, report->changed_new);
}

/* A new curve from a stroke, redrawn in part, then redrawn again with other options. */
static void sketch(parity_sink *sink) {
    enum { COUNT = 300 };
    random_source r = {10};
    double points[2 * COUNT];
    for (int k = 0; k < 4; k++) {
        bat_sketch_options options = bat_sketch_defaults();
        bat_sketch_report report = {0};
        bat_stroke stroke = {.dimension = 2, .count = COUNT, .points = points};
        bat_curve *first = NULL, *second = NULL;
        arc_stroke(&r, COUNT, 300, 2.5, points);
        bat_status status = bat_sketch_new(&stroke, false, &options, &first, &report);
        put(sink, status);
        if (status != BAT_OK) return;
        arc_stroke(&r, COUNT, 310 + k, 1.2 + 0.1 * k, points);
        options.pins = k % 2 ? 2 : 3;
        status = bat_sketch(first, &stroke, &options, &second, &report);
        put_curve(sink, BAT_OK, first);
        put_sketch(sink, status, second, &report);
    }
}

/* Strokes calmed: wavy curves of every kind, over a part. */
static void calm(parity_sink *sink) {
    random_source r = {15};
    for (int i = 0; i < 24; i++) {
        bat_curve *curve = random_curve(&r, 3, 2, i % 3, 12), *calmed = NULL;
        double domain[2];
        bat_curve_domain(curve, domain);
        const double all = domain[1] - domain[0], size = bat_curve_size(curve);
        const double range[2] = {domain[0] + 0.2 * all, domain[0] + random_between(&r, 0.4, 0.9) * all};
        bat_status status = bat_sketch_calm(curve, range, random_between(&r, 0.001, 0.1) * size, size / 400,
                                            &calmed);
        put_curve(sink, status, calmed);
        bat_curve_free(curve);
    }
}

static void put_reading(parity_sink *sink, const bat_intent_reading *reading) {
    put(sink, reading->kind), put(sink, reading->cost), put(sink, reading->count);
    for (int i = 0; i < reading->count; i++) {
        put(sink, reading->part[i].line);
        put_many(sink, 2, reading->part[i].along);
    }
}

/* Strokes over planar curves: what they mean, the best first. */
static void meaning(parity_sink *sink) {
    enum { COUNT = 120, LINES = 4 };
    random_source r = {14};
    for (int i = 0; i < 40; i++) {
        double points[2 * COUNT];
        bat_intent *intent = NULL;
        bat_intent_reading readings[BAT_INTENT_READINGS];
        int count = 0;
        put(sink, bat_intent_create(i % 5 == 0, false, &intent));
        for (int k = 0; k < LINES; k++) {
            bat_curve *curve = random_curve(&r, 3, 2, k % 3, 9);
            const double scale = 400 / bat_curve_size(curve);
            put(sink, bat_intent_line(intent, curve, (double[]){scale, 0, 200, 0, scale, 200}, true));
            bat_curve_free(curve);
        }
        const double radius = random_between(&r, 40, 200), turn = random_between(&r, 0.5, 6);
        arc_stroke(&r, COUNT, radius, turn, points);
        for (int k = 0; k < 2 * COUNT; k++) points[k] += 200;
        put(sink, bat_intent_add(intent, COUNT, points));
        put(sink, bat_intent_rank(intent, true, readings, &count));
        put(sink, count);
        for (int k = 0; k < count; k++) put_reading(sink, &readings[k]);
        bat_intent_free(intent);
    }
}

/* A whole session: an object, the view, strokes over it and beside it, undo. The journal holds every number
 * and digest of it as text. */
static void session(parity_sink *sink) {
    random_source r = {8};
    bat_document *document = NULL;
    bat_editor *editor = NULL;
    bat_curve *curve = random_curve(&r, 3, 2, 0, 4);
    const double scale[] = {100, 0, 300, 0, 100, 300};
    bat_curve *large = NULL;
    bat_object *object = NULL;
    bat_style style = bat_style_defaults();
    bat_status status = bat_curve_transform(curve, scale, &large);
    bat_curve_free(curve);
    if (status == BAT_OK) status = bat_document_create(&document);
    if (status == BAT_OK) {
        status = bat_object_create_path(bat_document_new_id(document), "line", &style, 1, &large, &object);
    }
    if (status == BAT_OK) status = bat_document_insert(document, 0, object);
    bat_object_release(object);
    if (status == BAT_OK) status = bat_editor_create(&editor);
    if (status == BAT_OK) bat_editor_resize(editor, 1280, 800, 1);
    if (status == BAT_OK) status = bat_editor_open(editor, document, "session");
    for (int stroke = 0; stroke < 6 && status == BAT_OK; stroke++) {
        double x = random_between(&r, 200, 500), y = random_between(&r, 200, 600), time = 1000.0 * stroke;
        double dx = random_between(&r, 2, 5), bend = random_between(&r, -0.05, 0.05);
        for (int i = 0; i < 100; i++) {
            bat_pointer event = {.phase = i == 0    ? BAT_POINTER_DOWN
                                          : i == 99 ? BAT_POINTER_UP
                                                    : BAT_POINTER_MOVE,
                                 .device = BAT_DEVICE_PEN,
                                 .buttons = i == 99 ? 0 : BAT_BUTTON_PRIMARY,
                                 .x = x + dx * i,
                                 .y = y + bend * i * (100 - i) + random_between(&r, -0.3, 0.3),
                                 .pressure = 0.5,
                                 .time = time + 4 * i};
            bat_editor_pointer(editor, 1, &event);
            if (i % 10 == 0) put(sink, bat_editor_frame(editor)->error);
        }
        if (stroke == 2) bat_editor_wheel(editor, 640, 400, 0, -120, BAT_CTRL, time + 500);
        if (stroke == 3) put(sink, bat_editor_command(editor, "undo"));
    }
    put(sink, status);
    if (status == BAT_OK) {
        size_t size = 0;
        const char *journal = bat_editor_journal(editor, &size);
        put(sink, (double)size);
        for (size_t i = 0; i < size; i++) put(sink, journal[i]);
        uint64_t digest = bat_document_digest(bat_editor_document(editor));
        put(sink, (double)(digest >> 32)), put(sink, (double)(digest & 0xffffffff));
    }
    bat_editor_free(editor);
}

/* Directions all round the clock, tension, loops, space; and a point put on the curve. */
static void tangents(parity_sink *sink) {
    enum { COUNT = 9 };
    random_source r = {12};
    for (int k = 0; k < 12; k++) {
        double points[3 * COUNT], tangents[3 * COUNT], tension[2 * COUNT], deviation = 0;
        for (int i = 0; i < 3 * COUNT; i++) points[i] = random_between(&r, -300, 300);
        for (int i = 0; i < 3 * COUNT; i++) tangents[i] = i / 3 % 3 ? random_between(&r, -1, 1) : 0;
        for (int i = 0; i < 2 * COUNT; i++) tension[i] = random_between(&r, 0.5, 2);
        bat_spline spline = {2 + k % 2, k % 3 == 0, COUNT, points, tangents, k % 4 ? tension : NULL}, longer;
        bat_tangents_options options = {sizeof options,
                                        k % 5 == 2  ? BAT_TANGENTS_ROUND
                                        : k % 5 > 2 ? (bat_tangents_mode)(k % 5 - 2)
                                                    : BAT_TANGENTS_FAITHFUL,
                                        (bat_tangents_default)(k % 3)};
        bat_joint joints[COUNT];
        bat_curve *curve = NULL;
        void *block = NULL;
        int index = 0;
        bat_status status = bat_tangents(&spline, &options, joints, NULL, NULL, &curve);
        if (status == BAT_OK)
            for (int i = 0; i < COUNT; i++) {
                put(sink, isnan(joints[i].k) ? -1 : joints[i].k);
                put(sink, isnan(joints[i].angle_in) ? -1 : joints[i].angle_in);
                put_many(sink, 3, joints[i].left), put_many(sink, 3, joints[i].right);
            }
        put_curve(sink, status, curve);
        status = bat_tangents_insert(&spline, k % 7, 0.3, &options, &longer, &block, &index, &deviation);
        put(sink, status), put(sink, deviation);
        if (status == BAT_OK) put_many(sink, (size_t)(2 * longer.count), longer.tension);
        bat_free(block);
    }
}

/* Frames of all rules one at a time and in bulk; levels dragged, live and in one shot, and taken apart. */
static void levels_one(parity_sink *sink, random_source *r, bat_curve *curve) {
    enum { MANY = 70 };
    double domain[2], u[MANY], t[3 * MANY], s[3 * MANY], delta[3];
    bat_curve_domain(curve, domain);
    bat_curve_spread(curve, MANY, u);
    for (int rule = 0; rule < 3; rule++) {
        bat_frame_options options = bat_frame_defaults();
        bat_frame_chain *chain;
        bat_frame_arrays out = {NULL, t, s, NULL};
        options.rule = (bat_frame_rule)rule;
        bat_status status = bat_frame_chain_create(curve, &options, &chain);
        put(sink, status);
        if (status != BAT_OK) continue;
        put(sink, bat_frame_chain_many(chain, MANY, u, &out));
        put_many(sink, 3 * MANY, t), put_many(sink, 3 * MANY, s);
        put(sink, bat_frame_chain_holonomy(chain));
        bat_frame_chain_free(chain);
    }
    bat_shape *shape, *after;
    bat_shape_live *live;
    if (bat_shape_create(curve, NULL, &shape) != BAT_OK) return;
    for (int l = 1; l <= 2; l++) {
        put(sink, bat_shape_add_level(shape, 0, NULL, NULL, NULL));
        for (int i = 0; i < 5; i++) {
            for (int d = 0; d < 3; d++) delta[d] = random_between(r, -20, 20);
            put(sink, bat_shape_drag(shape, l, random_between(r, domain[0], domain[1]), delta));
        }
    }
    if (bat_shape_live_begin(shape, 0, &live) == BAT_OK) {
        put(sink, bat_shape_live_drag(live, random_between(r, domain[0], domain[1]), delta));
        bat_status status = bat_shape_live_commit(live, &after);
        put(sink, status);
        if (status == BAT_OK) {
            for (int l = 0; l <= bat_shape_levels(after); l++) {
                const bat_curve *c = bat_shape_curve(after, l);
                put_many(sink, (size_t)(bat_point_count(c) * bat_curve_dimension(c)), bat_curve_points(c));
            }
            bat_shape_free(after);
        }
    }
    bat_shape_free(shape);
    if (bat_shape_decompose(curve, 1, NULL, &shape) != BAT_OK) return;
    put_many(sink, 3 * (size_t)bat_point_count(bat_shape_curve(shape, 1)), bat_shape_details(shape, 1));
    bat_shape_free(shape);
}

static void levels(parity_sink *sink) { each_curve(sink, 13, levels_one); }

static void put_cast(parity_sink *sink, random_source *r, int number, const bat_canvas *canvas) {
    enum { COUNT = 12 };
    const double middle[3] = {0, 0, 0};
    const bat_viewpoint view = some_view(r, number, middle, 40);
    double pixels[2 * COUNT];
    bat_cast_point out[COUNT];
    for (int i = 0; i < 2 * COUNT; i++) pixels[i] = view.size[i % 2] * random_between(r, 0.3, 0.7);
    const bat_stroke stroke = {.dimension = 2, .count = COUNT, .points = pixels};
    put(sink, bat_cast(&view, &stroke, canvas, out, NULL));
    for (int i = 0; i < COUNT; i++) {
        put(sink, out[i].fate);
        if (out[i].fate != BAT_CAST_LANDED) continue;
        put_many(sink, 3, out[i].point), put_many(sink, 2, out[i].own);
    }
}

static void put_pick(parity_sink *sink, random_source *r, int number, const bat_surface *surface) {
    const double middle[3] = {0, 0, 0};
    const bat_viewpoint view = some_view(r, number, middle, 40);
    double pixels[8];
    bat_surface_pick pick = {.value = 0};
    for (int i = 0; i < 8; i++) pixels[i] = view.size[i % 2] * random_between(r, 0.3, 0.7);
    const bat_stroke stroke = {.dimension = 2, .count = 4, .points = pixels};
    put(sink, bat_surface_pick_line(&view, &stroke, surface, &pick));
    put(sink, pick.direction), put(sink, pick.value), put_many(sink, 2, pick.residual);
}

/* A stroke along a line of a sheet that is nearly flat. */
static void put_line(parity_sink *sink, random_source *r, int number) {
    enum { COUNT = 40, SIDE = 8 };
    const double knots[] = {0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5};
    double points[SIDE * SIDE * 3], pixels[2 * COUNT];
    for (int i = 0; i < SIDE * SIDE; i++) {
        points[3 * i] = 4.0 * (i / SIDE), points[3 * i + 1] = 4.0 * (i % SIDE);
        points[3 * i + 2] = random_between(r, -0.2, 0.2);
    }
    bat_surface *sheet, *made = NULL;
    put(sink,
        bat_surface_create((const int[2]){3, 3}, (const bool[2]){false, false}, (const size_t[2]){SIDE, SIDE},
                           points, (const int[2]){12, 12}, knots, knots, &sheet));
    const bat_viewpoint view = {
        .eye = {-40, -30, 30}, .target = {14, 14, 0}, .up = {0, 0, 1}, .size = {900, 700}, .height = 40};
    for (int i = 0; i < COUNT; i++) {
        const double x = i / (COUNT - 1.0);
        double at[3];
        bat_surface_eval(sheet, 2.5, 1 + 3 * x, 0, at);
        at[2] += random_between(r, 2, 2.02) * x * (1 - x);
        put(sink, bat_viewpoint_project(&view, at, pixels + 2 * i, NULL));
    }
    const bat_stroke stroke = {.dimension = 2, .count = COUNT, .points = pixels};
    bat_surface_sketch_options options = bat_surface_sketch_defaults();
    options.tolerance = 0.05 * (1 + number % 3);
    put(sink, bat_surface_sketch(sheet, BAT_U, 2.5, &view, &stroke, &options, &made, NULL, NULL));
    for (int i = 0; made && i < SIDE; i++)
        put_many(sink, 3 * bat_surface_count(made, BAT_V), bat_surface_row(made, i));
    bat_surface_free(made), bat_surface_free(sheet);
}

static void space(parity_sink *sink) {
    random_source r = {14};
    for (int number = 0; number < 30; number++) {
        bat_surface *surface = some_surface(&r, number);
        put_cast(sink, &r, number, &(bat_canvas){.surface = surface});
        put_pick(sink, &r, number, surface);
        put_line(sink, &r, number);
        put_cast(sink, &r, number, &(bat_canvas){.normal = {0, number, 1}});
        bat_canvas ruled = {.along = {1, 0, number}};
        const bat_status status = bat_surface_isocurve(surface, BAT_U, random_parameter(&r, surface, BAT_U),
                                                       &ruled.curve);
        put(sink, status);
        if (status == BAT_OK) put_cast(sink, &r, number, &ruled);
        bat_curve_free(ruled.curve);
        bat_surface_free(surface);
    }
}

/* Levels of surfaces: taken apart, carried over, changed. */
static void reliefs(parity_sink *sink) {
    random_source r = {15};
    for (int number = 0; number < 30; number++) {
        bat_surface *surface = some_surface(&r, number);
        bat_surface *other = some_surface(&r, number + 1);
        bat_relief *relief = NULL, *onto = NULL;
        const double delta[3] = {1, .5, -2};
        put(sink, bat_relief_decompose(surface, 1, &relief));
        if (relief) {
            put(sink, bat_relief_drag(relief, 0, random_parameter(&r, surface, BAT_U), .4, delta));
            put(sink, bat_relief_set_gain(relief, 1, 1.5));
            put(sink, bat_relief_copy_levels(relief, other, &onto));
            const bat_surface *made[2] = {bat_relief_surface(relief, 1), bat_relief_surface(onto, 1)};
            for (int k = 0; k < 2; k++)
                for (size_t i = 0; i < bat_surface_count(made[k], BAT_U); i++)
                    put_many(sink, 3 * bat_surface_count(made[k], BAT_V), bat_surface_row(made[k], (int)i));
        }
        bat_relief_free(relief), bat_relief_free(onto);
        bat_surface_free(surface), bat_surface_free(other);
    }
}

const parity_section parity_sections[] = {{"elementary functions", elementary},
                                          {"numbers as text", text},
                                          {"evaluation", eval},
                                          {"knot insertion", insert},
                                          {"closest point", nearest},
                                          {"measures", measure},
                                          {"surgery", surgery},
                                          {"fit", fit},
                                          {"sketch", sketch},
                                          {"calm", calm},
                                          {"meaning", meaning},
                                          {"tangents", tangents},
                                          {"levels", levels},
                                          {"views", space},
                                          {"surfaces with levels", reliefs},
                                          {"a session", session}};
const int parity_section_count = (int)(sizeof parity_sections / sizeof *parity_sections);
