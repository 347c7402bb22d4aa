#include "editor/choice/writing.h"

#include "document/lettering.h"
#include "editor/choice/choice.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"

#include <string.h>

const bat_object *bat_writing_text(const bat_context *c, bat_id id) {
    const int index = id ? bat_document_find(c->session->document, id) : -1;
    const bat_object *object = index < 0 ? NULL : bat_document_at(c->session->document, index);
    return object && (bat_object_lettering(object) || bat_object_is_foreign(object)) ? object : NULL;
}

void bat_writing_ask(bat_context *c, bat_id id, const double at[2]) {
    bat_writing *writing = &c->choice->writing;
    *writing = (bat_writing){.id = id};
    if (!id) memcpy(writing->at, at, sizeof writing->at);
    c->notices->requests |= BAT_ASK_TEXT;
}

bat_status bat_command_text_edit(bat_context *c, bat_command_id id) {
    const bat_selection *selection = &c->choice->selection;
    (void)id;
    if (selection->count != 1 || !bat_writing_text(c, selection->ids[0])) return BAT_STATE;
    bat_writing_ask(c, selection->ids[0], NULL);
    return BAT_OK;
}
