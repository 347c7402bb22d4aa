/* Bytes become a session of events of every kind. The invariants hold after each; undoing everything gives
 * the first document back, redoing the last. */
#include "demand.h"
#include "support/session.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { MOST = 30 }; /* bytes; long sessions are left to the tests, here many short ones matter */

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    session_bytes bytes = {data, size < MOST ? size : MOST, 0};
    bat_editor *editor = pen_editor();
    uint64_t first = digest(editor);
    double time = 0;
    while (bytes.at < bytes.size) {
        session_event(editor, &bytes, &time);
        const char *wrong = bat_editor_check(editor);
        demand(!wrong, wrong);
    }
    bat_editor_frame(editor);
    const bat_space *space = bat_editor_space(editor);
    demand(!space || space->count <= 2 * (uint32_t)bat_document_count(bat_editor_document(editor)),
           "too many buffers");
    demand(strlen(bat_space_constants()) > 0, "no constants");
    bat_editor_command(editor, "cancel");
    while (bat_editor_command(editor, "redo") == BAT_OK) {
    }
    uint64_t top = digest(editor);
    while (bat_editor_command(editor, "undo") == BAT_OK) {
    }
    demand(digest(editor) == first, "undoing everything does not give the first document");
    while (bat_editor_command(editor, "redo") == BAT_OK) {
    }
    demand(digest(editor) == top, "redoing everything does not give the last document");
    bat_editor_free(editor);
    return 0;
}
