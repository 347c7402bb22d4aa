/* Surfaces made from the selected curves: what is offered, what is made, how it follows while curves are edited, and when it
 * is free. Each session replays, and undo leads back. */
#include "document/document.h"
#include "editor/edit/making.h"
#include "editor/editor.h"
#include "editor/export.h"
#include "editor/tables/tables.h"

#include <batten/batten.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support/editing.h"
#include "support/xml.h"

enum { CURVES = 5 };

typedef struct scene {
    int count;
    int points[CURVES]; /* below 0: closed, of that many */
    double at[CURVES][12];
} scene;

static bat_editor *open(const scene *s) {
    bat_curve *curves[CURVES];
    for (int i = 0; i < s->count; i++) {
        const int n = abs(s->points[i]);
        double knots[8];
        for (int k = 0; k <= n; k++) knots[k] = k;
        const bat_status status =
            s->points[i] < 0 ? bat_curve_create(2, 2, true, (size_t)n, s->at[i], n + 1, knots, &curves[i])
                             : bat_curve_create_clamped(2, n > 3 ? 3 : 1, (size_t)n, s->at[i], &curves[i]);
        assert_int_equal(status, BAT_OK);
    }
    bat_editor *editor = editor_with(s->count, curves);
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    bat_editor_frame(editor);
    return editor;
}

static const scene PIPE = {
    2, {4, -4}, {{200, 600, 300, 500, 500, 500, 600, 600}, {700, 200, 740, 200, 740, 240, 700, 240}}};
static const scene TWO = {
    2, {4, 4}, {{200, 600, 300, 500, 500, 500, 600, 600}, {600, 300, 500, 250, 300, 250, 200, 300}}};
static const scene JUG = {2, {4, 2}, {{500, 600, 600, 500, 520, 350, 560, 200}, {400, 650, 400, 150}}};
static const scene FOUR = {4,
                           {2, 4, 2, 2},
                           {{200, 200, 500, 200},
                            {500, 200, 540, 300, 540, 400, 500, 500},
                            {200, 500, 500, 500},
                            {200, 500, 200, 200}}};
static const scene THREE = {3,
                            {4, 4, 4},
                            {{100, 100, 200, 90, 300, 90, 400, 100},
                             {100, 500, 200, 480, 300, 480, 400, 500},
                             {400, 300, 300, 250, 200, 250, 100, 300}}};

static bool offers(bat_editor *editor, const char *name) {
    const char *all = bat_editor_actions(editor), *at = all ? strstr(all, name) : NULL;
    const size_t length = strlen(name);
    while (at && (at[length] != ' ' && at[length] != 0)) at = strstr(at + 1, name);
    return at != NULL;
}

static const bat_object *surface_in(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    for (int i = bat_document_count(document) - 1; i >= 0; i--)
        if (bat_object_surface(bat_document_at(document, i))) return bat_document_at(document, i);
    return NULL;
}

/* The surface is what its recipe makes of the curves as they are. */
static void is_fresh(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    const bat_object *made = surface_in(editor), *from[BAT_RECIPE_CURVES];
    const bat_curve *curves[BAT_RECIPE_CURVES];
    bat_surface *wanted = NULL;
    assert_non_null(made);
    const int count = bat_object_sources(made, NULL);
    assert_true(count > 0 && bat_document_sources(document, made, from));
    for (int i = 0; i < count; i++) curves[i] = bat_object_curve(from[i], 0);
    assert_int_equal(bat_recipe_surface(bat_object_recipe(made), (size_t)count, curves, &wanted, NULL),
                     BAT_OK);
    assert_true(bat_surface_is_equal(wanted, bat_object_surface(made)));
    bat_surface_free(wanted);
}

static void only_what_fits_is_offered(void **state) {
    (void)state;
    static const char *const names[] = {"surface-sweep", "surface-ruled", "surface-revolve", "surface-coons",
                                        "surface-close", "surface-loft",  "surface-free"};
    const struct {
        const scene *scene;
        unsigned wanted; /* bits of names */
    } cases[] = {{&PIPE, 1}, {&TWO, 1 | 2}, {&JUG, 1 | 2 | 4}, {&FOUR, 8}, {&THREE, 32}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_editor *editor = open(cases[i].scene);
        for (int k = 0; k < 7; k++) {
            const bool wanted = cases[i].wanted >> k & 1;
            if (offers(editor, names[k]) != wanted) fail_msg("scene %d: %s", (int)i, names[k]);
            if (wanted) continue;
            const uint64_t before = digest(editor);
            assert_int_equal(bat_editor_command(editor, names[k]), BAT_STATE);
            assert_true(bat_editor_frame(editor)->notice[0] != 0); /* says why */
            assert_true(digest(editor) == before);
        }
        bat_editor_free(editor);
    }
}

