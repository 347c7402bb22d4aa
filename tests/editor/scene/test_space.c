/* The tilted view as buffers: they are seen where the overlay is, only what moves is made anew, and the look is a setting of
 * the view. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "editor/edit/affine.h"
#include "editor/editor.h"
#include "editor/session/transaction.h"
#include "editor/scene/space.h"
#include "editor/tools/surface/state.h"
#include "editor/tools/toolbox.h"
#include "support/alloc_fail.h"
#include "support/editing.h"
#include "support/sheet.h"

enum { SHEET = 7 };

static uint32_t seed;

static double any(double low, double high) {
    seed = seed * 1664525u + 1013904223u;
    return low + (high - low) * ((double)(seed >> 8) / 16777216);
}

/* 17 x 17 patches over 300..700 x 200..600, in waves. */
static bat_surface *fine_sheet(void) {
    enum { N = 20 };
    double points[3 * N * N], knots[N + 4];
    bat_surface *surface = NULL;
    for (int i = 0; i < N + 4; i++) knots[i] = fmin(fmax(i - 3, 0), N - 3);
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            const double at[3] = {300 + 400.0 * i / (N - 1), 200 + 400.0 * j / (N - 1),
                                  15 * sin(0.5 * i - 0.4 * j)};
            memcpy(points + 3 * (i * N + j), at, sizeof at);
        }
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){false, false},
                                        (const size_t[2]){N, N}, points, (const int[2]){N + 4, N + 4}, knots,
                                        knots, &surface),
                     BAT_OK);
    return surface;
}

static bat_editor *with(bat_surface *surface) {
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    pen_add(document, pen_curve(200, 400, 60, 5, 11));
    assert_int_equal(sheet_add(document, SHEET, surface), BAT_OK);
    bat_surface_free(surface);
    return editor_of(document);
}

static bat_editor *with_sheet(void) { return with(sheet_create()); }

static const bat_space *space_of(bat_editor *editor) {
    bat_editor_frame(editor);
    const bat_space *space = bat_editor_space(editor);
    assert_non_null(space);
    return space;
}

static const bat_space_item *item_of(const bat_space *space, uint32_t kind, uint32_t id) {
    for (uint32_t i = 0; i < space->count; i++)
        if (space->items[i].kind == kind && space->items[i].id == id) return &space->items[i];
    return NULL;
}

/* The view pixel at which a host shows a vertex. */
static void shown_at(const bat_space *space, const bat_view *view, const float *vertex, double pixel[2],
                     double *depth) {
    double c[4];
    for (int row = 0; row < 4; row++) {
        c[row] = space->clip[12 + row];
        for (int k = 0; k < 3; k++) c[row] += (double)space->clip[4 * k + row] * (double)vertex[k];
    }
    const double wide = round(view->width * view->ratio), tall = round(view->height * view->ratio);
    pixel[0] = (c[0] / c[3] + 1) / 2 * wide / view->ratio;
    pixel[1] = (1 - c[1] / c[3]) / 2 * tall / view->ratio;
    *depth = c[2] / c[3];
}

/* Compares with the overlay's projection, and with the library's camera for the depth. */
static double compare(bat_editor *editor, const bat_space *space, const float *vertex,
                      const double point[3]) {
    const bat_stage *stage = editor->context.stage;
    double pixel[2], depth, seen[2], other[2];
    shown_at(space, &stage->view, vertex, pixel, &depth);
    if (!bat_stage_look(stage, 3, point, seen)) return -2; /* behind the eye */
    if (bat_stage_deep(stage) && !(depth > -1)) return -2; /* before the near plane */
    bat_stage_project(stage, seen, other);
    const double x = pixel[0] - other[0], y = pixel[1] - other[1];
    /* far beside the window single precision tells */
    const double far = fmax(fabs(other[0]), fabs(other[1]));
    if (!(sqrt(x * x + y * y) < 0.05 * fmax(1, far / 2000)))
        fail_msg("(%g, %g) instead of (%g, %g)", pixel[0], pixel[1], other[0], other[1]);
    assert_true(depth > -1 && depth < 1);
    return depth;
}

