/* The tilted view: its camera against the public one, orbits by hand and by keys, the way home, and what it refuses. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/view/room.h"
#include "editor/view/saved.h"
#include "editor/view/views.h"
#include "support/editing.h"
#include <stdio.h>

static uint32_t seed;

static double any(double low, double high) {
    seed = seed * 1664525u + 1013904223u;
    return low + (high - low) * ((double)(seed >> 8) / 16777216);
}

static bat_stage any_stage(void) {
    bat_stage stage = bat_stage_defaults();
    bat_view *view = &stage.view;
    view->width = 1000;
    view->height = 800;
    view->x = any(-500, 500);
    view->y = any(-500, 500);
    view->zoom = any(0.2, 5);
    const double x = any(-300, 300), y = any(-300, 300), z = any(-300, 300);
    bat_view_set_pivot(view, (double[]){x, y, z});
    const double angle = any(-180, 180), tilt = any(1, 179);
    bat_view_orbit(view, angle, tilt);
    return stage;
}

static double apart(const double *a, const double *b, int count) {
    double sum = 0;
    for (int k = 0; k < count; k++) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sqrt(sum);
}

static void it_is_the_camera_of_the_library(void **state) {
    (void)state;
    seed = 7;
    for (int i = 0; i < 400; i++) {
        const bat_stage stage = any_stage();
        bat_viewpoint camera;
        double at[3], seen[2], pixel[2], other[2], from[3], along[3];
        for (int k = 0; k < 3; k++) at[k] = any(-400, 400);
        assert_int_equal(bat_stage_viewpoint(&stage, &camera), BAT_OK);
        bat_stage_look(&stage, 3, at, seen);
        bat_stage_project(&stage, seen, pixel);
        assert_int_equal(bat_viewpoint_project(&camera, at, other, NULL), BAT_OK);
        assert_true(apart(pixel, other, 2) < 1e-6);
        /* Its ray runs as the library's does, and meets the page where it is seen. */
        const bat_ray ray = bat_view_ray(&stage.view, pixel);
        assert_int_equal(bat_viewpoint_ray(&camera, pixel, from, along), BAT_OK);
        assert_true(apart(ray.along, along, 3) < 1e-9);
        bat_hit hit;
        const double flat[3] = {at[0], at[1], 0};
        bat_stage_look(&stage, 2, flat, seen);
        bat_stage_project(&stage, seen, pixel);
        const double slant = fabs(stage.view.tilt - 90);
        bat_status status = bat_stage_place(&stage, pixel, NULL, &hit);
        if (slant > 5.01) {
            assert_int_equal(status, BAT_OK);
            assert_true(apart(hit.at, flat, 3) < 1e-7);
        } else if (slant < 4.99) {
            assert_int_equal(status, BAT_SINGULAR);
        }
    }
}

static void the_pivot_stays_where_it_is_seen(void **state) {
    (void)state;
    seed = 11;
    for (int i = 0; i < 200; i++) {
        bat_stage stage = any_stage();
        double at[3], seen[2], before[2], after[2];
        for (int k = 0; k < 3; k++) at[k] = any(-400, 400);
        const double point[3] = {any(-9, 9), 3, 4};
        bat_stage_look(&stage, 3, point, seen);
        bat_stage_project(&stage, seen, before);
        bat_view_set_pivot(&stage.view, at); /* the picture stays */
        bat_stage_look(&stage, 3, point, seen);
        bat_stage_project(&stage, seen, after);
        assert_true(apart(before, after, 2) < 1e-8);
        bat_stage_look(&stage, 3, at, seen);
        assert_true(apart(seen, at, 2) < 1e-9);
        bat_stage_project(&stage, seen, before);
        const double angle = any(-180, 180), tilt = any(-50, 300);
        bat_view_orbit(&stage.view, angle, tilt);
        assert_true(stage.view.tilt >= 0 && stage.view.tilt <= 180);
        bat_stage_look(&stage, 3, at, seen);
        bat_stage_project(&stage, seen, after);
        assert_true(apart(before, after, 2) < 1e-8);
    }
}

/* ---- the editor ---- */

static bat_editor *drawing(void) {
    bat_curve *curves[2] = {pen_curve(200, 300, 60, 40, 8), pen_curve(300, 500, 60, 40, 8)};
    return editor_with(2, curves);
}

