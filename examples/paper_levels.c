/*
 * Figures 2, 5, 6, 7 and 8 of the paper that the levels hand comes from, on curves of our own (docs/levels.md). Checks
 * what is said of them there; with a folder's name it draws them, as SVG.
 *
 * Details are measured without the library's frames: control points of C^j less those of C^(j-1) refined, against the
 * tangent that the derivative of C^(j-1) gives.
 */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <batten/batten.h>

enum { POINTS_MAX = 1024 };

static int failed;

static void claim(const char *what, bool holds) {
    if (!holds) printf("does not hold: %s\n", what), failed++;
}

static void must(bat_status status) {
    if (status != BAT_OK) printf("%s\n", bat_status_message(status)), exit(2);
}

/* ---- pictures: tenths of a pixel; y grows upwards in the world, downwards on the page ---- */

static const char *folder;

typedef struct picture {
    FILE *file;
    double x, y, scale; /* where the world's origin lies on the page, and how large its unit is */
    double turn, raise; /* of the view on curves in space; 0, pi/2: from above */
} picture;

static const char INK[] = "#1f242b' stroke-width='16", THIN[] = "#8b95a1' stroke-width='11",
                  FAINT[] = "#c3c9d1' stroke-width='9", NORMAL[] = "#7a3fd1' stroke-width='8";

static void say(picture *p, const char *format, ...) {
    va_list words;
    if (!p->file) return;
    va_start(words, format);
    vfprintf(p->file, format, words);
    va_end(words);
}

static void begin(picture *p, const char *name, int width, int height) {
    char path[600];
    *p = (picture){.raise = acos(0)};
    if (!folder) return;
    snprintf(path, sizeof path, "%.500s/levels-%s.svg", folder, name);
    p->file = fopen(path, "w");
    if (!p->file) printf("%s cannot be written\n", path), exit(2);
    say(p,
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %d %d' font-family='sans-serif' "
        "font-size='130' fill='none' stroke-linejoin='round'>\n<path d='M0 0h%dv%dH0' fill='#fff'/>\n",
        10 * width, 10 * height, 10 * width, 10 * height);
}

static void end(picture *p) {
    say(p, "</svg>\n");
    if (p->file && fclose(p->file)) printf("a picture is cut short\n"), failed++;
}

/* The next panel: the world's origin is at x, y (pixels), a unit is `scale` pixels; the caption stands at `below`. */
static void panel(picture *p, double x, double y, double scale, double left, double below,
                  const char *caption) {
    p->x = 10 * x, p->y = 10 * y, p->scale = 10 * scale;
    say(p, "<text x='%.0f' y='%.0f' fill='#59616c'>%s</text>\n", 10 * left, 10 * below, caption);
}

static void place(const picture *p, const double *at, int dimension, int out[2]) {
    double x = at[0], y = at[1], z = dimension == 3 ? at[2] : 0;
    double across = x * cos(p->turn) - y * sin(p->turn), away = x * sin(p->turn) + y * cos(p->turn);
    out[0] = (int)lround(p->x + p->scale * across);
    out[1] = (int)lround(p->y - p->scale * (away * sin(p->raise) + z * cos(p->raise)));
}

static void draw(picture *p, const bat_curve *curve, const char *style) {
    double *cubics = NULL;
    int count = 0, dimension = bat_curve_dimension(curve), last[2], next[2];
    if (!p->file) return;
    must(bat_curve_to_cubics(curve, 1e-3, &count, &cubics));
    place(p, cubics, dimension, last);
    say(p, "<path stroke='%s' d='M%d %d", style, last[0], last[1]);
    for (int i = 0; i < count; i++) {
        for (int k = 1; k < 4; k++) {
            place(p, cubics + (4 * i + k) * dimension, dimension, next);
            say(p, "%s%d %d", k == 1 ? "c" : " ", next[0] - last[0], next[1] - last[1]);
        }
        memcpy(last, next, sizeof last);
    }
    say(p, "'/>\n");
    bat_free(cubics);
}

static void line(picture *p, int dimension, const double *a, const double *b, const char *style) {
    int from[2], to[2];
    place(p, a, dimension, from), place(p, b, dimension, to);
    say(p, "<path stroke='%s' d='M%d %dL%d %d'/>\n", style, from[0], from[1], to[0], to[1]);
}

