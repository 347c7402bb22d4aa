#include "scenes.h"

#include <batten/batten.h>

#include <math.h>
#include <stdlib.h>

#include "document/lettering.h"
#include "kinds/primitive.h"
#include "support/pen.h"
#include "support/pictures.h"
#include "support/walker.h"

/* A row of an editor's life: a document, then the commands that lead to the state. */
static bat_editor *open(bat_document *document, const char *const *commands) {
    bat_editor *editor = NULL;
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    if (bat_editor_create(&editor) != BAT_OK) abort();
    bat_editor_resize(editor, 1000, 800, 1);
    if (bat_editor_open(editor, document, "growth") != BAT_OK) abort();
    bat_editor_command(editor, "zoom-100");
    for (; commands && *commands; commands++)
        if (bat_editor_command(editor, *commands) == BAT_UNSUPPORTED) abort();
    bat_editor_frame(editor);
    return editor;
}

static bat_document *document(void) {
    bat_document *made = NULL;
    if (bat_document_create(&made) != BAT_OK) abort();
    return made;
}

/* Of count points along a wave from (x, y), `step` apart; no two alike. */
static bat_curve *wave(double x, double y, double step, int count, bool closed) {
    double *points = malloc(sizeof(double) * 2 * (size_t)count),
           *knots = malloc(sizeof(double) * ((size_t)count + 4));
    bat_curve *curve = NULL;
    if (!points || !knots) abort();
    for (int i = 0; i < count; i++) {
        double angle = 6.283185307179586 * i / count, radius = closed ? step * count / 6 : 0;
        points[2 * i] = closed ? x + radius * cos(angle) : x + step * i;
        points[2 * i + 1] = closed ? y + radius * sin(angle) : y + 20 * sin(points[2 * i] / 25 + y);
    }
    for (int i = 0; i < count + 4; i++) knots[i] = closed ? i : i < 4 ? 0 : i >= count ? count - 3 : i - 3;
    if (bat_curve_create(2, 3, closed, (size_t)count, points, closed ? count + 1 : count + 4, knots,
                         &curve) != BAT_OK)
        abort();
    free(points);
    free(knots);
    return curve;
}

/* Appends it as it would be in the group. Takes the object over. */
static bat_id append(bat_document *to, bat_object *object, bat_id parent) {
    bat_object *placed = NULL;
    bat_id id = bat_object_id(object);
    if (bat_object_with_parent(object, parent, &placed) != BAT_OK) abort();
    if (bat_document_insert(to, bat_document_count(to), placed) != BAT_OK) abort();
    bat_object_release(placed);
    bat_object_release(object);
    return id;
}

static bat_id add_curves(bat_document *to, int count, bat_curve **curves, bat_id parent) {
    bat_object *object = NULL;
    bat_style style = bat_style_defaults();
    if (bat_object_create_path(bat_document_new_id(to), "line", &style, count, curves, &object) != BAT_OK)
        abort();
    return append(to, object, parent);
}

static bat_id add_curve(bat_document *to, bat_curve *curve, bat_id parent) {
    return add_curves(to, 1, &curve, parent);
}

typedef enum shape { LINES, RINGS, MIXED } shape;

/* The i-th of many, in a square about the middle of the view: what lies there is the same at every n. The first two lie
 * far out, so that the box around all is, too. */
static bat_id add_small(bat_document *to, int i, int n, shape closed, bat_id parent) {
    int side = (int)ceil(sqrt(n)), column = i % side - side / 2, row = i / side - side / 2;
    if (i < 2 && n > 2) column = row = i ? 70 : -70;
    return add_curve(to,
                     wave(400.0123456789 + 40.0123456789 * column + 0.3 * row, 400.3 + 30 * row, 7.0123456789,
                          5, closed == MIXED ? (column + row) % 3 == 0 : closed == RINGS),
                     parent);
}

static bat_id add_group(bat_document *to, bool layer, bat_id parent) {
    bat_object *group = NULL;
    if (bat_object_create_group(bat_document_new_id(to), "group", layer, &group) != BAT_OK) abort();
    return append(to, group, parent);
}

static const char *const choose_all[] = {"tool-select", "select-all", NULL};

