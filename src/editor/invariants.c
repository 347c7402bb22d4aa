/* The invariants that must hold after every event, whatever the input. */
#include "editor/invariants.h"

#include "document/document.h"
#include "editor/editor.h"
#include <math.h>

static const char *check_view(const bat_stage *stage) {
    if (!(stage->view.zoom >= BAT_ZOOM_MIN && stage->view.zoom <= BAT_ZOOM_MAX))
        return "the zoom is out of its limits";
    if (!(fabs(stage->view.x) <= BAT_VIEW_REACH && fabs(stage->view.y) <= BAT_VIEW_REACH))
        return "the view is out of reach";
    if (!(stage->view.angle > -180 && stage->view.angle <= 180) ||
        !(fabs(stage->view.cosine * stage->view.cosine + stage->view.sine * stage->view.sine - 1) < 1e-12))
        return "the view's angle is out of range";
    const double cosine = stage->view.tilt_cosine, sine = stage->view.tilt_sine;
    if (!(stage->view.tilt >= 0 && stage->view.tilt <= 180) ||
        !(fabs(cosine * cosine + sine * sine - 1) < 1e-12))
        return "the view's tilt is out of range";
    if (!(stage->view.width >= 0 && stage->view.width <= BAT_PIXELS_MAX && stage->view.height >= 0 &&
          stage->view.height <= BAT_PIXELS_MAX))
        return "the window's size is out of range";
    return NULL;
}

static const char *check_scene(const bat_context *c) {
    const bat_scene *scene = c->scene;
    if (scene->revision != c->session->revision || scene->stale) return NULL; /* waits for the next sync */
    if (scene->count != bat_document_count(c->session->document))
        return "the scene has another number of objects";
    for (int i = 0; i < scene->count; i++) {
        const bat_scene_entry *entry = &scene->entries[i];
        if (entry->object != bat_document_at(c->session->document, i))
            return "the scene shows another object";
        if (entry->item.path_count && !entry->path) return "an item has no path";
    }
    return NULL;
}

static const char *check_contacts(const bat_contacts *contacts) {
    if (bat_contacts_count(contacts, BAT_DUTY_TOOL, NULL) > 1) return "two contacts drive the tool";
    if (bat_contacts_count(contacts, BAT_DUTY_NAVIGATE, NULL) > 2) return "more than two contacts navigate";
    if (bat_contacts_count(contacts, BAT_DUTY_ORBIT, NULL) > 3)
        return "more than three contacts turn the view";
    for (int i = 0; i < contacts->count; i++)
        for (int j = 0; j < i; j++)
            if (contacts->list[i].id == contacts->list[j].id &&
                contacts->list[i].device == contacts->list[j].device)
                return "a contact is there twice";
    return NULL;
}

static const char *check_deltas(const bat_delta *deltas, int count) {
    const char *wrong = NULL;
    for (int i = 0; i < count && !wrong; i++)
        if (deltas[i].after) wrong = bat_object_check(deltas[i].after);
    return wrong;
}

/* Checks the objects of the steps made since, and of the change under way. */
static const char *check_steps(const bat_session *session, uint64_t states) {
    const bat_history *history = &session->history;
    const char *wrong = check_deltas(session->transaction.deltas, session->transaction.count);
    for (int i = history->count; i > 0 && history->steps[i - 1].after > states && !wrong; i--)
        wrong = check_deltas(history->steps[i - 1].deltas, history->steps[i - 1].count);
    return wrong;
}

static const char *check_session(const bat_session *session) {
    const bat_history *history = &session->history;
    if (history->done < 0 || history->done > history->count || history->count > BAT_HISTORY_ROOM)
        return "the history is out of step";
    if (!session->journal.size || session->journal.text[session->journal.size - 1] != '\n')
        return "the journal does not end with a line";
    return NULL;
}

static const char *check_settings(const bat_settings *settings) {
    for (int i = 0; i < BAT_PROPERTY_COUNT; i++) {
        const bat_property_row *row = bat_property_at((bat_property_id)i);
        if (!(settings->values[i] >= row->low && settings->values[i] <= row->high))
            return "a property is out of its range";
    }
    return NULL;
}

const char *bat_editor_check_since(const bat_editor *editor, bat_checked *checked, bool whole) {
    const bat_context *c = &editor->context;
    const bat_session *session = c->session;
    const bat_selection *selection = &c->choice->selection;
    const bat_checked before = *checked;
    *checked = (bat_checked){session->history.states, session->revision, c->scene->still_version,
                             selection->version};
    bool changed = whole || session->revision != before.revision;
    const char *wrong = whole     ? bat_document_check(session->document)
                        : changed ? check_steps(session, before.states)
                                  : NULL;
    if (!wrong) wrong = check_view(c->stage);
    if (!wrong && (whole || c->scene->still_version != before.still)) wrong = check_scene(c);
    if (!wrong) wrong = check_contacts(&c->input->contacts);
    if (!wrong) wrong = check_session(session);
    if (!wrong) wrong = check_settings(c->settings);
    if (wrong) return wrong;
    bool chosen_anew = changed || selection->version != before.selection;
    if (chosen_anew && !session->transaction.open && !bat_selection_holds(selection, session->document))
        return "the selection has objects that are not in the document";
    if (session->transaction.open && !bat_toolbox_busy(c)) return "a transaction is open and nobody holds it";
    const bat_slot *tool = bat_toolbox_tool(c);
    return tool->is->check ? tool->is->check(c, tool->state) : NULL;
}

const char *bat_editor_check(const bat_editor *editor) {
    return bat_editor_check_since(editor, &(bat_checked){0}, true);
}