static int points_of(const bat_curve *curve) { return (int)bat_curve_count(curve); }

static void draw_points(picture *p, const bat_curve *curve) {
    int n = points_of(curve), dimension = bat_curve_dimension(curve), at[2];
    const double *points = bat_curve_points(curve);
    for (int i = 0; i < n; i++) {
        if (i > 0) line(p, dimension, points + (i - 1) * dimension, points + i * dimension, FAINT);
        place(p, points + i * dimension, dimension, at);
        say(p, "<circle cx='%d' cy='%d' r='30' fill='#1f62d6'/>\n", at[0], at[1]);
    }
}

/* The frames' s at the nodes of the level over `curve`. */
static void draw_normals(picture *p, const bat_shape *shape, int level, bat_frame_rule rule, double length) {
    bat_frame3 frames[POINTS_MAX];
    bat_frame_options options = bat_frame_defaults();
    const bat_curve *below = bat_shape_curve(shape, level - 1);
    int n = points_of(bat_shape_curve(shape, level));
    options.rule = rule;
    must(bat_frames(below, (size_t)n, bat_shape_nodes(shape, level), &options, frames, NULL));
    for (int i = 0; i < n; i++) {
        double tip[3];
        for (int d = 0; d < 3; d++) tip[d] = frames[i].point[d] + length * frames[i].s[d];
        line(p, 3, frames[i].point, tip, NORMAL);
    }
}

/* ---- shapes ---- */

static bat_curve *curve_of(int dimension, bool closed, int count, const double *points) {
    double knots[POINTS_MAX];
    bat_curve *curve;
    for (int i = 0; i < count + 4; i++) knots[i] = closed ? i : i < 4 ? 0 : i >= count ? count - 3 : i - 3;
    must(bat_curve_create(dimension, 3, closed, (size_t)count, points, closed ? count + 1 : count + 4, knots,
                          &curve));
    return curve;
}

/* A base under `levels` midpoint refinements, without details. */
static bat_shape *shape_of(const bat_curve *base, bat_frame_rule rule, int levels) {
    bat_shape_options options = bat_shape_defaults();
    bat_shape *shape;
    options.frame = rule;
    options.has_first = true, options.first[1] = 1;
    must(bat_shape_create(base, &options, &shape));
    while (levels-- > 0) must(bat_shape_add_level(shape, 0, NULL, NULL, NULL));
    return shape;
}

/* The base goes to other control points. */
static void repose(bat_shape *shape, const double *points) {
    const bat_curve *base = bat_shape_curve(shape, 0);
    int n = points_of(base) * bat_curve_dimension(base);
    double deltas[POINTS_MAX];
    for (int i = 0; i < n; i++) deltas[i] = points[i] - bat_curve_points(base)[i];
    must(bat_shape_move_many(shape, 0, 0, bat_curve_count(base), deltas));
}

/* A bump on control point i of the level: so far to the left of the curve as seen from above. */
static void bump(bat_shape *shape, int level, int i, double height) {
    const bat_curve *below = bat_shape_curve(shape, level - 1);
    double d[6];
    bat_curve_eval(below, bat_shape_nodes(shape, level)[i], 1, d);
    const double *t = d + bat_curve_dimension(below);
    double delta[3] = {-t[1] * height / hypot(t[0], t[1]), t[0] * height / hypot(t[0], t[1]), 0};
    must(bat_shape_move(shape, level, i, delta));
}

/* What level j adds to each control point: along the curve below, to its left (in space: away from it, unsigned), and as
 * it stands in the world. */
typedef struct measured {
    int count;
    double along[POINTS_MAX], aside[POINTS_MAX], world[POINTS_MAX][3], curvature[POINTS_MAX];
} measured;

