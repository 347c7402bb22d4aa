/* Masks: how much of a curve or a group is seen, kept by the file, by both formats and by maps. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "document/clip.h"
#include "document/document.h"
#include "document/object.h"
#include "document/picture.h"
#include "editor/edit/affine.h"
#include "format/svg/tags.h"
#include "support/alloc_fail.h"
#include "support/svg_kept.h"
#include <batten/bezier.h>
#include <batten/format.h>

#include <math.h>
#include <stdlib.h>

#define HEAD "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>"
#define MASK(more) "<mask id='m' " more "><rect width='50' height='50' fill='#888'/></mask>"
#define USER "maskUnits='userSpaceOnUse' x='1' y='2' width='30' height='40'"
#define BOX "<rect x='10' y='20' width='50' height='40' mask='url(#m)'/>"

static bat_svg_report report;

static bat_status read_file(const char *text, bat_document **out) {
    return svg_read_kept(NULL, text, strlen(text), out, &report);
}

static bat_document *opened(const char *content) {
    char text[6000];
    bat_document *document = NULL;
    snprintf(text, sizeof text, HEAD "%s</svg>", content);
    assert_int_equal(read_file(text, &document), BAT_OK);
    return document;
}

static const bat_clip *mask_of(const bat_document *document) {
    const bat_clip *clip = bat_object_clip(bat_document_at(document, 0));
    while (clip && !bat_clip_picture(clip)) clip = bat_clip_within(clip);
    assert_non_null(clip);
    return clip;
}

/* Where the region of the mask lies, by CSS Masking 1, 7.2: its top left, top right and lower right corner. */
static void places(void **unused) {
    (void)unused;
    static const struct {
        const char *mask, *masked;
        double corners[6];
    } cases[] = {
        {"", BOX, {5, 16, 65, 16, 65, 64}},
        {USER, BOX, {1, 2, 31, 2, 31, 42}},
        {"maskUnits='userSpaceOnUse'", BOX, {-10, -10, 110, -10, 110, 110}},
        {"x='0' y='50%' width='.5' height='50%'", BOX, {10, 40, 35, 40, 35, 60}},
        {"maskContentUnits='objectBoundingBox'", BOX, {5, 16, 65, 16, 65, 64}},
        {USER, "<g transform='translate(5 6) rotate(90)'>" BOX "</g>", {3, 7, 3, 37, -37, 37}},
        {USER, "<g mask='url(#m)'><path d='M0 0H9V9Z'/><path d='M1 1H9V9Z'/></g>", {1, 2, 31, 2, 31, 42}},
        {"x='0' y='0' width='1' height='1'",
         "<g style='mask:url(#m)' transform='scale(2)'><path d='M2 3H9V9Z'/><path d='M4 4H12V9Z'/></g>",
         {4, 6, 24, 6, 24, 18}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char content[2000];
        double corners[8];
        snprintf(content, sizeof content,
                 "<mask id='m' %s><rect width='50' height='50' fill='#888'/></mask>%s", cases[i].mask,
                 cases[i].masked);
        bat_document *document = opened(content);
        assert_int_equal(bat_losses_total(&report.lost), 0);
        assert_false(bat_object_is_foreign(bat_document_at(document, 0)));
        bat_clip_corners(mask_of(document), corners);
        for (int k = 0; k < 6; k++)
            if (!(fabs(corners[k] - cases[i].corners[k]) <= 1e-9))
                fail_msg("case %zu, %d: %g is %g", i, k, corners[k], cases[i].corners[k]);
        bat_document_free(document);
    }
}

/* The picture has what the mask takes from elsewhere in the file, and nothing that is run. */
static void pictures(void **unused) {
    (void)unused;
    bat_document *document = opened(
        "<style>.a{fill:#123}</style><linearGradient id='g'><stop offset='1' stop-color='blue'/>"
        "</linearGradient><mask id='n'><path d='M0 0H9V9Z' fill='lime'/></mask><g fill='teal' "
        "transform='scale(7)'><mask id='m' " USER
        " stroke='aqua' mask-type='alpha' onload='x()'><path class='a' d='M0 0H3V3Z' stroke='url(#g)' "
        "mask='url(#n)'/></mask></g>" BOX);
    char text[6000];
    size_t size;
    const void *bytes = bat_picture_bytes(bat_clip_picture(mask_of(document)), &size);
    assert_true(size < sizeof text);
    memcpy(text, bytes, size);
    text[size] = '\0';
    static const char *const wanted[] = {"class='a'",   ".a{fill:#123}",   "linearGradient id='g'",
                                         "mask id='n'", "stroke=\"aqua\"", "mask-type=\"alpha\""};
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++)
        if (!strstr(text, wanted[i])) fail_msg("%s is missing", wanted[i]);
    assert_null(strstr(text, "onload"));
    /* It is within what it inherits from, which has no effects. */
    const char *around = strstr(text, "<g fill=\"teal\" style=\";opacity:1!important"),
               *mask = strstr(text, "<mask id=\"m");
    assert_true(around && mask && around < mask);
    assert_null(strstr(text, "scale(7)"));
    assert_true(bat_picture_is_drawing(bat_clip_picture(mask_of(document))));
    bat_document_free(document);
}