/* All numbers that are painted of the drawing. */
static uint64_t picture(bat_editor *editor) {
    const bat_frame *frame = bat_editor_frame(editor);
    uint64_t sum = 1469598103934665603u;
    const unsigned char *bytes = (const unsigned char *)frame->view;
    for (size_t i = 0; i < sizeof frame->view; i++) sum = (sum ^ bytes[i]) * 1099511628211u;
    bytes = (const unsigned char *)frame->origin;
    for (size_t i = 0; i < sizeof frame->origin; i++) sum = (sum ^ bytes[i]) * 1099511628211u;
    for (uint32_t i = 0; i < frame->still_count; i++) {
        bytes = (const unsigned char *)frame->still[i].path;
        for (size_t k = 0; k < frame->still[i].path_count * sizeof(float); k++)
            sum = (sum ^ bytes[k]) * 1099511628211u;
        bytes = (const unsigned char *)frame->still[i].bounds;
        for (size_t k = 0; k < sizeof frame->still[i].bounds; k++) sum = (sum ^ bytes[k]) * 1099511628211u;
        sum = (sum ^ frame->still[i].role) * 1099511628211u;
    }
    return sum;
}

static double tilt_of(bat_editor *editor) { return bat_editor_frame(editor)->tilt; }

static pen right_button(bat_editor *editor) {
    pen p = mouse(editor);
    p.buttons = BAT_BUTTON_SECONDARY;
    return p;
}

static void a_right_drag_orbits_and_home_is_exact(void **state) {
    (void)state;
    bat_editor *editor = drawing();
    bat_editor_command(editor, "view-left");
    bat_editor_command(editor, "zoom-in");
    const uint64_t first = digest(editor), before = picture(editor);
    pen p = right_button(editor);
    pen_event(&p, BAT_POINTER_DOWN, 500, 400); /* a click turns nothing */
    pen_event(&p, BAT_POINTER_MOVE, 502, 401);
    pen_event(&p, BAT_POINTER_UP, 502, 401);
    assert_true(picture(editor) == before);
    assert_int_equal(bat_editor_command(editor, "view-back"), BAT_STATE);
    for (int i = 0; i < 10; i++) {
        drag(&p, 500, 400, 500 + 13 * i, 300 - 7 * i);
        assert_true(tilt_of(editor) > 10);
        assert_true(picture(editor) != before);
    }
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_STATE); /* never in the history */
    assert_int_equal(bat_editor_command(editor, "view-upright"), BAT_OK);
    assert_true(tilt_of(editor) == 0);
    assert_true(picture(editor) == before);
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_command(editor, "view-back"), BAT_OK); /* where home was called */
    assert_true(tilt_of(editor) > 10);
    for (int i = 0; i < 10; i++) assert_int_equal(bat_editor_command(editor, "view-back"), BAT_OK);
    assert_true(picture(editor) == before);
    assert_int_equal(bat_editor_command(editor, "view-back"), BAT_STATE);
    bat_editor_free(editor);
}

/* A machine with time to spare reports a quick drag as one move. */
static void a_drag_of_a_single_move_turns(void **state) {
    (void)state;
    bat_editor *editor = drawing();
    pen p = right_button(editor);
    pen_event(&p, BAT_POINTER_DOWN, 500, 400);
    pen_event(&p, BAT_POINTER_MOVE, 520, 310);
    pen_event(&p, BAT_POINTER_UP, 520, 310);
    assert_true(fabs(tilt_of(editor) - 45) < 1e-9);
    bat_editor_free(editor);
}

static void escape_returns_to_before(void **state) {
    (void)state;
    bat_editor *editor = drawing();
    const uint64_t before = picture(editor);
    pen p = right_button(editor);
    drag_to(&p, 500, 400, 560, 250);
    assert_true(tilt_of(editor) > 30);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_PIVOT));
    bat_editor_command(editor, "cancel");
    assert_true(picture(editor) == before);
    pen_event(&p, BAT_POINTER_MOVE, 600, 200); /* until it is lifted it does nothing */
    pen_event(&p, BAT_POINTER_UP, 600, 200);
    assert_true(picture(editor) == before);
    assert_int_equal(bat_editor_command(editor, "view-back"), BAT_STATE);
    bat_editor_free(editor);
}

static void keys_turn_in_steps_and_name_views(void **state) {
    (void)state;
    bat_editor *editor = drawing();
    for (int i = 0; i < 3; i++) assert_true(bat_editor_key(editor, "ArrowUp", true, BAT_SHIFT | BAT_ALT, 0));
    assert_true(tilt_of(editor) == 45);
    assert_true(bat_editor_key(editor, "ArrowLeft", true, BAT_SHIFT | BAT_ALT, 0));
    assert_true(bat_editor_frame(editor)->view[3] == 15);
    assert_true(bat_editor_key(editor, "7", true, 0, 0));
    assert_true(tilt_of(editor) == 90 && bat_editor_frame(editor)->view[3] == 0);
    assert_true(bat_editor_key(editor, "8", true, 0, 0));
    assert_true(tilt_of(editor) == 90 && bat_editor_frame(editor)->view[3] == 90);
    assert_true(bat_editor_key(editor, "9", true, 0, 0));
    assert_true(tilt_of(editor) == 0 && bat_editor_frame(editor)->view[3] == 0);
    assert_true(bat_editor_key(editor, "Z", true, BAT_SHIFT, 0));
    assert_true(tilt_of(editor) == 90);
    static const double tilts[] = {180, 90, 0, 90}; /* straight below, head down, straight above, as before */
    for (int i = 0; i < 24; i++) {
        bat_editor_key(editor, "ArrowUp", true, BAT_SHIFT | BAT_ALT, 0);
        if (i % 6 == 5) assert_true(fabs(tilt_of(editor) - tilts[i / 6]) < 1e-9);
        if (i == 5) assert_int_equal(bat_editor_frame(editor)->still[0].role, BAT_ROLE_PAGE_BACK);
    }
    assert_true(bat_editor_frame(editor)->view[3] == 90);
    assert_true(bat_editor_key(editor, "5", true, 0, 0));
    assert_int_equal(bat_editor_frame(editor)->still[0].role, BAT_ROLE_PAGE);
    check(editor);
    bat_editor_free(editor);
}