static bat_editor *lines(int n) {
    bat_document *made = document();
    for (int i = 0; i < n; i++) add_small(made, i, n, LINES, 0);
    return open(made, choose_all);
}

/* The front ones have the lowest ids, every second one is chosen. */
static bat_editor *reversed(int n) {
    bat_document *made = document();
    for (int i = 0; i < n; i++) {
        add_small(made, i, n, RINGS, 0);
        bat_object *last = bat_object_retain(bat_document_at(made, i));
        bat_document_remove(made, i);
        bat_document_insert(made, 0, last);
        bat_object_release(last);
    }
    bat_editor *editor = open(made, (const char *const[]){"tool-select", NULL});
    for (int i = 2; i <= n; i += 2) bat_editor_select(editor, (bat_id)i, i > 2);
    bat_editor_frame(editor);
    return editor;
}

static bat_editor *group(int n) {
    bat_document *made = document();
    bat_id parent = add_group(made, false, 0);
    for (int i = 0; i < n; i++) add_small(made, i, n, LINES, parent);
    return open(made, choose_all);
}

static bat_editor *groups(int n) {
    bat_document *made = document();
    bat_id parent = 0;
    for (int i = 0; i < n; i++) {
        if (i % 4 == 0) parent = add_group(made, false, 0);
        add_small(made, i, n, MIXED, parent);
    }
    return open(made, choose_all);
}

/* Layers of eight; of the last, which is active, nothing is chosen. */
static bat_editor *layers(int n) {
    bat_document *made = document();
    bat_id layer = 0, last = 0;
    for (int i = 0; i < n; i++) {
        if (i % 8 == 0) layer = add_group(made, true, 0);
        add_small(made, i, n, LINES, layer);
    }
    last = add_group(made, true, 0);
    bat_editor *editor = open(made, choose_all);
    bat_editor_activate_layer(editor, last);
    bat_editor_frame(editor);
    return editor;
}

/* One layer with all in it, active; a second one before and behind. */
static bat_editor *layer(int n) {
    bat_document *made = document();
    add_small(made, 0, 1, LINES, add_group(made, true, 0));
    bat_id parent = add_group(made, true, 0);
    for (int i = 0; i < n; i++) add_small(made, i, n, LINES, parent);
    add_small(made, 0, 1, LINES, add_group(made, true, 0));
    bat_editor *editor = open(made, choose_all);
    bat_editor_activate_layer(editor, parent);
    bat_editor_frame(editor);
    return editor;
}

static bat_editor *subpaths(int n) {
    bat_document *made = document();
    bat_curve **curves = malloc(sizeof *curves * (size_t)n);
    if (!curves) abort();
    int side = (int)ceil(sqrt(n));
    for (int i = 0; i < n; i++)
        curves[i] = wave(400.0123456789 + 40.0123456789 * (i % side - side / 2),
                         400.3 + 30 * (i / side - side / 2), 7.0123456789, 5, i % 2);
    add_curves(made, n, curves, 0);
    free(curves);
    return open(made, choose_all);
}

static bat_editor *one_curve(int n, bool closed, const char *const *commands) {
    bat_document *made = document();
    bat_id id = add_curve(made, wave(100, 400, 800.0 / n, n, closed), 0);
    add_curve(made, wave(100, 700, 20, 20, false), 0);
    bat_editor *editor = open(made, commands);
    bat_editor_select(editor, id, false);
    bat_editor_frame(editor);
    return editor;
}

static bat_editor *points(int n) {
    bat_editor *editor = one_curve(n, false, NULL);
    bat_editor_choose(editor, 1, n / 2);
    bat_editor_frame(editor);
    return editor;
}

static bat_editor *ring(int n) { return one_curve(n, true, choose_all); }

static bat_editor *knot(int n) {
    bat_editor *editor = points(n);
    bat_editor_command(editor, "knot-next");
    bat_editor_frame(editor);
    return editor;
}

static bat_editor *corner(int n) {
    bat_editor *editor = points(n);
    bat_editor_command(editor, "corner-make");
    bat_editor_frame(editor);
    return editor;
}

