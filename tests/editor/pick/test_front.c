/* What a click picks in a tilted view: surfaces and meshes anywhere on them, what is in front before what it hides. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"
#include "support/sheet.h"

enum { CUBE = 3, BEHIND = 4, BEFORE = 5, SHEET = 6, MORE = 7 };

static void add_between(bat_document *document, bat_id id, const double ends[6]) {
    const double knots[4] = {0, 0, 1, 1};
    const bat_style style = bat_style_defaults();
    bat_curve *curve = NULL;
    bat_object *object = NULL;
    assert_int_equal(bat_curve_create(3, 1, false, 2, ends, 4, knots, &curve), BAT_OK);
    assert_int_equal(bat_object_create_path(id, "", &style, 1, &curve, &object), BAT_OK);
    assert_int_equal(bat_document_insert(document, bat_document_count(document), object), BAT_OK);
    bat_object_release(object);
}

static void add_line(bat_document *document, bat_id id, double y, double z) {
    add_between(document, id, (double[]){200, y, z, 800, y, z});
}

/* A cube of 200 about 500, 400, 0, a sheet far behind it, and two lines along x: one through the cube's back half, one before it. */
static bat_editor *scene_with(const double *more) {
    static const int faces[] = {0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3};
    const int sizes[6] = {4, 4, 4, 4, 4, 4};
    const bat_style style = bat_style_defaults();
    double corners[24];
    bat_document *document = NULL;
    bat_polymesh *mesh = NULL;
    bat_object *object = NULL;
    for (int i = 0; i < 8; i++) {
        corners[3 * i] = i & 1 ? 600 : 400, corners[3 * i + 1] = i & 2 ? 500 : 300;
        corners[3 * i + 2] = i & 4 ? 100 : -100;
    }
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    assert_int_equal(bat_polymesh_create(8, corners, 6, sizes, faces, &mesh, NULL), BAT_OK);
    assert_int_equal(bat_object_create_mesh(CUBE, "", &style, mesh, &object), BAT_OK);
    bat_polymesh_free(mesh);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    bat_object_release(object);
    add_line(document, BEHIND, 400, 50);
    add_line(document, BEFORE, 350, -150);
    if (more) add_between(document, MORE, more);
    bat_surface *sheet = sheet_create();
    assert_int_equal(sheet_add(document, SHEET, sheet), BAT_OK);
    bat_surface_free(sheet);
    return editor_of(document);
}

static bat_editor *scene(void) { return scene_with(NULL); }

static void turn_to_it(bat_editor *editor) {
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    bat_editor_command(editor, "orbit-up");
    bat_editor_command(editor, "orbit-up");
    bat_editor_command(editor, "orbit-left");
    bat_editor_frame(editor);
}

static void chosen(pen *p, const double at[3], bat_id id) {
    double seen[2], pixel[2];
    assert_true(bat_stage_look(&p->editor->stage, 3, at, seen));
    bat_stage_project(&p->editor->stage, seen, pixel);
    p->time += 1000;
    click(p, pixel[0], pixel[1], 0);
    if (selected(p->editor) != (id != 0) || (id && !has(p->editor, id)))
        fail_msg("%g %g %g at %g %g: %d selected (%d), not %d", at[0], at[1], at[2], pixel[0], pixel[1],
                 selected(p->editor), (int)p->editor->choice.selection.ids[0], (int)id);
}

static void the_front_is_picked(void **state) {
    (void)state;
    bat_editor *editor = scene();
    const uint64_t now = digest(editor);
    bat_surface *sheet = sheet_create();
    double patch[3];
    pen p = mouse(editor);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    for (int deep = 0; deep < 2; deep++) {
        bat_editor_set(editor, "perspective", deep);
        bat_editor_command(editor, "orbit-up");
        bat_editor_command(editor, "orbit-left");
        bat_editor_frame(editor);
        chosen(&p, (double[]){470, 380, -100}, CUBE);   /* in the middle of a face, away from its edges */
        chosen(&p, (double[]){520, 400, 50}, CUBE);     /* it hides the line */
        chosen(&p, (double[]){240, 400, 50}, BEHIND);   /* where it sticks out */
        chosen(&p, (double[]){520, 350, -150}, BEFORE); /* what is before it */
        bat_surface_eval(sheet, 3.5, 2.5, 0,
                         patch); /* in the middle of a patch, away from the lines that show it */
        chosen(&p, patch, SHEET);
        chosen(&p, (double[]){60, 60, 0}, 0);
    }
    bat_editor_command(editor, "deselect");
    assert_true(digest(editor) == now);
    bat_surface_free(sheet);
    bat_editor_free(editor);
}

