/* Surfaces that are made from curves of the document: they are made again when a curve changes, are free when one goes or they
 * are moved away, and are written and read with what they are made from. */
#include "document/document.h"
#include "document/follow.h"
#include "document/kind.h"
#include "document/object.h"
#include "editor/edit/affine.h"

#include <batten/format.h>
#include <batten/refine.h>
#include <batten/recipe.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support/alloc_fail.h"
#include "support/objects.h"

enum { PATH = 1, PROFILE = 2, MADE = 3 };

static bat_object *path_of(bat_id id, int count, const double *points) {
    const bat_style style = bat_style_defaults();
    bat_curve *curve = NULL;
    bat_object *object = NULL;
    assert_int_equal(bat_curve_create_clamped(2, count > 3 ? 3 : 1, (size_t)count, points, &curve), BAT_OK);
    assert_int_equal(bat_object_create_path(id, "line", &style, 1, &curve, &object), BAT_OK);
    return object;
}

static const double bow[] = {100, 400, 200, 380, 300, 390, 400, 400}, line[] = {90, 300, 120, 300};

static bat_recipe sweep_of(double twist, double scale) {
    bat_recipe recipe = bat_recipe_of(BAT_RECIPE_SWEEP);
    recipe.twist = twist, recipe.scale = scale;
    return recipe;
}

/* A path, a profile, and the sweep. */
static bat_document *document_with(const bat_recipe *recipe) {
    const bat_style style = bat_style_defaults();
    bat_document *document = NULL;
    bat_object *objects[3] = {path_of(PATH, 4, bow), path_of(PROFILE, 2, line), NULL};
    assert_int_equal(bat_object_create_made(MADE, "pipe", &style, recipe, 2,
                                            (const bat_object *const *)objects, &objects[2]),
                     BAT_OK);
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_document_fill(document, 3, objects), BAT_OK);
    assert_null(bat_document_check(document));
    return document;
}

static const bat_object *found(const bat_document *document, bat_id id) {
    return bat_document_at(document, bat_document_find(document, id));
}

static void put(bat_document *document, bat_object *object) {
    const int at = bat_document_find(document, bat_object_id(object));
    assert_int_equal(bat_document_replace(document, at, object), BAT_OK);
    bat_object_release(object);
}

static void is_made_of_its_curves(void **state) {
    (void)state;
    const bat_recipe recipe = sweep_of(30, 2);
    bat_document *document = document_with(&recipe);
    const bat_object *made = found(document, MADE);
    const bat_id *ids;
    const bat_curve *curves[2] = {bat_object_curve(found(document, PATH), 0),
                                  bat_object_curve(found(document, PROFILE), 0)};
    bat_surface *wanted = NULL;
    assert_int_equal(bat_recipe_surface(&recipe, 2, curves, &wanted, NULL), BAT_OK);
    assert_true(bat_surface_is_equal(wanted, bat_object_surface(made)));
    assert_int_equal(bat_object_sources(made, &ids), 2);
    assert_true(ids[0] == PATH && ids[1] == PROFILE);
    assert_true(bat_object_recipe(made)->twist == 30 && bat_object_recipe(made)->scale == 2);
    assert_int_equal(bat_object_kind(made), BAT_KIND_SURFACE);
    assert_int_equal(bat_object_sources(found(document, PATH), NULL), 0);
    assert_null(bat_object_recipe(found(document, PATH)));
    bat_surface_free(wanted);
    bat_document_free(document);
}

static void follows_its_curves(void **state) {
    (void)state;
    const bat_recipe recipe = sweep_of(0, 1);
    bat_document *document = document_with(&recipe);
    const bat_object *before = found(document, MADE);
    assert_int_equal(bat_document_follow(document), BAT_OK);
    assert_ptr_equal(found(document, MADE), before); /* nothing has changed */
    put(document, path_of(PROFILE, 2, (double[]){0, 0, 60, 0}));
    assert_int_equal(bat_document_follow(document), BAT_OK);
    const bat_object *after = found(document, MADE);
    assert_true(after != before && bat_object_recipe(after) != NULL);
    double size = bat_surface_size(bat_object_surface(after));
    assert_true(size > 305 && size < 320); /* 300 along, 60 across, 20 of bow */
    assert_null(bat_document_check(document));
    assert_true(strcmp(bat_object_name(after), "pipe") == 0);
    bat_document_free(document);
}