static void each_is_one_step(void **state) {
    (void)state;
    const struct {
        const scene *scene;
        const char *name;
        bat_recipe_kind kind;
    } cases[] = {{&PIPE, "surface-sweep", BAT_RECIPE_SWEEP},
                 {&TWO, "surface-ruled", BAT_RECIPE_RULED},
                 {&JUG, "surface-revolve", BAT_RECIPE_REVOLVE},
                 {&FOUR, "surface-coons", BAT_RECIPE_COONS},
                 {&THREE, "surface-loft", BAT_RECIPE_LOFT}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_editor *editor = open(cases[i].scene);
        const uint64_t first = digest(editor);
        assert_int_equal(bat_editor_command(editor, cases[i].name), BAT_OK);
        const bat_frame *frame = bat_editor_frame(editor);
        assert_int_equal(frame->selected, 1);
        assert_string_equal(frame->notice, "The surface follows its curves");
        assert_string_equal(frame->offer, "orbit-up"); /* the page is seen from above */
        assert_int_equal(bat_object_recipe(surface_in(editor))->kind, cases[i].kind);
        is_fresh(editor);
        assert_true(offers(editor, "surface-free"));
        assert_int_equal(round_trip(editor, first), 1);
        bat_editor_free(editor);
    }
}

/* Sections in their order in space, not in that in which they were drawn. */
static void sections_lie_side_by_side(void **state) {
    (void)state;
    bat_editor *editor = open(&THREE);
    const bat_id *ids;
    assert_int_equal(bat_editor_command(editor, "surface-loft"), BAT_OK);
    assert_int_equal(bat_object_sources(surface_in(editor), &ids), 3);
    assert_true(ids[1] == 3);
    bat_editor_free(editor);
}

/* In every frame of a drag. */
static void follows_while_a_point_is_dragged(void **state) {
    (void)state;
    bat_editor *editor = open(&JUG);
    assert_int_equal(bat_editor_command(editor, "surface-revolve"), BAT_OK);
    const uint64_t first = digest(editor);
    bat_editor_command(editor, "tool-points");
    assert_int_equal(bat_editor_choose(editor, 1, 1), BAT_OK);
    bat_editor_frame(editor);
    pen p = mouse(editor);
    double low[3], high[3], widest = 0;
    p.time += 1000;
    pen_event(&p, BAT_POINTER_HOVER, 600, 500);
    bat_editor_frame(editor);
    pen_event(&p, BAT_POINTER_DOWN, 600, 500);
    for (int i = 1; i <= 8; i++) {
        pen_event(&p, BAT_POINTER_MOVE, 600 + 20 * i, 500);
        bat_editor_frame(editor);
        check(editor);
        is_fresh(editor);
        bat_surface_box(bat_object_surface(surface_in(editor)), low, high);
        assert_true(high[0] - low[0] > widest);
        widest = high[0] - low[0];
    }
    pen_event(&p, BAT_POINTER_UP, 760, 500);
    bat_editor_frame(editor);
    is_fresh(editor);
    assert_true(widest > 500);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK); /* one step for both */
    assert_true(digest(editor) == first);
    is_fresh(editor);
    replays(editor, 1);
    bat_editor_free(editor);
}

/* A drag that is cancelled leaves nothing behind. */
static void cancelled_it_goes_back(void **state) {
    (void)state;
    bat_editor *editor = open(&JUG);
    assert_int_equal(bat_editor_command(editor, "surface-revolve"), BAT_OK);
    const uint64_t first = digest(editor);
    assert_int_equal(bat_editor_select(editor, 1, false), BAT_OK);
    pen p = mouse(editor);
    bat_editor_frame(editor);
    drag_to(&p, 552.5, 418.75, 600, 430);
    assert_true(digest(editor) != first);
    is_fresh(editor);
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

static void with_a_deleted_curve_it_is_free(void **state) {
    (void)state;
    bat_editor *editor = open(&PIPE);
    const uint64_t first = digest(editor);
    assert_int_equal(bat_editor_command(editor, "surface-sweep"), BAT_OK);
    const uint64_t made = digest(editor);
    assert_int_equal(bat_editor_select(editor, 1, false), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "delete"), BAT_OK);
    assert_string_equal(bat_editor_frame(editor)->notice,
                        "Detached: the surface no longer follows its curves");
    assert_null(bat_object_recipe(surface_in(editor)));
    check(editor);
    replays(editor, 1);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK); /* the same step */
    assert_true(digest(editor) == made);
    is_fresh(editor);
    bat_editor_command(editor, "redo");
    assert_int_equal(round_trip(editor, first), 2);
    bat_editor_free(editor);
}

