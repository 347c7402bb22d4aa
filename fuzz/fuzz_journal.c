/* Any text as a journal: a status, never a crash; what was replayed leaves a valid editor, whose own journal
 * replays to the same document. */
#include "demand.h"
#include <batten/batten.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { MOST = 1000 }; /* bytes; long journals are left to the tests, here many short ones matter */

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bat_editor *editor = NULL, *again = NULL;
    bat_problem problem = {"", ""};
    if (size > MOST) return 0;
    if (bat_editor_create(&editor) != BAT_OK) return 0;
    bat_status status = bat_editor_replay(editor, (const char *)data, size, true, &problem);
    demand(status == BAT_OK || problem.message[0], "a failure without a reason");
    if (status == BAT_OK) bat_editor_replay_line(editor, (const char *)data, size, &problem);
    const char *wrong = bat_editor_check(editor);
    demand(!wrong, wrong);
    bat_editor_frame(editor);
    size_t length = 0;
    const char *text = bat_editor_journal(editor, &length);
    demand(bat_editor_create(&again) == BAT_OK, "no editor");
    status = bat_editor_replay(again, text, length, true, &problem);
    if (status != BAT_OK) fprintf(stderr, "%s: %s\n", problem.place, problem.message);
    demand(status == BAT_OK, "its own journal does not replay");
    int left_out = 0;
    status = bat_editor_salvage(again, (const char *)data, size, &left_out);
    wrong = bat_editor_check(again);
    demand(!wrong, wrong);
    demand(status == BAT_OK || left_out == 0, "lines were left out of nothing");
    bat_editor_free(again);
    bat_editor_free(editor);
    return 0;
}