static void measure(const bat_shape *shape, int level, measured *m) {
    const bat_curve *curve = bat_shape_curve(shape, level), *below = bat_shape_curve(shape, level - 1);
    int dimension = bat_curve_dimension(curve);
    bat_curve *refined;
    must(bat_curve_refine(below, bat_curve_knot_count(curve), bat_curve_knots(curve), &refined));
    m->count = points_of(curve);
    for (int i = 0; i < m->count; i++) {
        double d[6] = {0}, *v = m->world[i], u = bat_shape_nodes(shape, level)[i], length = 0, square = 0;
        bat_curve_eval(below, u, 1, d);
        const double *t = d + dimension;
        m->along[i] = v[2] = 0;
        for (int c = 0; c < dimension; c++) {
            v[c] = bat_curve_points(curve)[i * dimension + c] - bat_curve_points(refined)[i * dimension + c];
            m->along[i] += v[c] * t[c];
            length += t[c] * t[c], square += v[c] * v[c];
        }
        length = sqrt(length);
        m->along[i] /= length;
        m->aside[i] = dimension == 2 ? (t[0] * v[1] - t[1] * v[0]) / length
                                     : sqrt(fmax(0, square - m->along[i] * m->along[i]));
        m->curvature[i] = bat_curve_curvature(below, u);
    }
    bat_curve_free(refined);
}

/* The greatest difference between two lists. */
static double apart(const double *a, const double *b, int count) {
    double most = 0;
    for (int i = 0; i < count; i++) most = fmax(most, fabs(a[i] - b[i]));
    return most;
}

static double curves_apart(const bat_curve *a, const bat_curve *b) {
    return apart(bat_curve_points(a), bat_curve_points(b), points_of(a) * bat_curve_dimension(a));
}

/* Details are as long as they were, and lie to the same side. */
static bool kept(const measured *a, const measured *b) {
    return apart(a->along, b->along, a->count) < 1e-12 && apart(a->aside, b->aside, a->count) < 1e-12;
}

/* ---- Figure 2 ---- */

static void figure_2(void) {
    static const double ARCH[] = {0, 0, .7, 1.9, 2.3, 2.9, 4.3, 2.9, 5.9, 1.9, 6.6, 0},
                        WAVE[] = {0, 0, .7, 1.9, 2.3, 2.7, 3.9, -.4, 5.6, -.6, 6.6, 1.6};
    static const char *const RESULT[] = {"(d) in rotation-minimising frames", "(f) in Frenet frames",
                                         "(e) in a fixed system"};
    static const double PLACE[] = {20, 520, 270};
    enum { LEVEL = 3 };
    bat_curve *arch = curve_of(2, false, 6, ARCH);
    bat_curve *first = NULL;
    picture p;
    begin(&p, "fig2", 760, 400);
    for (int rule = 0; rule < 3; rule++) {
        static measured before, after;
        bat_shape *shape = shape_of(arch, (bat_frame_rule)rule, LEVEL);
        for (int i = 3; i < 25; i += 3) bump(shape, LEVEL, i, .75);
        measure(shape, LEVEL, &before);
        if (rule == 0) {
            must(bat_shape_flatten(shape, &first));
            panel(&p, 20, 150, 30, 20, 195, "(a) the curve at level 0");
            draw(&p, arch, INK), draw_points(&p, arch);
            panel(&p, 270, 150, 30, 270, 195, "(b) edited at level 3");
            draw(&p, arch, THIN), draw(&p, first, INK);
        }
        claim("Fig. 2: (b) is the same curve under all three rules",
              curves_apart(first, bat_shape_curve(shape, LEVEL)) < 1e-13);
        repose(shape, WAVE);
        measure(shape, LEVEL, &after);
        if (rule == 0) {
            panel(&p, 520, 150, 30, 520, 195, "(c) level 0 edited again");
            draw(&p, bat_shape_curve(shape, 0), INK), draw_points(&p, bat_shape_curve(shape, 0));
        }
        panel(&p, PLACE[rule], 320, 30, PLACE[rule], 385, RESULT[rule]);
        draw(&p, bat_shape_curve(shape, 0), THIN), draw(&p, bat_shape_curve(shape, LEVEL), INK);

        int changed = 0, wrong = 0;
        for (int i = 0; i < after.count; i++) {
            bool flips = before.curvature[i] * after.curvature[i] < 0;
            double sign = flips && rule == BAT_FRAMES_FRENET ? -1 : 1;
            changed += flips && fabs(before.aside[i]) > .5;
            wrong += !(fabs(after.aside[i] - sign * before.aside[i]) < 1e-12);
        }
        claim("Fig. 2: the curvature changes its sign under four of the eight bumps", changed == 4);
        if (rule == BAT_FRAMES_FIXED)
            claim("Fig. 2: in a fixed system details stand as they stood, and lean against the curve",
                  apart(*before.world, *after.world, 3 * after.count) < 1e-13 && wrong > 5);
        else
            claim(rule == BAT_FRAMES_RMF ? "Fig. 2: RMF keep every detail on its side"
                                         : "Fig. 2: Frenet frames change sides just where the curvature does",
                  wrong == 0);
        bat_shape_free(shape);
    }
    end(&p);
    bat_curve_free(first), bat_curve_free(arch);
}