static bat_editor *spline(int n) {
    bat_document *made = document();
    bat_object *object = NULL;
    double *p = malloc(sizeof(double) * 2 * (size_t)n);
    if (!p) abort();
    for (int i = 0; i < n; i++) p[2 * i] = 100 + 800.0 * i / n, p[2 * i + 1] = 400 + 40 * sin(p[2 * i] / 30);
    bat_style style = bat_style_defaults();
    bat_spline data = {.dimension = 2, .count = (size_t)n, .points = p};
    bat_tangents_options options; /* where directions are found together, how often depends on the points */
    bat_tangents_options_init(&options, sizeof options);
    options.mode = BAT_TANGENTS_FAITHFUL;
    if (bat_object_create_spline(bat_document_new_id(made), "", &style, &data, &options, &object) != BAT_OK)
        abort();
    append(made, object, 0);
    free(p);
    bat_editor *editor = open(made, NULL);
    bat_editor_choose(editor, 1, n / 2);
    bat_editor_frame(editor);
    return editor;
}

static bat_editor *apart(int n) { /* before it is taken apart */
    return one_curve(n, false, (const char *const[]){"tool-levels", NULL});
}

static bat_editor *with_surface_tool(int n) {
    return one_curve(n, false, (const char *const[]){"tool-surface", NULL});
}

static bat_editor *levels(int n) {
    bat_editor *editor = apart(n);
    bat_editor_command(editor, "take-apart");
    bat_editor_frame(editor);
    bat_editor_level(editor, BAT_LEVEL_CHOOSE, 1, 0, true);
    bat_editor_frame(editor);
    return editor;
}

static bat_editor *taken_apart(int n) {
    bat_editor *editor = levels(n);
    bat_editor_command(editor, "accept");
    bat_editor_frame(editor);
    return editor;
}

/* One long curve that trembles. */
static bat_editor *trembling(int n) {
    bat_document *made = document();
    bat_curve *smooth = wave(100, 400, 7, n, false), *rough = NULL;
    double *points = malloc(sizeof(double) * 2 * (size_t)n);
    if (!points) abort();
    for (int i = 0; i < 2 * n; i++) points[i] = bat_curve_points(smooth)[i] + sin(1e4 * sin(i));
    if (bat_curve_create(2, 3, false, (size_t)n, points, bat_curve_knot_count(smooth),
                         bat_curve_knots(smooth), &rough) != BAT_OK)
        abort();
    free(points);
    bat_curve_free(smooth);
    add_curve(made, rough, 0);
    return open(made, choose_all);
}

static bat_editor *range(int n) {
    return one_curve(n, false, (const char *const[]){"tool-sketch", "range", NULL});
}

static bat_editor *range_smooth(int n) {
    return one_curve(n, false, (const char *const[]){"tool-smooth", "range", NULL});
}

static bat_editor *range_eraser(int n) {
    return one_curve(n, true, (const char *const[]){"tool-eraser", "range", NULL});
}

/* The keyboard's pen over n lines. */
static bat_editor *waypoints(int n) {
    bat_document *made = document();
    for (int i = 0; i < n; i++) add_small(made, i, n, LINES, 0);
    return open(made, (const char *const[]){"tool-sketch", "place", "accept", "nudge-right", "accept",
                                            "nudge-up", "accept", NULL});
}

static bat_editor *guides(int n) {
    bat_document *made = document();
    for (int i = 0; i < n; i++) {
        bat_object *guide = NULL;
        double at = i < 2 ? 401 + 2 * i : 600.0123456789 + 0.7 * i;
        if (bat_object_create_guide(bat_document_new_id(made), i % 2, at, &guide) != BAT_OK) abort();
        append(made, guide, 0);
    }
    add_small(made, 0, 1, LINES, 0);
    return open(made, (const char *const[]){"tool-select", "show-rulers", "select-all", "guide-level", NULL});
}

/* A drawing of n lines in space, which are planar. */
static bat_document *in_space(int n) {
    bat_document *made = document();
    for (int i = 0; i < n; i++) {
        bat_curve *flat = wave(100, 100 + i % 600, 20, 8, false), *curve = NULL;
        if (bat_curve_to_dimension(flat, 3, &curve) != BAT_OK) abort();
        bat_curve_free(flat);
        add_curve(made, curve, 0);
    }
    return made;
}