/* What refers to none is seen whole; an empty one hides all; what cannot be placed stays foreign content. */
static void odd_ones(void **unused) {
    (void)unused;
    enum { WHOLE, NOTHING, FOREIGN, MASKED };
    static const struct {
        const char *content;
        int seen;
    } cases[] = {
        {"<rect width='9' height='9' mask='url(#m)'/>", WHOLE},
        {"<linearGradient id='m'/>" BOX, WHOLE},
        {MASK("") "<rect width='9' height='9' mask='none'/>", WHOLE},
        {"<mask id='m'/>" BOX, NOTHING},
        {MASK("width='0'") BOX, NOTHING},
        {MASK("maskUnits='userSpaceOnUse' height='0'") BOX, NOTHING},
        {MASK("width='-1'") BOX, FOREIGN},
        {MASK("width='1e300'") BOX, MASKED}, /* that is no length: as if there were none */
        {MASK("") "<path d='M0 5H50' stroke='red' mask='url(#m)'/>", FOREIGN}, /* its box is flat */
        {MASK("maskUnits='userSpaceOnUse'") "<path d='M0 5H50' stroke='red' mask='url(#m)'/>", MASKED},
        {MASK("") "<g transform='rotate(9)' mask='url(#m)'><path d='M0 0H9V9Z'/><path d='M1 1H9V9Z'/></g>",
         FOREIGN},
        {"<mask id='m'><rect width='50' height='50' fill='#888' mask='url(#m)'/></mask>" BOX, MASKED},
        {MASK("") "<filter id='f'/><rect width='9' height='9' mask='url(#m)' filter='url(#f)'/>", FOREIGN},
        {MASK("") "<rect width='9' height='9' style='mask:url(#m) luminance'/>", FOREIGN},
        {"<mask id='\xc3\xa9'><rect width='9' height='9'/></mask><rect width='9' height='9' "
         "mask='url(#\xc3\xa9)'/>",
         FOREIGN},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_document *document = opened(cases[i].content);
        const bat_object *object = bat_document_at(document, 0);
        const bat_clip *clip = object ? bat_object_clip(object) : NULL;
        const int seen = bat_object_is_foreign(object) ? FOREIGN
                         : !clip                       ? WHOLE
                         : bat_clip_picture(clip)      ? MASKED
                                                       : NOTHING;
        if (seen != cases[i].seen) fail_msg("case %zu: %d", i, seen);
        if (seen == NOTHING) assert_int_equal(bat_clip_curve_count(clip), 0);
        bat_document_free(document);
    }
}