static void can_be_freed(void **state) {
    (void)state;
    bat_editor *editor = open(&PIPE);
    const uint64_t first = digest(editor);
    assert_int_equal(bat_editor_command(editor, "surface-free"), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "surface-sweep"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "surface-free"), BAT_OK);
    assert_null(bat_object_recipe(surface_in(editor)));
    assert_false(offers(editor, "surface-free"));
    bat_surface *kept = NULL;
    bat_surface_copy(bat_object_surface(surface_in(editor)), &kept);
    assert_int_equal(bat_editor_select(editor, 1, false), BAT_OK);
    bat_editor_command(editor, "nudge-right");
    assert_true(bat_surface_is_equal(kept, bat_object_surface(surface_in(editor))));
    bat_surface_free(kept);
    assert_int_equal(round_trip(editor, first), 3);
    bat_editor_free(editor);
}

/* The same points with the normals the other way; twice, the surface as it was. */
static void can_be_flipped(void **state) {
    (void)state;
    bat_editor *editor = open(&PIPE);
    const uint64_t first = digest(editor);
    assert_int_equal(bat_editor_command(editor, "surface-flip"), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "surface-sweep"), BAT_OK);
    bat_surface *before = NULL;
    bat_surface_copy(bat_object_surface(surface_in(editor)), &before);
    bat_editor_frame(editor);
    assert_true(offers(editor, "surface-flip"));
    assert_int_equal(bat_editor_command(editor, "surface-flip"), BAT_OK);
    const bat_surface *after = bat_object_surface(surface_in(editor));
    double u[3], v[3];
    bat_surface_spread(before, BAT_U, 3, u), bat_surface_spread(before, BAT_V, 3, v);
    for (int i = 0; i < 3; i++) {
        double at[3], now[3], normal[3], turned[3];
        bat_surface_eval(before, u[i], v[i], 0, at), bat_surface_eval(after, v[i], u[i], 0, now);
        assert_int_equal(bat_surface_normal(before, u[i], v[i], normal), BAT_OK);
        assert_int_equal(bat_surface_normal(after, v[i], u[i], turned), BAT_OK);
        for (int k = 0; k < 3; k++)
            assert_true(fabs(at[k] - now[k]) < 1e-9 && fabs(normal[k] + turned[k]) < 1e-9);
    }
    assert_null(bat_object_recipe(surface_in(editor)));
    assert_int_equal(bat_editor_command(editor, "surface-flip"), BAT_OK);
    assert_true(bat_surface_is_equal(before, bat_object_surface(surface_in(editor))));
    bat_surface_free(before);
    assert_int_equal(round_trip(editor, first), 3);
    bat_editor_free(editor);
}

/* Of what is exported: whether STEP has a solid, and whether triangles have open edges. */
static void is_solid(bat_editor *editor, bool solid) {
    bat_problem problem;
    char *bytes = NULL;
    size_t size = 0;
    assert_int_equal(bat_editor_export(editor, "step wall", BAT_EXCERPT_ALL, 0, &bytes, &size, &problem),
                     BAT_OK);
    assert_int_equal(strstr(bytes, "MANIFOLD_SOLID_BREP") != NULL, solid);
    bat_free(bytes);
    assert_int_equal(bat_editor_export(editor, "stl wall tell", BAT_EXCERPT_ALL, 0, &bytes, &size, &problem),
                     BAT_OK);
    assert_int_equal(strstr(bytes, "\"open\":0,") != NULL, solid);
    bat_free(bytes);
}

/* A tube whose ends are open is closed by cones and planes to the middles of its rims; nothing else of it moves, its triangles
 * leave no edge open, and there is nothing more to close. */