static void it_is_where_the_overlay_is(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    bat_view *view = &editor->context.stage->view;
    const bat_document *document = bat_editor_document(editor);
    const bat_object *line = bat_document_at(document, 0);
    const bat_surface *surface = bat_object_surface(bat_document_at(document, 1));
    assert_null(bat_editor_space(editor));
    seed = 3;
    for (int i = 0; i < 200; i++) {
        view->width = any(300, 1200), view->height = any(300, 900), view->ratio = any(0.7, 3);
        view->x = any(-300, 600), view->y = any(-300, 600), view->zoom = any(0.2, 9);
        const double about = any(-180, 180), down = any(0.01, 180);
        view->fov = i & 1 ? BAT_FOV : 0;
        bat_view_orbit(view, about, down);
        const bat_space *space = space_of(editor);
        const bat_space_item *sheet = item_of(space, BAT_SPACE_TRIANGLES, SHEET);
        const bat_space_item *drawn = item_of(space, BAT_SPACE_LINES, (uint32_t)bat_object_id(line));
        const size_t n = sheet->columns, m = sheet->rows;
        double point[3] = {0}, depth[4], far[4];
        bat_viewpoint camera;
        bat_stage_viewpoint(editor->context.stage, &camera);
        memcpy(point, bat_curve_points(bat_object_curve(line, 0)), 2 * sizeof *point);
        compare(editor, space, drawn->vertices, point);
        for (int k = 0; k < 4; k++) {
            const size_t at = (k & 1 ? (m - 1) * n : 0) + (k & 2 ? n - 1 : 0);
            double pixel[2];
            bat_surface_eval(surface, k & 1 ? 4 : 0, k & 2 ? 3 : 0, 0, point);
            depth[k] = compare(editor, space, sheet->vertices + BAT_SOLID_CORNER * at, point);
            if (bat_viewpoint_project(&camera, point, pixel, &far[k]) != BAT_OK) far[k] = 0;
        }
        for (int k = 1; k < 4; k++)
            if (fabs(far[k] - far[0]) > 1 && depth[k] > -2 && depth[0] > -2)
                assert_true((depth[k] > depth[0]) == (far[k] > far[0]));
    }
    bat_editor_free(editor);
}

/* Where the fine sheet's middle line is seen, at a share of its length; along: it runs along v. */
static void project(bat_editor *editor, int along, double share, double pixel[2]) {
    const bat_surface *sheet = bat_object_surface(bat_document_at(bat_editor_document(editor), 1));
    bat_viewpoint view;
    double point[3];
    assert_int_equal(bat_stage_viewpoint(editor->context.stage, &view), BAT_OK);
    bat_surface_eval(sheet, along ? 8.5 : 17 * share, along ? 17 * share : 8.5, 0, point);
    bat_viewpoint_project(&view, point, pixel, NULL);
}

/* Lights that line in a tilted view and begins to redraw it. */
static pen begin_redraw(bat_editor *editor, int along) {
    double from[2], to[2];
    assert_int_equal(bat_editor_command(editor, "tool-surface"), BAT_OK);
    for (int i = 0; i < 2; i++) bat_editor_command(editor, "orbit-up");
    bat_editor_frame(editor);
    pen p = pen_for(editor);
    project(editor, along, 0.35, from);
    project(editor, along, 0.65, to);
    drag(&p, from[0], from[1], to[0], to[1]);
    space_of(editor);
    p.time += 1000;
    for (int i = 0; i <= 40; i++) {
        const double t = i / 40.0, w = 16 * t * t * (1 - t) * (1 - t);
        double at[2];
        project(editor, along, 0.1 + 0.8 * t, at);
        pen_event(&p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, at[0], at[1] - 20 * w);
    }
    return p;
}

