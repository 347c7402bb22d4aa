#include "editor/commands/tuning.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/edit/arrange.h"
#include "editor/scene/path.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/undo.h"
#include "editor/show/inspect.h"
#include "editor/view/stage.h"
#include <math.h>
#include <stdlib.h>

static const float WIDTH = 2;
static const double BESIDE = 10; /* px from an end to its number */

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

bat_status bat_tuning_gather(bat_context *c, bool (*wanted)(const bat_document *document, int index)) {
    const bat_document *document = c->session->document;
    bat_tuning *t = c->tuning;
    int *members = NULL, count = 0;
    bat_status status = bat_arrange_members(c, &members, &count);
    if (status != BAT_OK) return status;
    t->before = malloc((size_t)(count > 0 ? count : 1) * sizeof *t->before);
    for (int i = 0; i < count && t->before; i++)
        if (!wanted || wanted(document, members[i]))
            t->before[t->count++] = bat_object_retain(bat_document_at(document, members[i]));
    free(members);
    if (!t->before) return BAT_MEMORY;
    return t->count > 0 ? BAT_OK : BAT_STATE;
}

bat_status bat_tuning_start(bat_context *c, const bat_tuning_kind *kind, bat_status gathered,
                            bat_string none) {
    bat_status status = gathered;
    if (status == BAT_OK) {
        bat_tuning_mark(c, kind, false);
        status = kind->show(c);
    }
    if (status == BAT_OK) return BAT_OK;
    bat_tuning_free(c->tuning);
    return bat_notice_refuse(c, status, status == BAT_STATE ? none : BAT_STRING_COUNT);
}

void bat_tuning_follow(bat_context *c, const bat_tuning_kind *kind) {
    if (!bat_tuning_holds(c) || c->tuning->kind != kind) return;
    const bat_status status = kind->show(c);
    if (status == BAT_OK) return;
    bat_tuning_free(c->tuning);
    bat_notice_failure(c, status);
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
    for (int i = 0; i < t->shown && t->comb; i++) bat_comb_show(overlay, t->fit[i], c->stage);
    for (int k = 0; k < 2 && t->kind->other; k++) {
        double at[2];
        if (bat_stage_look(c->stage, 3, t->place[k], at))
            bat_overlay_label(overlay, BAT_ROLE_VALUE, at, BESIDE, -BESIDE, k ? "2" : "1");
    }
}

void bat_tuning_look(const bat_stage *stage, const double box[4], double seen[4]) {
    for (int k = 0; k < 4; k++) {
        const double corner[3] = {box[k & 1 ? 2 : 0], box[k & 2 ? 3 : 1], 0};
        double at[2], pixel[2];
        bat_stage_look(stage, 3, corner, at);
        bat_stage_project(stage, at, pixel);
        for (int j = 0; j < 2; j++) {
            seen[j] = k ? fmin(seen[j], pixel[j]) : pixel[j];
            seen[j + 2] = k ? fmax(seen[j + 2], pixel[j]) : pixel[j];
        }
    }
}