/* Fingers come down beside each other, move together, and are lifted. */
static void swipe(bat_editor *editor, int count, double dx, double dy) {
    pen fingers[3];
    for (int i = 0; i < count; i++) {
        fingers[i] = pen_for(editor);
        fingers[i].device = BAT_DEVICE_TOUCH;
        fingers[i].contact = (uint32_t)i + 1;
        pen_event(&fingers[i], BAT_POINTER_DOWN, 400 + 80 * i, 400);
        check(editor);
    }
    for (int k = 1; k <= 8; k++)
        for (int i = 0; i < count; i++) {
            pen_event(&fingers[i], BAT_POINTER_MOVE, 400 + 80 * i + dx * k / 8, 400 + dy * k / 8);
            check(editor);
        }
    for (int i = 0; i < count; i++) {
        pen_event(&fingers[i], BAT_POINTER_UP, NAN, NAN);
        check(editor);
    }
}

static void three_fingers_turn_and_two_never_do(void **state) {
    (void)state;
    bat_editor *editor = drawing();
    swipe(editor, 2, 50, -120);
    assert_true(tilt_of(editor) == 0);
    swipe(editor, 3, 20, -120);
    const double tilt = tilt_of(editor);
    assert_true(tilt > 30 && tilt < 60);
    const double angle = bat_editor_frame(editor)->view[3];
    swipe(editor, 2, 50, -120);
    assert_true(tilt_of(editor) == tilt && bat_editor_frame(editor)->view[3] == angle);
    swipe(editor, 3, 3, 3); /* a tap */
    assert_true(tilt_of(editor) == tilt);
    bat_editor_free(editor);
}

static void with_a_pen_one_finger_turns_a_tilted_view(void **state) {
    (void)state;
    bat_editor *editor = drawing();
    pen p = pen_for(editor);
    pen_event(&p, BAT_POINTER_HOVER, 700, 700);
    pen_event(&p, BAT_POINTER_LEAVE, 700, 700); /* while it hovers, hands rest */
    swipe(editor, 1, 0, -100);
    assert_true(tilt_of(editor) == 0); /* face-on it pans */
    bat_editor_command(editor, "orbit-up");
    swipe(editor, 1, 0, -100);
    assert_true(tilt_of(editor) > 40);
    const double tilt = tilt_of(editor);
    p.buttons = BAT_BUTTON_SECONDARY | BAT_BUTTON_PRIMARY;
    drag(&p, 500, 400, 500, 350);
    assert_true(tilt_of(editor) > tilt + 15);
    bat_editor_free(editor);
}

/* Every tool works in a tilted view; what takes the window for the page does not, and says so. */
static void what_is_not_ready_for_it_is_refused_and_home_offered(void **state) {
    (void)state;
    static const char *const commands[] = {"range", "guide-level", "symmetry-middle"};
    bat_editor *editor = drawing();
    const uint64_t first = digest(editor);
    for (int i = 0; i < BAT_TOOL_COUNT; i++)
        assert_true((bat_tool_at((bat_tool_id)i)->traits & BAT_TILTS) ||
                    i == BAT_TOOL_TEXT); /* letters lie on the page */
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        bat_editor_command(editor, "view-upright");
        bat_editor_command(editor, "orbit-up");
        const uint32_t said = bat_editor_frame(editor)->notice_version;
        assert_int_equal(bat_editor_command(editor, commands[i]), BAT_STATE);
        assert_true(digest(editor) == first);
        assert_true(bat_editor_frame(editor)->notice_version > said);
        assert_string_equal(bat_editor_frame(editor)->offer, "view-upright");
    }
    assert_int_equal(bat_editor_command(editor, bat_editor_frame(editor)->offer), BAT_OK);
    assert_true(tilt_of(editor) == 0);
    bat_editor_free(editor);
}

/* ---- strokes that land on the page, through the camera ---- */

/* An editor in a tilted view of the drawing. */
static bat_editor *tilted_drawing(double dx, double dy) {
    bat_editor *editor = drawing();
    pen p = right_button(editor);
    drag(&p, 500, 400, 500 + dx, 400 + dy);
    return editor;
}

