/* label: slow. Every command and every other call that hosts make, in every scene: each call that allocates sees its
 * allocations fail. The editor stays sound; after a command the drawing is the one before or the one after; and nothing
 * leaks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/alloc_paths.h"
#include "editor/tables/tables.h"
#include "growth/acts.c"
#include "growth/scenes.c"
#include "support/editing.h"

enum { THINGS = 6 };

static void command(bat_editor *editor, int which) {
    bat_editor_command(editor, bat_command_at((bat_command_id)which)->name);
    bat_editor_frame(editor);
}

static void act(bat_editor *editor, int which) { growth_acts[which].perform(editor); }

/* Performs it with memory, and then again until every call has seen its allocations fail. */
static void fail_each(const growth_scene *scene, const char *name, void (*perform)(bat_editor *, int),
                      int which) {
    const long held = alloc_live();
    bat_editor *editor = scene->make(THINGS);
    const uint64_t before = digest(editor);
    perform(editor, which);
    const uint64_t after = digest(editor);
    bat_editor_free(editor);
    for (bool again = true; again;) {
        editor = scene->make(THINGS);
        alloc_fail_new(false);
        perform(editor, which);
        again = alloc_fail_reached();
        const char *wrong = bat_editor_check(editor);
        if (wrong) fail_msg("%s, %s: %s", scene->name, name, wrong);
        const uint64_t now = digest(editor);
        if (perform == command && now != before && now != after)
            fail_msg("%s, %s: neither before nor after", scene->name, name);
        if (!again && now != after) fail_msg("%s, %s: not done", scene->name, name);
        bat_editor_frame(editor); /* what could not be shown is shown now */
        assert_null(bat_editor_check(editor));
        bat_editor_free(editor);
        assert_true(alloc_live() == held);
    }
}

static void commands(void **state) {
    (void)state;
    for (const growth_scene *scene = growth_scenes; scene->name; scene++)
        for (int i = 0; i < BAT_COMMAND_COUNT; i++)
            fail_each(scene, bat_command_at((bat_command_id)i)->name, command, i);
    assert_true(alloc_known_count > 2000);
}

static void acts(void **state) {
    (void)state;
    for (const growth_scene *scene = growth_scenes; scene->name; scene++)
        for (int i = 0; growth_acts[i].name; i++) {
            const char *name = growth_acts[i].name;
            /* What stops the program when it fails. */
            if (!strcmp(name, "pasted") || !strcmp(name, "replayed")) continue;
            fail_each(scene, name, act, i);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(commands), cmocka_unit_test(acts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
