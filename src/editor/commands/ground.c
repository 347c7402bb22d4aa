/* The commands that choose what the pen draws on. */
#include "document/document.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/commands.h"
#include "editor/tables/words.h"
#include "editor/view/stage.h"

/* The plane that comes after the ground in the drawing, or the first; what is hidden with its layer is left out. */
static const bat_object *next_plane(const bat_context *c) {
    const bat_document *document = c->session->document;
    const bat_object *first = NULL;
    int now = c->stage->ground.object ? bat_document_find(document, c->stage->ground.object) : -1;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        if (!bat_object_plane(object) || bat_document_level(document, i).hidden) continue;
        if (i > now) return object;
        if (!first) first = object;
    }
    return first;
}

bat_status bat_command_draw_on(bat_context *c, bat_command_id id) {
    if (id == BAT_COMMAND_DRAW_ON_PAGE) {
        if (!c->stage->ground.object) return BAT_STATE;
        c->stage->ground = bat_ground_page();
        bat_notice(c, BAT_STRING_NOTICE_ON_PAGE);
        return BAT_OK;
    }
    const bat_object *plane = next_plane(c);
    if (!plane) {
        bat_notice(c, BAT_STRING_NOTICE_NO_PLANE);
        return BAT_STATE;
    }
    const char *name = bat_object_name(plane);
    c->stage->ground = bat_ground_plane(bat_object_plane(plane), bat_object_id(plane));
    bat_notice_value(c, BAT_STRING_NOTICE_ON_PLANE, *name ? name : bat_word(c, BAT_STRING_KIND_PLANE));
    return BAT_OK;
}