/* One that is left with a curve it cannot be made of keeps its shape. */
static void lets_go(void **state) {
    (void)state;
    const bat_recipe recipe = sweep_of(0, 1);
    for (int way = 0; way < 3; way++) {
        bat_document *document = document_with(&recipe);
        bat_surface *before = NULL;
        assert_int_equal(bat_surface_copy(bat_object_surface(found(document, MADE)), &before), BAT_OK);
        if (way == 0) { /* a path that turns back in a corner */
            put(document, path_of(PATH, 3, (double[]){0, 0, 9, 0, 4, 0}));
            assert_int_equal(bat_document_follow(document), BAT_OK);
        } else if (way == 1) { /* one is gone */
            assert_int_equal(bat_document_remove(document, 0), BAT_OK);
            assert_string_equal(bat_document_check(document), "what an object is made from is gone");
            assert_int_equal(bat_document_follow(document), BAT_ARGUMENT);
            assert_int_equal(bat_document_let_go(document), BAT_OK);
        } else { /* the path becomes a surface itself: one level, no graph */
            bat_object *other = NULL;
            const bat_style style = bat_style_defaults();
            assert_int_equal(bat_object_create_surface(PATH, "", &style, before, &other), BAT_OK);
            put(document, other);
            assert_int_equal(bat_document_let_go(document), BAT_OK);
        }
        const bat_object *after = found(document, MADE);
        assert_null(bat_object_recipe(after));
        assert_true(bat_surface_is_equal(before, bat_object_surface(after)));
        assert_false(bat_document_has_followers(document));
        assert_null(bat_document_check(document));
        bat_surface_free(before);
        bat_document_free(document);
    }
}

static void moved_away_it_is_free(void **state) {
    (void)state;
    const bat_recipe recipe = sweep_of(0, 1);
    const double matrix[6] = {1, 0, 0, 1, 40, 7};
    for (int with = 0; with < 3; with++) {
        bat_document *document = document_with(&recipe);
        const bat_id moved[3] = {MADE, PATH, PROFILE};
        double was[3], top[3];
        bat_surface_box(bat_object_surface(found(document, MADE)), was, top);
        for (int k = 0; k <= with; k++) {
            bat_object *image = NULL;
            assert_int_equal(bat_affine_object(found(document, moved[k]), matrix, false, &image), BAT_OK);
            put(document, image);
        }
        assert_int_equal(bat_document_follow(document), BAT_OK);
        const bat_object *after = found(document, MADE);
        double low[3], high[3];
        bat_surface_box(bat_object_surface(after), low, high);
        assert_true(fabs(low[0] - was[0] - 40) < 1e-3 && fabs(low[1] - was[1] - 7) < 1e-3);
        assert_true((bat_object_recipe(after) != NULL) == (with > 0));
        bat_document_free(document);
    }
}

/* Bit for bit, and as version 5, which older programs refuse; free again, as version 2. */
static void is_written_and_read(void **state) {
    (void)state;
    const bat_recipe kinds[] = {sweep_of(-90, 0.5), bat_recipe_of(BAT_RECIPE_RULED),
                                bat_recipe_of(BAT_RECIPE_LOFT)};
    for (int k = 0; k < 3; k++) {
        bat_document *document = document_with(&kinds[k]), *again = NULL;
        bat_problem problem;
        char *text = NULL;
        size_t size;
        assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
        assert_non_null(strstr(text, "{\"batten\":5,"));
        if (bat_document_read(text, size, &again, &problem) != BAT_OK) fail_msg("%s", problem.message);
        assert_true(bat_document_digest(again) == bat_document_digest(document));
        assert_int_equal(bat_object_recipe(found(again, MADE))->kind, kinds[k].kind);
        free(text);
        assert_int_equal(bat_document_remove(again, 0), BAT_OK);
        assert_int_equal(bat_document_let_go(again), BAT_OK);
        assert_int_equal(bat_document_write(again, &text, &size), BAT_OK);
        assert_non_null(strstr(text, "{\"batten\":2,"));
        free(text);
        bat_document_free(again), bat_document_free(document);
    }
}