/* They are chosen, and a sheet behind them is seen in a tilted view. */
static bat_editor *over_a_sheet(int n) {
    static const double corners[12] = {300, 300, -50, 300, 500, -40, 600, 300, -50, 600, 500, -60},
                        knots[4] = {0, 0, 1, 1};
    bat_document *made = in_space(n);
    bat_style style = bat_style_defaults();
    bat_surface *sheet = NULL;
    bat_object *object = NULL;
    if (bat_surface_create((const int[2]){1, 1}, (const bool[2]){false, false}, (const size_t[2]){2, 2},
                           corners, (const int[2]){4, 4}, knots, knots, &sheet) != BAT_OK ||
        bat_object_create_surface(bat_document_new_id(made), "sheet", &style, sheet, &object) != BAT_OK)
        abort();
    bat_surface_free(sheet);
    append(made, object, 0);
    return open(made, (const char *const[]){"tool-select", "select-all", "orbit-up", NULL});
}

/* Behind them are two planes and a saved view; the pen draws on the first. */
static bat_editor *planes(int n) {
    bat_document *made = in_space(n);
    for (int i = 0; i < 2; i++) {
        bat_object *plane = NULL;
        if (bat_object_create_plane(bat_document_new_id(made), "", (double[]){0, 0, 10.0 * i},
                                    (double[]){1, 0, 0, 0, 0.8, 0.6}, &plane) != BAT_OK)
            abort();
        append(made, plane, 0);
    }
    const bat_viewpoint above = {.eye = {0, 0, -9}, .up = {0, -1, 0}, .size = {1000, 800}, .height = 900};
    bat_object *view = NULL;
    if (bat_object_create_view(bat_document_new_id(made), "", &above, &view) != BAT_OK) abort();
    append(made, view, 0);
    return open(made, (const char *const[]){"tool-sketch", "draw-on-plane", NULL});
}

static bat_editor *pictures(int n) {
    bat_document *made = document();
    unsigned char head[HEAD_ROOM];
    bat_picture *picture = NULL;
    if (bat_picture_create(head, head_png(head, 30, 20), &picture) != BAT_OK) abort();
    for (int i = 0; i < n; i++) {
        bat_object *object = NULL;
        double matrix[6] = {1, 0, 0, 1, 400 + 40.0 * (i % 25), 400 + 30.0 * (i / 25)};
        if (bat_object_create_image(bat_document_new_id(made), "", picture, matrix, 1, &object) != BAT_OK)
            abort();
        append(made, object, 0);
    }
    bat_picture_release(picture);
    return open(made, choose_all);
}

/* After one step that moved, made and took away many. */
static bat_editor *stepped(int n) {
    bat_editor *editor = lines(n);
    bat_editor_command(editor, "nudge-right");
    bat_editor_frame(editor);
    return editor;
}
static bat_editor *deleted(int n) {
    bat_editor *editor = reversed(n);
    bat_editor_command(editor, "delete");
    bat_editor_frame(editor);
    return editor;
}
static bat_editor *undone(int n) {
    bat_editor *editor = reversed(n);
    bat_editor_command(editor, "duplicate");
    bat_editor_command(editor, "undo");
    bat_editor_frame(editor);
    return editor;
}

/* n steps of one object. */
static bat_editor *long_session(int n) {
    bat_editor *editor = lines(4);
    for (int i = 0; i < n; i++) bat_editor_command(editor, i % 2 ? "nudge-left" : "nudge-right");
    bat_editor_frame(editor);
    return editor;
}

/* Nothing chosen, all seen: where the pen works. */
static bat_editor *drawing(int n) {
    bat_document *made = document();
    for (int i = 0; i < n; i++) add_small(made, i, n, MIXED, 0);
    return open(made, (const char *const[]){"tool-sketch", NULL});
}

/* All on one spot. */
static bat_editor *heap(int n) {
    bat_document *made = document();
    for (int i = 0; i < n; i++) add_curve(made, wave(400 + 0.001 * i, 400, 20, 12, false), 0);
    return open(made, (const char *const[]){"tool-select", NULL});
}

/* They were clicked where they begin. */
static bat_editor *heap_clicked(int n) {
    bat_editor *editor = heap(n);
    pen p = pen_for(editor);
    const double y = 400 + 20 * sin(400.0 / 25 + 400);
    pen_event(&p, BAT_POINTER_DOWN, 400, y);
    pen_event(&p, BAT_POINTER_UP, 400, y);
    bat_editor_frame(editor);
    return editor;
}