/* A line behind the cube that is seen 5 px beside its edge: the edge is meant; 12 px beside it, the line is. */
static void an_edge_comes_before_what_is_behind(void **state) {
    (void)state;
    bat_editor *editor = scene();
    double right[3], down[3], ahead[3], ends[2][2], line[2][6];
    static const double edge[2][3] = {{400, 300, -100}, {600, 300, -100}}; /* the far one of its top */
    turn_to_it(editor);
    bat_view_axes(&editor->stage.view, right, down, ahead);
    for (int i = 0; i < 2; i++) {
        double seen[2];
        bat_stage_look(&editor->stage, 3, edge[i], seen);
        bat_stage_project(&editor->stage, seen, ends[i]);
    }
    /* Away from the cube's middle, across the edge as it is seen. */
    double middle[2], seen[2];
    bat_stage_look(&editor->stage, 3, (double[]){500, 400, 0}, seen);
    bat_stage_project(&editor->stage, seen, middle);
    const double x = ends[1][0] - ends[0][0], y = ends[1][1] - ends[0][1], length = hypot(x, y);
    double across[2] = {-y / length, x / length};
    if (across[0] * (middle[0] - ends[0][0]) + across[1] * (middle[1] - ends[0][1]) > 0)
        across[0] = -across[0], across[1] = -across[1];
    for (int far = 0; far < 2; far++)
        for (int i = 0; i < 2; i++)
            for (int k = 0; k < 3; k++)
                line[far][3 * i + k] = edge[i][k] + 30 * ahead[k] +
                                       (far ? 12 : 5) * (across[0] * right[k] + across[1] * down[k]);
    bat_editor_free(editor);
    for (int far = 0; far < 2; far++) {
        editor = scene_with(line[far]);
        turn_to_it(editor);
        pen p = mouse(editor);
        const double *l = line[far];
        chosen(&p, (double[]){(l[0] + l[3]) / 2, (l[1] + l[4]) / 2, (l[2] + l[5]) / 2}, far ? MORE : CUBE);
        bat_editor_free(editor);
    }
}

/* J over a mesh draws on the plane of the face under the pen; J again goes back to the page. */
static void a_face_is_drawn_on(void **state) {
    (void)state;
    bat_editor *editor = scene();
    const uint64_t first = digest(editor);
    const double on_top[3] = {520, 420, -100};
    double seen[2], pixel[2];
    pen p = mouse(editor);
    turn_to_it(editor);
    bat_stage_look(&editor->stage, 3, on_top, seen);
    bat_stage_project(&editor->stage, seen, pixel);
    pen_event(&p, BAT_POINTER_HOVER, pixel[0], pixel[1]);
    assert_true(bat_editor_key(editor, "j", true, 0, p.time));
    assert_int_equal(bat_stage_dimension(&editor->stage), 3);
    const double *plane = bat_object_plane(bat_document_at(bat_editor_document(editor), 4));
    assert_non_null(plane);
    assert_true(fabs(plane[2] + 100) < 1e-6 && fabs(plane[5]) < 1e-12 && fabs(plane[8]) < 1e-12);
    assert_true(bat_editor_key(editor, "j", true, 0, p.time));
    assert_int_equal(bat_stage_dimension(&editor->stage), 2);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_front_is_picked),
                                       cmocka_unit_test(an_edge_comes_before_what_is_behind),
                                       cmocka_unit_test(a_face_is_drawn_on)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
