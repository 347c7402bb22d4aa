/* A file that is kept, and groups that go elsewhere: their elements go along, with all that Batten does not know. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "document/document.h"
#include "format/svg/reader.h"
#include "format/svg/tags.h"
#include "support/random_curve.h"
#include "support/svg_kept.h"
#include <batten/bezier.h>
#include <batten/format.h>

#include <math.h>
#include <stdlib.h>

#define SVG "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 90 90'>\n"

static bat_document *opened(const char *text) {
    bat_document *document = NULL;
    assert_int_equal(svg_read_kept(NULL, text, strlen(text), &document, NULL), BAT_OK);
    return document;
}

static char *written(const bat_document *document, bool native) {
    char *text = NULL;
    size_t size = 0;
    assert_int_equal(bat_svg_write(document, native, &text, &size), BAT_OK);
    return text;
}

static int find_group(const bat_document *document, int nth) {
    for (int i = 0; i < bat_document_count(document); i++)
        if (bat_object_is_group(bat_document_at(document, i)) && nth-- == 0) return i;
    return -1;
}

static int count_groups(const bat_document *document) {
    int count = 0;
    while (find_group(document, count) >= 0) count++;
    return count;
}

/* Takes an object with all that is in it to `to`, counted without it, in another group. */
static void move(bat_document *document, int from, int to, bat_id parent) {
    enum { MOST = 64 };
    bat_object *moved[MOST] = {NULL};
    const int count = bat_document_end(document, from) - from;
    assert_in_range(count, 1, MOST);
    for (int i = 0; i < count; i++) moved[i] = bat_object_retain(bat_document_at(document, from + i));
    for (int i = count - 1; i >= 0; i--) assert_int_equal(bat_document_remove(document, from + i), BAT_OK);
    bat_object *first = NULL;
    assert_int_equal(bat_object_with_parent(moved[0], parent, &first), BAT_OK);
    bat_object_release(moved[0]);
    moved[0] = first;
    for (int i = 0; i < count; i++) {
        assert_int_equal(bat_document_insert(document, to + i, moved[i]), BAT_OK);
        bat_object_release(moved[i]);
    }
}

static void shift(bat_document *document, int index, double dx) {
    const bat_object *object = bat_document_at(document, index);
    const double rows[6] = {1, 0, dx, 0, 1, dx};
    bat_curve *curves[4];
    bat_object *made = NULL;
    if (!bat_object_is_made_of_curves(object)) return;
    const int count = bat_object_curve_count(object);
    assert_in_range(count, 1, 4);
    for (int i = 0; i < count; i++)
        assert_int_equal(bat_curve_transform(bat_object_curve(object, i), rows, &curves[i]), BAT_OK);
    assert_int_equal(bat_object_with_curves(object, count, curves, &made), BAT_OK);
    assert_int_equal(bat_document_replace(document, index, made), BAT_OK);
    bat_object_release(made);
}

static void expect_written(bat_document *document, const char *expected) {
    char *text = written(document, false);
    assert_string_equal(text, expected);
    bat_free(text);
    bat_document_free(document);
}

#define FACE                                                                                                 \
    "<g id='face' class=\"big\" data-mine='1' fill='red' transform='scale(2)'><!-- eyes -->"                 \
    "<path d='M1 1H3V4Z'/><text x='9'>hm</text><g id='m'><path d='M5 1H7V4Z'/>\n<path d='M5 "                \
    "8H7V9Z'/></g></g>"
#define LINE "<path id='l' d='M0 0L50 50' stroke='blue'/>"
#define LAST                                                                                                 \
    "<path d='M9 9L50 9V20Z'/><rect width='2' height='3'/><rect width='3' height='2'/><rect width='4' "      \
    "height='4'/><rect width='4' height='5'/><rect width='4' height='6'/>"