/* Draws along places of the page as they are seen. */
static void draw_on_page(bat_editor *editor, const bat_curve *along, double lift) {
    const bat_stage *stage = editor->context.stage;
    pen p = pen_for(editor);
    double domain[2], at[2], seen[2], pixel[2];
    bat_curve_domain(along, domain);
    p.time += 5000;
    for (int i = 0; i <= 60; i++) {
        bat_curve_eval(along, domain[0] + (domain[1] - domain[0]) * i / 60, 0, at);
        at[1] += lift * 4 * i / 60 * (60 - i) / 60;
        bat_stage_look(stage, 2, at, seen);
        bat_stage_project(stage, seen, pixel);
        if (!i) pen_event(&p, BAT_POINTER_HOVER, pixel[0], pixel[1]);
        if (!i) bat_editor_frame(editor);
        pen_event(&p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, pixel[0], pixel[1]);
        if (i % 8 == 0) bat_editor_frame(editor);
        check(editor);
    }
    pen_event(&p, BAT_POINTER_UP, pixel[0], pixel[1]);
    bat_editor_frame(editor);
    check(editor);
}

/* How far a curve of the document lies from places of another one, at most. */
static double farthest(const bat_curve *curve, const bat_curve *from) {
    bat_finder *finder = NULL;
    bat_near near;
    double worst = 0, domain[2], at[2];
    assert_int_equal(bat_finder_create(curve, &finder), BAT_OK);
    bat_curve_domain(from, domain);
    for (int i = 0; i <= 100; i++) {
        bat_curve_eval(from, domain[0] + (domain[1] - domain[0]) * i / 100, 0, at);
        bat_finder_nearest(finder, at, &near);
        worst = fmax(worst, near.distance);
    }
    bat_finder_free(finder);
    return worst;
}

static void a_new_line_lands_on_the_page(void **state) {
    (void)state;
    static const double drags[][2] = {{60, -90}, {-140, -60}, {30, -260}, {200, -110}};
    for (size_t i = 0; i < sizeof drags / sizeof *drags; i++) {
        bat_editor *editor = tilted_drawing(drags[i][0], drags[i][1]);
        const uint64_t first = digest(editor);
        bat_curve *line = pen_curve(250, 690, 60, 20, 8);
        draw_on_page(editor, line, 0);
        const bat_document *document = bat_editor_document(editor);
        assert_int_equal(bat_document_count(document), 3);
        const bat_curve *made = bat_object_curve(bat_document_at(document, 2), 0);
        assert_int_equal(bat_curve_dimension(made), 2);
        assert_true(farthest(made, line) < 6);
        assert_int_equal(round_trip(editor, first), 1);
        bat_curve_free(line);
        bat_editor_free(editor);
    }
}

/* The same places drawn over face-on and tilted give the same line, but for the roundings of pixels. */
static void a_redraw_is_that_of_the_page(void **state) {
    (void)state;
    bat_curve *made[2] = {NULL, NULL};
    for (int i = 0; i < 2; i++) {
        bat_editor *editor = i ? tilted_drawing(50, -80) : drawing();
        const uint64_t first = digest(editor);
        bat_curve *line = pen_curve(200, 300, 60, 40, 8);
        draw_on_page(editor, line, 14);
        assert_int_equal(bat_document_count(bat_editor_document(editor)), 2);
        bat_curve_copy(bat_object_curve(bat_document_at(bat_editor_document(editor), 0), 0), &made[i]);
        assert_false(bat_curve_is_equal(made[i], line));
        assert_true(farthest(made[i], line) > 8);
        assert_int_equal(round_trip(editor, first), 1);
        bat_curve_free(line);
        bat_editor_free(editor);
    }
    assert_true(farthest(made[0], made[1]) < 3);
    bat_curve_free(made[0]);
    bat_curve_free(made[1]);
}

static void edge_on_no_stroke_begins(void **state) {
    (void)state;
    bat_editor *editor = drawing();
    const uint64_t first = digest(editor);
    for (int steps = 0; steps < 6; steps++) bat_editor_command(editor, "orbit-up");
    bat_editor_glide(editor, 1);
    pen p = pen_for(editor);
    pen_line(&p, 300, 300, 600, 420, 20);
    assert_true(digest(editor) == first);
    assert_string_equal(bat_editor_frame(editor)->offer, "view-ground");
    assert_int_equal(bat_editor_command(editor, "view-ground"), BAT_OK);
    assert_true(tilt_of(editor) == 0);
    pen_line(&p, 300, 650, 600, 620, 20);
    assert_true(digest(editor) != first);
    bat_editor_free(editor);
}

