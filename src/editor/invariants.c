/* What must hold after every event, whatever came in. */
#include "editor/editor.h"
#include <math.h>

static const char *check_view(const bat_view *view) {
    if (!(view->zoom >= BAT_ZOOM_MIN && view->zoom <= BAT_ZOOM_MAX)) return "the zoom is out of its limits";
    if (!(fabs(view->x) <= BAT_VIEW_REACH && fabs(view->y) <= BAT_VIEW_REACH))
        return "the view is out of reach";
    if (!(view->angle > -180 && view->angle <= 180) ||
        !(fabs(view->cosine * view->cosine + view->sine * view->sine - 1) < 1e-12))
        return "the view's angle is out of range";
    if (!(view->width >= 0 && view->width <= BAT_PIXELS_MAX && view->height >= 0 &&
          view->height <= BAT_PIXELS_MAX))
        return "the window's size is out of range";
    return NULL;
}

static const char *check_scene(const bat_context *c) {
    const bat_scene *scene = c->scene;
    if (scene->revision != c->session->revision || scene->stale) return NULL; /* due for the next sync */
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
    for (int i = 0; i < contacts->count; i++)
        for (int j = 0; j < i; j++)
            if (contacts->list[i].id == contacts->list[j].id &&
                contacts->list[i].device == contacts->list[j].device)
                return "a contact is there twice";
    return NULL;
}

const char *bat_editor_check(const bat_editor *editor) {
    const bat_context *c = &editor->context;
    const char *wrong = bat_document_check(c->session->document);
    if (!wrong) wrong = check_view(c->view);
    if (!wrong) wrong = check_scene(c);
    if (!wrong) wrong = check_contacts(&c->input->contacts);
    if (wrong) return wrong;
    const bat_history *history = &c->session->history;
    if (history->done < 0 || history->done > history->count || history->count > BAT_HISTORY_STEPS)
        return "the history is out of step";
    if (!c->session->transaction.open && !bat_selection_holds(&c->choice->selection, c->session->document))
        return "the selection has objects that are not in the document";
    if (c->session->transaction.open && !bat_toolbox_busy(c))
        return "a transaction is open and nobody holds it";
    for (int i = 0; i < BAT_PROPERTY_COUNT; i++) {
        const bat_property_row *row = bat_property_at((bat_property_id)i);
        if (!(c->settings->values[i] >= row->low && c->settings->values[i] <= row->high))
            return "a property is out of its range";
    }
    if (!c->session->journal.size || c->session->journal.text[c->session->journal.size - 1] != '\n')
        return "the journal does not end with a line";
    const bat_slot *tool = bat_toolbox_tool(c);
    return tool->is->check ? tool->is->check(c, tool->state) : NULL;
}
