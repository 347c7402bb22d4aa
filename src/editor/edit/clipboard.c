/* The clipboard: copies the selection as an SVG file that keeps every knot, and pastes the contents of a file. */
#include "document/document.h"
#include "document/follow.h"
#include "editor/edit/affine.h"
#include "editor/edit/arrange.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/edit/clipboard.h"
#include "editor/edit/excerpt.h"
#include "editor/input/input.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/tables.h"
#include "editor/view/stage.h"
#include "editor/session/reorder.h"
#include "base/matrix.h"
#include "document/kind.h"
#include <batten/recipe.h>
#include <math.h>
#include <stdlib.h>

static const double STEP = 10; /* px between a paste and what was copied, or the paste before */

static bat_status copy(const bat_context *c, char **text, size_t *size) {
    bat_document *part = NULL;
    bat_status status = bat_excerpt_make(c, BAT_EXCERPT_SELECTION, &part);
    if (status == BAT_OK) status = bat_svg_write(part, true, text, size);
    bat_document_free(part);
    return status;
}

bat_status bat_clipboard_copy(bat_context *c, bool cut, char **text, size_t *size) {
    char *made = NULL;
    if (!text || !size) return BAT_ARGUMENT;
    bat_status status = c->session->busy ? BAT_STATE : copy(c, &made, size);
    if (status == BAT_OK && cut) status = bat_arrange_delete(c);
    if (status != BAT_OK) {
        free(made);
        if (status == BAT_STATE)
            bat_notice(c, BAT_STRING_NOTICE_SELECT_FIRST);
        else
            bat_notice_failure(c, status);
        return status;
    }
    *text = made;
    c->clipboard->pastes = cut ? -1 : 0; /* after a cut the first paste goes back to the same place */
    c->clipboard->pasted = 0;
    bat_notice(c, cut ? BAT_STRING_NOTICE_CUT : BAT_STRING_NOTICE_COPIED);
    return BAT_OK;
}

/* How far the pasted objects are shifted. own: copied from a Batten drawing, to be pasted near its own place. */
static void find_shift(bat_context *c, const bat_document *document, bool own, double shift[2]) {
    const bat_stage *stage = c->stage;
    double box[4], low[2], high[2], to[2] = {stage->view.width / 2, stage->view.height / 2};
    shift[0] = shift[1] = 0;
    if (c->modifiers & BAT_SHIFT || c->clipboard->paste_in_place) return;
    uint64_t digest = bat_document_digest(document);
    if (c->clipboard->pasted && c->clipboard->pasted != digest)
        c->clipboard->pastes = 0; /* something else was copied meanwhile */
    c->clipboard->pasted = digest;
    if (own) shift[0] = shift[1] = STEP * bat_stage_pixel(stage) * ++c->clipboard->pastes;
    bat_document_bounds(document, box);
    if (!(box[0] <= box[2]) || !(stage->view.width > 0 && stage->view.height > 0)) return;
    bat_stage_project(stage, (double[]){box[0] + shift[0], box[1] + shift[1]}, low);
    bat_stage_project(stage, (double[]){box[2] + shift[0], box[3] + shift[1]}, high);
    bool seen = fmax(low[0], high[0]) > 0 && fmin(low[0], high[0]) < stage->view.width &&
                fmax(low[1], high[1]) > 0 && fmin(low[1], high[1]) < stage->view.height;
    if (own && seen) return;
    /* At the pointer, or in the middle of the view when the pointer is elsewhere. */
    if (!own && c->input->pen_near) to[0] = c->input->pen[0], to[1] = c->input->pen[1];
    bat_stage_seen(stage, to, shift);
    for (int k = 0; k < 2; k++) shift[k] -= box[k] / 2 + box[k + 2] / 2;
}

typedef struct pasting {
    bat_id *ids; /* new ids of the document's objects; for a layer: what now contains its contents */
    int index;   /* where the next object goes */
    bat_id parent;
} pasting;

