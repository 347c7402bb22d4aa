/* The session's axis of symmetry: kept in the journal, since it is not part of the drawing. */
#include "editor/session/journal_line.h"
#include "editor/session/session.h"

bat_status bat_session_set_axis(bat_session *session, const bat_mirror *axis) {
    bat_text line = {0};
    if (axis->on && !bat_mirror_is_good(axis)) return BAT_NUMBER;
    bat_text_string(&line, "{\"axis\":");
    bat_line_numbers(&line, (double[]){axis->at[0], axis->at[1], axis->along[0], axis->along[1]},
                     axis->on ? 4 : 0, 1);
    bat_text_string(&line, "}");
    bat_status status = bat_journal_append(&session->journal, line.data, line.size, line.failed);
    bat_text_free(&line);
    if (status == BAT_OK) session->axis = *axis;
    return status;
}