static void open_ends_are_capped(void **state) {
    (void)state;
    bat_editor *editor = open(&PIPE);
    const uint64_t first = digest(editor);
    assert_int_equal(bat_editor_command(editor, "surface-cap"), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "surface-sweep"), BAT_OK);
    bat_surface *before = NULL;
    bat_surface_copy(bat_object_surface(surface_in(editor)), &before);
    bat_editor_frame(editor);
    assert_true(offers(editor, "surface-cap"));
    is_solid(editor, false);
    assert_int_equal(bat_editor_command(editor, "surface-cap"), BAT_OK);
    is_solid(editor, true);
    const bat_surface *after = bat_object_surface(surface_in(editor));
    const bat_direction along = bat_surface_is_closed(before, BAT_U) ? BAT_V : BAT_U;
    double was[2], now[2], around[2];
    bat_surface_domain(before, along, was), bat_surface_domain(after, along, now);
    bat_surface_domain(before, 1 - along, around);
    for (int i = 0; i <= 24; i++) {
        const double t = was[0] + (was[1] - was[0]) * i / 24,
                     s = around[0] + (around[1] - around[0]) * i / 24;
        const double place[2] = {along == BAT_U ? t : s, along == BAT_U ? s : t};
        double at[3], there[3], end[2][3];
        bat_surface_eval(before, place[0], place[1], 0, at),
            bat_surface_eval(after, place[0], place[1], 0, there);
        for (int k = 0; k < 3; k++) assert_true(fabs(at[k] - there[k]) < 1e-9);
        for (int e = 0; e < 2; e++) { /* each end is one point, and straight ways lead there */
            double half[3], rim[3];
            const double ways[3] = {now[e], (now[e] + was[e]) / 2, was[e]};
            bat_surface_eval(after, along == BAT_U ? ways[0] : s, along == BAT_U ? s : ways[0], 0, end[e]);
            bat_surface_eval(after, along == BAT_U ? ways[1] : s, along == BAT_U ? s : ways[1], 0, half);
            bat_surface_eval(after, along == BAT_U ? ways[2] : s, along == BAT_U ? s : ways[2], 0, rim);
            for (int k = 0; k < 3; k++) assert_true(fabs(half[k] - (end[e][k] + rim[k]) / 2) < 1e-9);
        }
    }
    assert_null(bat_object_recipe(surface_in(editor)));
    assert_int_equal(bat_editor_command(editor, "surface-cap"), BAT_STATE);
    bat_surface_free(before);
    assert_int_equal(round_trip(editor, first), 2);
    bat_editor_free(editor);
}

/* All moved together it stays bound; moved alone it is free, which is told. */
static void moved_together_or_alone(void **state) {
    (void)state;
    for (int alone = 0; alone < 2; alone++) {
        bat_editor *editor = open(&PIPE);
        const uint64_t first = digest(editor);
        assert_int_equal(bat_editor_command(editor, "surface-sweep"), BAT_OK);
        if (!alone) bat_editor_command(editor, "select-all");
        bat_editor_command(editor, "nudge-right");
        assert_true((bat_object_recipe(surface_in(editor)) == NULL) == alone);
        if (!alone) is_fresh(editor);
        assert_int_equal(round_trip(editor, first), 2);
        bat_editor_free(editor);
    }
}

/* Duplicated with its curves it follows the copies, alone it is free. */
static void copies(void **state) {
    (void)state;
    for (int alone = 0; alone < 2; alone++)
        for (int paste = 0; paste < 2; paste++) {
            bat_editor *editor = open(&PIPE);
            const uint64_t first = digest(editor);
            assert_int_equal(bat_editor_command(editor, "surface-sweep"), BAT_OK);
            const bat_id original = bat_object_id(surface_in(editor));
            if (!alone) bat_editor_command(editor, "select-all");
            if (paste) {
                char *text = NULL;
                size_t size;
                bat_document *part = NULL;
                bat_svg_report report;
                bat_problem problem;
                assert_int_equal(bat_editor_copy(editor, false, &text, &size), BAT_OK);
                assert_int_equal(xml_read(text, NULL, &part, &report, &problem), BAT_OK);
                assert_int_equal(bat_editor_paste(editor, part, true), BAT_OK);
                bat_free(text);
                bat_document_free(part);
            } else {
                assert_int_equal(bat_editor_command(editor, "duplicate"), BAT_OK);
            }
            const bat_document *document = bat_editor_document(editor);
            const bat_object *copy = NULL;
            for (int i = 0; i < bat_document_count(document); i++)
                if (bat_object_surface(bat_document_at(document, i)) &&
                    bat_object_id(bat_document_at(document, i)) != original)
                    copy = bat_document_at(document, i);
            const bat_id *ids;
            assert_non_null(copy);
            assert_int_equal(bat_object_sources(copy, &ids), alone ? 0 : 2);
            if (!alone) assert_true(ids[0] > original && ids[1] > original && ids[0] != ids[1]);
            assert_int_equal(
                bat_object_sources(bat_document_at(document, bat_document_find(document, original)), &ids),
                2);
            assert_true(ids[0] == 1 && ids[1] == 2);
            assert_int_equal(round_trip(editor, first), 2);
            bat_editor_free(editor);
        }
}