/* *out: the object, which follows the copies of what it follows; NULL: nothing. */
static bat_status follow_copies(const bat_document *document, const bat_object *object, const bat_id *copies,
                                bat_object **out) {
    const bat_id *from, followed = bat_object_followed(object);
    bat_id ids[BAT_RECIPE_CURVES] = {0};
    const int count = bat_object_sources(object, &from);
    if (followed) ids[0] = copies[bat_document_find(document, followed)];
    for (int i = 0; i < count; i++) ids[i] = copies[bat_document_find(document, from[i])];
    return bat_object_renumbered(object, ids, out);
}

static bat_status paste_one(bat_context *c, const bat_document *document, int i, const double matrix[6],
                            pasting *p) {
    const bat_object *object = bat_document_at(document, i);
    bat_id outer = bat_object_parent(object);
    bat_id parent = outer ? p->ids[bat_document_find(document, outer)] : p->parent;
    bat_object *loose = NULL, *named = NULL, *placed = NULL, *moved = NULL, *led = NULL;
    if (bat_object_is(object, BAT_LAYER)) { /* its contents go into the active layer here */
        p->ids[i] = parent;
        return BAT_OK;
    }
    bat_status status = bat_object_with_parent(object, 0, &loose);
    if (status == BAT_OK) status = bat_object_with_id(loose, p->ids[i], &named);
    if (status == BAT_OK) status = bat_object_with_parent(named, parent, &placed);
    if (status == BAT_OK && bat_affine_moves(placed))
        status = bat_affine_object(placed, matrix, false, &moved);
    if (status == BAT_OK && moved) status = follow_copies(document, moved, p->ids, &led);
    if (status == BAT_OK) status = bat_transaction_insert(c, p->index++, led ? led : moved ? moved : placed);
    bat_object_release(loose);
    bat_object_release(named);
    bat_object_release(placed);
    bat_object_release(moved), bat_object_release(led);
    return status;
}

static bat_status paste(bat_context *c, const bat_document *document, bool own) {
    int count = bat_document_count(document), first = 0;
    double shift[2], matrix[6];
    pasting p = {calloc((size_t)count + 1, sizeof *p.ids), 0, 0};
    if (!p.ids) return BAT_MEMORY;
    find_shift(c, document, own, shift);
    bat_matrix_translation(shift[0], shift[1], matrix);
    first = p.index = bat_arrange_place(c, &p.parent);
    bat_status status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        for (int i = 0; i < count; i++)
            if (!bat_object_is(bat_document_at(document, i), BAT_LAYER))
                p.ids[i] = bat_document_new_id(c->session->document);
        for (int i = 0; i < count && status == BAT_OK; i++) status = paste_one(c, document, i, matrix, &p);
        if (status == BAT_OK && p.index == first) status = BAT_STATE; /* it held nothing but layers */
        status = bat_transaction_end(c, status, BAT_STRING_STEP_PASTE);
    }
    free(p.ids);
    if (status != BAT_OK) return status;
    if (bat_tool_at(c->choice->tool)->traits & BAT_DRAWS) c->choice->wanted = BAT_CHOOSES;
    bat_selection_clear(&c->choice->selection);
    for (int i = first; i < p.index;
         i = bat_document_end(c->session->document, i)) /* out of memory: not selected */
        bat_selection_append(&c->choice->selection, bat_object_id(bat_document_at(c->session->document, i)));
    bat_selection_sort(&c->choice->selection);
    bat_selection_prune(&c->choice->selection, c->session->document);
    return BAT_OK;
}

bat_status bat_clipboard_paste(bat_context *c, const bat_document *document, bool own) {
    if (!document) return BAT_ARGUMENT;
    bat_status status = c->session->busy || !bat_document_count(document) ? BAT_STATE
                                                                          : paste(c, document, own);
    c->clipboard->paste_in_place = false;
    if (status == BAT_OK)
        bat_notice(c, BAT_STRING_NOTICE_PASTED);
    else if (status == BAT_STATE)
        bat_notice(c, BAT_STRING_NOTICE_NOTHING_TO_PASTE);
    else
        bat_notice_failure(c, status);
    return status;
}
