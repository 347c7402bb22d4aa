/* The commands that choose what the pen draws on. */
#include "document/document.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/commands.h"
#include "editor/tables/words.h"
#include "editor/view/stage.h"

/* The next object in the drawing, after the present ground, that can be drawn on, or the first; none in a hidden
 * layer. */
static const bat_object *next_ground(const bat_context *c, bat_ground *out) {
    const bat_document *document = c->session->document;
    int now = c->stage->ground.object ? bat_document_find(document, c->stage->ground.object) : -1;
    int count = bat_document_count(document);
    for (int i = 1; i <= count; i++) {
        int at = (now + i) % count;
        const bat_object *object = bat_document_at(document, at);
        if (!bat_document_level(document, at).hidden && bat_ground_of(object, out)) return object;
    }
    return NULL;
}

bat_status bat_command_draw_on(bat_context *c, bat_command_id id) {
    if (id == BAT_COMMAND_DRAW_ON_PAGE) {
        if (!c->stage->ground.object) return BAT_STATE;
        c->stage->ground = bat_ground_page();
        bat_notice(c, BAT_STRING_NOTICE_ON_PAGE);
        return BAT_OK;
    }
    const bat_object *ground = next_ground(c, &c->stage->ground);
    if (!ground) {
        bat_notice(c, BAT_STRING_NOTICE_NO_PLANE);
        return BAT_STATE;
    }
    const char *name = bat_object_name(ground);
    bat_notice_value(c, BAT_STRING_NOTICE_ON_PLANE, *name ? name : bat_word(c, BAT_STRING_A_PLANE));
    return BAT_OK;
}