static void numbers(void **state) {
    (void)state;
    bat_editor *editor = open(&PIPE);
    const uint64_t first = digest(editor);
    assert_string_equal(bat_editor_number(editor, "surface-twist"), "");
    assert_int_equal(bat_editor_command(editor, "surface-sweep"), BAT_OK);
    assert_string_equal(bat_editor_number(editor, "surface-twist"), "0°");
    assert_string_equal(bat_editor_number(editor, "surface-scale"), "1");
    assert_string_equal(bat_editor_number(editor, "surface-angle"), "");
    assert_int_equal(bat_editor_enter(editor, "surface-twist", "90"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "surface-scale", "0.5"), BAT_OK);
    assert_string_equal(bat_editor_number(editor, "surface-twist"), "90°");
    assert_non_null(
        strstr(bat_editor_frame(editor)->hint, "twist 90°, scale 0.5 at the end")); /* beside the hint, too */
    assert_string_equal(bat_editor_number(editor, "surface-scale"), "0.5");
    is_fresh(editor);
    assert_true(bat_object_recipe(surface_in(editor))->twist == 90);
    assert_int_equal(bat_editor_enter(editor, "surface-twist", "1000000"), BAT_NUMBER);
    assert_int_equal(bat_editor_enter(editor, "surface-scale", "-1"), BAT_NUMBER);
    assert_true(bat_editor_enter(editor, "surface-scale", "wide") != BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "surface-angle", "90"), BAT_STATE);
    assert_int_equal(round_trip(editor, first), 3);
    bat_editor_free(editor);
    editor = open(&JUG);
    assert_int_equal(bat_editor_command(editor, "surface-revolve"), BAT_OK);
    assert_string_equal(bat_editor_number(editor, "surface-angle"), "360°");
    assert_non_null(strstr(bat_editor_frame(editor)->hint, "angle 360°"));
    assert_int_equal(bat_editor_enter(editor, "surface-angle", "180"), BAT_OK);
    assert_non_null(strstr(bat_editor_frame(editor)->hint, "angle 180°"));
    assert_false(bat_surface_is_closed(bat_object_surface(surface_in(editor)), BAT_U));
    is_fresh(editor);
    bat_editor_free(editor);
}

/* Corners: up to 2 px apart they are closed by one command, further apart the distance is told. */
static void corners(void **state) {
    (void)state;
    for (int far = 0; far < 2; far++) {
        scene s = FOUR;
        s.at[0][2] += far ? 20 : 1.5;
        bat_editor *editor = open(&s);
        assert_true(offers(editor, "surface-close") == !far);
        assert_true(offers(editor, "surface-coons") == far);
        if (far) {
            assert_int_equal(bat_editor_command(editor, "surface-coons"), BAT_STATE);
            assert_string_equal(bat_editor_frame(editor)->notice, "The corners are up to 20 px apart");
        } else {
            assert_int_equal(bat_editor_command(editor, "surface-close"), BAT_OK);
            assert_string_equal(bat_editor_frame(editor)->notice, "Corners up to 1.5 px apart are closed");
            is_fresh(editor);
        }
        bat_editor_free(editor);
    }
}

/* Four splines of the tangents tool that meet make a Coons patch, as the paper of 1994 ends; the arrow of one of them turns its
 * direction, and the patch follows. */
