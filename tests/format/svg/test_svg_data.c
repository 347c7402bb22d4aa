/* Of an edited path only the subpaths that were edited are written anew: the text of the others stays, whatever their commands
 * are relative to, and they are the same curves bit for bit. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "document/document.h"
#include "format/svg/svg.h"
#include "format/svg/write/feed.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"
#include <batten/bezier.h>
#include <batten/drag.h>
#include <batten/format.h>
#include <batten/measure.h>

#include <math.h>
#include <stdlib.h>

enum { ROOM = 4000, CURVES = 8 };

static bat_document *opened(const char *text, double tolerance) {
    bat_svg_options options = bat_svg_merging();
    bat_svg_reader *reader;
    bat_document *document = NULL;
    options.tolerance = tolerance;
    assert_int_equal(bat_svg_reader_create(&options, &reader), BAT_OK);
    assert_int_equal(bat_svg_reader_source(reader, text, strlen(text)), BAT_OK);
    assert_int_equal(bat_svg_feed(text, strlen(text), reader), BAT_OK);
    assert_int_equal(bat_svg_reader_finish(reader, &document, NULL, NULL), BAT_OK);
    return document;
}

static bat_document *opened_path(const char *data) {
    char file[ROOM + 200];
    snprintf(file, sizeof file,
             "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 90 90'><g transform='scale(2 3)'>"
             "<path fill='none' stroke='red' d='%s'/></g></svg>",
             data);
    return opened(file, 1e-3);
}

static void put(bat_document *document, int count, bat_curve *const *curves) {
    bat_object *made = NULL;
    assert_int_equal(bat_object_with_curves(bat_document_at(document, 0), count, curves, &made), BAT_OK);
    assert_int_equal(bat_document_replace(document, 0, made), BAT_OK);
    bat_object_release(made);
}

static bat_curve *moved(const bat_curve *curve, double dx, double dy) {
    const double rows[6] = {1, 0, dx, 0, 1, dy};
    bat_curve *made = NULL;
    assert_int_equal(bat_curve_transform(curve, rows, &made), BAT_OK);
    return made;
}

/* The curves that stay, moved (bit set in `moves`) or not; those of `drops` go. front, back: a copy of the first one is added. */
static void edit(bat_document *document, unsigned moves, unsigned drops, bool front, bool back) {
    const bat_object *object = bat_document_at(document, 0);
    bat_curve *list[CURVES + 2];
    int count = 0;
    if (front) list[count++] = moved(bat_object_curve(object, 0), 1, 1);
    for (int i = 0; i < bat_object_curve_count(object); i++)
        if (!(drops >> i & 1)) {
            const double by = moves >> i & 1 ? 6 : 0;
            list[count++] = moved(bat_object_curve(object, i), by, by);
        }
    if (back) list[count++] = moved(bat_object_curve(object, 0), 2, 2);
    put(document, count, list);
}

static char *written(const bat_document *document) {
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_svg_write(document, false, &text, &size), BAT_OK);
    return text;
}

/* What is written begins and ends so, and holds as many subpaths. */
static void expect_data(const char *data, unsigned moves, unsigned drops, const char *head,
                        const char *tail) {
    bat_document *document = opened_path(data);
    edit(document, moves, drops, false, false);
    char *text = written(document), *at = strstr(text, " d=\""), *end;
    assert_non_null(at);
    end = strchr(at += 4, '"');
    assert_non_null(end);
    const size_t size = (size_t)(end - at), before = strlen(head), behind = strlen(tail);
    if (size < before + behind || memcmp(at, head, before) != 0 || memcmp(end - behind, tail, behind) != 0)
        fail_msg("%.*s\nis not %s ... %s", (int)size, at, head, tail);
    bat_document *again = opened(text, 1e-3);
    const bat_object *one = bat_document_at(document, 0), *other = bat_document_at(again, 0);
    assert_int_equal(bat_object_curve_count(one), bat_object_curve_count(other));
    bat_document_free(again);
    bat_free(text);
    bat_document_free(document);
}

