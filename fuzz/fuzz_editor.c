/* Bytes become a session with everything that the editor can do. The invariants hold after each event; the
 * journal replays to the same drawing; undoing everything gives the first drawing back, redoing the last. */
#include "demand.h"
#include "support/wild.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { MOST = 40 }; /* bytes; long sessions are left to the tests, here many short ones matter */

static void replays(const bat_editor *editor) {
    bat_editor *again = NULL;
    bat_problem problem = {"", ""};
    size_t size = 0;
    const char *text = bat_editor_journal(editor, &size);
    demand(bat_editor_create(&again) == BAT_OK, "no memory");
    bool replayed = bat_editor_replay(again, text, size, true, &problem) == BAT_OK;
    if (!replayed) fprintf(stderr, "%s: %s\n", problem.place, problem.message);
    demand(replayed && digest(again) == digest(editor), "the journal does not replay");
    bat_editor_free(again);
}

/* Every part of the drawing can be had as a document, which is whole; only a selection may be missing. */
static void comes_apart(const bat_editor *editor) {
    for (int part = BAT_EXCERPT_PAGE; part <= BAT_EXCERPT_SELECTION; part++) {
        bat_document *made = NULL;
        const bat_status status = bat_editor_excerpt(editor, (bat_excerpt)part, &made);
        demand(status == BAT_OK || (part == BAT_EXCERPT_SELECTION && status == BAT_STATE), "no excerpt");
        demand(status != BAT_OK || !bat_document_check(made), "the excerpt is not whole");
        bat_document_free(made);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    session_bytes bytes = {data, size < MOST ? size : MOST, 0};
    bat_editor *editor = pen_editor();
    uint64_t first = digest(editor);
    double time = 0;
    while (bytes.at < bytes.size) {
        wild_event(editor, &bytes, &time);
        bat_editor_glide(editor, (double)(bytes.at % 5) / 4);
        const char *wrong = bat_editor_check(editor);
        demand(!wrong, wrong);
    }
    wild_settle(editor);
    replays(editor);
    comes_apart(editor);
    while (bat_editor_command(editor, "redo") == BAT_OK) {
    }
    uint64_t top = digest(editor);
    int steps = 0;
    while (bat_editor_command(editor, "undo") == BAT_OK) steps++;
    /* A shortened journal keeps 250 undo steps. */
    demand(steps >= 250 || digest(editor) == first, "undoing everything does not give the first drawing");
    while (bat_editor_command(editor, "redo") == BAT_OK) {
    }
    demand(*bat_editor_problem(editor)->message, "what is refused does not say why");
    demand(digest(editor) == top, "redoing everything does not give the last drawing");
    bat_editor_free(editor);
    return 0;
}
