#include "editor/pick/stack.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/edit/arrange.h"
#include "editor/pick/pick.h"
#include "editor/scene/seen.h"
#include "editor/session/session.h"
#include <stdlib.h>

bat_status bat_stack_at(bat_context *c, const double point[2], double within, bool deep, bat_stack *out) {
    int *found = NULL, count = 0;
    bat_id last = 0;
    *out = (bat_stack){0};
    bat_seen_sync(c);
    bat_status status = bat_pick_all(c->scene, point, within, &found, &count);
    for (int i = 0; i < count && status == BAT_OK; i++) {
        const int index = deep ? found[i] : bat_arrange_whole(c, found[i]);
        const bat_id id = bat_object_id(bat_document_at(c->session->document, index));
        if (id == last) continue;
        last = id;
        if (!out->front) out->front = id;
        if (bat_selection_has(&c->choice->selection, id))
            out->selected = id, out->below = 0;
        else if (out->selected && !out->below)
            out->below = id;
    }
    if (!out->below) out->below = out->front;
    free(found);
    return status;
}
