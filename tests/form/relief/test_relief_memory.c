/* Every call on surfaces with levels survives the failure of any one of its allocations: BAT_MEMORY, outputs and the
 * relief untouched, nothing leaked. Its JSON comes back bit for bit, and what is wrong with it is told at its place. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/relief.h>
#include "support/alloc_fail.h"
#include "support/random_surface.h"

static bat_surface *sheet, *other;
static bat_relief *relief;
static char *text;
static size_t text_size;

/* What a call made. */
typedef struct made {
    bat_relief *relief;
    char *text;
} made;

typedef bat_status operation(made *out);

static bat_status create(made *out) { return bat_relief_create(sheet, &out->relief); }
static bat_status copy(made *out) { return bat_relief_copy(relief, &out->relief); }
static bat_status decompose(made *out) { return bat_relief_decompose(sheet, 2, &out->relief); }
static bat_status decompose_to(made *out) {
    return bat_relief_decompose_to(sheet, 1, (const size_t[2]){5, 4}, &out->relief);
}
static bat_status transplant(made *out) { return bat_relief_copy_levels(relief, other, &out->relief); }
static bat_status write_text(made *out) {
    size_t size;
    return bat_relief_write(relief, &out->text, &size);
}
static bat_status read_text(made *out) { return bat_relief_read(text, text_size, &out->relief, NULL); }

/* The others change a relief: on failure it must be as it was. */
static bat_status more(bat_relief *r) { return bat_relief_add_level(r, NULL, NULL, NULL, NULL, NULL); }
static bat_status move(bat_relief *r) {
    return bat_relief_move(r, 0, 1, (const size_t[1]){3}, (const double[3]){1, 2, 3});
}
static bat_status drag(bat_relief *r) { return bat_relief_drag(r, 1, .4, .6, (const double[3]){1, 2, 3}); }
static bat_status drag_finest(bat_relief *r) {
    double left;
    return bat_relief_drag_finest(r, 0, .4, .6, (const double[3]){.1, .2, .3}, 1, &left);
}
static bat_status louder(bat_relief *r) { return bat_relief_set_gain(r, 1, 1.5); }
static bat_status mute(bat_relief *r) { return bat_relief_set_muted(r, 1, true); }
static bat_status turn(bat_relief *r) {
    return bat_relief_transform(r, (const double[12]){0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 2});
}
static bat_status redraw(bat_relief *r) {
    bat_curve *line = NULL;
    bat_status status = bat_surface_isocurve(bat_relief_surface(r, 1), BAT_U, .4, &line);
    if (status == BAT_OK) status = bat_relief_redraw(r, 1, BAT_U, .5, line, NULL, NULL, NULL);
    bat_curve_free(line);
    return status;
}

static void fail_each(operation *make, bat_status (*change)(bat_relief *)) {
    for (long n = 1;; n++) {
        made out = {NULL, NULL};
        bat_relief *edited = NULL;
        bat_status status = BAT_OK;
        const long before = alloc_live();
        if (change) assert_int_equal(bat_relief_copy(relief, &edited), BAT_OK);
        alloc_fail_at(n);
        status = change ? change(edited) : make(&out);
        const bool reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        if (reached) assert_true(!out.relief && !out.text);
        if (reached && change) {
            char *now = NULL;
            size_t size = 0;
            assert_int_equal(bat_relief_write(edited, &now, &size), BAT_OK);
            assert_true(size == text_size && memcmp(now, text, size) == 0);
            bat_free(now);
        }
        bat_relief_free(out.relief), bat_relief_free(edited);
        bat_free(out.text);
        assert_int_equal(alloc_live(), before);
        if (!reached) {
            assert_true(n > 1);
            return;
        }
    }
}

static void each_allocation(void **state) {
    (void)state;
    static operation *const makers[] = {create,     copy,       decompose, decompose_to,
                                        transplant, write_text, read_text};
    static bat_status (*const changers[])(bat_relief *) = {more,   move, drag, drag_finest,
                                                           louder, mute, turn, redraw};
    for (size_t i = 0; i < sizeof makers / sizeof *makers; i++) fail_each(makers[i], NULL);
    for (size_t i = 0; i < sizeof changers / sizeof *changers; i++) fail_each(NULL, changers[i]);
}