/* The views along the page have planes of their own, through what they turn about; on the way back the page is drawn on again. */
static void front_and_side_draw_on_their_own_plane(void **state) {
    (void)state;
    static const char *const views[] = {"view-front", "view-side"};
    bat_editor *editor = drawing();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    double right[3], down[3], ahead[3];
    for (int i = 0; i < 2; i++) {
        bat_editor_command(editor, views[i]);
        bat_editor_glide(editor, 1);
        const bat_stage *stage = editor->context.stage;
        bat_view_axes(&stage->view, right, down, ahead);
        assert_true(fabs(bat_stage_slant(stage) - 1) < 1e-9);
        pen_line(&p, 300, 300, 600, 420, 20);
        const bat_document *document = bat_editor_document(editor);
        const bat_curve *curve = bat_object_curve(bat_document_at(document, bat_document_count(document) - 1),
                                                  0);
        assert_int_equal(bat_curve_dimension(curve), 3);
        double domain[2], seen[2], pixel[2], at[3];
        bat_curve_domain(curve, domain);
        for (int end = 0; end < 2; end++) { /* it lies in that plane, under the pen */
            bat_curve_eval(curve, domain[end], 0, at);
            double depth = 0;
            for (int k = 0; k < 3; k++) depth += ahead[k] * (at[k] - stage->view.pivot[k]);
            assert_true(fabs(depth) < 1e-9);
            bat_stage_look(stage, 3, at, seen);
            bat_stage_project(stage, seen, pixel);
            assert_true(apart(pixel, end ? (double[]){600, 420} : (double[]){300, 300}, 2) < 2);
        }
        check(editor);
    }
    assert_int_equal(round_trip(editor, first), 2);
    for (int i = 0; i < 2;
         i++) { /* which the first of them has left in the drawing: the page stays the floor */
        bat_editor_command(editor, views[i]);
        bat_editor_glide(editor, 1);
        assert_true(fabs(bat_stage_slant(editor->context.stage) - 1) < 1e-9);
        assert_int_equal(bat_stage_dimension(editor->context.stage), 3);
        bat_view_axes(&editor->context.stage->view, right, down, ahead);
        assert_true(fabs(down[2] - 1) < 1e-9);
    }
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 5);
    bat_editor_command(editor, "view-top");
    bat_editor_glide(editor, 1);
    assert_int_equal(bat_stage_dimension(editor->context.stage), 2);
    bat_editor_command(editor, "view-side");
    assert_int_equal(bat_editor_command(editor, "draw-on-page"), BAT_OK);
    assert_int_equal(bat_stage_dimension(editor->context.stage), 2);
    bat_editor_command(editor, "view-side");
    assert_int_equal(bat_editor_command(editor, "view-upright"), BAT_OK);
    bat_editor_glide(editor, 1);
    assert_int_equal(bat_stage_dimension(editor->context.stage), 2);
    bat_editor_free(editor);
}

static void a_disc_lies_under_the_hovering_pen(void **state) {
    (void)state;
    bat_editor *editor = drawing();
    pen p = pen_for(editor);
    pen_event(&p, BAT_POINTER_HOVER, 500, 100);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_REACH)); /* face-on as ever */
    for (int steps = 1; steps <= 6; steps++) {
        bat_editor_command(editor, "orbit-up");
        const bat_frame *frame = bat_editor_frame(editor);
        const bat_item *disc = pen_live(frame, BAT_ROLE_REACH);
        if (steps == 6) {
            assert_null(disc); /* edge-on */
            continue;
        }
        assert_non_null(disc);
        assert_non_null(strstr(frame->hint, "the page"));
        const double wide = disc->bounds[2] - disc->bounds[0] - 1,
                     high = disc->bounds[3] - disc->bounds[1] - 1;
        assert_true(fabs(wide - 24) < 0.5);
        assert_true(fabs(high - 24 * cos(15 * steps * 3.14159265358979 / 180)) < 0.5);
        assert_true(disc->opacity == 1);
    }
    p = right_button(editor);
    drag(&p, 500, 400, 500, 420); /* to 80 degrees */
    p = pen_for(editor);
    pen_event(&p, BAT_POINTER_HOVER, 500, 400);
    assert_true(pen_live(bat_editor_frame(editor), BAT_ROLE_REACH)->opacity < 1);
    bat_editor_free(editor);
}

/* Of a floor and of a wall: what is upright is seen upright from every side, as far as the poles; over them a drag goes on with
 * no jump, upside down, all the way round. */