static void only_the_edited_subpath_is_new(void **state) {
    (void)state;
    static const char rings[] = "m1 1 h6 a3 2 30 0 1 6 6v 9\n z m 2,2 4,0 q1 1 0 4 z M30 5\tH40V9L31 9";
    expect_data(rings, 1, 0, "M4 3", "M3 3l4,0 q1 1 0 4 z M30 5\tH40V9L31 9");
    expect_data(rings, 2, 0, "m1 1 h6 a3 2 30 0 1 6 6v 9\n z M6 5", "ZM30 5\tH40V9L31 9");
    expect_data(rings, 4, 0, "m1 1 h6 a3 2 30 0 1 6 6v 9\n z m 2,2 4,0 q1 1 0 4 z M", "");
    expect_data(rings, 5, 0, "M4 3", "");
    expect_data(rings, 0, 2, "m1 1 h6 a3 2 30 0 1 6 6v 9\n z M30 5\tH40V9L31 9", "");
    /* After an end there may be no move; a point alone stays where it is; single quotes, and all in one. */
    expect_data("M1 1h5v5zl 9 9 9 0", 1, 0, "M4 3", "ZM1 1l 9 9 9 0");
    expect_data("M1 1h5v5zM8 8h0m9 9h3v3z", 1, 0, "M4 3", "ZM8 8h0m9 9h3v3z");
    expect_data("M7 7 M1 1h5v5z m1 1 M3 3h5v5z", 1, 0, "M4 3", "ZM3 3h5v5z");
    expect_data("M1 1A5 5 0 0 1 9 9M2 2a5 5 0 01-9 9", 2, 0, "M1 1A5 5 0 0 1 9 9M5 4C", "");
    /* Data with an error are read up to there: what follows them would not be read. */
    expect_data("M1 1h5v5zM9 9h1v1z!", 1, 0, "M4 3L", "ZM9 9L10 9L10 10Z");
}

/* Z draws the last leg of a closed polygon, but one of no length: a reader finds as many as there were. */
static void the_end_draws_the_last_leg(void **state) {
    (void)state;
    random_source r = {11};
    for (int round = 0; round < 200; round++) {
        const int count = random_int(&r, 3, 7), zero = random_int(&r, 0, 2);
        double points[14], knots[8];
        for (int i = 0; i < 2 * count; i++) points[i] = random_int(&r, 1, 90) / 4.0;
        if (zero == 0) memcpy(points + 2 * (size_t)(count - 1), points, 2 * sizeof *points);
        for (int i = 0; i <= count; i++) knots[i] = i;
        bat_document *document = opened_path("M1 1L2 2");
        bat_curve *curve = NULL;
        assert_int_equal(bat_curve_create(2, 1, true, (size_t)count, points, count + 1, knots, &curve),
                         BAT_OK);
        int zeros = 0, legs = 0;
        double domain[2], first[2], last[2];
        bat_curve_domain(curve, domain);
        bat_curve_eval(curve, domain[0], 0, first);
        bat_curve_eval(curve, domain[0] + count - 1, 0, last);
        zeros = first[0] == last[0] && first[1] == last[1];
        put(document, 1, &curve);
        char *text = written(document), *at = strstr(text, " d=\"");
        assert_non_null(at);
        bat_outline outline = {0};
        const size_t size = strcspn(at + 4, "\"");
        assert_true(bat_svg_path(at + 4, size, &outline));
        for (size_t i = 0; i < size; i++) legs += at[4 + i] == 'L';
        assert_int_equal(legs, count - 1 + zeros);
        assert_true(at[4 + size - 1] == 'Z');
        assert_int_equal(outline.subpath_count, 1);
        assert_true(outline.subpaths[0].closed);
        assert_int_equal(outline.subpaths[0].segments, count);
        bat_outline_free(&outline);
        bat_free(text);
        bat_document_free(document);
    }
}

/* Moves one control point of a curve. */
static void nudge(bat_document *document, int curve, int point, double dx, double dy) {
    const bat_object *object = bat_document_at(document, 0);
    bat_curve *list[CURVES];
    const int count = bat_object_curve_count(object);
    for (int i = 0; i < count; i++) {
        const double delta[2] = {i == curve ? dx : 0, i == curve ? dy : 0};
        assert_int_equal(bat_curve_move_point(bat_object_curve(object, i), point, delta, &list[i]), BAT_OK);
    }
    put(document, count, list);
}

static void expect_nudged(const char *data, int point, const char *head, const char *tail) {
    bat_document *document = opened_path(data);
    nudge(document, 0, point, 2, 3); /* a unit of the path each */
    char *text = written(document), *at = strstr(text, " d=\"");
    assert_non_null(at);
    at += 4;
    const size_t size = strcspn(at, "\""), before = strlen(head), behind = strlen(tail);
    if (size < before + behind || memcmp(at, head, before) != 0 ||
        memcmp(at + size - behind, tail, behind) != 0)
        fail_msg("%.*s\nis not %s ... %s", (int)size, at, head, tail);
    bat_free(text);
    bat_document_free(document);
}

