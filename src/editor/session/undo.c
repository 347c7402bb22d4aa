#include "editor/session/undo.h"
#include "editor/session/session.h"

bat_status bat_session_step(bat_context *c, bool back) {
    if (bat_session_refuses(c)) return BAT_STATE;
    bat_session *session = c->session;
    bat_status status = back ? bat_history_undo(&session->history, session->document)
                             : bat_history_redo(&session->history, session->document);
    if (status != BAT_OK) return status;
    bat_text line = {0};
    bat_text_string(&line, back ? "{\"do\":\"undo\"" : "{\"do\":\"redo\"");
    status = bat_session_log(session, &line, session->document);
    if (status != BAT_OK && back) bat_history_redo(&session->history, session->document);
    if (status != BAT_OK && !back) bat_history_undo(&session->history, session->document);
    session->revision++;
    return status;
}
