/* Sessions: opening, logging, freeing. */
#include <batten/bezier.h>
#include "editor/session/session.h"
#include "editor/session/journal_line.h"
#include "editor/session/notice.h"
#include "format/native/native.h"
#include <stdlib.h>
#include <string.h>

/* The journal's first line: the document at the time the journal begins. JSON may contain line breaks, but a journal
 * entry may not; outside strings a line break can be replaced by a space. */
static bat_status write_head(const bat_document *document, const char *name, bat_journal *journal) {
    bat_text line = {.packed = true};
    bat_text_string(&line, "{\"journal\":\"batten\",\"version\":1,\"name\":");
    bat_text_json_string(&line, name);
    bat_text_string(&line, ",\"digest\":");
    bat_line_digest(&line, bat_document_digest(document));
    bat_text_string(&line, ",\"document\":");
    const size_t from = line.size;
    bat_document_to_json(document, true, &line);
    for (size_t i = from; i < line.size; i++)
        if (line.data[i] == '\n' || line.data[i] == '\r') line.data[i] = ' ';
    while (line.size > from && line.data[line.size - 1] == ' ') line.size--;
    bat_text_string(&line, "}");
    const bat_status status = bat_journal_append(journal, line.data, line.size, line.failed);
    bat_text_free(&line);
    return status;
}

bat_status bat_session_begin_journal(const bat_document *document, const char *name, bat_journal *journal,
                                     bat_pictures *pictures) {
    bat_status status = write_head(document, name, journal);
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++)
        for (int k = 0; k < BAT_OBJECT_PICTURES && status == BAT_OK; k++) {
            const bat_picture *picture = bat_object_picture_at(bat_document_at(document, i), k);
            if (picture) status = bat_pictures_add(pictures, picture);
        }
    return status;
}

bat_status bat_session_log(bat_session *session, bat_text *line, const bat_document *document) {
    bat_text_string(line, ",\"digest\":");
    bat_line_digest(line, bat_document_digest(document));
    bat_text_string(line, "}");
    bat_status status = bat_journal_append(&session->journal, line->data, line->size, line->failed);
    bat_text_free(line);
    return status;
}

bat_status bat_session_keep_picture(bat_session *session, const bat_picture *picture) {
    int before = session->pictures.count;
    bat_status status = bat_pictures_add(&session->pictures, picture);
    if (status != BAT_OK || session->pictures.count == before) return status;
    bat_text line = {0};
    bat_picture_to_json(picture, &line);
    status = bat_journal_append(&session->journal, line.data, line.size, line.failed);
    bat_text_free(&line);
    if (status != BAT_OK) bat_pictures_drop(&session->pictures);
    return status;
}

bat_status bat_session_keep_pictures(bat_session *session, const bat_object *object) {
    bat_status status = BAT_OK;
    for (int k = 0; k < BAT_OBJECT_PICTURES && object && status == BAT_OK; k++) {
        const bat_picture *picture = bat_object_picture_at(object, k);
        if (picture) status = bat_session_keep_picture(session, picture);
    }
    return status;
}

static bat_status log_losses(bat_session *session, const bat_losses *losses) {
    bat_text line = {0};
    bat_text_string(&line, "{\"lost\":");
    bat_losses_to_json(losses, &line);
    bat_text_string(&line, "}");
    bat_status status = bat_journal_append(&session->journal, line.data, line.size, line.failed);
    bat_text_free(&line);
    return status;
}

bat_status bat_session_set_losses(bat_session *session, const bat_losses *losses) {
    static const bat_losses none = {{0}};
    if (!losses) losses = &none;
    for (int i = 0; i < BAT_LOSS_COUNT; i++)
        if (losses->count[i] < 0) return BAT_ARGUMENT;
    if (memcmp(losses, &session->losses, sizeof *losses) == 0) return BAT_OK;
    bat_status status = log_losses(session, losses);
    if (status == BAT_OK) session->losses = *losses;
    return status;
}

bat_status bat_session_open(bat_session *session, bat_document *document, const char *name) {
    char *own_name = malloc(strlen(name) + 1);
    bat_journal journal = {0};
    bat_pictures pictures = {0};
    bat_status status = own_name ? bat_session_begin_journal(document, name, &journal, &pictures)
                                 : BAT_MEMORY;
    if (status != BAT_OK) {
        free(own_name);
        bat_journal_free(&journal);
        bat_pictures_free(&pictures);
        return status;
    }
    strcpy(own_name, name);
    bat_session_free(session);
    session->document = document;
    session->name = own_name;
    session->journal = journal;
    session->pictures = pictures;
    session->losses = (bat_losses){{0}};
    session->axis = (bat_mirror){0};
    session->revision++;
    session->saved_state = session->history.state;
    session->asked = false;
    return BAT_OK;
}

void bat_session_free(bat_session *session) {
    bat_history_clear(&session->history);
    bat_journal_free(&session->journal);
    bat_pictures_free(&session->pictures);
    bat_document_free(session->document);
    free(session->name);
    session->document = NULL;
    session->name = NULL;
}

bool bat_session_refuses(bat_context *c) {
    if (c->session->read_only) bat_notice(c, BAT_STRING_NOTICE_READ_ONLY);
    c->session->refused = c->session->read_only;
    return c->session->read_only;
}