static void segments_that_were_not_touched_keep_their_text(void **state) {
    (void)state;
    /* Points: the start, and 3 for each straight segment. */
    expect_nudged("M1 1 H9 V9 h-6", 3, "M1 1C", "9 9h-6");
    expect_nudged("M1 1 H9 V9 h-6", 9, "M1 1 H9 V9C", "4 10");
    expect_nudged("m1 1 h8 v8 h-6v-3", 0, "M2 2C", " 9 1v8 h-6v-3");
    expect_nudged("m1 1 8 0 0 8-6 0 0-3", 3, "M1 1C", " 9 9l-6 0 0-3"); /* what is left out is said again */
    expect_nudged("M1 1H20V20A8 5 10 01 9 29q-2 0-4-1t-3 2", 4, "M1 1H20C",
                  " 20 20A8 5 10 01 9 29q-2 0-4-1t-3 2");
    expect_nudged("M1 1H20V20H9z", 2, "M1 1C", " 20 20H9z"); /* the end draws the last leg */
    expect_nudged("M1 1H20V20H9z", 10, "M1 1H20V20H9C", " 1 1Z");
    expect_nudged("M1 1H20V20H9z m2 2h5v5", 4, "M1 1H20C", " 20 20H9zM3 3h5v5");
}

/* ---- random data ---- */

static void add_segments(char *data, size_t *at, random_source *r) {
    static const char commands[] = "lLhHvVcCsSqQtTaA";
    static const int counts[] = {2, 2, 1, 1, 1, 1, 6, 6, 4, 4, 4, 4, 2, 2, 7, 7};
    for (int n = random_int(r, 1, 4); n > 0; n--) {
        const int which = random_int(r, 0, 15), times = random_int(r, 1, 2);
        data[(*at)++] = commands[which];
        for (int k = 0; k < times * counts[which]; k++) {
            const bool flag = counts[which] == 7 && (k % 7 == 3 || k % 7 == 4);
            const double number = flag ? random_int(r, 0, 1) : random_int(r, 1, 40) / 4.0;
            *at += (size_t)snprintf(data + *at, ROOM - *at, k ? " %g" : "%g", number);
        }
    }
}

/* Some subpaths, each long enough to be a curve. */
static int make_data(char *data, random_source *r) {
    const int count = random_int(r, 1, CURVES);
    size_t at = 0;
    bool closed = false;
    for (int i = 0; i < count; i++) {
        const bool moves = i == 0 || !closed || random_int(r, 0, 2);
        const int x = random_int(r, 1, 20), y = random_int(r, 1, 20);
        if (moves)
            at += (size_t)snprintf(data + at, ROOM - at, random_int(r, 0, 1) ? "m%d %d" : "M%d,%d", x, y);
        if (moves && random_int(r, 0, 1))
            at += (size_t)snprintf(data + at, ROOM - at, " %d %d", x + 3, y + 1);
        data[at++] = 'l';
        at += (size_t)snprintf(data + at, ROOM - at, "%d-7", x);
        add_segments(data, &at, r);
        closed = random_int(r, 0, 1);
        if (closed) data[at++] = random_int(r, 0, 1) ? 'z' : 'Z';
    }
    data[at] = '\0';
    return count;
}

/* The curves that were left alone come back bit for bit, the others as near as rounding leaves them. */
static void expect_curves(const bat_document *document, const bat_document *again, unsigned moves,
                          unsigned drops, int count, int front) {
    const bat_object *one = bat_document_at(document, 0), *other = bat_document_at(again, 0);
    assert_int_equal(bat_object_curve_count(one), bat_object_curve_count(other));
    for (int i = 0, k = front; i < count; i++) {
        if (drops >> i & 1) continue;
        const bat_curve *a = bat_object_curve(one, k), *b = bat_object_curve(other, k);
        if (!(moves >> i & 1)) assert_true(bat_curve_is_equal(a, b));
        k++;
    }
    double a[4], b[4];
    bat_object_bounds(one, a);
    bat_object_bounds(other, b);
    for (int k = 0; k < 4; k++) assert_true(fabs(a[k] - b[k]) < 4e-3);
}

/* How many cubics of the new data are some of the old data bit for bit, in order. */
static int kept_cubics(const bat_outline *one, const bat_outline *other) {
    int kept = 0;
    size_t next = 0;
    for (size_t i = 0; i + 3 < other->count; i++)
        for (size_t k = next; k + 3 < one->count; k++)
            if (memcmp(one->points + 2 * k, other->points + 2 * i, 8 * sizeof(double)) == 0) {
                kept++;
                next = k + 1;
                break;
            }
    return kept;
}