static void only_what_moves_is_made_anew(void **state) {
    (void)state;
    for (int along = 0; along < 2; along++) {
        bat_editor *editor = with(fine_sheet());
        begin_redraw(editor, along);
        bat_scene_entry *entry = &editor->context.scene->entries[1];
        const bat_solid *solid = entry->solid;
        bat_mesh mesh;
        bat_tessellation_mesh(solid->mesh, &mesh);
        const size_t size = mesh.rows * mesh.columns * BAT_SOLID_CORNER * sizeof *solid->corners;
        float *before = malloc(size);
        memcpy(before, solid->corners, size);
        const uint32_t version = solid->version;
        const bat_space_item sheet = *item_of(space_of(editor), BAT_SPACE_TRIANGLES, SHEET);
        const bat_surfacing *surfacing = bat_toolbox_state(&editor->context, bat_tool_surface());
        assert_non_null(surfacing->made.surface);
        assert_int_equal(sheet.version, version);
        const int d = along ? 0 : 2; /* rows move, or columns */
        assert_true(sheet.moved[d] < sheet.moved[d + 1]);
        assert_int_equal(sheet.moved[2 - d], 0);
        assert_int_equal(sheet.moved[3 - d], along ? sheet.columns : sheet.rows);
        size_t there = 0;
        for (size_t i = 0; i < mesh.rows; i++)
            for (size_t j = 0; j < mesh.columns; j++) {
                const size_t k = BAT_SOLID_CORNER * (i * mesh.columns + j);
                double point[3], was[3];
                bat_surface_eval(surfacing->made.surface, mesh.u[i], mesh.v[j], 0, point);
                bat_surface_eval(surfacing->made.surface, mesh.u[0], mesh.v[0], 0, was);
                for (int c = 0; c < 3; c++) {
                    const double off = (double)(solid->corners[k + (size_t)c] - solid->corners[c]) -
                                       (point[c] - was[c]);
                    assert_true(fabs(off) < 1e-3);
                }
                const bool moves = i >= sheet.moved[0] && i < sheet.moved[1] && j >= sheet.moved[2] &&
                                   j < sheet.moved[3];
                if (!moves) assert_memory_equal(before + k, solid->corners + k, 28);
                there += !moves;
            }
        assert_true(there > 0);
        bat_editor_command(editor, "cancel"); /* the surface is as it was, to the bit */
        assert_true(item_of(space_of(editor), BAT_SPACE_TRIANGLES, SHEET)->version == version);
        assert_memory_equal(before, solid->corners, size);
        const bat_space_item *still = item_of(space_of(editor), BAT_SPACE_TRIANGLES, SHEET);
        assert_true(still->moved[0] == still->moved[1]);
        free(before);
        bat_editor_free(editor);
    }
}

/* When the pen is lifted, and undo brings back what was, the buffers are those of the surface that is there now; little of
 * them is sent again. */
static void a_surface_replaced_keeps_its_triangles(void **state) {
    (void)state;
    bat_editor *editor = with(fine_sheet());
    pen p = begin_redraw(editor, 1);
    const uint32_t version = item_of(space_of(editor), BAT_SPACE_TRIANGLES, SHEET)->version;
    const uint64_t first = digest(editor);
    double last[2];
    project(editor, 1, 0.9, last);
    pen_event(&p, BAT_POINTER_UP, last[0], last[1]);
    for (int i = 0; i < 3; i++) {
        const bat_space_item sheet = *item_of(space_of(editor), BAT_SPACE_TRIANGLES, SHEET);
        const bat_surface *surface = bat_object_surface(bat_document_at(bat_editor_document(editor), 1));
        const bat_solid *solid = editor->context.scene->entries[1].solid;
        bat_mesh mesh;
        bat_tessellation_mesh(solid->mesh, &mesh);
        assert_int_equal(sheet.version, version);
        assert_true((digest(editor) == first) == (i == 1));
        assert_true(i == 0 ? sheet.moved[1] == 0 : sheet.moved[0] > 0 && sheet.moved[1] < sheet.rows);
        for (size_t k = 0; k < mesh.rows * mesh.columns; k++) {
            double point[3];
            bat_surface_eval(surface, mesh.u[k / mesh.columns], mesh.v[k % mesh.columns], 0, point);
            for (size_t c = 0; c < 3; c++) {
                const double off = (double)solid->corners[BAT_SOLID_CORNER * k + c] + solid->grain.origin[c] -
                                   point[c];
                assert_true(fabs(off) < 1e-3);
            }
        }
        assert_int_equal(bat_editor_command(editor, i == 0 ? "undo" : "redo"), i < 2 ? BAT_OK : BAT_STATE);
    }
    bat_editor_free(editor);
}