/* ---- Figure 5 ---- */

/* A base of one segment and one level of `spans` equal spans with the coefficients h across the curve. */
static bat_shape *with_field(const bat_curve *base, bat_frame_rule rule, bat_node_rule nodes, int spans,
                             const double *h) {
    double knots[POINTS_MAX], details[3 * POINTS_MAX] = {0};
    bat_shape_options options = bat_shape_defaults();
    bat_shape *shape;
    options.frame = rule, options.nodes = nodes;
    for (int i = 0; i < spans + 7; i++) knots[i] = i < 4 ? 0 : i >= spans + 3 ? 1 : (double)(i - 3) / spans;
    for (int i = 0; i < spans + 3; i++) details[3 * i + 1] = h[i];
    must(bat_shape_create(base, &options, &shape));
    must(bat_shape_add_level(shape, spans + 7, knots, details, NULL));
    return shape;
}

/* How far C^0 + F D with frames taken at the nodes is from the offset curve, which is C^0 + F D itself. */
static double offset_error(const bat_curve *base, bat_node_rule nodes, int spans) {
    enum { SAMPLES = 4000 };
    double h[POINTS_MAX], most = 0, offset = .4;
    for (int i = 0; i < spans + 3; i++) h[i] = offset;
    bat_shape *shape = with_field(base, BAT_FRAMES_RMF, nodes, spans, h);
    for (int i = 0; i <= SAMPLES; i++) {
        double u = (double)i / SAMPLES, d[4], at[2];
        bat_curve_eval(base, u, 1, d);
        bat_curve_eval(bat_shape_curve(shape, 1), u, 0, at);
        double speed = hypot(d[2], d[3]);
        most = fmax(most, hypot(at[0] - d[0] + offset * d[3] / speed, at[1] - d[1] - offset * d[2] / speed));
    }
    bat_shape_free(shape);
    return most;
}

