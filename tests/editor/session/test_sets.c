/* The small sets that a session keeps, against plain arrays: the selection, filled one by one and many at once, and the
 * objects that a transaction has replaced. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "editor/choice/selection.h"
#include "editor/session/replaced.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { IDS = 60 };

static void check_selection(const bat_selection *selection, const bool *in) {
    int count = 0;
    for (int i = 0; i < IDS; i++) {
        assert_int_equal(bat_selection_has(selection, (bat_id)i + 1), in[i]);
        count += in[i];
    }
    assert_int_equal(selection->count, count);
    for (int i = 1; i < count; i++) assert_true(selection->ids[i - 1] < selection->ids[i]);
}

static void one_by_one_and_many_at_once(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= 50; seed++) {
        random_source r = {seed};
        bat_selection selection = {0};
        bool in[IDS] = {false};
        for (int step = 0; step < 60; step++) {
            int many = step % 3 == 2 ? (int)(random_unit(&r) * 20) : 0;
            int id = (int)(random_unit(&r) * IDS);
            uint32_t version = selection.version;
            bool before = in[id];
            if (step % 3 == 0) {
                assert_int_equal(bat_selection_add(&selection, (bat_id)id + 1), BAT_OK);
                assert_int_equal(selection.version != version, !before);
                in[id] = true;
            } else if (step % 3 == 1) {
                bat_selection_remove(&selection, (bat_id)id + 1);
                assert_int_equal(selection.version != version, before);
                in[id] = false;
            }
            bool more = false;
            for (int i = 0; i < many; i++) {
                id = (int)(random_unit(&r) * IDS);
                assert_int_equal(bat_selection_append(&selection, (bat_id)id + 1), BAT_OK);
                more = more || !in[id];
                in[id] = true;
            }
            if (many) {
                bat_selection_sort(&selection);
                assert_int_equal(selection.version != version, more);
            }
            check_selection(&selection, in);
        }
        bat_selection_free(&selection);
    }
}

static void selection_without_memory(void **state) {
    (void)state;
    bat_selection selection = {0};
    for (bat_id id = 16; id > 0; id--) assert_int_equal(bat_selection_append(&selection, id), BAT_OK);
    alloc_fail_at(1);
    assert_int_equal(bat_selection_append(&selection, 17), BAT_MEMORY);
    assert_true(alloc_fail_reached());
    bat_selection_sort(&selection);
    assert_int_equal(selection.count, 16);
    for (int i = 0; i < 16; i++) assert_true(selection.ids[i] == (bat_id)i + 1);
    bat_selection_free(&selection);
}

static void replaced_as_an_array(void **state) {
    (void)state;
    enum { MOST = 3000 };
    static int number[MOST];
    for (uint64_t seed = 1; seed <= 20; seed++) {
        random_source r = {seed};
        bat_replaced replaced = {0};
        int count = 0, stride = 1 << seed % 12;
        for (int i = 0; i < MOST; i++) number[i] = -1;
        while (count < (int)seed * 100) {
            int index = (int)(random_unit(&r) * MOST);
            assert_int_equal(bat_replaced_find(&replaced, index * stride), number[index]);
            if (number[index] >= 0) continue;
            alloc_fail_at(1);
            bat_status status = bat_replaced_reserve(&replaced);
            if (alloc_fail_reached()) {
                assert_int_equal(status, BAT_MEMORY);
                status = bat_replaced_reserve(&replaced);
            }
            assert_int_equal(status, BAT_OK);
            bat_replaced_add(&replaced, index * stride, count);
            number[index] = count++;
        }
        for (int i = 0; i < MOST; i++) assert_int_equal(bat_replaced_find(&replaced, i * stride), number[i]);
        bat_replaced_clear(&replaced);
        assert_int_equal(bat_replaced_find(&replaced, 0), -1);
        bat_replaced_clear(&replaced);
    }
    assert_int_equal(alloc_live(), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_by_one_and_many_at_once),
                                       cmocka_unit_test(selection_without_memory),
                                       cmocka_unit_test(replaced_as_an_array)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