static void the_look_belongs_to_the_view(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    const uint64_t first = digest(editor);
    size_t size, grown;
    uint32_t edges = 0;
    bat_editor_journal(editor, &size);
    assert_int_equal(bat_editor_command(editor, "look-next"), BAT_STATE);
    bat_editor_key(editor, "x", true, 0, 10);
    assert_true(editor->context.input->drawing_new); /* face-on the key is another's */
    bat_editor_key(editor, "x", false, 0, 20);
    for (int i = 0; i < 3; i++) bat_editor_command(editor, "orbit-up");
    for (uint32_t i = 1; i <= BAT_LOOK_COUNT; i++) {
        bat_editor_key(editor, "x", true, 0, 30);
        const bat_space *space = space_of(editor);
        assert_int_equal(space->look, i % BAT_LOOK_COUNT);
        assert_true((space->range > 0) == (i == BAT_LOOK_GAUSS || i == BAT_LOOK_MEAN));
        const uint32_t points = item_of(space, BAT_SPACE_LINES, SHEET)->rows;
        if (i == 1) edges = points;
        assert_true(i == BAT_LOOK_LINES ? points > 3 * edges / 2
                                        : points == edges); /* at all knots, or the edges */
    }
    bat_editor_journal(editor, &grown);
    assert_int_equal(grown, size);
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_STATE);
    bat_editor_free(editor);
}

/* When the view rests a surface has its outline: there the gaze touches it. It stays while nothing changes, is left out while
 * the view moves, and is that of the surface as it is. */
static void the_outline_comes_with_rest(void **state) {
    (void)state;
    for (int deep = 0; deep < 2; deep++) {
        bat_editor *editor = with(fine_sheet());
        for (int i = 0; i < 5; i++) bat_editor_command(editor, "orbit-up");
        if (deep) bat_editor_command(editor, "perspective");
        const bat_space *space = space_of(editor);
        assert_null(item_of(space, BAT_SPACE_LINES, SHEET | BAT_SPACE_OUTLINE));
        assert_int_equal(space->waits, 1);
        space = space_of(editor);
        assert_int_equal(space->waits, 0);
        const bat_space_item *line = item_of(space, BAT_SPACE_LINES, SHEET | BAT_SPACE_OUTLINE);
        assert_non_null(line);
        assert_true(line->rows > 40);
        const bat_surface *surface = bat_object_surface(bat_document_at(bat_editor_document(editor), 1));
        const double *origin = editor->scene.space->origin;
        bat_viewpoint view;
        assert_int_equal(bat_stage_viewpoint(editor->context.stage, &view), BAT_OK);
        for (uint32_t i = 1; i < line->rows - 1; i += 7) {
            double at[3], normal[3], touch = 0, far = 0;
            bat_surface_point near;
            for (int d = 0; d < 3; d++) at[d] = origin[d] + (double)line->vertices[4 * i + (uint32_t)d];
            assert_int_equal(bat_surface_nearest(surface, at, &near), BAT_OK);
            assert_true(near.distance < 1e-3);
            assert_int_equal(bat_surface_normal(surface, near.u, near.v, normal), BAT_OK);
            for (int d = 0; d < 3; d++) {
                const double way = deep ? at[d] - view.eye[d] : view.target[d] - view.eye[d];
                touch += way * normal[d], far += way * way;
            }
            assert_true(fabs(touch) < 2e-3 * sqrt(far));
        }
        const uint32_t version = line->version;
        assert_int_equal(item_of(space_of(editor), BAT_SPACE_LINES, SHEET | BAT_SPACE_OUTLINE)->version,
                         version);
        bat_editor_command(editor, "orbit-right");
        assert_null(item_of(space_of(editor), BAT_SPACE_LINES, SHEET | BAT_SPACE_OUTLINE));
        line = item_of(space_of(editor), BAT_SPACE_LINES, SHEET | BAT_SPACE_OUTLINE);
        assert_true(line && line->version != version);
        const uint32_t turned = line->version;
        bat_object *moved = NULL;
        assert_int_equal(bat_affine_object(bat_document_at(bat_editor_document(editor), 1),
                                           (double[]){1, 0, 0, 1, 30, 0}, true, &moved),
                         BAT_OK);
        bat_context *c = &editor->context;
        assert_int_equal(bat_transaction_begin(c), BAT_OK);
        assert_int_equal(bat_transaction_replace(c, 1, moved), BAT_OK);
        assert_int_equal(bat_transaction_end(c, BAT_OK, BAT_STRING_STEP_PLANE), BAT_OK);
        bat_object_release(moved);
        line = item_of(space_of(editor), BAT_SPACE_LINES, SHEET | BAT_SPACE_OUTLINE);
        assert_true(line && line->version != turned);
        assert_int_equal(bat_editor_set_state(editor, SHEET, true, false), BAT_OK);
        assert_null(item_of(space_of(editor), BAT_SPACE_LINES, SHEET | BAT_SPACE_OUTLINE));
        bat_editor_free(editor);
    }
}

