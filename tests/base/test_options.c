/* Options structs of callers built with another version: an older version has fewer members, a newer one more. */
#include "base/options.h"
#include <batten/batten.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

/* One struct in two versions; the later one has two members more. */
typedef struct first_version {
    size_t size;
    double width;
    int count;
} first_version;
typedef struct later_version {
    size_t size;
    double width;
    int count;
    double height; /* begins where the first version ends */
    bool round;
} later_version;

static const later_version LATER = {sizeof LATER, 1, 2, 3, true};

/* What a caller has, in a block of just that size: reading beyond it is seen. */
static void *block(const void *bytes, size_t size) {
    void *made = malloc(size);
    assert_non_null(made);
    memcpy(made, bytes, size);
    return made;
}

static void older_callers_get_defaults_for_the_rest(void **state) {
    (void)state;
    first_version *old = block(&(first_version){sizeof *old, 10, 20}, sizeof *old);
    later_version own = LATER;
    assert_int_equal(bat_options_read(old, sizeof *old, sizeof own, &own), BAT_OK);
    assert_true(own.size == sizeof own && own.width == 10 && own.count == 20 && own.height == 3 && own.round);
    for (size_t size = 0; size < sizeof *old; size++) {
        old->size = size, own = LATER;
        assert_int_equal(bat_options_read(old, sizeof *old, sizeof own, &own), BAT_ARGUMENT);
        assert_true(own.width == 1 && own.count == 2 && own.height == 3);
    }
    bat_options_give(&LATER, sizeof LATER, sizeof *old, old);
    assert_true(old->size == sizeof *old && old->width == 1 && old->count == 2);
    free(old);
    assert_int_equal(bat_options_read(NULL, sizeof *old, sizeof own, &own), BAT_OK);
}

static void newer_callers_are_read_as_far_as_known(void **state) {
    (void)state;
    const first_version known = {sizeof known, 1, 2};
    later_version *more = block(&(later_version){sizeof *more, 10, 20, 30, true}, sizeof *more);
    first_version own = known;
    assert_int_equal(bat_options_read(more, sizeof known, sizeof own, &own), BAT_OK);
    assert_true(own.size == sizeof own && own.width == 10 && own.count == 20);
    bat_options_give(&known, sizeof known, sizeof *more,
                     more); /* what the library does not know is nothing */
    assert_true(more->size == sizeof *more && more->width == 1 && more->count == 2 && more->height == 0 &&
                !more->round);
    free(more);
    unsigned char tiny[sizeof(size_t)];
    memset(tiny, 0x5a, sizeof tiny);
    bat_options_give(&known, sizeof known, sizeof tiny - 1, tiny); /* not even a size */
    assert_int_equal(tiny[0], 0x5a);
    bat_options_give(&known, sizeof known, sizeof known, NULL);
}

/* ---- every kind of options ---- */

static const double POINTS[] = {0, 0, 10, 1, 20, 3, 30, 3, 40, 1, 50, 0, 60, -2, 70, 0};
enum { COUNT = sizeof POINTS / sizeof *POINTS / 2 };

static bat_status sketched(const void *options) {
    const bat_stroke stroke = {.dimension = 2, .count = COUNT, .points = POINTS};
    bat_curve *curve = NULL;
    bat_status status = bat_sketch_new(&stroke, false, options, &curve, NULL);
    bat_curve_free(curve);
    return status;
}

static bat_status fitted(const void *options) {
    bat_curve *curve = NULL;
    bat_status status = bat_fit(2, COUNT, POINTS, options, &curve, NULL);
    bat_curve_free(curve);
    return status;
}

static bat_curve *sample(void) {
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create_clamped(2, 3, COUNT, POINTS, &curve), BAT_OK);
    return curve;
}

static bat_status framed(const void *options) {
    bat_curve *curve = sample();
    bat_frame_chain *chain = NULL;
    bat_status status = bat_frame_chain_create(curve, options, &chain);
    bat_frame_chain_free(chain);
    bat_curve_free(curve);
    return status;
}