static void orbits_go_round_the_rooms_upright(void **state) {
    (void)state;
    seed = 23;
    for (int wall = 0; wall < 2; wall++) {
        bat_stage stage = bat_stage_defaults();
        bat_view *view = &stage.view;
        double held = 0, before[9], after[9], turned = 0;
        int heads = 0;
        view->width = 1000, view->height = 800;
        bat_room_take(view, wall, &(bat_attitude){.turn = 30, .tilt = 65});
        bat_view_axes(view, before, before + 3, before + 6);
        assert_true(fabs(before[wall ? 1 : 2]) < 1e-3);
        assert_true(before[wall ? 4 : 5] > 0.8 &&
                    before[wall ? 7 : 8] > 0.4); /* up is up, and looked down on */
        assert_true(before[6] < -0.4);           /* from the right */
        for (int i = 0; i < 740; i++) {
            bat_room_orbit(view, wall, any(-2, 2), 0.5, &held);
            bat_view_axes(view, after, after + 3, after + 6);
            turned = fmax(turned, apart(before, after, 9));
            memcpy(before, after, sizeof after);
            const bat_attitude pose = bat_room_attitude(view, wall);
            assert_true(pose.tilt >= 0 && pose.tilt <= 180);
            assert_true(fabs(pose.roll) < 1e-9 || fabs(fabs(pose.roll) - 180) < 1e-9);
            assert_true(pose.roll == 0 ? after[wall ? 4 : 5] > -1e-3 : after[wall ? 4 : 5] < 1e-3);
            heads += fabs(pose.roll) > 90;
        }
        assert_true(turned < 0.06);
        assert_true(heads > 300 && heads < 400);
        const bat_attitude end = bat_room_attitude(view, wall);
        assert_true(end.roll == 0 && end.tilt > 62 &&
                    end.tilt < 76); /* each pole holds it for some degrees */
    }
}

/* A view of any attitude is the public camera, and one that is saved comes back as it was. */
static void a_view_may_be_rolled(void **state) {
    (void)state;
    seed = 31;
    for (int i = 0; i < 200; i++) {
        bat_stage stage = any_stage(), again = bat_stage_defaults();
        const double angle = any(-180, 180), tilt = any(1, 179), roll = any(-180, 180);
        bat_view_pose(&stage.view, angle, tilt, roll);
        bat_viewpoint camera;
        double at[3], seen[2], pixel[2], other[2], from[3], along[3];
        for (int k = 0; k < 3; k++) at[k] = any(-400, 400);
        assert_int_equal(bat_stage_viewpoint(&stage, &camera), BAT_OK);
        bat_stage_look(&stage, 3, at, seen);
        bat_stage_project(&stage, seen, pixel);
        assert_int_equal(bat_viewpoint_project(&camera, at, other, NULL), BAT_OK);
        assert_true(apart(pixel, other, 2) < 1e-6);
        const bat_ray ray = bat_view_ray(&stage.view, pixel);
        assert_int_equal(bat_viewpoint_ray(&camera, pixel, from, along), BAT_OK);
        assert_true(apart(ray.along, along, 3) < 1e-9);
        again.view.width = 1000, again.view.height = 800;
        bat_view_look_from(&again.view, &camera);
        assert_true(again.view.angle == stage.view.angle && again.view.tilt == stage.view.tilt);
        assert_true(again.view.roll == stage.view.roll || fabs(remainder(roll, 180)) < 0.06);
        bat_stage_look(&again, 3, at, seen);
        bat_stage_project(&again, seen, other);
        assert_true(apart(pixel, other, 2) < 1e-3);
    }
}

/* A plane in space, whatever way it lies, is turned to. */
static void the_view_turns_to_a_plane(void **state) {
    (void)state;
    seed = 5;
    for (int i = 0; i < 50; i++) {
        bat_stage stage = any_stage();
        double x[3], y[3], length = 0, dot = 0;
        for (int k = 0; k < 3; k++) x[k] = any(-1, 1), length += x[k] * x[k];
        for (int k = 0; k < 3; k++) x[k] /= sqrt(length), y[k] = any(-1, 1), dot += x[k] * y[k];
        length = 0;
        for (int k = 0; k < 3; k++) y[k] -= dot * x[k], length += y[k] * y[k];
        double numbers[9] = {1, 2, 3};
        for (int k = 0; k < 3; k++) numbers[3 + k] = x[k], numbers[6 + k] = y[k] / sqrt(length);
        assert_true(bat_ground_named("plane", 9, numbers, &stage.ground));
        double normal[3], right[3], down[3], ahead[3];
        bat_stage_facing(&stage, normal);
        bat_room_look_along(&stage.view, i % 2, normal);
        assert_true(bat_stage_slant(&stage) > 1 - 1e-6);
        bat_view_axes(&stage.view, right, down, ahead);
        assert_true(fabs(right[i % 2 ? 1 : 2]) < 1e-3); /* the horizon is level */
    }
}

