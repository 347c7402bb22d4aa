/* IGES: what is written keeps the columns of the standard and comes back bit for bit; files of other programs with their
 * delimiters, units, matrices, texts, trims; what is refused, with its line; every allocation may fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"
#include "support/random_surface.h"

static void there_and_back(void **state) {
    (void)state;
    random_source r = {77};
    for (int run = 0; run < 150; run++) {
        int degree[2], kind[2], spans[2];
        for (int d = 0; d < 2; d++) {
            degree[d] = random_int(&r, 1, 4);
            kind[d] = random_int(&r, 0, 2);
            spans[d] = random_int(&r, 2, 5);
        }
        bat_surface *surface = random_surface(&r, degree, kind, spans);
        bat_curve *curves[2];
        for (int k = 0; k < 2; k++) {
            const int p = random_int(&r, 1, 7), how = random_int(&r, 0, 2);
            curves[k] = random_curve(&r, p, 2 + k, how, 4);
        }
        bat_model back;
        const bat_model model = {
            .surface_count = 1, .curve_count = 2, .surfaces = &surface, .curves = curves};
        bat_problem problem;
        char *bytes;
        size_t size, lines = 0;
        assert_int_equal(bat_iges_write(&model, &bytes, &size), BAT_OK);
        for (size_t i = 0; i < size; i++) { /* each line has 80 columns */
            if (bytes[i] == '\n') assert_true(i == 81 * ++lines - 1);
            assert_true(bytes[i] == '\n' || (bytes[i] >= ' ' && bytes[i] <= '~'));
        }
        assert_int_equal(size, 81 * lines);
        assert_int_equal(bat_iges_read(bytes, size, &back, &problem), BAT_OK);
        assert_true(back.surface_count == 1 && back.curve_count == 2 && back.left_out == 0 && !back.mesh);
        assert_true(bat_surface_is_equal(back.surfaces[0], surface));
        for (int k = 0; k < 2; k++) assert_true(bat_curve_is_equal(back.curves[k], curves[k]));
        bat_model_clear(&back);
        bat_free(bytes);
        bat_surface_free(surface);
        for (int k = 0; k < 2; k++) bat_curve_free(curves[k]);
    }
}

/* ---- files of other programs ---- */

/* An entity: type, matrix (the number of its entity), status, and parameters. */
typedef struct entity {
    int type, matrix;
    const char *status, *parameters;
} entity;

static char made[1 << 16];
static size_t used;

static void put_line(const char *what, int width, const char *tail, char letter, int number) {
    used += (size_t)snprintf(made + used, sizeof made - used, "%-*.*s%s%c%7d\r\n", width, width, what, tail,
                             letter, number);
}

/* A file with these parameters of section G and these entities, their parameters 64 columns a line. */
static const char *file_of(const char *globals, const entity *list, int count) {
    int first = 1, number = 0;
    char line[160];
    used = 0;
    put_line("made by hand", 72, "", 'S', 1);
    for (size_t at = 0; at < strlen(globals); at += 72)
        put_line(globals + at, 72, "", 'G', (int)(at / 72) + 1);
    for (int i = 0; i < count; i++) {
        const int lines = ((int)strlen(list[i].parameters) + 63) / 64;
        snprintf(line, sizeof line, "%8d%8d%8d%8d%8d%8d%8d%8d%8s", list[i].type, first, 0, 0, 0, 0,
                 list[i].matrix, 0, list[i].status);
        put_line(line, 72, "", 'D', 2 * i + 1);
        snprintf(line, sizeof line, "%8d%8d%8d%8d%8d", list[i].type, 0, 0, lines, 0);
        put_line(line, 72, "", 'D', 2 * i + 2);
        first += lines;
    }
    for (int i = 0; i < count; i++)
        for (size_t at = 0; at < strlen(list[i].parameters); at += 64) {
            snprintf(line, sizeof line, "%8d", 2 * i + 1);
            put_line(list[i].parameters + at, 64, line, 'P', ++number);
        }
    put_line("S      1G      1D      2P      1", 72, "", 'T', 1);
    return made;
}

static const char USUAL[] = "1H,,1H;,1Ha,1Hb,1Hc,1Hd,32,38,6,308,15,1He,1.,2,2HMM;";

static bat_model read(const char *text) {
    bat_model model;
    bat_problem problem = {.place = ""};
    const bat_status status = bat_iges_read(text, strlen(text), &model, &problem);
    if (status != BAT_OK) print_message("%s: %s\n", problem.place, problem.message);
    assert_int_equal(status, BAT_OK);
    return model;
}

