#include "editor/commands/tuning.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/scene/path.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/undo.h"
#include <stdlib.h>

static const float WIDTH = 2;

void bat_tuning_unshow(bat_tuning *t) {
    for (int i = 0; i < t->shown; i++) bat_curve_free(t->fit[i]);
    free(t->fit);
    t->fit = NULL;
    t->shown = 0;
}

void bat_tuning_free(bat_tuning *t) {
    bat_tuning_unshow(t);
    for (int i = 0; i < t->count; i++) bat_object_release(t->before[i]);
    free(t->before);
    *t = (bat_tuning){.version = t->version, .past = t->past};
}

bat_status bat_tuning_add(bat_tuning *t, bat_curve *curve) {
    bat_curve **more = realloc(t->fit, (size_t)(t->shown + 1) * sizeof *more);
    if (!more) {
        bat_curve_free(curve);
        return BAT_MEMORY;
    }
    t->fit = more;
    t->fit[t->shown++] = curve;
    return BAT_OK;
}

void bat_tuning_mark(bat_context *c, const bat_tuning_kind *kind, bool stepped) {
    bat_tuning *t = c->tuning;
    t->kind = kind;
    t->stepped = stepped;
    t->revision = c->session->revision;
    t->selection = c->choice->selection.version;
    t->tool = c->choice->tool;
    t->version++;
}

bool bat_tuning_holds(const bat_context *c) {
    const bat_tuning *t = c->tuning;
    return t->kind && t->revision == c->session->revision && t->tool == c->choice->tool &&
           t->selection == c->choice->selection.version && !c->session->busy;
}

uint32_t bat_tuning_version(const bat_context *c) {
    return bat_tuning_holds(c) ? c->tuning->version | 1U << 31 : 0;
}

bool bat_tuning_cancel(bat_context *c) {
    bat_tuning *t = c->tuning;
    if (!bat_tuning_holds(c)) return false;
    if (t->stepped && bat_session_step(c, true) == BAT_OK)
        bat_notice_value(c, BAT_STRING_NOTICE_UNDONE, bat_word(c, t->kind->step));
    bat_tuning_free(t);
    return true;
}

bool bat_tuning_accept(bat_context *c) {
    if (!bat_tuning_holds(c)) return false;
    if (c->tuning->kind->accept && c->tuning->kind->accept(c) != BAT_OK) return true;
    bat_tuning_free(c->tuning);
    return true;
}

void bat_tuning_show(bat_context *c, bat_overlay *overlay) {
    const bat_tuning *t = c->tuning;
    if (t->shown == 0 || !bat_tuning_holds(c)) return;
    bat_overlay_item(overlay, BAT_ROLE_FIT, BAT_ITEM_STROKED, WIDTH);
    for (int i = 0; i < t->shown; i++) bat_path_curve(&overlay->path, t->fit[i]);
}