/* What a file says of the surface's points does not matter: it is made of the curves. */
static void is_made_when_it_is_read(void **state) {
    (void)state;
    const bat_recipe recipe = sweep_of(0, 1);
    bat_document *document = document_with(&recipe), *again = NULL;
    char *text = NULL, *at;
    size_t size;
    const uint64_t before = bat_document_digest(document);
    assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
    at = strstr(text, "\"points\":[[[");
    assert_non_null(at);
    at += strlen("\"points\":[[[");
    *at = *at == '1' ? '2' : '1';
    assert_int_equal(bat_document_read(text, size, &again, NULL), BAT_OK);
    assert_true(bat_document_digest(again) == before);
    free(text);
    bat_document_free(again), bat_document_free(document);
}

static void refuses(void **state) {
    (void)state;
    static const char *const wrong[] = {"7",
                                        "{}",
                                        "{\"by\":\"loft\"}",
                                        "{\"by\":\"knit\",\"from\":[1,2]}",
                                        "{\"by\":\"ruled\",\"from\":[1]}",
                                        "{\"by\":\"ruled\",\"from\":[1,1]}",
                                        "{\"by\":\"ruled\",\"from\":[1,2.5]}",
                                        "{\"by\":\"ruled\",\"from\":[0,2]}",
                                        "{\"by\":\"ruled\",\"from\":[1,\"2\"]}",
                                        "{\"by\":\"coons\",\"from\":[1,2]}",
                                        "{\"by\":\"sweep\",\"from\":[1,2],\"stand\":\"up\"}",
                                        "{\"by\":\"sweep\",\"from\":[1,2],\"twist\":1e6}",
                                        "{\"by\":\"sweep\",\"from\":[1,2],\"scale\":-1}",
                                        "{\"by\":\"revolve\",\"from\":[1,2],\"angle\":0}",
                                        "{\"by\":\"revolve\",\"from\":[1,2],\"angle\":400}",
                                        "{\"by\":\"ruled\",\"from\":[1,3]}",   /* itself */
                                        "{\"by\":\"ruled\",\"from\":[1,99]}"}; /* nothing */
    const bat_recipe recipe = bat_recipe_of(BAT_RECIPE_RULED);
    bat_document *document = document_with(&recipe);
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
    const char *from = strstr(text, "{\"by\""), *end = strchr(from, '}') + 1;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        bat_document *out = NULL;
        bat_problem problem = {"", ""};
        char *bad = malloc(size + 100);
        sprintf(bad, "%.*s%s%s", (int)(from - text), text, wrong[i], end);
        const bat_status status = bat_document_read(bad, strlen(bad), &out, &problem);
        if (status == BAT_OK || out || !problem.message[0]) fail_msg("%s: %s", wrong[i], problem.message);
        free(bad);
    }
    free(text);
    /* From objects. */
    const bat_style style = bat_style_defaults();
    const bat_object *path = found(document, PATH), *made = found(document, MADE);
    bat_object *out = NULL;
    const bat_object *pairs[][2] = {{path, path}, {path, made}, {path, NULL}};
    for (int i = 0; i < 3; i++)
        assert_int_equal(bat_object_create_made(9, "", &style, &recipe, 2, pairs[i], &out), BAT_ARGUMENT);
    const bat_object *both[2] = {path, found(document, PROFILE)};
    assert_int_equal(bat_object_create_made(PATH, "", &style, &recipe, 2, both, &out), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_made(9, "", NULL, &recipe, 2, both, &out), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_made(9, "", &style, &recipe, 3, both, &out), BAT_COUNT);
    assert_int_equal(bat_object_create_made(9, "", &style, NULL, 2, both, &out), BAT_ARGUMENT);
    assert_int_equal(bat_object_with_recipe(path, &recipe, 2, both, &out), BAT_ARGUMENT);
    assert_int_equal(bat_object_with_recipe(NULL, &recipe, 2, both, &out), BAT_ARGUMENT);
    assert_null(out);
    bat_document_free(document);
}