/* Two, to be joined; with n beside them. */
static bat_editor *pair(int n) {
    bat_document *made = document();
    for (int i = 0; i < n; i++) add_small(made, i, n, LINES, 0);
    bat_editor *editor = open(made, (const char *const[]){"tool-select", NULL});
    bat_editor_select(editor, 1, false);
    bat_editor_select(editor, 2, true);
    bat_editor_frame(editor);
    return editor;
}

/* Two rings that cross, with n lines beside them. */
static bat_editor *crossing(int n) {
    bat_document *made = document();
    bat_id ids[2];
    for (int i = 0; i < n; i++) add_small(made, i, n, LINES, 0);
    for (int i = 0; i < 2; i++) ids[i] = add_curve(made, wave(401 + 5 * i, 401, 7, 5, true), 0);
    bat_editor *editor = open(made, (const char *const[]){"tool-select", NULL});
    for (int i = 0; i < 2; i++) bat_editor_select(editor, ids[i], i > 0);
    bat_editor_frame(editor);
    return editor;
}

static bat_curve *segment(double x0, double y0, double x1, double y1) {
    bat_curve *line = NULL;
    if (bat_curve_create_clamped(2, 1, 2, (double[]){x0, y0, x1, y1}, &line) != BAT_OK) abort();
    return line;
}

/* Chosen lines that bound a patch, side by side, or a profile and an axis, with n others beside them. */
static bat_editor *among(int n, int count, double lines[][4], const char *then) {
    bat_document *made = document();
    bat_id ids[4];
    for (int i = 0; i < n; i++) add_small(made, i, n, LINES, 0);
    for (int i = 0; i < count; i++)
        ids[i] = add_curve(made, segment(lines[i][0], lines[i][1], lines[i][2], lines[i][3]), 0);
    bat_editor *editor = open(made, (const char *const[]){"tool-select", NULL});
    for (int i = 0; i < count; i++) bat_editor_select(editor, ids[i], i > 0);
    if (then && bat_editor_command(editor, then) != BAT_OK) abort();
    bat_editor_frame(editor);
    return editor;
}

static double ring_of_four[4][4] = {
    {300, 300, 500, 300}, {500, 300, 520, 500}, {520, 500, 280, 500}, {280, 500, 300, 300}};
static double four_apart[4][4] = {
    {301, 300, 500, 300}, {500, 300, 520, 500}, {520, 500, 280, 500}, {280, 500, 300, 300}};
static double side_by_side[4][4] = {{300, 300, 500, 300}, {300, 400, 500, 410}, {300, 500, 500, 490}};
static bat_editor *bounds(int n) { return among(n, 4, ring_of_four, NULL); }
static bat_editor *bounds_apart(int n) { return among(n, 4, four_apart, NULL); }
static double two_lines[4][4] = {{300, 300, 400, 500}, {250, 600, 250, 200}};
static bat_editor *with_axis(int n) { return among(n, 2, two_lines, NULL); }
static bat_editor *sections(int n) { return among(n, 3, side_by_side, NULL); }
/* A mesh of n vertices in a row of squares, and a wire along it; both are chosen. */
static bat_editor *mesh_and_wire(int n, const char *then, bool wire_too) {
    bat_document *made = document();
    const bat_style style = bat_style_defaults();
    const int squares = n / 2 - 1;
    double *vertices = calloc((size_t)3 * (size_t)n, sizeof *vertices);
    int *sizes = calloc((size_t)n, sizeof *sizes), *corners = calloc((size_t)4 * (size_t)n, sizeof *corners);
    bat_polymesh *mesh = NULL;
    bat_object *object = NULL;
    if (!vertices || !sizes || !corners) abort();
    for (int i = 0; i < n; i++)
        vertices[3 * i] = 200 + 400.0 * (i / 2) / n, vertices[3 * i + 1] = 300 + 50 * (i % 2);
    for (int i = 0; i < squares; i++) {
        const int face[4] = {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1};
        memcpy(corners + (ptrdiff_t)4 * i, face, sizeof face);
        sizes[i] = 4;
    }
    if (bat_polymesh_create((size_t)n / 2 * 2, vertices, (size_t)squares, sizes, corners, &mesh, NULL) !=
            BAT_OK ||
        bat_object_create_mesh(bat_document_new_id(made), "mesh", &style, mesh, &object) != BAT_OK ||
        bat_document_insert(made, 0, object) != BAT_OK)
        abort();
    bat_object_release(object);
    bat_polymesh_free(mesh);
    free(vertices), free(sizes), free(corners);
    const bat_id wire = add_curve(made, segment(200, 320, 400, 320), 0);
    const bat_id other = add_curve(made, segment(200, 340, 400, 340), 0);
    bat_editor *editor = open(made, (const char *const[]){"tool-select", NULL});
    bat_editor_select(editor, 1, false);
    bat_editor_select(editor, wire, true);
    if (then && bat_editor_command(editor, then) != BAT_OK) abort();
    if (wire_too) bat_editor_select(editor, other, true);
    bat_editor_frame(editor);
    return editor;
}
static bat_editor *to_be_bound(int n) { return mesh_and_wire(n, NULL, false); }
static bat_editor *bound_mesh(int n) { return mesh_and_wire(n, "wire-bind", false); }
static bat_editor *bound_and_beside(int n) { return mesh_and_wire(n, "wire-bind", true); }

