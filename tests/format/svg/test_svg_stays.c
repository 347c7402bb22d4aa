/* An edit changes the text of the element that was edited, and none elsewhere in the file, whatever refers to what. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "document/clip.h"
#include "document/document.h"
#include "document/kind.h"
#include "format/svg/tags.h"
#include "format/svg/write/patch.h"
#include "support/svg_kept.h"
#include <batten/bezier.h>
#include <batten/format.h>

#include <math.h>
#include <stdlib.h>

#define HEAD                                                                                                 \
    "<svg xmlns='http://www.w3.org/2000/svg' xmlns:l='http://www.w3.org/1999/xlink' viewBox='0 0 100 100'>"
#define PAIR "<path d='M20 20H60V50Z'/><path d='M30 10L40 70L9 9Z' fill='red'/>"

static bat_document *opened(const char *text) {
    bat_document *document = NULL;
    assert_int_equal(svg_read_kept(NULL, text, strlen(text), &document, NULL), BAT_OK);
    return document;
}

static char *written(const bat_document *document) {
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_svg_write(document, false, &text, &size), BAT_OK);
    return text;
}

static void shift(bat_document *document, int index, double dx) {
    const bat_object *object = bat_document_at(document, index);
    const double rows[12] = {1, 0, 0, dx, 0, 1, 0, 0, 0, 0, 1, 0};
    bat_object *made = NULL;
    assert_int_equal(bat_object_type(object)->transform(object, rows, &made), BAT_OK);
    assert_int_equal(bat_document_replace(document, index, made), BAT_OK);
    bat_object_release(made);
}

/* Where two texts differ: from *from of both, up to *to of the first. */
static void difference(const char *a, const char *b, size_t *from, size_t *to) {
    const size_t size[2] = {strlen(a), strlen(b)};
    size_t before = 0, behind = 0;
    while (a[before] && a[before] == b[before]) before++;
    while (behind < size[0] - before && behind < size[1] - before &&
           a[size[0] - 1 - behind] == b[size[1] - 1 - behind])
        behind++;
    *from = before, *to = size[0] - behind;
}

/* The element that an object was read from; 0: `use` draws it. */
static uint32_t element_of(const bat_document *document, int index) {
    const bat_source *source = bat_document_origin(document);
    for (int k = 0; k < bat_source_count(source); k++) {
        const bat_sourced *entry = bat_source_at(source, k);
        if (entry->id == bat_object_id(bat_document_at(document, index)))
            return entry->copied ? 0 : entry->element;
    }
    return 0;
}

/* In a group that is seen through its box: that group's text changes, too, as its box does. */
static bool is_framed(const bat_document *document, const bat_object *object) {
    while ((object = bat_document_at(document, bat_document_find(document, bat_object_parent(object)))))
        if (bat_object_clip(object)) return true;
    return false;
}

static const char *const FILES[] = {
    /* A group that is masked or clipped by its box, in others, and beside others. */
    HEAD "<mask id='m'><rect width='99' height='99' fill='#888'/></mask><g mask='url(#m)'>" PAIR
         "</g><path d='M1 1H9V9Z'/></svg>",
    HEAD
    "<mask id='m' maskContentUnits='objectBoundingBox'><circle r='1' fill='#fff'/></mask><g id='a'><g id='b' "
    "mask='url(#m)'>" PAIR "</g><g>" PAIR "</g></g><path d='M1 1H9V9Z'/></svg>",
    HEAD
    "<clipPath id='c' clipPathUnits='objectBoundingBox'><circle r='.8'/></clipPath><path d='M1 1H9V9Z'/><g "
    "clip-path='url(#c)'>" PAIR "</g></svg>",
    HEAD
    "<mask id='m'><rect width='99' height='99' fill='#888'/></mask><g mask='url(#m)'>" PAIR
    "<g display='none'><path d='M0 0H99V99Z'/><path d='M0 0H99V98Z'/></g></g><path d='M1 1H9V9Z'/></svg>",
    /* Shapes with paints of their box, and copies of shapes. */
    HEAD "<linearGradient id='g'><stop stop-color='red'/><stop offset='1'/></linearGradient><g "
         "fill='url(#g)'>" PAIR "</g><path d='M1 1H9V9Z'/></svg>",
    HEAD
    "<path id='p' d='M20 20H60V50Z'/><use href='#p' x='9'/><use id='q' l:href='#p' y='9'/><use href='#q' "
    "x='20'/><path d='M1 1H9V9Z'/></svg>",
    HEAD "<style>#p{fill:red;stroke:blue}</style><g><use href='#p' x='9'/><path id='p' "
         "d='M20 20H60V50Z'/></g><clipPath id='c'><use href='#p'/></clipPath><path clip-path='url(#c)' d='M1 "
         "1H90V90Z'/></svg>",
};