static void splines_make_a_patch(void **state) {
    (void)state;
    const double points[4][6] = {{200, 200, 350, 170, 500, 200},
                                 {500, 200, 530, 350, 500, 500},
                                 {500, 500, 350, 470, 200, 500},
                                 {200, 500, 230, 350, 200, 200}};
    const bat_style style = bat_style_defaults();
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    for (int i = 0; i < 4; i++) {
        const bat_spline spline = {.dimension = 2, .count = 3, .points = points[i]};
        bat_object *object = NULL;
        assert_int_equal(bat_object_create_spline((bat_id)(i + 1), "", &style, &spline, NULL, &object),
                         BAT_OK);
        assert_int_equal(bat_document_insert(document, i, object), BAT_OK);
        bat_object_release(object);
    }
    bat_editor *editor = editor_of(document);
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    bat_editor_frame(editor);
    const uint64_t first = digest(editor);
    assert_true(offers(editor, "surface-coons"));
    assert_int_equal(bat_editor_command(editor, "surface-coons"), BAT_OK);
    is_fresh(editor);
    double before[3], after[3];
    bat_surface *kept = NULL;
    assert_int_equal(bat_surface_copy(bat_object_surface(surface_in(editor)), &kept), BAT_OK);
    for (int k = 0; k < 4; k++) { /* each corner is that of the splines */
        bat_surface_eval(kept, k & 1, k >> 1, 0, before);
        bool met = false;
        for (int i = 0; i < 4; i++)
            met = met || (fabs(before[0] - points[i][0]) < 1e-9 && fabs(before[1] - points[i][1]) < 1e-9);
        assert_true(met);
    }
    bat_editor_command(editor, "tool-tangents");
    pen p = pen_for(editor);
    tap(&p, 350, 170);
    p.modifiers = BAT_CTRL; /* no snapping */
    drag(&p, 350 + 44, 170, 350 + 44 * cos(0.5), 170 + 44 * sin(0.5));
    const bat_document *now = bat_editor_document(editor);
    const bat_spline *turned = bat_object_spline(bat_document_at(now, bat_document_find(now, 1)));
    assert_non_null(turned); /* still a spline */
    assert_non_null(turned->tangents);
    assert_true(fabs(turned->tangents[3] / turned->tangents[2] - tan(0.5)) < 0.02);
    is_fresh(editor);
    double most = 0;
    for (int k = 0; k <= 20; k++)
        for (int j = 0; j < 4; j++) { /* the side that was turned moves, its ends stay */
            const double t = k / 20.0, u = j < 2 ? t : j - 2, v = j < 2 ? j : t;
            bat_surface_eval(kept, u, v, 0, before);
            bat_surface_eval(bat_object_surface(surface_in(editor)), u, v, 0, after);
            const double far = hypot(after[0] - before[0], after[1] - before[1]);
            assert_true((k > 0 && k < 20) || far < 1e-9);
            most = fmax(most, far);
        }
    assert_true(most > 3);
    assert_int_equal(round_trip(editor, first), 2);
    bat_surface_free(kept);
    bat_editor_free(editor);
}

static void folds_are_told(void **state) {
    (void)state;
    scene s = {
        2, {4, -4}, {{300, 300, 400, 300, 400, 340, 300, 340}, {600, 300, 760, 300, 760, 460, 600, 460}}};
    bat_editor *editor = open(&s);
    assert_int_equal(bat_editor_command(editor, "surface-sweep"), BAT_OK);
    const char *notice = bat_editor_frame(editor)->notice;
    assert_true(strncmp(notice, "The surface folds over itself in ", 33) == 0 && atoi(notice + 33) > 0);
    for (int chosen = 0; chosen < 2;
         chosen++) { /* hatched while the surface or one of its curves is selected */
        bat_editor_command(editor, chosen ? "select-all" : "deselect");
        const bat_frame *frame = bat_editor_frame(editor);
        int hatched = 0;
        for (uint32_t i = 0; i < frame->live_count; i++) hatched += frame->live[i].role == BAT_ROLE_ERASED;
        assert_int_equal(hatched, chosen);
    }
    bat_editor_free(editor);
}