static void add_sheet(bat_document *made, const double points[12]) {
    const double knots[4] = {0, 0, 1, 1};
    const bat_style style = bat_style_defaults();
    bat_surface *sheet = NULL;
    bat_object *object = NULL;
    if (bat_surface_create((const int[2]){1, 1}, (const bool[2]){false, false}, (const size_t[2]){2, 2},
                           points, (const int[2]){4, 4}, knots, knots, &sheet) != BAT_OK ||
        bat_object_create_surface(bat_document_new_id(made), "sheet", &style, sheet, &object) != BAT_OK ||
        bat_document_insert(made, bat_document_count(made), object) != BAT_OK)
        abort();
    bat_object_release(object);
    bat_surface_free(sheet);
}

/* Two surfaces that cross, chosen, with n curves beside them. */
static bat_editor *crossing_sheets(int n) {
    bat_document *made = document();
    for (int i = 0; i < n; i++) add_small(made, i, n, LINES, 0);
    add_sheet(made, (const double[]){300, 300, 0, 300, 500, 0, 500, 300, 0, 500, 500, 0});
    add_sheet(made, (const double[]){400, 250, -99, 400, 250, 99, 410, 550, -99, 410, 550, 99});
    bat_editor *editor = open(made, (const char *const[]){"tool-select", NULL});
    bat_editor_select(editor, (bat_id)n + 1, false);
    bat_editor_select(editor, (bat_id)n + 2, true);
    bat_editor_frame(editor);
    return editor;
}
static bat_editor *turned_surface(int n) { return among(n, 2, two_lines, "surface-revolve"); }
static bat_editor *made_surface(int n) { return among(n, 3, side_by_side, "surface-loft"); }

/* A straight one, chosen, with n beside it. */
static bat_editor *straight(int n) {
    bat_document *made = document();
    bat_curve *line = NULL;
    if (bat_curve_create_clamped(2, 1, 2, (double[]){380, 390, 430.5, 410.25}, &line) != BAT_OK) abort();
    for (int i = 0; i < n; i++) add_small(made, i, n, LINES, 0);
    const bat_id id = add_curve(made, line, 0);
    bat_editor *editor = open(made, (const char *const[]){"tool-select", NULL});
    bat_editor_select(editor, id, false);
    bat_editor_frame(editor);
    return editor;
}

static bat_editor *straight_among(int n) {
    bat_editor *editor = straight(n);
    bat_editor_command(editor, "select-all");
    bat_editor_frame(editor);
    return editor;
}

