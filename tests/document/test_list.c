/* The document's list against a plain array: order, search by id, digest; also when allocations fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "document/document.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { MOST = 300 };

typedef struct model {
    bat_id ids[MOST];
    int count;
} model;

static bat_object *group(bat_id id, const char *name) {
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_group(id, name, false, &object), BAT_OK);
    return object;
}

static int random_below(random_source *r, int limit) { return (int)(random_unit(r) * limit); }

static void put(bat_document *document, int index, bat_id id) {
    bat_object *object = group(id, "");
    assert_int_equal(bat_document_insert(document, index, object), BAT_OK);
    bat_object_release(object);
}

/* Made from nothing by another way: from the front to the back, and the other way round. */
static void check(const bat_document *document, const model *m) {
    assert_int_equal(bat_document_count(document), m->count);
    assert_null(bat_document_check(document));
    bat_document *forth = NULL, *back = NULL;
    bat_document_create(&forth);
    bat_document_create(&back);
    for (int i = 0; i < m->count; i++) {
        assert_true(bat_object_id(bat_document_at(document, i)) == m->ids[i]);
        assert_int_equal(bat_document_find(document, m->ids[i]), i);
        put(forth, i, m->ids[i]);
        put(back, 0, m->ids[m->count - 1 - i]);
    }
    assert_null(bat_document_at(document, -1));
    assert_null(bat_document_at(document, m->count));
    assert_int_equal(bat_document_find(document, 0), -1);
    assert_true(bat_document_digest(forth) == bat_document_digest(document));
    assert_true(bat_document_digest(back) == bat_document_digest(document));
    bat_document_free(forth);
    bat_document_free(back);
}

static void insert_at(bat_document *document, model *m, int at, bat_id id) {
    put(document, at, id);
    memmove(m->ids + at + 1, m->ids + at, (size_t)(m->count - at) * sizeof *m->ids);
    m->ids[at] = id;
    m->count++;
}

static void remove_at(bat_document *document, model *m, int at) {
    bat_id id = m->ids[at];
    assert_int_equal(bat_document_remove(document, at), BAT_OK);
    assert_int_equal(bat_document_find(document, id), -1);
    m->count--;
    memmove(m->ids + at, m->ids + at + 1, (size_t)(m->count - at) * sizeof *m->ids);
}

static void as_a_plain_array(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= 30; seed++) {
        random_source r = {seed};
        bat_document *document = NULL;
        model m = {.count = 0};
        bat_document_create(&document);
        for (int step = 0; step < 400; step++) {
            bool grow = m.count < MOST && random_unit(&r) < (seed % 2 ? 0.6 : 0.5);
            /* Ids in order, or far apart and in any. */
            bat_id id = seed % 3 ? bat_document_new_id(document) : (bat_id)(random_unit(&r) * 2e9) + 1;
            if (bat_document_find(document, id) >= 0) continue;
            if (grow)
                insert_at(document, &m, random_below(&r, m.count + 1), id);
            else if (m.count)
                remove_at(document, &m, random_below(&r, m.count));
            if (step % 40 == 0) check(document, &m);
        }
        check(document, &m);
        while (m.count) remove_at(document, &m, seed % 2 ? m.count - 1 : 0);
        check(document, &m);
        bat_document_free(document);
    }
}

/* Ids that meet in the table: multiples of a power of two; all found while any are taken away. */
static void crowded_ids(void **state) {
    (void)state;
    for (int shift = 1; shift < 26; shift += 3) {
        random_source r = {(uint64_t)shift};
        bat_document *document = NULL;
        model m = {.count = 0};
        bat_document_create(&document);
        for (int i = 1; i <= 60; i++) insert_at(document, &m, 0, (bat_id)i << shift);
        while (m.count) {
            remove_at(document, &m, random_below(&r, m.count));
            for (int i = 0; i < m.count; i++) assert_int_equal(bat_document_find(document, m.ids[i]), i);
        }
        bat_document_free(document);
    }
}

/* Every order of four has a digest of its own; so has every replaced object. */
static void digest_tells_orders_apart(void **state) {
    (void)state;
    uint64_t seen[25];
    int count = 0;
    for (int code = 0; code < 256; code++) {
        int order[4] = {code & 3, code >> 2 & 3, code >> 4 & 3, code >> 6};
        bool used[4] = {false}, good = true;
        for (int i = 0; i < 4; i++) good = good && !used[order[i]], used[order[i]] = true;
        if (!good) continue;
        bat_document *document = NULL;
        bat_document_create(&document);
        for (int i = 0; i < 4; i++) put(document, i, (bat_id)order[i] + 1);
        seen[count++] = bat_document_digest(document);
        if (count == 24) {
            bat_object *other = group(bat_object_id(bat_document_at(document, 2)), "x");
            assert_int_equal(bat_document_replace(document, 2, other), BAT_OK);
            seen[count++] = bat_document_digest(document);
            bat_object_release(other);
        }
        bat_document_free(document);
    }
    assert_int_equal(count, 25);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < i; k++) assert_true(seen[i] != seen[k]);
}

static void copies_are_whole(void **state) {
    (void)state;
    random_source r = {5};
    bat_document *document = NULL, *copy = NULL;
    model m = {.count = 0};
    bat_document_create(&document);
    for (int i = 0; i < 50; i++)
        insert_at(document, &m, random_below(&r, m.count + 1), bat_document_new_id(document));
    remove_at(document, &m, 20); /* the gap is in the middle */
    assert_int_equal(bat_document_copy(document, &copy), BAT_OK);
    bat_document_free(document);
    check(copy, &m);
    bat_document_free(copy);
}

static void memory_fails(void **state) {
    (void)state;
    long live = alloc_live();
    bat_document *document = NULL;
    bat_object *list[20];
    bat_document_create(&document);
    for (int i = 0; i < 20; i++) list[i] = group((bat_id)i + 1, "");
    for (int i = 0; i < 20; i++) {
        bat_status status = BAT_MEMORY;
        for (int n = 1; status == BAT_MEMORY; n++) {
            alloc_fail_at(n);
            status = bat_document_insert(document, i / 2, list[i]);
            bool failed = alloc_fail_reached();
            assert_int_equal(status, failed ? BAT_MEMORY : BAT_OK);
            assert_int_equal(bat_document_count(document), failed ? i : i + 1);
            assert_null(bat_document_check(document));
        }
    }
    for (int i = 0; i < 20; i++) assert_int_equal(bat_document_remove(document, 0), BAT_OK);
    for (int i = 0; i < 20; i++) { /* it keeps the room it had */
        alloc_fail_at(1);
        assert_int_equal(bat_document_insert(document, 0, list[i]), BAT_OK);
        alloc_fail_reached();
    }
    for (int i = 0; i < 20; i++) bat_object_release(list[i]);
    bat_document_free(document);
    assert_int_equal(alloc_live(), live);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(as_a_plain_array), cmocka_unit_test(crowded_ids),
                                       cmocka_unit_test(digest_tells_orders_apart),
                                       cmocka_unit_test(copies_are_whole), cmocka_unit_test(memory_fails)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