static void groups_go_along(void **state) {
    (void)state;
    static const char file[] = SVG "  " LINE "\n  " LAST "\n  " FACE "\n</svg>";
    bat_document *document = opened(file); /* to the back */
    move(document, find_group(document, 0), 0, 0);
    expect_written(document, SVG "  " FACE "\n  " LINE "\n  " LAST "\n</svg>");

    document = opened(file); /* between two */
    move(document, find_group(document, 0), 1, 0);
    expect_written(document, SVG "  " LINE "\n" FACE "\n  " LAST "\n</svg>");

    document = opened(file); /* with something edited in it, and in what is in it */
    const int face = find_group(document, 0);
    shift(document, bat_document_count(document) - 1, 10);
    move(document, face, 0, 0);
    char *text = written(document, false);
    const char *head = strstr(
        text, "data-mine='1' fill='red' transform='scale(2)'><!-- eyes --><path d='M1 1H3V4Z'/>"
              "<text x='9'>hm</text><g id='m'><path d='M5 1H7V4Z'/>\n<path d=");
    assert_non_null(head);
    assert_true(head < strstr(text, LINE));
    assert_null(strstr(text, "M5 8"));
    bat_free(text);
    bat_document_free(document);

    document = opened(file); /* the one in it within it */
    const int inner = find_group(document, 1);
    move(document, inner, find_group(document, 0) + 1, bat_object_parent(bat_document_at(document, inner)));
    text = written(document, false);
    const char *eye = strstr(text, "<g id='m'><path d='M5 1H7V4Z'/>\n<path d='M5 8H7V9Z'/></g>");
    assert_non_null(eye);
    assert_non_null(
        strstr(eye, "<path d='M1 1H3V4Z'/>")); /* of as few elements as can be the place is another */
    assert_non_null(strstr(eye, "<text x='9'>hm</text>"));
    bat_free(text);
    bat_document_free(document);
}

/* What replaces all that was in a group is in it, between the same neighbours. */
static void groups_stay_when_all_in_them_is_new(void **state) {
    (void)state;
    bat_document *document = opened(SVG FACE LINE "</svg>");
    const int face = find_group(document, 0);
    const bat_id id = bat_object_id(bat_document_at(document, face));
    while (bat_document_end(document, face) > face + 1)
        assert_int_equal(bat_document_remove(document, bat_document_end(document, face) - 1), BAT_OK);
    const int line = bat_document_count(document) - 1;
    for (int i = 0; i < 2; i++) { /* in the group, and behind it */
        bat_object *other = NULL, *made = NULL;
        assert_int_equal(
            bat_object_with_id(bat_document_at(document, line + i), bat_document_new_id(document), &other),
            BAT_OK);
        assert_int_equal(bat_object_with_parent(other, i == 0 ? id : 0, &made), BAT_OK);
        assert_int_equal(bat_document_insert(document, face + 1 + i, made), BAT_OK);
        bat_object_release(other);
        bat_object_release(made);
    }
    char *text = written(document, false);
    const char *group = strstr(text, "<g id='face' class=\"big\" data-mine='1'");
    assert_non_null(group);
    const char *first = strstr(group, "<path"), *end = strstr(group, "</g>");
    assert_true(first && end && first < end);
    const char *next = strstr(end, "<path"), *last = strstr(end, LINE);
    assert_true(next && last && next < last);
    bat_free(text);
    bat_document_free(document);
}

/* A copy that is edited is written in the place of its element, and nothing else is touched. */
static void copies_give_way_at_their_place(void **state) {
    (void)state;
    static const char head[] = SVG "<defs><path id='p' d='M1 1H3V4Z'/></defs>" LINE
                                   "\n <g class='w' transform='scale(2)'>"
                                   "<g>\n   ",
                      copy[] = "<use href='#p' x='3'/>", tail[] = "\n  </g><!-- w --></g>\n" LAST "</svg>";
    char file[sizeof head + sizeof copy + sizeof tail];
    snprintf(file, sizeof file, "%s%s%s", head, copy, tail);
    bat_document *document = opened(file);
    assert_true(bat_document_count(document) > 2);
    shift(document, 1, 4);
    char *text = written(document, false);
    const size_t size = strlen(text);
    assert_int_equal(strncmp(text, head, sizeof head - 1), 0);
    assert_string_equal(text + size - (sizeof tail - 1), tail);
    assert_int_equal(strncmp(text + sizeof head - 1, "<path", 5), 0);
    bat_document *seen = opened(text);
    double box[4];
    bat_object_bounds(bat_document_at(seen, 1), box);
    assert_true(fabs(box[0] - 12) < 1e-6 && fabs(box[1] - 6) < 1e-6 && fabs(box[2] - 16) < 1e-6);
    bat_document_free(seen);
    bat_free(text);

    bat_object *other = NULL; /* and what is new below it stays below it */
    assert_int_equal(bat_object_with_id(bat_document_at(document, 2), bat_document_new_id(document), &other),
                     BAT_OK);
    assert_int_equal(bat_document_remove(document, 0), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, other), BAT_OK);
    bat_object_release(other);
    text = written(document, false);
    seen = opened(text);
    bat_object_bounds(bat_document_at(seen, 0), box);
    assert_true(fabs(box[0] - 9) < 1e-6 && fabs(box[2] - 50) < 1e-6);
    bat_object_bounds(bat_document_at(seen, 1), box);
    assert_true(fabs(box[0] - 12) < 1e-6);
    assert_non_null(strstr(text, "<!-- w -->"));
    bat_document_free(seen);
    bat_free(text);
    bat_document_free(document);
}

