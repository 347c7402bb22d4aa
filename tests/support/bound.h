/* A sheet, a mesh or a curve that is bound to lines through it in an editor, and where what is bound has to be. Include after
 * editing.h. */
#ifndef BATTEN_TESTS_BOUND_H
#define BATTEN_TESTS_BOUND_H

#include "document/document.h"
#include "form/wire/match.h"

enum { SHEET = 1, WIRE = 2, OTHER = 3, SIDE = 12 };

/* A bicubic sheet over the page from (180, 180) to (620, 620). */
static inline bat_surface *sheet_of(void) {
    double points[3 * SIDE * SIDE], knots[SIDE + 4];
    bat_surface *sheet = NULL;
    for (int k = 0; k < SIDE + 4; k++) knots[k] = k < 4 ? 0 : k > SIDE ? SIDE - 3 : k - 3;
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) { /* at the means of the knots, so that parameters go evenly */
            double *p = points + 3 * (i * SIDE + j);
            p[0] = 180 + 440 * (knots[i + 1] + knots[i + 2] + knots[i + 3]) / (3 * (SIDE - 3));
            p[1] = 180 + 440 * (knots[j + 1] + knots[j + 2] + knots[j + 3]) / (3 * (SIDE - 3));
            p[2] = 0;
        }
    assert_int_equal(bat_surface_create((int[]){3, 3}, (bool[]){false, false}, (size_t[]){SIDE, SIDE}, points,
                                        (int[]){SIDE + 4, SIDE + 4}, knots, knots, &sheet),
                     BAT_OK);
    return sheet;
}

static inline bat_polymesh *mesh_of(void) {
    double vertices[3 * SIDE * SIDE];
    int sizes[SIDE * SIDE], corners[4 * SIDE * SIDE], faces = 0;
    bat_polymesh *mesh = NULL;
    for (int i = 0; i < SIDE * SIDE; i++) {
        vertices[3 * i] = 200 + 400.0 * (i / SIDE) / (SIDE - 1);
        vertices[3 * i + 1] = 200 + 400.0 * (i % SIDE) / (SIDE - 1);
        vertices[3 * i + 2] = 0;
        if (i / SIDE == SIDE - 1 || i % SIDE == SIDE - 1) continue;
        const int face[4] = {i, i + SIDE, i + SIDE + 1, i + 1};
        memcpy(corners + (ptrdiff_t)4 * faces, face, sizeof face);
        sizes[faces++] = 4;
    }
    assert_int_equal(bat_polymesh_create(SIDE * SIDE, vertices, (size_t)faces, sizes, corners, &mesh, NULL),
                     BAT_OK);
    return mesh;
}

static inline bat_curve *line_at(double x) {
    bat_curve *line = NULL;
    const double points[] = {x, 250, x, 350, x, 450, x, 550};
    assert_int_equal(bat_curve_create_clamped(2, 3, 4, points, &line), BAT_OK);
    return line;
}

static inline void add(bat_document *document, bat_object *object) {
    assert_int_equal(bat_document_insert(document, bat_document_count(document), object), BAT_OK);
    bat_object_release(object);
}

static inline void add_line(bat_document *document, bat_id id, double x) {
    const bat_style style = bat_style_defaults();
    bat_curve *line = line_at(x);
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_path(id, "", &style, 1, &line, &object), BAT_OK);
    add(document, object);
}

typedef enum what { A_SHEET, A_MESH, A_CURVE } what;

/* The thing with id SHEET, and lines through it at x = 400 and, with two, 500. */
static inline bat_editor *open(what thing, int lines) {
    const bat_style style = bat_style_defaults();
    bat_document *document = NULL;
    bat_object *object = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    if (thing == A_SHEET) {
        bat_surface *sheet = sheet_of();
        assert_int_equal(bat_object_create_surface(SHEET, "", &style, sheet, &object), BAT_OK);
        bat_surface_free(sheet);
        add(document, object);
    } else if (thing == A_MESH) {
        bat_polymesh *mesh = mesh_of();
        assert_int_equal(bat_object_create_mesh(SHEET, "", &style, mesh, &object), BAT_OK);
        bat_polymesh_free(mesh);
        add(document, object);
    } else {
        add_line(document, SHEET, 440);
    }
    for (int i = 0; i < lines; i++) add_line(document, (bat_id)(WIRE + i), 400 + 100 * i);
    bat_editor *editor = editor_of(document);
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    bat_editor_frame(editor);
    return editor;
}

static inline const bat_object *found(const bat_editor *editor, bat_id id) {
    const bat_document *document = bat_editor_document(editor);
    return bat_document_at(document, bat_document_find(document, id));
}

static inline bool offers(bat_editor *editor, const char *name) {
    const char *all = bat_editor_actions(editor), *at = all ? strstr(all, name) : NULL;
    const size_t length = strlen(name);
    while (at && (at[length] != ' ' && at[length] != 0)) at = strstr(at + 1, name);
    return at != NULL;
}

