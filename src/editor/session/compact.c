/* Compacts the journal: the document before the first step that can still be undone, then all steps. */
#include "editor/session/page.h"
#include "editor/session/record.h"
#include "editor/session/session.h"

static bat_status write_step(bat_session *session, const bat_step *step, bat_document *document) {
    bat_text line = {0};
    bat_status status = bat_step_apply(step, document, true);
    for (int i = 0; i < step->count && status == BAT_OK; i++)
        status = bat_session_keep_pictures(session, step->deltas[i].after);
    if (status != BAT_OK) return status;
    if (step->page)
        bat_page_write(&step->page->after, &line);
    else
        bat_change_write(step->deltas, step->count, (bat_string)step->label, &line);
    return bat_session_log(session, &line, document);
}

static bat_status write_undo(bat_session *session, const bat_step *step, bat_document *document) {
    bat_text line = {0};
    bat_status status = bat_step_apply(step, document, false);
    if (status != BAT_OK) return status;
    bat_text_string(&line, "{\"do\":\"undo\"");
    return bat_session_log(session, &line, document);
}

static bat_status write_losses(bat_session *session) {
    const bat_losses losses = session->losses;
    session->losses = (bat_losses){{0}};
    bat_status status = bat_session_set_losses(session, &losses);
    session->losses = losses;
    return status;
}

/* Writes the whole journal into the empty one. document: a copy, which ends up in the present state. */
static bat_status write_all(bat_session *session, bat_document *document) {
    const bat_history *history = &session->history;
    bat_status status = BAT_OK;
    for (int i = history->done - 1; i >= 0 && status == BAT_OK; i--) {
        status = bat_step_apply(&history->steps[i], document, false);
    }
    if (status == BAT_OK)
        status = bat_session_begin_journal(document, session->name, &session->journal, &session->pictures);
    if (status == BAT_OK) status = write_losses(session);
    if (status == BAT_OK && session->axis.on) status = bat_session_set_axis(session, &session->axis);
    for (int i = 0; i < history->count && status == BAT_OK; i++) {
        status = write_step(session, &history->steps[i], document);
    }
    for (int i = history->count - 1; i >= history->done && status == BAT_OK; i--) {
        status = write_undo(session, &history->steps[i], document);
    }
    return status;
}

bat_status bat_session_compact(bat_session *session) {
    if (session->transaction.open) return BAT_STATE;
    bat_document *document = NULL;
    bat_status status = bat_document_copy(session->document, &document);
    if (status != BAT_OK) return status;
    bat_journal journal = session->journal;
    bat_pictures pictures = session->pictures;
    session->journal = (bat_journal){0};
    session->pictures = (bat_pictures){0};
    status = write_all(session, document);
    if (status == BAT_OK) {
        bat_journal_free(&journal);
        bat_pictures_free(&pictures);
    } else {
        bat_journal_free(&session->journal);
        bat_pictures_free(&session->pictures);
        session->journal = journal;
        session->pictures = pictures;
    }
    bat_document_free(document);
    return status;
}