/* A new group around what stays is written when it has something to say of them all. */
static void new_groups_are_translucent(void **state) {
    (void)state;
    bat_document *document = opened(
                     SVG "<path id='one' d='M1 1H3V4Z'/><rect id='two' width='4' height='4'/></svg>"),
                 *seen;
    const bat_id id = bat_document_new_id(document);
    bat_object *plain = NULL, *group = NULL, *made = NULL;
    assert_int_equal(bat_object_create_group(id, "", false, &plain), BAT_OK);
    bat_style style = *bat_object_style(plain);
    style.opacity = 0.5;
    assert_int_equal(bat_object_with_style(plain, &style, &group), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, group), BAT_OK);
    for (int i = 1; i < 3; i++) {
        assert_int_equal(bat_object_with_parent(bat_document_at(document, i), id, &made), BAT_OK);
        assert_int_equal(bat_document_replace(document, i, made), BAT_OK);
        bat_object_release(made);
    }
    bat_object_release(plain);
    bat_object_release(group);
    char *text = written(document, false);
    seen = opened(text);
    assert_non_null(strstr(text, "id='one'"));
    assert_non_null(strstr(text, "<rect id='two' width='4' height='4'"));
    const int again = find_group(seen, 0);
    assert_int_equal(again, 0);
    assert_true(bat_object_style(bat_document_at(seen, again))->opacity == 0.5);
    assert_int_equal(bat_document_end(seen, again), 3);
    bat_document_free(seen);
    bat_free(text);
    bat_document_free(document);
}

/* ---- random edits ---- */

static const char *const FILES[] = {
    SVG "<!-- 1 --><path d='M0 0L50 50V9'/><g id='a' opacity='.5'><!-- 2 --><path d='M0 50L50 0V9'/><path "
        "d='M9 9L9 50H3'/>"
        "</g>\n<path d='M5 5H9V9'/><g transform='scale(2)'><g class='b'><path d='M1 9H8V3'/><g/><g id='c'>"
        "<path d='M2 9H8V3'/><path d='M3 9H8V3'/></g></g><path d='M4 9H8V3'/></g><!-- the end --></svg>",
    SVG "<defs><!-- 1 --></defs><g id='a'><g id='b'><rect width='5' height='6'/><circle r='4'/></g><g "
        "id='c'><line x2='4' y2='5'/>"
        "<rect x='9' width='2' height='3'/></g></g><!-- 2 --><g id='d'><rect y='9' width='5' height='6'/><g "
        "id='e'>"
        "<ellipse rx='3' ry='4'/><path d='M8 8h3v3z'/></g></g><switch><rect width='5' "
        "height='5'/></switch><!-- the end --></svg>",
    SVG "<g id='all'><path id='p' d='M0 0L50 50V9'/><use href='#p' x='9'/><g id='a'><use href='#p' "
        "y='9'/><path d='M3 3h9v9'/></g>"
        "<!-- 1 --><g id='b'><path d='M4 4h9v9'/><path d='M6 4h9v9'/></g></g><!-- the end --></svg>"};
enum { FILE_COUNT = sizeof FILES / sizeof *FILES };