static void at(const bat_model *model, double u, double x, double y, double z) {
    double found[3] = {0, 0, 0};
    assert_int_equal(model->curve_count, 1);
    bat_curve_eval(model->curves[0], u, 0, found);
    assert_true(fabs(found[0] - x) < 1e-12 && fabs(found[1] - y) < 1e-12 && fabs(found[2] - z) < 1e-12);
}

/* Two other delimiters, a text that holds them, blanks, D for the exponent, numbers left out, an early end; inches. */
static void free_form(void **state) {
    (void)state;
    static const entity list[] = {
        {126, 0, "00000000", " 126/ 1/1/ / /1/0/0.D0/0./ 1.0D+00/1 / 2/ 2.0/ // .5D1/ 1.D-1/ +2/ #comment"}};
    bat_model m = read(file_of("1H//1H#/5H/#/#//2Hb #", list, 1)); /* all the rest left out: inches */
    at(&m, 0, 0, 0, 5 * 25.4);
    at(&m, 1, 0.1 * 25.4, 2 * 25.4, 0);
    bat_model_clear(&m);
}

static void units(void **state) {
    (void)state;
    static const entity list[] = {
        {126, 0, "00000000", "126,1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,0.,0.,0.,1.,2.,0.;"}};
    static const struct {
        const char *globals;
        double millimetres;
    } cases[] = {{"1H,,1H;,,,,,,,,,,,1.,6,1HM;", 1000},
                 {"1H,,1H;,,,,,,,,,,,1.,3,2HCM;", 10},
                 {"1H,,1H;,,,,,,,,,,,.5,2,2HMM;", 2},
                 {",,1Ha,,,,,,,,,,1.,4,2HFT;", 304.8},
                 {"1H,,1H;,,,,,,,,,,,1.,3,4HINCH;", 25.4}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_model m = read(file_of(cases[i].globals, list, 1));
        at(&m, 1, cases[i].millimetres, 2 * cases[i].millimetres, 0);
        bat_model_clear(&m);
    }
}

/* The matrix comes after the curve that names it, and names a further one: a quarter turn, then a shift. Beside them a
 * trimmed surface, whose boundary is no curve of its own, a point, a note, a colour. */
static void other_entities(void **state) {
    (void)state;
    static const entity list[] = {
        {126, 5, "00000000", "126,1,1,0,0,1,0,0.,0.,1.,1.,3.,3.,0.,0.,0.,1.,2.,0.,0.,1.;"},
        {116, 0, "00000000", "116,1.,2.,3.;"},
        {124, 7, "00000000", "124,0.,-1.,0.,0.,1.,0.,0.,0.,0.,0.,1.,0.;"},
        {124, 0, "00000000", "124,1.,0.,0.,10.,0.,1.,0.,20.,0.,0.,1.,30.;"},
        {314, 0, "00000200", "314,100.,0.,0.;"},
        {212, 0, "00000100", "212,1,6,1.,1.,1,1.5,0.,0,0,0.,0.,0.,6H1;,2,3;"},
        {144, 0, "00000000", "144,15,1,0,17;"},
        {128, 0, "00010000",
         "128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,2.,2.,2.,2.,0.,0.,0.,1.,0.,0.,0.,1.,0.,1.,1.,1.,0.,1."
         ",0.,1.;"},
        {142, 0, "00010000", "142,0,15,21,19;"},
        {102, 0, "00010000", "102,1,23;"},
        {126, 0, "00010500", "126,1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,0.,0.,0.,1.,0.,0.,0.,1.;"},
        {126, 0, "00010000", "126,1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,0.,0.,0.,1.,0.,0.,0.,1.;"}};
    bat_model m = read(file_of(USUAL, list, sizeof list / sizeof *list));
    at(&m, 1, 8, 21, 30); /* (1, 2) turned is (-2, 1) */
    double found[3];
    assert_int_equal(m.surface_count, 1);
    bat_surface_eval(m.surfaces[0], 1, 0, 0, found); /* u runs first in the file */
    assert_true(found[0] == 1 && found[1] == 0 && found[2] == 0);
    assert_int_equal(m.left_out, 3); /* the point, the note, the trimmed surface */
    bat_model_clear(&m);
}

/* A curve that is stated to be a part of what its knots give. */
static void a_part(void **state) {
    (void)state;
    static const entity list[] = {
        {126, 0, "00000000", "126,1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,0.,0.,0.,4.,0.,0.,.25,.5;"}};
    bat_model m = read(file_of(USUAL, list, 1));
    double domain[2];
    bat_curve_domain(m.curves[0], domain);
    assert_true(domain[0] == 0.25 && domain[1] == 0.5);
    at(&m, 0.5, 2, 0, 0);
    bat_model_clear(&m);
}