static void comes_back(void **state) {
    (void)state;
    bat_relief *back = NULL;
    char *again = NULL;
    size_t size = 0;
    assert_int_equal(bat_relief_set_gain(relief, 2, .1), BAT_OK);
    assert_int_equal(bat_relief_set_muted(relief, 1, true), BAT_OK);
    bat_free(text);
    assert_int_equal(bat_relief_write(relief, &text, &text_size), BAT_OK);
    assert_int_equal(bat_relief_read(text, text_size, &back, NULL), BAT_OK);
    assert_int_equal(bat_relief_levels(back), 2);
    for (int j = 0; j <= 2; j++)
        assert_true(bat_surface_is_equal(bat_relief_surface(back, j), bat_relief_surface(relief, j)));
    for (int j = 1; j <= 2; j++) {
        const bat_surface *s = bat_relief_surface(back, j);
        const size_t n = bat_surface_count(s, BAT_U) * bat_surface_count(s, BAT_V);
        assert_memory_equal(bat_relief_source(back, j), bat_relief_source(relief, j), n * sizeof(int));
    }
    assert_true(bat_relief_is_muted(back, 1) && !bat_relief_is_muted(back, 2) &&
                bat_relief_gain(back, 2) == .1);
    assert_int_equal(bat_relief_write(back, &again, &size), BAT_OK);
    assert_true(size == text_size && memcmp(again, text, size) == 0);
    bat_free(again);
    bat_relief_free(back);
}

/* On a base of 2 by 2 points, over [0, 1] in both directions. */
#define SHEET                                                                                                \
    "{\"base\":{\"degree\":[1,1],\"knots\":[[0,0,1,1],[0,0,1,1]],\"points\":[[[0,0,0],[0,1,0]],[[1,0,0],"    \
    "[1,1,0]]]}"
#define FINE "\"knots\":[[0,0,0.5,1,1],[0,0,1,1]]"

static void is_told(void **state) {
    (void)state;
    static const struct {
        const char *text, *said;
    } cases[] = {
        {"[]", "relief: expected an object"},
        {"{}", "base: expected a surface, found none"},
        {SHEET ",\"levels\":1}", "levels: expected a list"},
        {SHEET ",\"levels\":[1]}", "level: expected an object"},
        {SHEET ",\"levels\":[{\"knots\":[1]}]}", "two lists of numbers"},
        {SHEET ",\"levels\":[{\"knots\":[[0],[1]]}]}", "all those of the level below"},
        {SHEET ",\"levels\":[{\"knots\":[[0,0,2,2],[0,0,1,1]]}]}", "all those of the level below"},
        {SHEET ",\"levels\":[{\"details\":[]}]}", "knots beside them"},
        {SHEET ",\"levels\":[{" FINE ",\"details\":[[[0,0,1],[0,0,1]],[[0,0,1],[0,0,1]]]}]}",
         "a row for each row"},
        {SHEET ",\"levels\":[{" FINE ",\"source\":[[0,0],[0,0],[0,1]]}]}", "a level below this one"},
        {SHEET ",\"levels\":[{\"gain\":\"loud\"}]}", "a number within 1e6"},
        {SHEET ",\"levels\":[{\"gain\":1e7}]}", "a number within 1e6"},
        {SHEET ",\"levels\":[{\"muted\":1}]}", "true or false"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_relief *read = NULL;
        bat_problem problem;
        assert_int_not_equal(bat_relief_read(cases[i].text, strlen(cases[i].text), &read, &problem), BAT_OK);
        assert_null(read);
        assert_true(strncmp(problem.place, "line 1, column ", 15) == 0);
        assert_non_null(strstr(problem.message, cases[i].said));
    }
    bat_relief *read = NULL;
    static const char fine[] = SHEET ",\"levels\":[{" FINE
                                     ",\"details\":[[[0,0,1],[0,0,1]],[[0,0,2],[0,0,2]],[[0,0,0],[0,0,"
                                     "0]]],\"gain\":0.5}]}";
    double at[3];
    assert_int_equal(bat_relief_read(fine, strlen(fine), &read, NULL), BAT_OK);
    bat_surface_eval(bat_relief_surface(read, 1), .5, .3, 0, at);
    assert_true(at[0] == .5 && at[1] == .3 && at[2] == 1);
    bat_relief_free(read);
}

static void begins(void **state) {
    (void)state;
    random_source r = {3};
    sheet = random_surface(&r, (const int[2]){3, 2}, (const int[2]){2, 1}, (const int[2]){5, 4});
    other = random_surface(&r, (const int[2]){2, 3}, (const int[2]){1, 2}, (const int[2]){2, 3});
    assert_int_equal(bat_relief_decompose(sheet, 2, &relief), BAT_OK);
    assert_int_equal(bat_relief_write(relief, &text, &text_size), BAT_OK);
}

static void ends(void **state) {
    (void)state;
    bat_free(text);
    bat_relief_free(relief);
    bat_surface_free(sheet), bat_surface_free(other);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(begins), cmocka_unit_test(each_allocation),
                                       cmocka_unit_test(comes_back), cmocka_unit_test(is_told),
                                       cmocka_unit_test(ends)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