/* Parts of two ellipses, one closed and one open, chosen, with n lines beside them. */
static bat_editor *arcs(int n) {
    bat_document *made = document();
    const bat_style style = bat_style_defaults();
    bat_id ids[2];
    for (int i = 0; i < n; i++) add_small(made, i, n, LINES, 0);
    for (int k = 0; k < 2; k++) {
        bat_primitive part = bat_primitive_ellipse((double[]){400 + 90 * k, 380, 480 + 90 * k, 440});
        bat_object *object = NULL;
        part.sweep = 200, part.ends = k ? BAT_ARC_OPEN : BAT_ARC_PIE;
        ids[k] = bat_document_new_id(made);
        if (bat_object_create_primitive(ids[k], "arc", &style, &part, &object) != BAT_OK) abort();
        append(made, object, 0);
    }
    bat_editor *editor = open(made, (const char *const[]){"tool-select", NULL});
    for (int k = 0; k < 2; k++) bat_editor_select(editor, ids[k], k > 0);
    bat_editor_frame(editor);
    return editor;
}

/* A text of n letters, chosen. */
static bat_editor *lettered(int n) {
    bat_document *made = document();
    bat_lettering letters = bat_lettering_defaults();
    bat_object *object = NULL;
    char *content = calloc((size_t)n + 1, 1);
    if (!content) abort();
    for (int i = 0; i < n; i++) content[i] = "a b,c\n"[i % 6];
    letters.content = content, letters.box[2] = 60, letters.box[3] = 4.0 * n;
    const bat_id id = bat_document_new_id(made);
    if (bat_object_create_text(id, "", &letters, (double[]){1, 0, 0, 1, 400, 300}, 0xff, 1, &object) !=
        BAT_OK)
        abort();
    free(content);
    append(made, object, 0);
    bat_editor *editor = open(made, (const char *const[]){"tool-select", NULL});
    bat_editor_select(editor, id, false);
    bat_editor_frame(editor);
    return editor;
}

static bat_editor *turned(int n) {
    bat_editor *editor = lines(n);
    bat_editor_command(editor, "view-right");
    bat_editor_frame(editor);
    return editor;
}

static bat_editor *tilted(int n) {
    bat_editor *editor = lines(n);
    bat_editor_command(editor, "orbit-up");
    bat_editor_frame(editor);
    return editor;
}

/* After a stroke that can be read in several ways. */
static bat_editor *redrawn(int n) {
    bat_document *made = document();
    for (int i = 0; i < n; i++) add_small(made, i, n, MIXED, 0);
    add_curve(made, pen_curve(270, 415, 25, 0, 11), 0);
    bat_editor *editor = open(made, (const char *const[]){"tool-sketch", NULL});
    pen p = pen_for(editor);
    pen_line(&p, 300, 410, 480, 410, 0);
    bat_editor_frame(editor);
    return editor;
}

/* A stroke of n samples over n lines was taken away. */
static bat_editor *taken_away(int n) {
    bat_document *made = document();
    for (int i = 0; i < n; i++) add_small(made, i, n, MIXED, 0);
    bat_editor *editor = open(made, (const char *const[]){"tool-sketch", NULL});
    pen p = pen_for(editor);
    pen_begin(&p, pen_arch, (double[]){300, 410, 480, 410, 20}, n);
    pen_event(&p, BAT_POINTER_CANCEL, 480, 410);
    bat_editor_frame(editor);
    return editor;
}

/* A camera along a curve of n points. */
static bat_editor *flight(int n) {
    static const char *const commands[] = {"tool-select", "camera-along", "move-next"};
    bat_editor *editor = one_curve(n, false, NULL);
    for (int i = 0; i < 3; i++) bat_editor_command(editor, commands[i]);
    bat_editor_frame(editor);
    return editor;
}

/* The same, with a key in the middle that is chosen. */
static bat_editor *gaze(int n) {
    bat_editor *editor = flight(n);
    bat_editor_seek(editor, 1.7);
    bat_editor_command(editor, "gaze-add");
    return editor;
}

/* n curves with a camera each. */
static bat_editor *cameras(int n) {
    bat_document *made = document();
    bat_style style = bat_style_defaults();
    bat_camera_options options = bat_camera_defaults();
    bat_id two[2] = {0, 0};
    options.mode = BAT_CAMERA_ALONG;
    for (int i = 0; i < n; i++) {
        const bat_id id = add_small(made, i, n, LINES, 0);
        bat_camera *camera = NULL;
        bat_object *object = NULL;
        const bat_object *curve = bat_document_at(made, bat_document_find(made, id));
        if (bat_camera_create(bat_object_curve(curve, 0), &options, &camera) != BAT_OK ||
            bat_object_create_camera(bat_document_new_id(made), "", &style, camera, id, &object) != BAT_OK)
            abort();
        bat_camera_free(camera);
        two[0] = two[1], two[1] = bat_object_id(object);
        append(made, object, 0);
    }
    bat_editor *editor = open(made, (const char *const[]){"tool-select", "move-next", "deselect", NULL});
    for (int i = 0; i < 2; i++) bat_editor_select(editor, two[i], true);
    return editor;
}