static bat_status shaped(const void *options) {
    bat_curve *curve = sample();
    bat_shape *shape = NULL;
    bat_status status = bat_shape_create(curve, options, &shape);
    if (status == BAT_OK) assert_true(bat_shape_options_of(shape)->size == sizeof(bat_shape_options));
    bat_shape_free(shape);
    bat_curve_free(curve);
    return status;
}

static bat_status splined(const void *options) {
    const bat_spline spline = {.dimension = 2, .count = COUNT, .points = POINTS};
    const bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    bat_status status = bat_tangents(&spline, options, NULL, NULL, NULL, NULL);
    assert_int_equal(bat_object_create_spline(1, NULL, &style, &spline, options, &object), status);
    if (object) assert_true(bat_object_spline_options(object)->size == sizeof(bat_tangents_options));
    bat_object_release(object);
    return status;
}

static bat_status svg_read(const void *options) {
    bat_svg_reader *reader = NULL;
    bat_status status = bat_svg_reader_create(options, &reader);
    bat_svg_reader_free(reader);
    return status;
}

static const struct kind {
    size_t first; /* as of 0.2, where pointers have 64 bits: never to be changed */
    size_t now;
    bat_status (*use)(const void *options);
} KINDS[] = {{56, sizeof(bat_sketch_options), sketched},  {56, sizeof(bat_fit_options), fitted},
             {112, sizeof(bat_frame_options), framed},    {96, sizeof(bat_shape_options), shaped},
             {16, sizeof(bat_tangents_options), splined}, {32, sizeof(bat_svg_options), svg_read}};

static void fill(size_t kind, void *options, size_t size) {
    switch (kind) {
    case 0: bat_sketch_options_init(options, size); break;
    case 1: bat_fit_options_init(options, size); break;
    case 2: bat_frame_options_init(options, size); break;
    case 3: bat_shape_options_init(options, size); break;
    case 4: bat_tangents_options_init(options, size); break;
    default: bat_svg_options_init(options, size); break;
    }
}

static void every_kind(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof KINDS / sizeof *KINDS; i++) {
        const struct kind *k = &KINDS[i];
        const size_t first = sizeof(size_t) == 8 ? k->first : k->now, more = k->now + 40;
        assert_int_equal(k->use(NULL), BAT_OK);
        unsigned char *old = malloc(first), *longer = malloc(more);
        assert_true(old && longer);
        fill(i, old, first);
        assert_int_equal(k->use(old), BAT_OK);
        for (size_t size = 0; size < first; size++) {
            memcpy(old, &size, sizeof size);
            assert_int_equal(k->use(old), BAT_ARGUMENT);
        }
        fill(i, longer, more);
        for (size_t at = k->now; at < more; at++) assert_int_equal(longer[at], 0);
        memset(longer + k->now, 0xff, more - k->now); /* members of a later version */
        assert_int_equal(k->use(longer), BAT_OK);
        free(old), free(longer);
    }
    bat_svg_options svg = bat_svg_merging();
    assert_true(svg.size == sizeof svg && svg.tolerance == 1e-3);
    bat_svg_options_init_merging(&svg, sizeof(size_t)); /* nothing but the size fits */
    assert_true(svg.size == sizeof(size_t) && svg.tolerance == 1e-3);
}

/* NULL is what the defaults are. */
static void none_are_the_defaults(void **state) {
    (void)state;
    const bat_fit_options options = bat_fit_defaults();
    bat_curve *a, *b;
    assert_int_equal(bat_fit(2, COUNT, POINTS, &options, &a, NULL), BAT_OK);
    assert_int_equal(bat_fit(2, COUNT, POINTS, NULL, &b, NULL), BAT_OK);
    assert_true(bat_curve_is_equal(a, b));
    bat_curve_free(a), bat_curve_free(b);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(older_callers_get_defaults_for_the_rest),
                                       cmocka_unit_test(newer_callers_are_read_as_far_as_known),
                                       cmocka_unit_test(every_kind), cmocka_unit_test(none_are_the_defaults)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