/* Another surface in its place is not made of the curves. */
static void edited_it_is_free(void **state) {
    (void)state;
    const bat_recipe recipe = sweep_of(0, 1);
    bat_document *document = document_with(&recipe);
    bat_object *other = NULL, *again = NULL;
    const bat_object *sources[2] = {found(document, PATH), found(document, PROFILE)};
    const bat_object *made = found(document, MADE);
    assert_int_equal(bat_object_with_surface(made, bat_object_surface(made), &other), BAT_OK);
    assert_null(bat_object_recipe(other));
    assert_int_equal(bat_object_with_recipe(other, &recipe, 2, sources, &again), BAT_OK);
    assert_true(bat_digest_object(1, again) == bat_digest_object(1, made));
    assert_true(bat_digest_object(1, other) != bat_digest_object(1, made));
    bat_object_release(other), bat_object_release(again);
    bat_document_free(document);
}

static void renumbered(void **state) {
    (void)state;
    const bat_recipe recipe = sweep_of(5, 1);
    bat_document *document = document_with(&recipe);
    bat_object *made = NULL, *none = NULL;
    const bat_id *ids;
    assert_int_equal(bat_object_renumbered(found(document, MADE), (const bat_id[]){7, 8}, &made), BAT_OK);
    assert_int_equal(bat_object_sources(made, &ids), 2);
    assert_true(ids[0] == 7 && ids[1] == 8 && bat_object_recipe(made)->twist == 5);
    bat_object_release(made);
    assert_int_equal(bat_object_renumbered(found(document, MADE), (const bat_id[]){7, 0}, &made), BAT_OK);
    assert_null(bat_object_recipe(made));
    bat_object_release(made);
    assert_int_equal(bat_object_renumbered(found(document, PATH), NULL, &none), BAT_OK);
    assert_null(none);
    bat_document_free(document);
}

/* Making, following, copying, writing, reading. */
static bat_status live(void) {
    const bat_recipe recipe = sweep_of(10, 0.7);
    const bat_style style = bat_style_defaults();
    static bat_object *given[2]; /* made once, and kept */
    bat_object *made = NULL, *image = NULL, *other = NULL;
    bat_document *document = NULL, *again = NULL, *copy = NULL;
    char *text = NULL;
    size_t size;
    if (!given[0]) given[0] = path_of(PATH, 4, bow), given[1] = path_of(PROFILE, 2, line);
    bat_status status = bat_object_create_made(MADE, "pipe", &style, &recipe, 2,
                                               (const bat_object *const *)given, &made);
    if (status == BAT_OK) status = bat_document_create(&document);
    for (int i = 0; i < 3 && status == BAT_OK; i++)
        status = bat_document_insert(document, i, i < 2 ? given[i] : made);
    if (status == BAT_OK) status = bat_affine_object(given[1], (double[]){2, 0, 0, 1, 0, 0}, false, &image);
    if (status == BAT_OK) status = bat_document_replace(document, 1, image);
    if (status == BAT_OK) status = bat_document_follow(document);
    if (status == BAT_OK) status = bat_document_copy(document, &copy);
    if (status == BAT_OK)
        status = bat_affine_object(bat_document_at(document, 2), (double[]){1, 0, 0, 1, 3, 0}, false, &other);
    if (status == BAT_OK) status = bat_document_write(document, &text, &size);
    if (status == BAT_OK) status = bat_document_read(text, size, &again, NULL);
    bat_object_release(made), bat_object_release(image), bat_object_release(other);
    bat_document_free(document), bat_document_free(again), bat_document_free(copy);
    free(text);
    return status;
}

static void allocations_fail(void **state) {
    (void)state;
    assert_int_equal(live(), BAT_OK);
    const long before = alloc_live();
    for (int n = 1;; n++) {
        alloc_fail_at(n);
        const bat_status status = live();
        const bool reached = alloc_fail_reached();
        alloc_fail_at(0);
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        assert_true(alloc_live() == before);
        if (!reached) break;
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(is_made_of_its_curves),
                                       cmocka_unit_test(follows_its_curves),
                                       cmocka_unit_test(lets_go),
                                       cmocka_unit_test(moved_away_it_is_free),
                                       cmocka_unit_test(is_written_and_read),
                                       cmocka_unit_test(is_made_when_it_is_read),
                                       cmocka_unit_test(refuses),
                                       cmocka_unit_test(renumbered),
                                       cmocka_unit_test(edited_it_is_free),
                                       cmocka_unit_test(allocations_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