static void a_plane_that_faces_me_takes_the_stroke(void **state) {
    (void)state;
    bat_editor *editor = tilted_drawing(70, -80);
    const uint64_t first = digest(editor);
    assert_true(bat_editor_key(editor, "J", true, BAT_SHIFT, 0));
    const bat_stage *stage = editor->context.stage;
    assert_true(bat_stage_slant(stage) > 1 - 1e-12);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_MARQUEE));
    pen p = pen_for(editor);
    pen_line(&p, 300, 300, 700, 380, 60);
    const bat_document *document = bat_editor_document(editor);
    assert_int_equal(bat_document_count(document), 4);
    const bat_curve *made = bat_object_curve(bat_document_at(document, 3), 0);
    assert_int_equal(bat_curve_dimension(made), 3);
    double right[3], down[3], ahead[3];
    bat_view_axes(&stage->view, right, down, ahead);
    for (size_t i = 0; i < bat_curve_count(made); i++) {
        const double *at = bat_curve_points(made) + 3 * i;
        double off = 0;
        for (int k = 0; k < 3; k++) off += (at[k] - stage->view.pivot[k]) * ahead[k];
        assert_true(fabs(off) < 1e-8);
    }
    assert_true(bat_editor_key(editor, "j", true, 0, 0)); /* off */
    assert_int_equal(bat_stage_dimension(stage), 2);
    assert_true(bat_editor_key(editor, "j", true, 0, 0)); /* and on */
    assert_int_equal(bat_stage_dimension(stage), 3);
    assert_int_equal(round_trip(editor, first), 2);
    bat_editor_free(editor);
}

/* Taps and a marquee find what is seen there; a drag moves along the page. */
static void what_is_seen_is_selected_and_moved(void **state) {
    (void)state;
    bat_editor *editor = tilted_drawing(60, -90);
    const bat_stage *stage = editor->context.stage;
    const uint64_t first = digest(editor);
    bat_editor_command(editor, "tool-select");
    double at[2], seen[2], from[2], to[2];
    const bat_curve *curve = bat_object_curve(bat_document_at(bat_editor_document(editor), 1), 0);
    double domain[2];
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, (domain[0] + domain[1]) / 2, 0, at);
    bat_stage_look(stage, 2, at, seen);
    bat_stage_project(stage, seen, from);
    pen p = pen_for(editor);
    tap(&p, from[0], from[1]);
    assert_int_equal(bat_editor_frame(editor)->selected, 1);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_HANDLE));
    const double moved[2] = {at[0] + 31, at[1] - 17};
    bat_stage_look(stage, 2, moved, seen);
    bat_stage_project(stage, seen, to);
    drag(&p, from[0], from[1], to[0], to[1]);
    double after[2];
    curve = bat_object_curve(bat_document_at(bat_editor_document(editor), 1), 0);
    bat_curve_eval(curve, (domain[0] + domain[1]) / 2, 0, after);
    assert_true(apart(after, moved, 2) < 0.05); /* pixels are rounded to hundredths */
    assert_int_equal(round_trip(editor, first), 1);
    drag(&p, 2, 798, 998, 2); /* a marquee around everything */
    assert_int_equal(bat_editor_frame(editor)->selected, 2);
    bat_editor_command(editor, "view-front");
    const uint64_t now = digest(editor);
    bat_curve_eval(curve, domain[0], 0, at); /* away from the handles about the middle */
    bat_stage_look(stage, 2, at, seen);
    bat_stage_project(stage, seen, from);
    drag(&p, from[0], from[1], from[0] + 80, from[1]);
    assert_true(digest(editor) == now);
    assert_string_equal(bat_editor_frame(editor)->offer, "view-upright");
    bat_editor_free(editor);
}

/* A bump over the middle half of the domain. */
static double height_at(double share) {
    return share < 0.25 || share > 0.75 ? 0 : 60 * pow(sin((share - 0.25) * 2 * 3.14159265358979), 2);
}

static void a_curve_is_lifted_and_its_first_view_stays(void **state) {
    (void)state;
    bat_editor *editor = drawing();
    bat_editor_command(editor, "tool-lift");
    pen p = pen_for(editor);
    const uint64_t first = digest(editor);
    tap(&p, 200, 300);
    assert_int_equal(bat_editor_frame(editor)->selected, 1);
    pen_line(&p, 250, 300, 500, 250, 30); /* face-on nothing has a height */
    assert_true(digest(editor) == first);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "misses the surface"));
    pen r = right_button(editor);
    drag(&r, 500, 400, 540, 280);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_MARQUEE));
    const bat_stage *stage = editor->context.stage;
    bat_curve *flat = NULL;
    bat_curve_copy(bat_object_curve(bat_document_at(bat_editor_document(editor), 0), 0), &flat);
    double domain[2], at[3] = {0}, seen[2], pixel[2];
    bat_curve_domain(flat, domain);
    p.time += 5000;
    for (int i = 0; i <= 120; i++) {
        bat_curve_eval(flat, domain[0] + (domain[1] - domain[0]) * i / 120, 0, at);
        at[2] = -height_at(i / 120.0);
        bat_stage_look(stage, 3, at, seen);
        bat_stage_project(stage, seen, pixel);
        pen_event(&p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, pixel[0], pixel[1]);
        if (i % 10 == 0) bat_editor_frame(editor);
        check(editor);
    }
    pen_event(&p, BAT_POINTER_UP, pixel[0], pixel[1]);
    check(editor);
    const bat_curve *made = bat_object_curve(bat_document_at(bat_editor_document(editor), 0), 0);
    assert_int_equal(bat_curve_dimension(made), 3);
    for (int i = 0; i <= 200; i++) {
        const double u = domain[0] + (domain[1] - domain[0]) * i / 200;
        bat_curve_eval(made, u, 0, at);
        double before[2];
        bat_curve_eval(flat, u, 0, before);
        assert_true(apart(at, before, 2) < 1e-9); /* the first view */
        assert_true(fabs(at[2] + height_at(i / 200.0)) < 4);
    }
    assert_int_equal(round_trip(editor, first), 1);
    bat_curve_free(flat);
    bat_editor_free(editor);
}