/* A quarter of a circle of radius 2, a part of one, and of a cylinder, 6 high. */
static void rational(void **state) {
    (void)state;
#define WEIGHT ".70710678118654757"
    static const entity list[] = {
        {126, 0, "00000000",
         "126,2,2,0,0,0,0,0.,0.,0.,1.,1.,1.,1.," WEIGHT ",1.,2.,0.,0.,2.,2.,0.,0.,2.,0.;"},
        {126, 0, "00000000",
         "126,2,2,0,0,0,0,0.,0.,0.,1.,1.,1.,1.," WEIGHT ",1.,2.,0.,0.,2.,2.,0.,0.,2.,0.,.5,1.;"},
        {128, 0, "00000000",
         "128,2,1,2,1,0,0,0,0,0,0.,0.,0.,1.,1.,1.,0.,0.,1.,1.,1.," WEIGHT ",1.,1.," WEIGHT
         ",1.,2.,0.,0.,2.,2.,0.,0.,2.,0.,2.,0.,6.,2.,2.,6.,0.,2.,6.,0.,1.,0.,1.;"}};
    bat_model m = read(file_of(USUAL, list, 3));
    double domain[2], p[3];
    for (int k = 0; k < 2; k++) {
        bat_curve_domain(m.curves[k], domain);
        for (int i = 0; i <= 20; i++) {
            bat_curve_eval(m.curves[k], domain[0] + (domain[1] - domain[0]) * i / 20, 0, p);
            assert_true(fabs(hypot(p[0], p[1]) - 2) < 2e-6);
        }
        bat_curve_eval(m.curves[k], domain[0], 0, p);
        assert_true(fabs(p[0] - (k ? sqrt(2) : 2)) < 1e-9);
    }
    for (int i = 0; i <= 20; i++) {
        bat_surface_eval(m.surfaces[0], i / 20.0, 0.25, 0, p);
        assert_true(fabs(hypot(p[0], p[1]) - 2) < 6e-6 && fabs(p[2] - 1.5) < 1e-12);
    }
    bat_model_clear(&m);
}