static void edits_stay_where_they_are(void **state) {
    (void)state;
    for (size_t f = 0; f < sizeof FILES / sizeof *FILES; f++) {
        bat_svg_tags tags;
        assert_int_equal(bat_svg_tags_scan(FILES[f], strlen(FILES[f]), &tags), BAT_OK);
        int tried = 0;
        for (int i = 0;; i++) {
            bat_document *document = opened(FILES[f]);
            const int count = bat_document_count(document);
            const uint32_t element = i < count ? element_of(document, i) : 0;
            const bat_object *object = bat_document_at(document, i);
            size_t from, to;
            const bool alone = element && bat_object_is_made_of_curves(object) &&
                               !is_framed(document, object);
            if (alone) {
                shift(document, i, 0.5);
                char *text = written(document);
                difference(FILES[f], text, &from, &to);
                if (from == to || from < tags.list[element].open || to > tags.list[element].end)
                    fail_msg("file %zu, object %d: %s", f, i, text);
                bat_document *again = opened(text); /* and it shows what the document does */
                assert_int_equal(bat_document_count(again), count);
                for (int k = 0; k < count; k++) {
                    double a[4], b[4];
                    bat_object_bounds(bat_document_at(document, k), a);
                    bat_object_bounds(bat_document_at(again, k), b);
                    for (int j = 0; j < 4 && bat_object_is_drawn(bat_document_at(document, k)); j++)
                        assert_true(fabs(a[j] - b[j]) < 1e-2);
                    const bat_style *was = bat_object_style(bat_document_at(document, k)),
                                    *now = bat_object_style(bat_document_at(again, k));
                    assert_true(was->fill == now->fill && was->filled == now->filled &&
                                was->stroked == now->stroked);
                }
                bat_document_free(again);
                bat_free(text);
                tried++;
            }
            bat_document_free(document);
            if (i >= count) break;
        }
        assert_true(tried > 0);
        bat_svg_tags_free(&tags);
    }
}

/* What gives a masked group its box: then it has a mask of its own, which stays where it was. */
static void a_box_that_changes_is_said(void **state) {
    (void)state;
    for (int e = 0; e < 2; e++) {
        bat_document *document = opened(FILES[0]);
        if (e == 0)
            shift(document, 1, 30); /* a member is moved */
        else
            bat_document_remove(document, 2); /* one goes */
        char *text = written(document);
        assert_non_null(strstr(text, "mask id=\"batten-paint-"));
        bat_free(text);
        bat_document_free(document);
    }
}

/* What is read again after writing takes no second memory for curves that are as they were, whatever was taken out or moved. */
static void what_is_read_again_shares_its_curves(void **state) {
    (void)state;
    static const char text[] = HEAD PAIR "<g id='g'>" PAIR "</g><rect width='9' height='7'/></svg>";
    enum { COUNT = 6, MOVED = 1, GROUP = 2 };
    for (int removed = 0; removed < 2; removed++) {
        const bat_svg_options merging = bat_svg_merging();
        bat_document *document = NULL;
        assert_int_equal(svg_read_kept(&merging, text, strlen(text), &document, NULL), BAT_OK);
        assert_int_equal(bat_document_count(document), COUNT);
        shift(document, MOVED, 0.1234567);
        if (removed) bat_document_remove(document, 0);
        char *made = written(document);
        bat_text again_text = {0};
        bat_svg_again again = {.like = document};
        bat_text_string(&again_text, made);
        assert_int_equal(bat_svg_again_read(&again_text, &merging, &again), BAT_OK);
        for (int i = 0; i < COUNT - removed; i++) {
            const bat_object *own = bat_document_at(document, i), *other = bat_document_at(again.document, i);
            if (i + removed == GROUP) continue;
            const bool same = bat_object_curve(own, 0) == bat_object_curve(other, 0);
            assert_int_equal(same, i + removed != MOVED);
        }
        bat_svg_again_free(&again);
        bat_text_free(&again_text);
        bat_free(made);
        assert_null(bat_document_check(document));
        bat_document_free(document);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edits_stay_where_they_are),
        cmocka_unit_test(a_box_that_changes_is_said),
        cmocka_unit_test(what_is_read_again_shares_its_curves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