/* Where control point or vertex i of the thing is. */
static inline void point_at(const bat_editor *editor, int i, double out[3]) {
    const bat_object *object = found(editor, SHEET);
    const bat_surface *surface = bat_object_surface(object);
    const bat_polymesh *mesh = bat_object_mesh(object);
    const bat_curve *curve = bat_object_curve(object, 0);
    out[2] = 0;
    if (surface)
        memcpy(out, bat_surface_row(surface, i / SIDE) + (ptrdiff_t)3 * (i % SIDE), 3 * sizeof *out);
    else if (mesh)
        memcpy(out, bat_polymesh_vertices(mesh) + (ptrdiff_t)3 * i, 3 * sizeof *out);
    else
        memcpy(out, bat_curve_points(curve) + (ptrdiff_t)2 * i, 2 * sizeof *out);
}

static inline size_t points_of(const bat_editor *editor) {
    const bat_object *object = found(editor, SHEET);
    if (bat_object_surface(object) || bat_object_mesh(object)) return (size_t)SIDE * SIDE;
    return bat_curve_count(bat_object_curve(object, 0));
}

/* What is bound is where the library's wires take it, to the bit. */
static inline void is_fresh(const bat_editor *editor, const double *rest) {
    const bat_object *object = found(editor, SHEET);
    const bat_wire *wires;
    const bat_wire_options *options;
    const bat_id *ids;
    const bat_curve *curves[BAT_BOUND_WIRES];
    bat_curve *matched[BAT_BOUND_WIRES] = {NULL};
    bat_binding *binding = NULL;
    const size_t count = points_of(editor);
    const int n = bat_object_wires(object, &wires, &options);
    double *wanted = malloc(3 * count * sizeof *wanted), now[3];
    assert_true(bat_object_sources(object, &ids) >= n); /* domain curves come behind them */
    assert_true(n > 0);
    for (int i = 0; i < n; i++) {
        curves[i] = bat_object_curve(found(editor, ids[i]), 0);
        assert_int_equal(bat_wire_match(wires[i].reference, curves[i], &matched[i]), BAT_OK);
        if (matched[i]) curves[i] = matched[i];
    }
    memcpy(wanted, rest, 3 * count * sizeof *wanted);
    assert_int_equal(bat_wires_bind((size_t)n, wires, count, rest, options, &binding, NULL), BAT_OK);
    assert_int_equal(bat_binding_apply(binding, curves, wanted, NULL, NULL), BAT_OK);
    for (size_t i = 0; i < count; i++) {
        point_at(editor, (int)i, now);
        assert_memory_equal(now, wanted + 3 * i, sizeof now);
    }
    for (int i = 0; i < n; i++) bat_curve_free(matched[i]);
    bat_binding_free(binding);
    free(wanted);
}

static inline double *rest_of(const bat_editor *editor) {
    const size_t count = points_of(editor);
    double *rest = malloc(3 * count * sizeof *rest);
    for (size_t i = 0; i < count; i++) point_at(editor, (int)i, rest + 3 * i);
    return rest;
}

/* Bends the line at x with the Sketch hand: over it by `by` to the right in its middle. In every frame what is bound follows. */
static inline void bend(bat_editor *editor, double x, double by, const double *rest) {
    pen p = pen_for(editor);
    bat_editor_command(editor, "tool-sketch");
    p.time += 1000;
    pen_event(&p, BAT_POINTER_HOVER, x, 290);
    bat_editor_frame(editor);
    pen_event(&p, BAT_POINTER_DOWN, x, 290);
    for (int i = 1; i <= 40; i++) {
        const double t = i / 40.0;
        pen_event(&p, BAT_POINTER_MOVE, x + by * 16 * t * t * (1 - t) * (1 - t), 290 + 220 * t);
        bat_editor_frame(editor);
        check(editor);
    }
    pen_event(&p, BAT_POINTER_UP, x, 510);
    bat_editor_frame(editor);
    check(editor);
    is_fresh(editor, rest);
}

static inline void redraw(bat_editor *editor, const double *rest) { bend(editor, 400, 28, rest); }

static inline double farthest(const bat_editor *editor, const double *rest) {
    double most = 0, now[3];
    for (size_t i = 0; i < points_of(editor); i++) {
        point_at(editor, (int)i, now);
        most = fmax(most, hypot(now[0] - rest[3 * i], now[1] - rest[3 * i + 1]));
    }
    return most;
}

static inline double radius_at(const bat_editor *editor, double at) {
    const bat_wire *wires;
    double jet[3];
    assert_true(bat_object_wires(found(editor, SHEET), &wires, NULL) > 0);
    bat_function_eval(&wires[0].radius, at, jet);
    return jet[0];
}

#endif