static void refusals(void **state) {
    (void)state;
#define SURFACE_HEAD "128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,"
#define POINTS "0.,0.,0.,1.,0.,0.,0.,1.,0.,1.,1.,1.,"
    static const struct {
        entity what;
        bat_status status;
        const char *place, *says;
    } cases[] = {
        {{126, 0, "", "126,1,1,0,0,0,0,0.,0.,1.,1.,1.,-2.,0.,0.,0.,1.,2.,0.;"},
         BAT_NUMBER,
         "line 5",
         "weights"},
        {{128, 0, "", SURFACE_HEAD "1.,0.," POINTS "0.,1.,0.,1.;"}, BAT_NUMBER, "line 5", "weights"},
        {{128, 0, "", SURFACE_HEAD "1.,1.," POINTS "0.,.5,0.,1.;"}, BAT_UNSUPPORTED, "line 5", "part"},
        {{126, 0, "", "126,8,8,0,0,1,0,0.;"}, BAT_DEGREE, "line 5", "degree from 1 to 7"},
        {{126, 0, "", "126,1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,0.,0.,0.,1.;"}, BAT_COUNT, "line 5", "fewer"},
        {{126, 0, "", "126,1,1,0,0,1,0,0.,0.,1.,0.,1.,1.,0.,0.,0.,1.,2.,0.;"}, BAT_KNOTS, "line 5", ""},
        {{126, 0, "", "126,1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,0.,0.,0.,1.,x,0.;"},
         BAT_SYNTAX,
         "line 5",
         "a number"},
        {{126, 0, "", "126,1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,0.,0.,0.,1.,1.E99,0.;"},
         BAT_NUMBER,
         "line 5",
         "1e75"},
        {{126, 0, "", "126,90000,1,0,0,1,0;"}, BAT_COUNT, "line 5", "points"},
        {{126, 0, "", "128,1,1;"}, BAT_SYNTAX, "line 5", "type"},
        {{126, 2, "", "126,1,1;"}, BAT_SYNTAX, "line 3", "matrix"},
        {{126, 1, "", "126,1,1;"}, BAT_SYNTAX, "line 3", "matrix"},
        {{126, 0, "", "126,9Habc;"}, BAT_SYNTAX, "line 5", ""},
        {{116, 0, "", "116,1.,2.,3.;"}, BAT_COUNT, "", "126, 128"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_model model;
        bat_problem problem = {.place = ""};
        const char *text = file_of(USUAL, &cases[i].what, 1);
        assert_int_equal(bat_iges_read(text, strlen(text), &model, &problem), cases[i].status);
        assert_string_equal(problem.place, cases[i].place);
        assert_non_null(strstr(problem.message, cases[i].says));
    }
}

static void bad_files(void **state) {
    (void)state;
    static const entity curve = {126, 0, "", "126,1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,0.,0.,0.,1.,2.,0.;"};
    static const char *const globals[] = {"2H,,,1H;;", "1H,,1H,;", "1Hx;", "1H,,1H;,,,,,,,,,,,1.,3,5HCUBIT;",
                                          "1H,,1H;,99Ha;"};
    bat_model model;
    bat_problem problem;
    for (size_t i = 0; i < sizeof globals / sizeof *globals; i++) {
        const char *text = file_of(globals[i], &curve, 1);
        const bat_status status = bat_iges_read(text, strlen(text), &model, &problem);
        assert_int_equal(status, i == 3 ? BAT_UNSUPPORTED : BAT_SYNTAX);
        assert_string_equal(problem.place, "line 2");
    }
    static const struct {
        size_t column, line;
        char letter;
        bat_status status;
        const char *place;
    } spoilt[] = {{72, 0, 'B', BAT_UNSUPPORTED, "line 1"}, {72, 0, 'C', BAT_UNSUPPORTED, "line 1"},
                  {72, 2, 'X', BAT_SYNTAX, "line 3"},      {72, 3, 'G', BAT_SYNTAX, "line 4"},
                  {72, 3, 'P', BAT_SYNTAX, "line 3"},      {15, 2, '9', BAT_SYNTAX, "line 3"},
                  {31, 3, '9', BAT_SYNTAX, "line 3"}};
    for (size_t i = 0; i < sizeof spoilt / sizeof *spoilt; i++) {
        (void)file_of(USUAL, &curve, 1);
        made[82 * spoilt[i].line + spoilt[i].column] = spoilt[i].letter;
        assert_int_equal(bat_iges_read(made, used, &model, &problem), spoilt[i].status);
        assert_string_equal(problem.place, spoilt[i].place);
    }
    assert_int_equal(bat_iges_read("", 0, &model, &problem), BAT_SYNTAX);
    assert_int_equal(bat_iges_read(NULL, 0, &model, &problem), BAT_ARGUMENT);
    assert_int_equal(bat_iges_read("x", 1, NULL, &problem), BAT_ARGUMENT);
    const bat_model empty = {.mesh = NULL};
    char *bytes;
    size_t size;
    assert_int_equal(bat_iges_write(&empty, &bytes, &size), BAT_COUNT);
    assert_int_equal(bat_iges_write(NULL, &bytes, &size), BAT_ARGUMENT);
}

static void each_allocation(void **state) {
    (void)state;
    static const entity list[] = {
        {128, 3, "00000000",
         "128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,2.,2.,2.,2.,0.,0.,0.,1.,0.,0.,0.,1.,0.,1.,1.,1.,0.,1."
         ",0.,1.;"},
        {124, 0, "00000000", "124,1.,0.,0.,10.,0.,1.,0.,20.,0.,0.,1.,30.;"},
        {126, 0, "00000000", "126,1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,0.,0.,0.,4.,0.,0.,.25,.5;"}};
    const char *text = file_of(USUAL, list, 3);
    bat_model whole = read(text);
    for (int write = 0; write < 2; write++) {
        const long before = alloc_live();
        bool reached = true;
        for (long n = 1; reached; n++) {
            bat_model model = {.mesh = NULL};
            char *bytes = NULL;
            size_t size;
            alloc_fail_at(n);
            const bat_status status = write ? bat_iges_write(&whole, &bytes, &size)
                                            : bat_iges_read(text, strlen(text), &model, NULL);
            reached = alloc_fail_reached();
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            if (reached) assert_true(model.surface_count + model.curve_count == 0 && !bytes);
            bat_model_clear(&model);
            bat_free(bytes);
            assert_int_equal(alloc_live(), before);
        }
    }
    bat_model_clear(&whole);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(there_and_back), cmocka_unit_test(free_form), cmocka_unit_test(units),
        cmocka_unit_test(other_entities), cmocka_unit_test(a_part),    cmocka_unit_test(rational),
        cmocka_unit_test(refusals),       cmocka_unit_test(bad_files), cmocka_unit_test(each_allocation)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
