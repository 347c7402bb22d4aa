/* The chosen curve and its levels: finding them, and changing them in undo steps. */
#include "editor/edit/curves_of.h"
#include "curve/curve.h"
#include "editor/tools/levels/state.h"
#include "document/digest.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/edit/stroke.h"
#include "editor/scene/seen.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include <batten/relief.h>
#include <stdlib.h>

bat_leveling *bat_leveling_of(const bat_context *c) { return bat_toolbox_that(c, BAT_EDITS_LEVELS)->state; }

void bat_leveling_free(bat_leveling *l) {
    bat_ladder_free(&l->base);
    bat_shape_live_cancel(l->live);
    bat_relief_free(l->carved);
    bat_ladder_free(&l->apart);
    free(l->strip);
    *l = (bat_leveling){.chosen = -1, .version = l->version};
}

const bat_object *bat_leveling_solid(const bat_context *c) {
    const bat_leveling *l = bat_leveling_of(c);
    const bat_document *document = c->session->document;
    const bat_object *object = l->object ? bat_document_at(document, bat_document_find(document, l->object))
                                         : NULL;
    return object && bat_object_surface(object) ? object : NULL;
}

const bat_relief *bat_leveling_relief(const bat_context *c) {
    const bat_object *object = bat_leveling_solid(c);
    return object ? bat_object_relief(object) : NULL;
}

bat_ladder bat_leveling_ladder(const bat_context *c) {
    return (bat_ladder){bat_leveling_shape(c), bat_leveling_relief(c)};
}

const bat_curve *bat_leveling_curve(const bat_context *c) {
    const bat_leveling *l = bat_leveling_of(c);
    return l->object && !bat_leveling_solid(c)
               ? bat_edit_target_in(c->session->document, 0, l->object, l->curve)
               : NULL;
}

const bat_shape *bat_leveling_shape(const bat_context *c) {
    const bat_leveling *l = bat_leveling_of(c);
    if (!bat_leveling_curve(c)) return NULL;
    return bat_object_shape(
        bat_document_at(c->session->document, bat_document_find(c->session->document, l->object)), l->curve);
}

void bat_leveling_settle(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    const bat_selection *selection = &c->choice->selection;
    if (selection->count == 1 && selection->ids[0] != l->adopted) {
        if (l->object != selection->ids[0] || l->curve != 0) l->pin_count = 0;
        l->object = l->adopted = selection->ids[0];
        l->curve = 0;
        l->chosen = -1;
    }
    int at = bat_document_find(c->session->document, l->object);
    if ((!bat_leveling_curve(c) && !bat_leveling_solid(c)) || bat_seen_out_of_reach(c, at)) {
        l->object = 0;
        l->copying = false;
        l->pin_count = 0;
    }
    const bat_shape *shape = bat_leveling_shape(c);
    int top = bat_ladder_levels(bat_leveling_ladder(c));
    if (l->level > top) l->level = top, l->chosen = -1;
    if (!shape || l->chosen >= bat_point_count(bat_shape_curve(shape, l->level))) l->chosen = -1;
    if (bat_ladder_any(l->apart) && (!l->object || l->apart_revision != c->session->revision))
        bat_apart_drop(c);
}

void bat_leveling_take(bat_context *c, bat_id object, int curve) {
    bat_leveling *l = bat_leveling_of(c);
    if (l->object != object || l->curve != curve) l->chosen = -1, l->pin_count = 0;
    l->object = l->adopted = object;
    l->curve = curve;
}

void bat_leveling_choose(bat_context *c, bat_id object, int curve) {
    bat_leveling_take(c, object, curve);
    bat_selection_clear(&c->choice->selection);
    if (object) bat_selection_add(&c->choice->selection, object); /* out of memory: not selected */
}

bat_status bat_leveling_put(bat_context *c, bat_shape *shape) {
    return bat_put_shape(c, bat_leveling_of(c)->object, bat_leveling_of(c)->curve, shape);
}

bat_status bat_leveling_commit(bat_context *c, bat_shape *shape, bat_string label) {
    return bat_commit_shape(c, bat_leveling_of(c)->object, bat_leveling_of(c)->curve, shape, label);
}

bool bat_leveling_let_go(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    if (!l->fading) return false;
    bat_ladder_free(&l->base);
    l->fading = false;
    bat_transaction_cancel(c);
    return true;
}

uint32_t bat_leveling_version(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    bool levels = bat_tool_at(c->choice->tool)->traits & BAT_EDITS_LEVELS,
         sketch = bat_tool_at(c->choice->tool)->traits & BAT_DRAWS;
    bool lines = bat_tool_at(c->choice->tool)->traits & BAT_REDRAWS_LINES;
    if (!(levels && (bat_leveling_curve(c) || bat_leveling_solid(c))) && !(sketch && bat_leveling_shape(c)) &&
        !(lines && bat_leveling_relief(c)))
        return 0;
    const uint64_t parts[] = {l->object,  (uint64_t)l->curve,   (uint64_t)l->level,
                              l->copying, c->session->revision, bat_ladder_any(l->apart),
                              levels};
    const bat_property_id values[] = {BAT_PROPERTY_SHOW_LEVELS,  BAT_PROPERTY_SHOW_FRAMES,
                                      BAT_PROPERTY_FRAME_RULE,   BAT_PROPERTY_LEVEL_SKETCH,
                                      BAT_PROPERTY_APART_LEVELS, BAT_PROPERTY_APART_POINTS};
    uint64_t shown = bat_digest_begin();
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) shown = bat_digest_number(shown, parts[i]);
    for (size_t i = 0; i < sizeof values / sizeof *values; i++)
        shown = bat_digest_double(shown, c->settings->values[values[i]]);
    if (shown != l->shown || !l->version) {
        l->shown = shown;
        if (++l->version == 0) l->version = 1;
    }
    return l->version;
}

bool bat_apart_drop(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    bool any = bat_ladder_any(l->apart);
    bat_ladder_free(&l->apart);
    return any;
}