/* Of a long subpath of which one point moves, most is kept; and what is drawn is what the curve is. */
static void random_nudges_keep_most(void **state) {
    (void)state;
    random_source r = {1913};
    long kept = 0, whole = 0;
    for (int i = 0; i < 300; i++) {
        char data[ROOM];
        size_t at = (size_t)snprintf(data, ROOM, "M%d 7", random_int(&r, 1, 20));
        for (int n = 0; n < 6; n++) add_segments(data, &at, &r);
        const bool closed = random_int(&r, 0, 1);
        if (closed) data[at++] = 'z';
        data[at] = '\0';
        bat_document *document = opened_path(data);
        const bat_object *object = bat_document_at(document, 0);
        const int points = object ? (int)bat_curve_count(bat_object_curve(object, 0)) : 0;
        if (points < 4) {
            bat_document_free(document);
            continue;
        }
        nudge(document, 0, random_int(&r, 0, points - 1), 2, 3);
        char *text = written(document), *d = strstr(text, " d=\"");
        assert_non_null(d);
        bat_outline one = {0}, other = {0};
        assert_true(bat_svg_path(data, at, &one));
        assert_true(bat_svg_path(d + 4, strcspn(d + 4, "\""), &other));
        assert_int_equal(other.subpath_count, 1);
        assert_true(other.subpaths[0].closed == closed);
        kept += kept_cubics(&one, &other);
        whole += one.subpaths[0].segments;
        bat_outline_free(&one);
        bat_outline_free(&other);
        bat_document *again = opened(text, 1e-3);
        const bat_curve *a = bat_object_curve(bat_document_at(document, 0), 0),
                        *b = bat_object_curve(bat_document_at(again, 0), 0);
        double from = 0, back = 0;
        assert_int_equal(bat_curve_distance(a, b, 20, &from, &back), BAT_OK);
        if (!(from < 5e-3 && back < 5e-3)) fail_msg("%s\nbecame %s", data, d);
        bat_document_free(again);
        bat_free(text);
        bat_document_free(document);
    }
    assert_true(kept * 10 > whole * 6);
}

static void random_paths_keep_what_was_left_alone(void **state) {
    (void)state;
    random_source r = {815};
    int kept = 0;
    for (int i = 0; i < 400; i++) {
        char data[ROOM];
        const int count = make_data(data, &r);
        bat_document *document = opened_path(data);
        if (bat_document_count(document) != 1 ||
            bat_object_curve_count(bat_document_at(document, 0)) != count) {
            bat_document_free(document); /* one that stays where it begins */
            continue;
        }
        const unsigned all = (1u << count) - 1;
        const int what = random_int(&r, 0, 5), from = random_int(&r, 1, count),
                  to = random_int(&r, from, count);
        const unsigned moves = what < 3 ? (unsigned)random_int(&r, 0, (int)all) : 0;
        const unsigned drops = what == 3 ? all >> from << from & ~(all >> to << to) : 0;
        const bool front = what == 4, back = what == 5;
        edit(document, moves, drops, front, back);
        char *text = written(document);
        bat_document *again = opened(text, 1e-3);
        expect_curves(document, again, moves, drops, count, front);
        kept += strstr(text, data) != NULL;
        bat_document_free(again);
        bat_free(text);
        bat_document_free(document);
    }
    assert_in_range(kept, 5, 200); /* where nothing or only behind it something was done */
}

static void exact_curves_are_known_again(void **state) {
    (void)state;
    const char *file =
        "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0h9h9h9v9zm2 2a9 9 0 0 1 9 9z'/></svg>";
    bat_document *document = opened(file, 0);
    edit(document, 2, 0, false, false);
    char *text = written(document);
    assert_non_null(strstr(text, " d=\"M0 0h9h9h9v9zM8 8C"));
    bat_free(text);
    bat_document_free(document);
}

static void failed_allocations_change_nothing(void **state) {
    (void)state;
    bat_document *document = opened_path("M1 1h5v5zm9 9a3 3 0 0 1 4 4zM5 5h9v9z");
    edit(document, 2, 0, false, false);
    const long before = alloc_live();
    for (int n = 1;; n++) {
        char *text = NULL;
        size_t size;
        alloc_fail_at(n);
        const bat_status status = bat_svg_write(document, false, &text, &size);
        const bool failed = alloc_fail_reached();
        if (status == BAT_OK) assert_non_null(strstr(text, "M1 1h5v5zM"));
        if (status != BAT_OK) assert_null(text);
        bat_free(text);
        assert_int_equal(alloc_live(), before);
        if (!failed) break;
        if (status != BAT_OK) assert_int_equal(status, BAT_MEMORY);
    }
    bat_document_free(document);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_the_edited_subpath_is_new),
        cmocka_unit_test(the_end_draws_the_last_leg),
        cmocka_unit_test(segments_that_were_not_touched_keep_their_text),
        cmocka_unit_test(random_paths_keep_what_was_left_alone),
        cmocka_unit_test(random_nudges_keep_most),
        cmocka_unit_test(exact_curves_are_known_again),
        cmocka_unit_test(failed_allocations_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