/* As many views as are kept, and no more; a way between two views ends at the second. */
static void old_views_give_way(void **state) {
    (void)state;
    bat_views views = {.count = 0};
    bat_stage stage = any_stage();
    bat_view now = bat_view_defaults();
    assert_false(bat_views_home(&views, &now) || bat_views_back(&views, &now));
    for (int i = 0; i < BAT_VIEWS_KEPT + 7; i++) {
        bat_view_orbit(&stage.view, 1, i + 1);
        bat_views_leave(&views, &stage.view);
    }
    for (int i = BAT_VIEWS_KEPT + 6; i > 6; i--) {
        assert_true(bat_views_back(&views, &now));
        assert_true(now.tilt == i + 1);
    }
    assert_false(bat_views_back(&views, &now));
    assert_false(bat_views_home(&views, &now)); /* it was never upright */
    for (int k = 0; k < 2; k++) {
        bat_view from = bat_view_defaults(), to = stage.view;
        from.width = to.width, from.height = to.height;
        bat_view_orbit(&to, 90, 60);
        now = from;
        bat_views_jump(&views, &from, &to);
        bat_views_glide(&views, &now, 0.5);
        assert_true(fabs(now.tilt - 30) < 0.011 && fabs(now.angle - 45) < 0.011);
        assert_true(fabs(now.zoom - sqrt(from.zoom * to.zoom)) < 1e-12 * now.zoom);
        bat_views_glide(&views, &now, k ? NAN : 1);
        assert_true(now.tilt == 60 && now.angle == 90 && now.x == to.x && now.y == to.y);
        bat_views_glide(&views, &now, 0); /* it has ended */
        assert_true(now.tilt == 60);
    }
}

static void fit_finds_everything(void **state) {
    (void)state;
    bat_editor *editor = drawing();
    seed = 3;
    for (int i = 0; i < 10; i++) {
        pen p = right_button(editor);
        const double x = any(-300, 300), y = any(-400, 100);
        drag(&p, 500, 400, 500 + x, 400 + y);
        bat_editor_wheel(editor, 100, 100, 900, 5000, 0, p.time);
        assert_int_equal(bat_editor_command(editor, "view-fit"), BAT_OK);
        const bat_frame *frame = bat_editor_frame(editor);
        const bat_context *c = &editor->context;
        for (uint32_t k = 0; k < frame->still_count; k++) {
            const float *path = frame->still[k].path;
            double pixel[2];
            bat_stage_project(c->stage, (double[]){path[1] + frame->origin[0], path[2] + frame->origin[1]},
                              pixel);
            assert_true(pixel[0] > 0 && pixel[0] < 1000 && pixel[1] > 0 && pixel[1] < 800);
        }
    }
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_the_camera_of_the_library),
        cmocka_unit_test(the_pivot_stays_where_it_is_seen),
        cmocka_unit_test(a_right_drag_orbits_and_home_is_exact),
        cmocka_unit_test(a_drag_of_a_single_move_turns),
        cmocka_unit_test(escape_returns_to_before),
        cmocka_unit_test(keys_turn_in_steps_and_name_views),
        cmocka_unit_test(three_fingers_turn_and_two_never_do),
        cmocka_unit_test(with_a_pen_one_finger_turns_a_tilted_view),
        cmocka_unit_test(what_is_not_ready_for_it_is_refused_and_home_offered),
        cmocka_unit_test(a_new_line_lands_on_the_page),
        cmocka_unit_test(a_redraw_is_that_of_the_page),
        cmocka_unit_test(edge_on_no_stroke_begins),
        cmocka_unit_test(front_and_side_draw_on_their_own_plane),
        cmocka_unit_test(a_disc_lies_under_the_hovering_pen),
        cmocka_unit_test(orbits_go_round_the_rooms_upright),
        cmocka_unit_test(a_view_may_be_rolled),
        cmocka_unit_test(the_view_turns_to_a_plane),
        cmocka_unit_test(a_curve_is_lifted_and_its_first_view_stays),
        cmocka_unit_test(old_views_give_way),
        cmocka_unit_test(what_is_seen_is_selected_and_moved),
        cmocka_unit_test(a_plane_that_faces_me_takes_the_stroke),
        cmocka_unit_test(fit_finds_everything),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