static char *written(const bat_document *document, bool svg) {
    char *text = NULL;
    size_t size;
    const bat_status status = svg ? bat_svg_write(document, true, &text, &size)
                                  : bat_document_write(document, &text, &size);
    assert_int_equal(status, BAT_OK);
    return text;
}

static bat_document *mapped(const bat_document *document, const double m[6]) {
    bat_document *made = NULL;
    bat_object *object = NULL;
    assert_int_equal(bat_document_create(&made), BAT_OK);
    assert_int_equal(bat_affine_object(bat_document_at(document, 0), m, true, &object), BAT_OK);
    assert_int_equal(bat_document_insert(made, 0, object), BAT_OK);
    bat_object_release(object);
    return made;
}

/* Both formats bring back masks and clips bit for bit, also without the native data, and after maps of the plane. */
static void is_kept(void **unused) {
    (void)unused;
    static const double maps[][6] = {{1, 0, 0, 1, 0, 0},
                                     {1, 0, 0, 1, 7.25, -3},
                                     {0.6, 0.8, -0.8, 0.6, 1, 2},
                                     {-1, 0, 0, 3, 50, 0.1},
                                     {1, 0.3, 0.2, 1.7, 0, 9}};
    bat_document *source = opened(MASK(USER) "<clipPath id='c'><path d='M0 0H40V90H0Z'/></clipPath><path "
                                             "clip-path='url(#c)' d='M10 10H60V40Z' mask='url(#m)'/>");
    for (size_t i = 0; i < sizeof maps / sizeof *maps; i++) {
        bat_document *document = mapped(source, maps[i]);
        double was[8], now[8];
        bat_clip_corners(mask_of(source), was);
        bat_clip_corners(mask_of(document), now);
        for (int k = 0; k < 8; k++) {
            const double *m = maps[i], *p = was + (k & ~1),
                         at = m[k & 1] * p[0] + m[2 + (k & 1)] * p[1] + m[4 + (k & 1)];
            assert_true(fabs(now[k] - at) <= 1e-12 * (1 + fabs(at)));
        }
        char *native = written(document, false);
        bat_document *back = NULL;
        bat_problem problem;
        assert_int_equal(bat_document_read(native, strlen(native), &back, &problem), BAT_OK);
        assert_true(bat_document_digest(back) == bat_document_digest(document));
        assert_non_null(strstr(native, "{\"batten\":10"));
        bat_document_free(back);
        bat_free(native);
        char *svg = written(document, true);
        assert_int_equal(read_file(svg, &back), BAT_OK);
        assert_true(report.native && !report.edited);
        assert_true(bat_document_digest(back) == bat_document_digest(document));
        bat_document_free(back);
        char *data = strstr(svg, "<metadata"), *end = strstr(svg, "</metadata>");
        if (data && end) memset(data, ' ', (size_t)(end - data) + strlen("</metadata>"));
        assert_int_equal(read_file(svg, &back), BAT_OK);
        assert_false(report.native);
        const bat_clip *a = mask_of(document), *b = mask_of(back);
        assert_true(bat_picture_digest(bat_clip_picture(a)) == bat_picture_digest(bat_clip_picture(b)));
        for (int k = 0; k < 6; k++) assert_true(fabs(bat_clip_matrix(a)[k] - bat_clip_matrix(b)[k]) <= 1e-9);
        assert_int_equal(bat_clip_count(bat_object_clip(bat_document_at(back, 0))), 2);
        bat_document_free(back);
        bat_free(svg);
        bat_document_free(document);
    }
    bat_document_free(source);
}