/* Face-on thin lines show it; tilted it is shaded, and has lines only in the look that is nothing but lines. */
static void a_surface_without_a_stroke(void **state) {
    (void)state;
    bat_document *document = NULL;
    bat_object *object = NULL;
    bat_style style = bat_style_defaults();
    bat_surface *sheet = sheet_create();
    style.stroked = false;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_object_create_surface(SHEET, "", &style, sheet, &object), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    bat_object_release(object);
    bat_surface_free(sheet);
    bat_editor *editor = editor_of(document);
    const bat_frame *frame = bat_editor_frame(editor);
    const bat_item *item = NULL;
    for (uint32_t i = 0; i < frame->still_count; i++)
        if (frame->still[i].id == SHEET) item = &frame->still[i];
    assert_non_null(item);
    if (!item) return;
    assert_true((item->flags & BAT_ITEM_STROKED) && (item->flags & BAT_ITEM_SCREEN_WIDTH));
    assert_true(item->width == 1 && (item->stroke & 255) == 255 && item->path_count > 0);
    for (int i = 0; i < 3; i++) bat_editor_command(editor, "orbit-up");
    assert_non_null(item_of(space_of(editor), BAT_SPACE_TRIANGLES, SHEET));
    assert_null(item_of(space_of(editor), BAT_SPACE_LINES, SHEET));
    assert_int_equal(bat_editor_set(editor, "look", BAT_LOOK_LINES), BAT_OK);
    assert_non_null(item_of(space_of(editor), BAT_SPACE_LINES, SHEET));
    bat_editor_free(editor);
}

static void what_is_hidden_is_not_there(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    for (int i = 0; i < 3; i++) bat_editor_command(editor, "orbit-up");
    assert_int_equal(space_of(editor)->count, 3);
    assert_int_equal(bat_editor_set_state(editor, SHEET, true, false), BAT_OK);
    assert_int_equal(space_of(editor)->count, 1);
    assert_int_equal(bat_editor_command(editor, "look-next"), BAT_STATE);
    bat_editor_command(editor, "select-all");
    bat_editor_command(editor, "delete");
    space_of(editor);
    bat_editor_free(editor);
}