static void figure_5(void) {
    enum { SPANS = 16, COUNT = SPANS + 3 };
    static const double POINTS[] = {-3, -.9, -1.2, 3, 1.2, -3, 3, .9}, KNOTS[] = {0, 0, 0, 0, 1, 1, 1, 1};
    static const char *const RESULT[] = {"(d) in RMF", "(c) in Frenet frames", "(b) in a fixed system"};
    static const double PLACE[][2] = {{560, 400}, {190, 400}, {560, 140}};
    double h[COUNT] = {0}, graph[2 * COUNT], knots[COUNT + 4];
    bat_curve *base, *field;
    picture p;
    for (int i = 2; i < COUNT - 2; i++) h[i] = .8 * (i % 3 != 0);
    must(bat_curve_create(2, 3, false, 4, POINTS, 8, KNOTS, &base));
    for (int i = 0; i < COUNT + 4; i++) knots[i] = i < 4 ? 0 : i >= COUNT ? 1 : (i - 3) / (double)SPANS;
    for (int i = 0; i < COUNT; i++)
        graph[2 * i] = (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3, graph[2 * i + 1] = h[i];
    must(bat_curve_create(2, 3, false, COUNT, graph, COUNT + 4, knots, &field));

    begin(&p, "fig5", 760, 520);
    panel(&p, 40, 160, 0, 40, 245, "(a) h, drawn twice as high as in the others");
    for (int i = 0; i < COUNT; i++) graph[2 * i] *= 5.4, graph[2 * i + 1] *= 2;
    bat_curve *wide;
    must(bat_curve_create(2, 3, false, COUNT, graph, COUNT + 4, knots, &wide));
    p.scale = 550;
    line(&p, 2, (double[]){-.1, 0}, (double[]){5.6, 0}, FAINT);
    line(&p, 2, (double[]){0, -.1}, (double[]){0, 1.8}, FAINT);
    draw(&p, wide, INK);
    bat_curve_free(wide);
    for (int rule = 0; rule < 3; rule++) {
        bat_shape *shape = with_field(base, (bat_frame_rule)rule, BAT_NODES_GREVILLE, SPANS, h);
        static measured m;
        measure(shape, 1, &m);
        panel(&p, PLACE[rule][0], PLACE[rule][1], 55, PLACE[rule][0] - 165, PLACE[rule][1] + 105,
              RESULT[rule]);
        draw_normals(&p, shape, 1, (bat_frame_rule)rule, .45);
        draw(&p, base, THIN), draw(&p, bat_shape_curve(shape, 1), INK);
        double left = 0, right = 0, far = 0;
        for (int i = 0; i < m.count; i++) {
            double middle = bat_shape_nodes(shape, 1)[i] - .5;
            if (rule == BAT_FRAMES_RMF)
                claim("Fig. 5: RMF: h is added to the left throughout", fabs(m.aside[i] - h[i]) < 1e-13);
            if (middle < -1e-9) left += m.aside[i];
            if (middle > 1e-9) right += m.aside[i];
        }
        for (int i = 0; i <= 100; i++) {
            double at[2], on[2], value[2];
            bat_curve_eval(bat_shape_curve(shape, 1), i / 100., 0, at);
            bat_curve_eval(base, i / 100., 0, on);
            bat_curve_eval(field, i / 100., 0, value);
            far = fmax(far, hypot(at[0] - on[0], at[1] - on[1] - value[1]));
        }
        if (rule == BAT_FRAMES_FIXED) claim("Fig. 5: fixed: the sum is C^0 + (0, h)", far < 1e-13);
        if (rule == BAT_FRAMES_FRENET)
            claim("Fig. 5: Frenet frames: to the right, then to the left", left < -2 && right > 2);
        bat_shape_free(shape);
    }
    end(&p);

    double inflections[4];
    claim("Fig. 5: C'' vanishes at the origin, and only there",
          bat_curve_inflections(base, 4, inflections) == 1 && fabs(inflections[0] - .5) < 1e-9);
    printf("Frames at the nodes alone: distance from the offset curve, Greville and argmax nodes\n");
    double before[2] = {0, 0}, now[2] = {0, 0};
    for (int spans = 8; spans <= 512; spans *= 2) {
        for (int rule = 0; rule < 2; rule++) {
            before[rule] = now[rule];
            now[rule] = offset_error(base, (bat_node_rule)rule, spans);
        }
        printf("%6d spans  %.2e  %.2e\n", spans, now[0], now[1]);
    }
    claim("Greville nodes are second order", before[0] / now[0] > 3.7);
    claim("argmax nodes are first order at the ends", before[1] / now[1] < 2.3 && now[1] > 10 * now[0]);
    bat_curve_free(field), bat_curve_free(base);
}

/* ---- Figure 6 ---- */

static void figure_6(void) {
    enum { LEVEL = 5 };
    static const double BOW[] = {0, 0, 1.6, 3.2, 4.6, 3.2, 6.4, .4},
                        BENT[] = {0, 0, .5, 4.2, 6.3, -2.6, 6.6, 2.6};
    static measured before, after;
    bat_curve *base = curve_of(2, false, 4, BOW);
    bat_shape *shape = shape_of(base, BAT_FRAMES_RMF, LEVEL);
    double details[3 * POINTS_MAX];
    picture p;
    for (int j = 1; j <= LEVEL; j++)
        claim("Fig. 6, Table 2: 3 + 2^j frames at level j",
              points_of(bat_shape_curve(shape, j)) == 3 + (1 << j));
    for (int i = 4; i < 31; i += 2) bump(shape, LEVEL, i, .25 + .5 * sin(i * .1));
    measure(shape, LEVEL, &before);
    memcpy(details, bat_shape_details(shape, LEVEL), sizeof(double) * 3 * (size_t)before.count);
    begin(&p, "fig6", 760, 500);
    panel(&p, 40, 185, 48, 40, 215, "(a) level 0, four control points");
    draw(&p, base, INK), draw_points(&p, base);
    panel(&p, 420, 185, 48, 420, 215, "(b) edited at level 5");
    draw(&p, base, THIN), draw(&p, bat_shape_curve(shape, LEVEL), INK);
    repose(shape, BENT);
    measure(shape, LEVEL, &after);
    panel(&p, 40, 378, 36, 40, 490, "(c) level 0 edited");
    draw(&p, bat_shape_curve(shape, 0), INK), draw_points(&p, bat_shape_curve(shape, 0));
    panel(&p, 420, 378, 36, 420, 490, "(d) level 5 after (c)");
    draw(&p, bat_shape_curve(shape, 0), THIN), draw(&p, bat_shape_curve(shape, LEVEL), INK);
    end(&p);
    claim("Fig. 6: details stand to the curve as they stood", kept(&before, &after));
    claim("Fig. 6: their coefficients are the same bits",
          memcmp(details, bat_shape_details(shape, LEVEL), sizeof(double) * 3 * (size_t)before.count) == 0);
    repose(shape, BOW);
    measure(shape, LEVEL, &after);
    claim("Fig. 6: back again, all is as it was",
          apart(*before.world, *after.world, 3 * after.count) < 1e-13);
    bat_shape_free(shape), bat_curve_free(base);
}

/* ---- Figure 7 ---- */

enum { CREATURE = 30 };
/* Counterclockwise: the underside from the tail to the jaw, then back along the back. */
static const double CREATURE_POINTS[2 * CREATURE] = {
    0,    2.3, 3,    1.7,  6,    1.25, 8.7,  1,    9.2,  -.9, 11,   -1,   11.5, .8,  14,
    .5,   17,  .5,   18.5, .8,   18.7, -.9,  20.5, -1,   21,  .9,   23,   1.2,  26,  1.4,
    29,   1.5, 30.8, 1.8,  30.6, 2.7,  28,   2.4,  25.8, 2.6, 24.4, 3.65, 22.8, 3.6, 21.2,
    3.05, 18,  3.7,  15,   4,    12,   3.75, 9,    3.2,  6,   2.75, 3,    2.5,  1.2, 2.4};

/* The plane bent so that the line y = 1.5 takes the direction angle(x), a unit of it staying a unit. */
static void bend(double (*angle)(double), double *points) {
    enum { STEPS = 400 };
    for (int i = 0; i < CREATURE; i++) {
        double x = CREATURE_POINTS[2 * i], y = CREATURE_POINTS[2 * i + 1] - 1.5, at[2] = {15, 1.5},
               step = (x - 15) / STEPS;
        for (int k = 0; k < STEPS; k++) {
            double a = angle(15 + step * (k + .5));
            at[0] += step * cos(a), at[1] += step * sin(a);
        }
        points[2 * i] = at[0] - y * sin(angle(x)), points[2 * i + 1] = at[1] + y * cos(angle(x));
    }
}

static double angle_bowl(double x) { return .075 * (x - 15); }
static double angle_wave(double x) { return .75 * cos(.2 * (x - 1)); }

static void figure_7(void) {
    enum { LEVEL = 4, PARTS = 1 << LEVEL, COUNT = CREATURE * PARTS };
    static const char *const POSE[] = {"(c) level 0 edited: both ends raised", "(d) level 0 edited: a wave"};
    static double details[3 * COUNT];
    static measured before, after;
    bat_curve *base = curve_of(2, true, CREATURE, CREATURE_POINTS);
    bat_shape *shape = shape_of(base, BAT_FRAMES_RMF, LEVEL - 1), *copy;
    picture p;
    for (int i = 0; i < COUNT; i++) {
        /* Node of coefficient i; that of base point k is k + 2. The left of the curve is the inside. */
        double u = (double)(i + 2) / PARTS, *d = details + 3 * i;
        if (u > 31.2 || u < 1.2) u += u < 1.2 ? CREATURE : 0;
        static const double SCALE[4] = {0, .25, 1, .1}, LEAN[4] = {0, .1, .5, .3};
        double size = 0;
        if (u > 23.6 && u < 31.4) size = .35 + .6 * sin((u - 23.6) / 7.8 * 3.14159); /* the back */
        if (u > 15.2 && u < 17.6) size = .22;                                        /* the jaw */
        if (u > 3 && u < 4.9) size = .25;                                            /* under the tail */
        d[0] = size * LEAN[i % 4], d[1] = -size * SCALE[i % 4];
    }
    must(bat_shape_add_level(shape, 0, NULL, details, NULL));
    measure(shape, LEVEL, &before);
    begin(&p, "fig7", 760, 360);
    panel(&p, 15, 75, 11.3, 15, 110, "(a) level 0, 30 control points");
    draw(&p, base, INK);
    for (int i = 0, at[2]; i < CREATURE; i++) {
        place(&p, CREATURE_POINTS + 2 * i, 2, at);
        say(&p, "<circle cx='%d' cy='%d' r='24' fill='#1f62d6'/>\n", at[0], at[1]);
    }
    panel(&p, 395, 75, 11.3, 395, 110, "(b) edited at level 4");
    draw(&p, bat_shape_curve(shape, LEVEL), INK);
    for (int pose = 0; pose < 2; pose++) {
        double points[2 * CREATURE];
        bend(pose ? angle_wave : angle_bowl, points);
        must(bat_shape_copy(shape, &copy));
        repose(copy, points);
        measure(copy, LEVEL, &after);
        panel(&p, pose ? 385 : 15, pose ? 280 : 290, 11.3, pose ? 395 : 15, 345, POSE[pose]);
        draw(&p, bat_shape_curve(copy, 0), THIN), draw(&p, bat_shape_curve(copy, LEVEL), INK);
        claim("Fig. 7: every scale is as long as it was, and leans as it did", kept(&before, &after));
        claim("Fig. 7: their coefficients are the same bits",
              memcmp(bat_shape_details(copy, LEVEL), details, sizeof details) == 0);
        bat_shape_free(copy);
    }
    end(&p);
    claim("Fig. 7: a base of 30 points, 480 at level 4", bat_curve_count(base) == 30 && before.count == 480);
    bat_shape_free(shape), bat_curve_free(base);
}

/* ---- Figure 8 ---- */

/* The most that s turns from sample to sample, over what the tangent turns. */
static double spin(const bat_curve *curve, bat_frame_rule rule) {
    enum { SAMPLES = 4000 };
    static bat_frame3 frames[SAMPLES];
    static double u[SAMPLES];
    bat_frame_options options = bat_frame_defaults();
    double most = 0;
    options.rule = rule;
    bat_curve_spread(curve, SAMPLES, u);
    must(bat_frames(curve, SAMPLES, u, &options, frames, NULL));
    for (int i = 1; i < SAMPLES; i++) {
        double turn[2] = {0, 0};
        for (int d = 0; d < 3; d++) {
            turn[0] += pow(frames[i].t[d] - frames[i - 1].t[d], 2);
            turn[1] += pow(frames[i].s[d] - frames[i - 1].s[d], 2);
        }
        most = fmax(most, sqrt(turn[1]) / fmax(sqrt(turn[0]), 1e-4));
    }
    return most;
}

/* A curve in space over its shadow. */
static void draw_in_space(picture *p, const bat_shape *shape, int level) {
    static const double FLAT[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, -1.6};
    const bat_curve *curve = bat_shape_curve(shape, level);
    bat_curve *shadow;
    must(bat_curve_transform(curve, FLAT, &shadow));
    draw(p, shadow, FAINT);
    for (int i = 0; i <= 12; i++) {
        double at[3], under[3], u = bat_curve_knots(curve)[bat_curve_count(curve)] * i / 12;
        bat_curve_eval(curve, u, 0, at);
        bat_curve_eval(shadow, u, 0, under);
        line(p, 3, at, under, FAINT);
    }
    bat_curve_free(shadow);
    draw(p, bat_shape_curve(shape, 0), THIN), draw(p, curve, INK);
}

static void figure_8(void) {
    enum { LEVEL = 4 };
    static const double FIRST[] = {0, 0, 0, 1.4, 2.6, 0, 4.2, 2.6, 0, 5.6, 0, 0},
                        RISEN[] = {0, 0, 0, .6, 4.6, 1.2, 5.4, 1.2, 3.2, 5.6, -1.6, 1.2},
                        TWISTED[] = {0, 0, 2.2, -.6, 4.4, -1.6, 6.6, 3.8, 3.6, 5.6, -1.4, -.6};
    static measured before, after;
    bat_curve *base = curve_of(3, false, 4, FIRST);
    bat_shape *shape = shape_of(base, BAT_FRAMES_RMF, LEVEL);
    picture p;
    begin(&p, "fig8", 760, 520);
    panel(&p, 20, 130, 38, 20, 205, "(a) level 0");
    draw(&p, base, INK), draw_points(&p, base);
    for (int i = 2; i < 17; i += 2) bump(shape, LEVEL, i, .9);
    measure(shape, LEVEL, &before);
    panel(&p, 275, 130, 38, 275, 205, "(b) edited at level 4");
    draw(&p, base, THIN), draw(&p, bat_shape_curve(shape, LEVEL), INK);
    must(bat_shape_move(shape, 1, 2, (double[]){0, -2.6, 0}));
    panel(&p, 530, 130, 38, 530, 205, "(c) edited at level 1");
    draw(&p, bat_shape_curve(shape, 1), THIN), draw(&p, bat_shape_curve(shape, LEVEL), INK);
    must(bat_shape_move(shape, 2, 5, (double[]){.2, 1.5, 0}));
    panel(&p, 20, 330, 38, 20, 505, "(d) edited at level 2");
    draw(&p, bat_shape_curve(shape, 2), THIN), draw(&p, bat_shape_curve(shape, LEVEL), INK);
    measure(shape, LEVEL, &after);
    claim("Fig. 8: edits at levels 1 and 2 keep the details of level 4", kept(&before, &after));
    claim("Fig. 8: in the plane Frenet frames flip, RMF turn as the tangent does",
          spin(bat_shape_curve(shape, 2), BAT_FRAMES_FRENET) > 100 &&
              spin(bat_shape_curve(shape, 2), BAT_FRAMES_RMF) < 1.001);
    for (int pose = 0; pose < 2; pose++) {
        repose(shape, pose ? TWISTED : RISEN);
        measure(shape, LEVEL, &after);
        panel(&p, pose ? 560 : 300, pose ? 370 : 400, pose ? 28 : 32, pose ? 530 : 275, 505,
              pose ? "(f) another, from another side" : "(e) level 0 edited in space");
        p.turn = pose ? -.5 : .35, p.raise = .5;
        draw_in_space(&p, shape, LEVEL);
        claim("Fig. 8: in space details keep their length and their lean", kept(&before, &after));
        double rmf = spin(bat_shape_curve(shape, LEVEL - 1), BAT_FRAMES_RMF),
               frenet = spin(bat_shape_curve(shape, LEVEL - 1), BAT_FRAMES_FRENET);
        claim("Fig. 8: in space RMF turn no more than the tangent does, Frenet frames do",
              rmf < 1.001 && frenet > (pose ? 15 : 45));
        printf(
            "Fig. 8 (%c): s turns at most %.3f times as fast as t with RMF, %.0f times with Frenet frames\n",
            pose ? 'f' : 'e', rmf, frenet);
    }
    end(&p);

    /* The second condition of section 3.2, that frames change little when the curve is edited: control point 1 of level
     * 2 reaches half of the curve. Behind it a plain chain of RMF spins all details. */
    for (int plain = 0; plain < 2; plain++) {
        bat_shape_options options = *bat_shape_options_of(shape);
        bat_shape *other;
        options.propagation = plain ? BAT_PROPAGATION_PLAIN : BAT_PROPAGATION_LOCAL;
        must(bat_shape_create(bat_shape_curve(shape, 0), &options, &other));
        for (int j = 1; j <= LEVEL; j++)
            must(bat_shape_add_level(other, 0, NULL, bat_shape_details(shape, j), NULL));
        measure(other, LEVEL, &before);
        must(bat_shape_move(other, 2, 1, (double[]){.2, -.1, .3}));
        measure(other, LEVEL, &after);
        double most = 0; /* angle by which a detail turns, degrees */
        for (int i = 0; i < after.count; i++) {
            const double *v = before.world[i], *w = after.world[i];
            double square = 0, size = 0;
            for (int d = 0; d < 3; d++) square += pow(w[d] - v[d], 2), size += v[d] * v[d];
            if (bat_shape_nodes(other, LEVEL)[i] > .75 && size > .01)
                most = fmax(most, 2 * asin(fmin(1, sqrt(square / size) / 2)) * 90 / acos(0));
        }
        if (plain)
            claim("a plain chain moves details far from the edit", fabs(most - 11.3) < .1);
        else
            claim("the local one leaves them where they are", most < 1e-12);
        printf("Fig. 8 (f), control point 1 of level 2 moved: details in the last quarter turn by %.3g "
               "degrees (%s)\n",
               most, plain ? "a plain chain" : "local");
        bat_shape_free(other);
    }
    bat_shape_free(shape), bat_curve_free(base);
}

int main(int count, char **words) {
    folder = count > 1 ? words[1] : NULL;
    figure_2();
    figure_5();
    figure_6();
    figure_7();
    figure_8();
    return failed ? 1 : 0;
}
