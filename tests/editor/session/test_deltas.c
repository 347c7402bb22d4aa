/* What a step tells about groups: its list of changes gives the same answer as a walk over the whole document. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "document/document.h"
#include "editor/session/history.h"
#include "support/random_curve.h"

static int below(random_source *r, int limit) { return (int)(random_unit(r) * limit); }

static bat_object *make(random_source *r, bat_document *document) {
    bat_object *object = NULL;
    bat_id id = bat_document_new_id(document);
    if (random_unit(r) < 0.5)
        bat_object_create_group(id, "", random_unit(r) < 0.3, &object);
    else
        bat_object_create_guide(id, 0, 1, &object);
    return object;
}

static bat_id any_parent(random_source *r, const bat_document *document) {
    int count = bat_document_count(document);
    const bat_object *other = count && random_unit(r) < 0.8 ? bat_document_at(document, below(r, count))
                                                            : NULL;
    return other ? bat_object_id(other) : 0;
}

/* Any change, sense or nonsense; the delta holds what it exchanged. */
static bat_delta change(random_source *r, bat_document *document) {
    int count = bat_document_count(document), kind = count ? below(r, 4) : 0,
        at = below(r, count + (kind == 0));
    bat_object *made = NULL, *after = NULL;
    const bat_object *before = kind ? bat_document_at(document, at) : NULL;
    if (kind == 0) made = make(r, document);
    if (kind < 2)
        bat_object_with_parent(made ? made : before, any_parent(r, document), &after);
    else if (kind == 2)
        bat_object_with_name(before, "x", &after);
    if (kind < 3 && !after) after = bat_object_retain(made ? made : before);
    bat_object_release(made);
    bat_delta delta = {at, before ? bat_object_retain(before) : NULL, after};
    assert_int_equal(bat_delta_apply(&delta, document, true), BAT_OK);
    return delta;
}

static void local_and_whole_agree(void **state) {
    (void)state;
    int held = 0, broken = 0;
    for (uint64_t seed = 1; seed <= 200; seed++) {
        random_source r = {seed};
        bat_document *document = NULL;
        bat_document_create(&document);
        for (int step = 0; step < 200; step++) {
            bat_delta deltas[6];
            int count = 1 + below(&r, seed % 3 ? 1 : 6);
            for (int i = 0; i < count; i++) deltas[i] = change(&r, document);
            bool whole = !bat_document_check_nesting(document);
            assert_int_equal(bat_deltas_hold(deltas, count, document), whole);
            held += whole, broken += !whole;
            if (!whole) assert_int_equal(bat_deltas_apply(deltas, count, document, false), BAT_OK);
            for (int i = 0; i < count; i++) {
                bat_object_release(deltas[i].before);
                bat_object_release(deltas[i].after);
            }
            for (int i = 0; i < bat_document_count(document); i++)
                assert_true(bat_document_fits(document, i));
        }
        bat_document_free(document);
    }
    assert_true(held > 5000 && broken > 5000);
}

/* A row of groups, each in the one before; 64 are allowed, whatever is looked at. */
static void too_deep(void **state) {
    (void)state;
    bat_document *document = NULL;
    bat_document_create(&document);
    for (bat_id id = 1; id <= 66; id++) {
        bat_object *group = NULL, *placed = NULL;
        bat_object_create_group(id, "", false, &group);
        bat_object_with_parent(group, id - 1, &placed);
        bat_document_insert(document, (int)id - 1, placed);
        bat_object_release(group);
        bat_object_release(placed);
        assert_int_equal(bat_document_fits(document, (int)id - 1), id <= 64);
        assert_int_equal(!bat_document_check_nesting(document), id <= 64);
    }
    bat_document_free(document);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(local_and_whole_agree), cmocka_unit_test(too_deep)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