/* Planes and guides have no buffers, fills without a line neither; they are no obstacle to what has. */
static void other_things(void **state) {
    (void)state;
    bat_document *document = NULL;
    bat_object *object = NULL;
    bat_style style = bat_style_defaults();
    bat_curve *ring = pen_curve(250, 300, 40, 30, 9);
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    assert_int_equal(
        bat_object_create_plane(21, "", (double[]){0, 0, 5}, (double[]){1, 0, 0, 0, 0.8, 0.6}, &object),
        BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    bat_object_release(object);
    assert_int_equal(bat_object_create_guide(22, 1, 40, &object), BAT_OK);
    assert_int_equal(bat_document_insert(document, 1, object), BAT_OK);
    bat_object_release(object);
    style.filled = true, style.stroked = false; /* the path takes the ring over */
    assert_int_equal(bat_object_create_path(23, "", &style, 1, &ring, &object), BAT_OK);
    assert_int_equal(bat_document_insert(document, 2, object), BAT_OK);
    bat_object_release(object);
    for (int i = 0; i < 2; i++) {
        bat_surface *sheet = i ? fine_sheet() : sheet_create();
        style.fill = 0x336699ff, style.stroked = i == 0;
        assert_int_equal(bat_object_create_surface((bat_id)(30 + i), "", &style, sheet, &object), BAT_OK);
        assert_int_equal(bat_document_insert(document, bat_document_count(document), object), BAT_OK);
        bat_object_release(object);
        bat_surface_free(sheet);
    }
    bat_editor *editor = editor_of(document);
    for (int i = 0; i < 3; i++) bat_editor_command(editor, "orbit-up");
    for (int look = 0; look < BAT_LOOK_COUNT; look++) {
        bat_editor_set(editor, "look", look);
        const bat_space *space = space_of(editor);
        for (uint32_t id = 21; id <= 23; id++)
            for (uint32_t i = 0; i < space->count; i++) assert_true(space->items[i].id != id);
        assert_true(space->count >= 2);
    }
    bat_editor_set(editor, "look", BAT_LOOK_GAUSS);
    const double widest = space_of(editor)->range;
    assert_int_equal(bat_editor_set_state(editor, 30, true, false), BAT_OK);
    const bat_space *space = space_of(editor);
    for (uint32_t i = 0; i < space->count; i++) assert_int_equal(space->items[i].id, 31);
    bat_editor_set_state(editor, 30, false, false), bat_editor_set_state(editor, 31, true, false);
    assert_true(space_of(editor)->range != widest); /* of what is seen alone */
    bat_editor_set_state(editor, 31, false, false);
    assert_int_equal(bat_editor_select(editor, 31, false), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "isolate"), BAT_OK);
    space = space_of(editor);
    for (uint32_t i = 0; i < space->count; i++) /* the rest is pale */
        assert_true((space->items[i].opacity < 0.5F) == (space->items[i].id != 31));
    bat_editor_free(editor);
}

static void any_allocation_may_fail(void **state) {
    (void)state;
    const long held = alloc_live();
    for (long n = 1, clean = 0; !clean; n++) {
        bat_editor *editor = with_sheet();
        for (int i = 0; i < 3; i++) bat_editor_command(editor, "orbit-up");
        bat_editor_set(editor, "look", BAT_LOOK_MEAN);
        bat_editor_frame(editor);
        alloc_fail_at(n);
        const bat_space *space = bat_editor_space(editor);
        clean = !alloc_fail_reached();
        alloc_fail_at(0);
        assert_true((space != NULL) == (clean != 0));
        assert_int_equal(space_of(editor)->count, 3);
        bat_editor_free(editor);
    }
    assert_int_equal(alloc_live(), held);
}

static void shaders_get_the_table_of_light(void **state) {
    (void)state;
    const char *text = bat_space_constants();
    assert_non_null(strstr(text, "const float STRIPES=float(18);"));
    assert_non_null(strstr(text, "const vec3 WARM=vec3(0.78,0.20,0.16);"));
    assert_non_null(strstr(text, "vec3(-0.48,0.60,0.64)"));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(it_is_where_the_overlay_is),
                                       cmocka_unit_test(only_what_moves_is_made_anew),
                                       cmocka_unit_test(a_surface_replaced_keeps_its_triangles),
                                       cmocka_unit_test(the_look_belongs_to_the_view),
                                       cmocka_unit_test(the_outline_comes_with_rest),
                                       cmocka_unit_test(a_surface_without_a_stroke),
                                       cmocka_unit_test(what_is_hidden_is_not_there),
                                       cmocka_unit_test(other_things),
                                       cmocka_unit_test(any_allocation_may_fail),
                                       cmocka_unit_test(shaders_get_the_table_of_light)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