/* A group or a thing goes to another place of the list: in the same group, or in one that is not in it. */
static void move_some(bat_document *document, int from, random_source *r) {
    const int last = bat_document_count(document) - 1, end = bat_document_end(document, from);
    const int to = random_int(r, 0, last);
    if (to >= from && to < end) return;
    const bat_object *there = bat_document_at(document, to);
    const bool inside = random_int(r, 0, 1) == 1 && bat_object_is_group(there);
    const int place = inside ? to + 1 : to;
    move(document, from, place > from ? place - (end - from) : place,
         inside ? bat_object_id(there) : bat_object_parent(there));
}

static void edit(bat_document *document, random_source *r) {
    const int index = random_int(r, 0, bat_document_count(document) - 1), which = random_int(r, 0, 9);
    const int groups = count_groups(document);
    const int group = groups ? find_group(document, random_int(r, 0, groups - 1)) : -1;
    if (which < 2) move_some(document, index, r);
    if (group < 0) return;
    const int end = bat_document_end(document, group);
    if (which > 1 && which < 6) move_some(document, group, r);
    if (which == 6)
        for (int i = group; i < end; i++) shift(document, i, 1.5);
    if (which == 7 && end < bat_document_count(document)) /* all in it goes */
        for (int i = end - 1; i > group; i--) assert_int_equal(bat_document_remove(document, i), BAT_OK);
    if (which == 8 && end > group + 1) /* all in it is new */
        for (int i = group + 1; i < end; i++) {
            if (bat_object_is_group(bat_document_at(document, i))) continue;
            bat_object *made = NULL;
            assert_int_equal(
                bat_object_with_id(bat_document_at(document, i), bat_document_new_id(document), &made),
                BAT_OK);
            assert_int_equal(bat_document_remove(document, i), BAT_OK);
            assert_int_equal(bat_document_insert(document, i, made), BAT_OK);
            bat_object_release(made);
        }
}

static const bat_object *next_drawn(const bat_document *document, int *at) {
    for (const bat_object *object; (object = bat_document_at(document, (*at)++));)
        if (bat_object_is_drawn(object) &&
            (bat_object_style(object)->stroked || bat_object_style(object)->filled))
            return object;
    return NULL;
}

/* The same things one above the other, as translucent as they were with all that they are in. */
static void expect_same_picture(const bat_document *one, const bat_document *other) {
    int i = 0, k = 0;
    for (const bat_object *a; (a = next_drawn(one, &i));) {
        const bat_object *b = next_drawn(other, &k);
        double box[4], there[4];
        assert_non_null(b);
        bat_object_bounds(a, box);
        bat_object_bounds(b, there);
        for (int j = 0; j < 4; j++) assert_true(fabs(box[j] - there[j]) < 2e-3);
        const double share = bat_object_style(a)->opacity * bat_document_level(one, i - 1).around;
        assert_true(fabs(share - bat_object_style(b)->opacity * bat_document_level(other, k - 1).around) <
                    1e-9);
        assert_true(bat_object_style(a)->fill == bat_object_style(b)->fill);
    }
    assert_null(next_drawn(other, &k));
}

static void random_edits_of_groups(void **state) {
    (void)state;
    random_source r = {15};
    for (int round = 0; round < 450; round++) {
        const char *file = FILES[round % FILE_COUNT];
        bat_document *document = opened(file);
        for (int again = 0; again < 3; again++) {
            const int edits = random_int(&r, 1, 3);
            for (int i = 0; i < edits; i++) edit(document, &r);
            assert_null(bat_document_check(document));
            char *plain = written(document, false), *whole = written(document, true);
            bat_document *seen = opened(plain), *back = opened(whole);
            expect_same_picture(document, seen);
            if (!strstr(plain, "<!-- the end -->")) fail_msg("the file was written anew: %s", plain);
            assert_true(bat_document_digest(back) == bat_document_digest(document) || !strcmp(whole, file));
            bat_document_free(document);
            document = back;
            bat_document_free(seen);
            bat_free(plain);
            bat_free(whole);
        }
        bat_document_free(document);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(groups_go_along),
        cmocka_unit_test(groups_stay_when_all_in_them_is_new),
        cmocka_unit_test(copies_give_way_at_their_place),
        cmocka_unit_test(new_groups_are_translucent),
        cmocka_unit_test(random_edits_of_groups),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