/* Two masks on one curve, as ungrouping makes them: each within the other. */
static void two_masks(void **unused) {
    (void)unused;
    bat_document *one = opened(MASK(USER) BOX), *two = opened(MASK("") BOX), *both = NULL, *back = NULL;
    bat_clip *joined = NULL;
    bat_object *object = NULL;
    assert_int_equal(bat_clip_join(mask_of(one), mask_of(two), &joined), BAT_OK);
    assert_int_equal(bat_clip_count(joined), 2);
    assert_int_equal(bat_object_with_clip(bat_document_at(one, 0), joined, &object), BAT_OK);
    assert_int_equal(bat_document_create(&both), BAT_OK);
    assert_int_equal(bat_document_insert(both, 0, object), BAT_OK);
    char *svg = written(both, true);
    assert_int_equal(read_file(svg, &back), BAT_OK);
    assert_true(report.native && !report.edited);
    assert_true(bat_document_digest(back) == bat_document_digest(both));
    /* A mask that is changed there is read instead. */
    char *image = strstr(svg, "<image width=\"");
    assert_non_null(image);
    image = strstr(image, "matrix(");
    assert_non_null(image);
    image[7] = image[7] == '2' ? '3' : '2';
    bat_document_free(back);
    assert_int_equal(read_file(svg, &back), BAT_OK);
    assert_true(report.edited);
    assert_int_equal(bat_clip_count(bat_object_clip(bat_document_at(back, 0))), 2);
    bat_document_free(back);
    bat_free(svg);
    bat_object_release(object);
    bat_clip_release(joined);
    bat_document_free(both);
    bat_document_free(two);
    bat_document_free(one);
}

static void wrong_ones_are_refused(void **unused) {
    (void)unused;
    bat_document *document = opened(MASK(USER) BOX), *back = NULL;
    const bat_picture *picture = bat_clip_picture(mask_of(document));
    const double flat[6] = {1, 2, 2, 4, 0, 0}, wrong[6] = {1, 0, 0, NAN, 0, 0}, far[6] = {1, 0, 0, 1, 1e300};
    bat_clip *clip = NULL;
    assert_int_equal(bat_clip_mask(picture, wrong, NULL, &clip), BAT_NUMBER);
    assert_int_equal(bat_clip_mask(picture, far, NULL, &clip), BAT_NUMBER);
    assert_int_equal(bat_clip_mask(NULL, flat, NULL, &clip), BAT_ARGUMENT);
    assert_int_equal(bat_clip_mask(picture, flat, NULL, &clip), BAT_OK);
    assert_true(bat_clip_curve_count(clip) == 0 && !bat_clip_picture(clip));
    bat_clip_release(clip);
    char *native = written(document, false), *mask = strstr(native, "\"mask\":\"");
    bat_problem problem;
    assert_non_null(mask);
    mask[8] = mask[8] == '0' ? '1' : '0';
    assert_int_not_equal(bat_document_read(native, strlen(native), &back, &problem), BAT_OK);
    bat_free(native);
    bat_document_free(document);
}

static void memory_may_run_out(void **unused) {
    (void)unused;
    static const char text[] = HEAD "<defs stroke='red'><g style='stroke-width:2'>" MASK(
        "") "</g></defs><circle r='9' mask='url(#m)'/><g mask='url(#m)'><path d='M0 "
            "0H9V9Z'/><path d='M1 1H9V9Z'/></g></svg>";
    const long before = alloc_live();
    for (int n = 1;; n++) {
        bat_document *document = NULL;
        char *svg = NULL;
        size_t size;
        alloc_fail_at(n);
        bat_status status = read_file(text, &document);
        if (status == BAT_OK) status = bat_svg_write(document, true, &svg, &size);
        const bool failed = alloc_fail_reached();
        alloc_fail_at(0);
        if (status != BAT_OK && status != BAT_MEMORY) fail_msg("allocation %d: %d", n, status);
        bat_free(svg);
        bat_document_free(document);
        assert_true(alloc_live() == before);
        if (!failed) {
            assert_true(status == BAT_OK && n > 20);
            return;
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(places),
        cmocka_unit_test(pictures),
        cmocka_unit_test(odd_ones),
        cmocka_unit_test(is_kept),
        cmocka_unit_test(two_masks),
        cmocka_unit_test(wrong_ones_are_refused),
        cmocka_unit_test(memory_may_run_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