/* A skeleton of n frames, which is selected. */
static bat_editor *skeleton(int n) {
    const bat_style style = bat_style_defaults();
    bat_document *made = document();
    bat_take *take = walker(3, (size_t)n);
    bat_motion *motion = NULL;
    bat_object *object = NULL;
    const bat_id id = bat_document_new_id(made);
    if (!take || bat_motion_fit(take, NULL, &motion, NULL) != BAT_OK ||
        bat_object_create_skeleton(id, "", &style, motion, NULL, &object) != BAT_OK)
        abort();
    bat_motion_free(motion), bat_take_free(take);
    append(made, object, 0);
    bat_editor *editor = open(made, (const char *const[]){"tool-select", NULL});
    bat_editor_select(editor, id, false);
    bat_editor_frame(editor);
    return editor;
}

static bat_editor *isolated(int n) {
    bat_editor *editor = groups(n);
    bat_editor_command(editor, "isolate");
    bat_editor_frame(editor);
    return editor;
}

const growth_scene growth_scenes[] = {
    {"n lines", lines},
    {"n rings, ids from the front, half chosen", reversed},
    {"a group of n", group},
    {"a stroke of n samples over n lines, taken away", taken_away},
    {"a camera along a curve of n points", flight},
    {"a skeleton of n frames", skeleton},
    {"a camera along a curve of n points, a key chosen", gaze},
    {"n cameras", cameras},
    {"n/4 groups", groups},
    {"n/8 layers", layers},
    {"a layer of n", layer},
    {"an object of n curves", subpaths},
    {"a curve of n points, one chosen", points},
    {"a curve of n points, a knot chosen", knot},
    {"a curve of n points, a corner chosen", corner},
    {"a curve of n points that trembles", trembling},
    {"a ring of n points", ring},
    {"a spline of n points", spline},
    {"n points, to be taken apart", apart},
    {"n points, the surface tool", with_surface_tool},
    {"n points in levels", levels},
    {"a curve of n points with levels", taken_apart},
    {"a range of n points", range},
    {"a range of n points, to be smoothed", range_smooth},
    {"a range of a ring of n points, to be rubbed out", range_eraser},
    {"waypoints over n lines", waypoints},
    {"n guides", guides},
    {"n lines in space, and planes", planes},
    {"n lines in space, and a sheet", over_a_sheet},
    {"n pictures", pictures},
    {"n lines, moved", stepped},
    {"n rings, half deleted", deleted},
    {"n rings, half duplicated and back", undone},
    {"n steps", long_session},
    {"n curves, nothing chosen", drawing},
    {"n curves, after a stroke", redrawn},
    {"n lines, the view turned", turned},
    {"n lines, the view tilted", tilted},
    {"n curves on one spot", heap},
    {"n curves on one spot, one clicked", heap_clicked},
    {"two of n lines", pair},
    {"two rings that cross, of n", crossing},
    {"four around a patch, of n", bounds},
    {"four that nearly meet, of n", bounds_apart},
    {"a profile and an axis, of n", with_axis},
    {"three side by side, of n", sections},
    {"a surface that follows three of n", made_surface},
    {"a surface around an axis, of n", turned_surface},
    {"a mesh of n vertices and a curve", to_be_bound},
    {"a mesh of n vertices, bound to a wire", bound_mesh},
    {"a mesh of n vertices, bound to a wire, and a curve", bound_and_beside},
    {"two surfaces that cross, and n curves", crossing_sheets},
    {"a straight line beside n", straight},
    {"a straight line among n, all chosen", straight_among},
    {"parts of two ellipses beside n lines", arcs},
    {"a text of n letters", lettered},
    {"n/4 groups, isolated", isolated},
    {NULL, NULL},
};