/* Along straight lines a sweep goes round the corner: what is swept there lies in the plane that halves it. */
static void corners_are_mitred(void **state) {
    (void)state;
    scene s = {2, {3, -4}, {{300, 300, 400, 300, 400, 400}, {600, 300, 640, 300, 640, 340, 600, 340}}};
    bat_editor *editor = open(&s);
    const uint64_t first = digest(editor);
    assert_int_equal(bat_editor_command(editor, "surface-sweep"), BAT_OK);
    const bat_document *document = bat_editor_document(editor);
    const bat_surface *made = NULL;
    for (int i = 0; i < bat_document_count(document); i++)
        if (bat_object_surface(bat_document_at(document, i)))
            made = bat_object_surface(bat_document_at(document, i));
    assert_non_null(made);
    double u[2], v[2], at[3];
    bat_surface_domain(made, BAT_U, u), bat_surface_domain(made, BAT_V, v);
    for (int k = 0; k < 9; k++) {
        bat_surface_eval(made, (u[0] + u[1]) / 2, v[0] + (v[1] - v[0]) * k / 9, 0, at);
        assert_true(fabs((at[0] - 400) + (at[1] - 300)) < 1e-9 && fabs(at[0] - 400) < 30);
    }
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

/* A corner beside a bend makes no sweep. */
static void corners_in_a_path(void **state) {
    (void)state;
    const double path[] = {300, 300, 340, 360, 400, 300, 440, 380, 500, 400},
                 knots[] = {0, 0, 0, 1, 1, 2, 2, 2}, around[] = {600, 300, 640, 300, 640, 340, 600, 340},
                 even[] = {0, 1, 2, 3, 4};
    bat_curve *curves[2] = {NULL, NULL};
    assert_int_equal(bat_curve_create(2, 2, false, 5, path, 8, knots, &curves[0]), BAT_OK);
    assert_int_equal(bat_curve_create(2, 2, true, 4, around, 5, even, &curves[1]), BAT_OK);
    bat_editor *editor = editor_with(2, curves);
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    const uint64_t first = digest(editor);
    assert_int_equal(bat_editor_command(editor, "surface-sweep"), BAT_UNSUPPORTED);
    assert_string_equal(bat_editor_frame(editor)->notice,
                        "The path has a corner beside a bend, or the profile lies in no plane");
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

/* Two strokes with nothing selected, of which the other is straight: the notice offers what takes them as they are. */
static void what_is_drawn_is_offered(void **state) {
    (void)state;
    static const struct {
        double curve[12];
        bool offered;
    } rows[] = {{{500, 600, 620, 500, 520, 350, 560, 200}, true},   /* beside the axis */
                {{300, 600, 200, 500, 280, 350, 240, 200}, true},   /* on its other side */
                {{300, 600, 200, 500, 620, 350, 560, 200}, false},  /* across it */
                {{500, 600, 500, 500, 500, 350, 500, 200}, false}}; /* a line, too */
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        scene s = {2, {4, 2}, {{0}, {400, 650, 400, 150}}};
        memcpy(s.at[0], rows[i].curve, sizeof s.at[0]);
        bat_editor *editor = open(&s);
        bat_editor_command(editor, "deselect");
        assert_int_equal(bat_making_offers_revolving(&editor->context), rows[i].offered);
        assert_int_equal(bat_editor_command(editor, "select-all"), BAT_OK);
        assert_false(bat_making_offers_revolving(&editor->context)); /* its bar offers it */
        bat_editor_command(editor, "deselect");
        if (rows[i].offered) {
            assert_int_equal(bat_editor_command(editor, "surface-revolve"), BAT_OK);
            assert_non_null(surface_in(editor));
            is_fresh(editor);
            bat_editor_command(editor, "deselect");
            assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
            assert_null(surface_in(editor));
        }
        bat_editor_free(editor);
    }
    bat_editor *editor = open(&FOUR); /* more than two */
    bat_editor_command(editor, "deselect");
    assert_int_equal(bat_editor_command(editor, "surface-revolve"), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "surface-coons"), BAT_OK);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_is_drawn_is_offered),
                                       cmocka_unit_test(only_what_fits_is_offered),
                                       cmocka_unit_test(each_is_one_step),
                                       cmocka_unit_test(sections_lie_side_by_side),
                                       cmocka_unit_test(follows_while_a_point_is_dragged),
                                       cmocka_unit_test(cancelled_it_goes_back),
                                       cmocka_unit_test(with_a_deleted_curve_it_is_free),
                                       cmocka_unit_test(can_be_freed),
                                       cmocka_unit_test(can_be_flipped),
                                       cmocka_unit_test(open_ends_are_capped),
                                       cmocka_unit_test(moved_together_or_alone),
                                       cmocka_unit_test(copies),
                                       cmocka_unit_test(numbers),
                                       cmocka_unit_test(corners),
                                       cmocka_unit_test(splines_make_a_patch),
                                       cmocka_unit_test(folds_are_told),
                                       cmocka_unit_test(corners_are_mitred),
                                       cmocka_unit_test(corners_in_a_path)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
