/* label: slow. Long random sessions with everything that the editor can do, in which each call that allocates sees its
 * allocations fail: the invariants hold after each event, undo and redo lead to the same drawings, and nothing leaks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/alloc_paths.h"
#include "support/random_curve.h"
#include "support/rounds.h"
#include "support/wild.h"
#include "support/editing.h"

static void must_be_sound(const bat_editor *editor, uint64_t seed, size_t at) {
    const char *wrong = bat_editor_check(editor);
    if (wrong) fail_msg("session %d, byte %zu: %s", (int)seed, at, wrong);
}

/* Back as far as it goes and forth again, while memory is there. */
static void back_and_forth(bat_editor *editor, uint64_t seed) {
    while (bat_editor_command(editor, "redo") == BAT_OK) {
    }
    const uint64_t top = digest(editor);
    while (bat_editor_command(editor, "undo") == BAT_OK) must_be_sound(editor, seed, 0);
    while (bat_editor_command(editor, "redo") == BAT_OK) must_be_sound(editor, seed, 0);
    assert_true(digest(editor) == top);
}

static void short_of_memory(void **state) {
    (void)state;
    enum { SIZE = 3000, SESSIONS = ROUNDS_OF(60) };
    static uint8_t data[SIZE];
    int failed = 0;
    for (uint64_t seed = 1; seed <= SESSIONS; seed++) {
        random_source r = {seed * 7919};
        for (int i = 0; i < SIZE; i++) data[i] = (uint8_t)random_int(&r, 0, 255);
        const long held = alloc_live();
        session_bytes bytes = {data, SIZE, 0};
        bat_editor *editor = pen_editor();
        double time = 0;
        while (bytes.at < bytes.size) {
            const size_t at = bytes.at;
            alloc_fail_new(seed % 4 == 0); /* in every fourth session all that follow fail, too */
            wild_event(editor, &bytes, &time);
            failed += alloc_fail_reached();
            must_be_sound(editor, seed, at);
            if (random_int(&r, 0, 3) == 0) bat_editor_frame(editor);
        }
        wild_settle(editor);
        must_be_sound(editor, seed, SIZE);
        replays(editor, seed); /* what memory did not suffice for is not in the journal, either */
        back_and_forth(editor, seed);
        bat_editor_free(editor);
        assert_true(alloc_live() == held);
    }
    assert_true(failed > (FEWER ? 60 : 1000));
    print_message("%d events ran out of memory\n", failed);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(short_of_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
