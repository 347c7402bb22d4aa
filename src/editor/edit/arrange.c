#include "editor/edit/arrange.h"
#include "base/box.h"
#include "document/clip.h"
#include "document/document.h"
#include "document/nesting.h"
#include "document/object.h"
#include "editor/edit/affine.h"
#include "editor/edit/copies.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/session/reorder.h"
#include "base/matrix.h"
#include "base/pose.h"
#include "document/kind.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

bat_status bat_arrange_roots(const bat_context *c, int **roots, int *count) {
    const bat_document *document = c->session->document;
    const bat_selection *selection = &c->choice->selection;
    if (!selection->count) return BAT_STATE;
    int *found = malloc((size_t)selection->count * sizeof *found), n = 0;
    if (!found) return BAT_MEMORY;
    for (int i = 0; i < bat_document_count(document) && n < selection->count;) {
        if (bat_selection_has(selection, bat_object_id(bat_document_at(document, i)))) {
            found[n++] = i;
            i = bat_document_end(document, i);
        } else {
            i++;
        }
    }
    if (!n) {
        free(found);
        return BAT_STATE;
    }
    *roots = found;
    *count = n;
    return BAT_OK;
}

static bool is_member(const bat_object *object) { return !bat_object_is_group(object); }

/* What is selected, or in something that is, as far as it is wanted. */
static bat_status collect(const bat_context *c, bool (*wanted)(const bat_object *object), int **members,
                          int *count) {
    const bat_document *document = c->session->document;
    int *roots = NULL, roots_count = 0, n = 0;
    bat_status status = bat_arrange_roots(c, &roots, &roots_count);
    int *found = status == BAT_OK ? malloc((size_t)bat_document_count(document) * sizeof *found) : NULL;
    if (status == BAT_OK && !found) status = BAT_MEMORY;
    for (int i = 0; i < roots_count && found; i++)
        for (int k = roots[i], end = bat_document_end(document, k); k < end; k++)
            if (wanted(bat_document_at(document, k))) found[n++] = k;
    free(roots);
    if (status != BAT_OK) return status;
    *members = found;
    *count = n;
    return BAT_OK;
}

bat_status bat_arrange_members(const bat_context *c, int **members, int *count) {
    return collect(c, is_member, members, count);
}

bat_status bat_arrange_moving(const bat_context *c, int **members, int *count) {
    return collect(c, bat_affine_moves, members, count);
}

bool bat_arrange_box(const bat_document *document, int first, int end, double box[4]) {
    bat_box_nothing(box);
    for (int i = first; i < end; i++) {
        const bat_object *object = bat_document_at(document, i);
        double own[4];
        if (!object) break;
        bat_object_bounds(object, own);
        bat_box_hold(box, own);
    }
    return box[0] <= box[2];
}

bool bat_arrange_selection_space(const bat_context *c, double low[3], double high[3]) {
    const bat_document *document = c->session->document;
    double box[4], z[2];
    low[2] = INFINITY, high[2] = -INFINITY;
    if (!bat_arrange_selection_box(c, box)) return false;
    for (int i = 0, end = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        if (i >= end && bat_selection_has(&c->choice->selection, bat_object_id(object)))
            end = bat_document_end(document, i);
        bat_object_depth(object, z);
        if (i < end) low[2] = fmin(low[2], z[0]), high[2] = fmax(high[2], z[1]);
    }
    for (int k = 0; k < 2; k++) low[k] = box[k], high[k] = box[k + 2];
    return true;
}

bool bat_arrange_selection_box(const bat_context *c, double box[4]) {
    const bat_document *document = c->session->document;
    bat_box_nothing(box);
    for (int i = 0; i < bat_document_count(document) && c->choice->selection.count;) {
        int end = i + 1;
        if (bat_selection_has(&c->choice->selection, bat_object_id(bat_document_at(document, i)))) {
            double own[4];
            end = bat_document_end(document, i);
            bat_arrange_box(document, i, end, own);
            bat_box_hold(box, own);
        }
        i = end;
    }
    return box[0] <= box[2];
}

int bat_arrange_whole(const bat_context *c, int index) {
    const bat_document *document = c->session->document;
    for (;;) {
        bat_id parent = bat_object_parent(bat_document_at(document, index));
        int at = parent ? bat_document_find(document, parent) : -1;
        if (at < 0 || parent == c->choice->entered || bat_object_is(bat_document_at(document, at), BAT_LAYER))
            return index;
        index = at;
    }
}

int bat_arrange_place(const bat_context *c, bat_id *parent) {
    const bat_document *document = c->session->document;
    int at = -1;
    bat_nesting nesting = {0};
    for (int i = 0; i < bat_document_count(document) && c->choice->layer && at < 0; i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level = {0};
        bat_nesting_next(&nesting, object, &level);
        if (bat_object_id(object) == c->choice->layer && !level.hidden && !level.locked) at = i;
    }
    *parent = at < 0 ? 0 : c->choice->layer;
    return at < 0 ? bat_document_count(document) : bat_document_end(document, at);
}

bat_status bat_arrange_insert(bat_context *c, const bat_object *object) {
    bat_id parent;
    int index = bat_arrange_place(c, &parent);
    bat_object *placed = NULL;
    bat_status status = bat_object_with_parent(object, parent, &placed);
    if (status == BAT_OK) status = bat_transaction_insert(c, index, placed);
    bat_object_release(placed);
    return status;
}

static bat_status apply(bat_context *c, bat_listing *listing, bat_string label) {
    bat_status status = bat_transaction_begin(c);
    if (status == BAT_OK) status = bat_transaction_end(c, bat_listing_apply(listing, c), label);
    bat_listing_free(listing);
    return status;
}

/* Transforms the objects first to end, within a transaction. */
static bat_status pose_range(bat_context *c, int first, int end, const double rows[12]) {
    bool strokes = c->settings->values[BAT_PROPERTY_SCALE_STROKES] != 0;
    for (int i = first; i < end; i++) {
        const bat_object *before = bat_document_at(c->session->document, i);
        bat_object *after = NULL;
        if (!bat_affine_moves(before)) continue;
        bat_status status = bat_affine_pose(before, rows, strokes, &after);
        if (status == BAT_OK) status = bat_transaction_replace(c, i, after);
        bat_object_release(after);
        if (status != BAT_OK) return status;
    }
    return BAT_OK;
}

bat_status bat_arrange_transform(bat_context *c, const double matrix[6], bat_string label) {
    double rows[12];
    bat_matrix_rows(matrix, 3, rows);
    return bat_arrange_pose(c, rows, label);
}

bat_status bat_arrange_pose(bat_context *c, const double rows[12], bat_string label) {
    int *roots, count;
    double box[4], matrix[6];
    bat_status status = bat_arrange_roots(c, &roots, &count);
    if (status != BAT_OK) return status;
    bat_arrange_selection_box(c, box);
    status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        for (int i = 0; i < count && status == BAT_OK; i++)
            status = pose_range(c, roots[i], bat_document_end(c->session->document, roots[i]), rows);
        status = bat_transaction_end(c, status, label);
    }
    if (status == BAT_OK && bat_pose_in_plane(rows, matrix)) bat_repetition_note(c, matrix, box, label);
    free(roots);
    return status;
}

/* Whether first..end holds anything but groups that `gone` does not mark. */
static bool has_paths(const bat_document *document, int first, int end, const bool *gone) {
    for (int i = first; i < end; i++)
        if (!gone[i] && !bat_object_is_group(bat_document_at(document, i))) return true;
    return false;
}

bat_status bat_arrange_delete(bat_context *c) {
    const bat_document *document = c->session->document;
    int *roots, count, all = bat_document_count(document);
    bat_status status = bat_arrange_roots(c, &roots, &count);
    if (status != BAT_OK) return status;
    bool *gone = calloc((size_t)all + 1, sizeof *gone);
    bat_listing listing = {.failed = !gone};
    for (int i = 0; i < count && gone; i++)
        for (int k = roots[i], end = bat_document_end(document, k); k < end; k++) gone[k] = true;
    /* A group left empty by the deletion goes too; a layer stays. */
    for (int i = 0; i < all && gone; i++) {
        const bat_object *object = bat_document_at(document, i);
        int end = bat_object_is_mere_group(object) ? bat_document_end(document, i) : i;
        bool emptied = false;
        for (int k = i + 1; k < end && !emptied; k++) emptied = gone[k];
        if (!gone[i] && emptied && !has_paths(document, i, end, gone))
            for (int k = i; k < end; k++) gone[k] = true;
    }
    for (int i = 0; i < all && gone; i++)
        if (!gone[i]) bat_listing_add(&listing, bat_document_at(document, i));
    free(gone);
    free(roots);
    return apply(c, &listing, BAT_STRING_STEP_DELETE);
}

bool bat_arrange_entered(const bat_context *c, int index) {
    const bat_object *whole = bat_document_at(c->session->document, bat_arrange_whole(c, index));
    return !c->choice->entered || bat_object_parent(whole) == c->choice->entered;
}

bool bat_arrange_leave(bat_context *c) {
    int at = c->choice->entered ? bat_document_find(c->session->document, c->choice->entered) : -1;
    if (at < 0) return false;
    bat_id parent = bat_object_parent(bat_document_at(c->session->document, at));
    int outer = parent ? bat_document_find(c->session->document, parent) : -1;
    bool group = outer >= 0 && bat_object_is_mere_group(bat_document_at(c->session->document, outer));
    bat_selection_clear(&c->choice->selection);
    bat_selection_add(&c->choice->selection, c->choice->entered); /* out of memory: not selected */
    c->choice->entered = group ? parent : 0;
    return true;
}

/* Within the open transaction, or as a step of that name. all: the originals are selected with the copies. */
static bat_status copy(bat_context *c, int copies, const double (*matrices)[6], bool all, bool open,
                       bat_string label) {
    int *roots, count;
    bat_status status = bat_arrange_roots(c, &roots, &count);
    if (status != BAT_OK) return status;
    bat_listing listing = {0};
    const int heads_count = count * copies;
    bat_id *heads = malloc((size_t)heads_count * sizeof *heads);
    if (!heads) listing.failed = true;
    if (heads) bat_copies_list(c, count, roots, copies, matrices, &listing, heads);
    if (open) {
        status = bat_listing_apply(&listing, c);
        bat_listing_free(&listing);
    } else {
        status = apply(c, &listing, label);
    }
    if (status == BAT_OK && heads) {
        if (!all) bat_selection_clear(&c->choice->selection);
        for (int i = 0; i < heads_count; i++) bat_selection_append(&c->choice->selection, heads[i]);
        bat_selection_sort(&c->choice->selection);
    }
    free(heads);
    free(roots);
    return status;
}

bat_status bat_arrange_copies(bat_context *c, int copies, const double (*matrices)[6], bat_string label) {
    return copy(c, copies, matrices, true, false, label);
}

bat_status bat_arrange_duplicate(bat_context *c, const double matrix[6]) {
    double box[4];
    bat_arrange_selection_box(c, box);
    double one[1][6];
    memcpy(one[0], matrix, sizeof one[0]);
    const bat_status status = copy(c, 1, (const double(*)[6])one, false, false, BAT_STRING_STEP_DUPLICATE);
    if (status == BAT_OK) bat_repetition_note_copies(c, matrix, box);
    return status;
}

bat_status bat_arrange_lift(bat_context *c) {
    double matrix[1][6];
    bat_matrix_identity(matrix[0]);
    bat_status status = bat_transaction_begin(c);
    return status == BAT_OK ? copy(c, 1, (const double(*)[6])matrix, false, true, BAT_STRING_COUNT) : status;
}

static void add_with_parent(bat_listing *listing, const bat_object *object, bat_id parent) {
    bat_object *placed = NULL;
    bat_object_with_parent(object, parent, &placed);
    bat_listing_take(listing, placed);
}

/* Seen as far as it and the group are. */
static bat_status clip_within(const bat_object *object, const bat_object *group, bat_object **out) {
    bat_clip *clip = NULL;
    bat_status status = bat_clip_join(bat_object_clip(object), bat_object_clip(group), &clip);
    const bool can = bat_object_is_drawn(object) || bat_object_is_group(object);
    if (status == BAT_OK && can)
        status = bat_object_with_clip(object, clip, out);
    else if (status == BAT_OK)
        *out = bat_object_retain(object);
    bat_clip_release(clip);
    return status;
}

/* A member of a group that is taken apart: it looks as it did. */
static void add_freed(bat_listing *listing, const bat_object *object, const bat_object *group) {
    bat_object *faded = NULL, *clipped = NULL;
    bat_status status = clip_within(object, group, &clipped);
    if (status == BAT_OK) status = bat_object_faded(clipped, bat_object_style(group)->opacity, &faded);
    if (status != BAT_OK) listing->failed = true;
    if (faded) add_with_parent(listing, faded, bat_object_parent(group));
    bat_object_release(clipped);
    bat_object_release(faded);
}

bat_status bat_arrange_group(bat_context *c) {
    const bat_document *document = c->session->document;
    int *roots, count, next = 0;
    bat_status status = bat_arrange_roots(c, &roots, &count);
    if (status != BAT_OK) return status;
    bool layers = false;
    for (int i = 0; i < count; i++)
        layers = layers || bat_object_is(bat_document_at(document, roots[i]), BAT_LAYER);
    if (count < 2 || layers) {
        free(roots);
        return BAT_STATE;
    }
    /* The group takes the place of the frontmost root and has its parent. */
    int front = roots[count - 1];
    bat_id id = bat_document_new_id(c->session->document);
    bat_object *group = NULL;
    bat_listing listing = {0};
    status = bat_object_create_group(id, NULL, false, &group);
    if (status != BAT_OK) listing.failed = true;
    for (int i = 0; i < bat_document_count(document) && !listing.failed;) {
        bool root = next < count && roots[next] == i;
        if (!root) {
            bat_listing_add(&listing, bat_document_at(document, i++));
            continue;
        }
        next++;
        int end = bat_document_end(document, i);
        if (i == front) {
            add_with_parent(&listing, group, bat_object_parent(bat_document_at(document, front)));
            for (int k = 0; k < count && !listing.failed; k++) {
                add_with_parent(&listing, bat_document_at(document, roots[k]), id);
                bat_listing_range(&listing, document, roots[k] + 1, bat_document_end(document, roots[k]));
            }
        }
        i = end;
    }
    bat_object_release(group);
    free(roots);
    status = apply(c, &listing, BAT_STRING_STEP_GROUP);
    if (status == BAT_OK) {
        bat_selection_clear(&c->choice->selection);
        status = bat_selection_add(&c->choice->selection, id);
    }
    return status == BAT_ARGUMENT ? BAT_STATE : status; /* nested too deeply */
}

bat_status bat_arrange_ungroup(bat_context *c) {
    const bat_document *document = c->session->document;
    int *roots, count, next = 0, groups = 0, all = bat_document_count(document);
    bat_status status = bat_arrange_roots(c, &roots, &count);
    if (status != BAT_OK) return status;
    bat_listing listing = {0};
    bat_id *freed = malloc((size_t)all * sizeof *freed);
    int freed_count = 0;
    if (!freed) listing.failed = true;
    for (int i = 0; i < all && !listing.failed;) {
        const bat_object *object = bat_document_at(document, i);
        bool root = next < count && roots[next] == i;
        next += root;
        if (!root || !bat_object_is_mere_group(object)) {
            if (root) freed[freed_count++] = bat_object_id(object);
            bat_listing_add(&listing, object);
            i++;
            continue;
        }
        int end = bat_document_end(document, i);
        groups++;
        for (int k = i + 1; k < end && !listing.failed; k++) {
            const bat_object *member = bat_document_at(document, k);
            if (bat_object_parent(member) == bat_object_id(object)) {
                add_freed(&listing, member, object);
                freed[freed_count++] = bat_object_id(member);
            } else {
                bat_listing_add(&listing, member);
            }
        }
        i = end;
    }
    free(roots);
    if (!groups && !listing.failed) {
        bat_listing_free(&listing);
        free(freed);
        return BAT_STATE;
    }
    status = apply(c, &listing, BAT_STRING_STEP_UNGROUP);
    if (status == BAT_OK) {
        bat_selection_clear(&c->choice->selection);
        for (int i = 0; i < freed_count; i++) bat_selection_append(&c->choice->selection, freed[i]);
        bat_selection_sort(&c->choice->selection);
        bat_selection_prune(&c->choice->selection, c->session->document);
    }
    free(freed);
    return status;
}

/* ---- order ---- */

/* Moves the chosen siblings as the order says; the chosen and the others each keep their own order. */
static void permute(int *siblings, const bool *chosen, int *spare, int count, bat_order order) {
    bool forward = order == BAT_ORDER_FORWARD || order == BAT_ORDER_FRONT;
    if (order == BAT_ORDER_BACK || order == BAT_ORDER_FRONT) {
        int n = 0;
        for (int pass = 0; pass < 2; pass++)
            for (int i = 0; i < count; i++)
                if (chosen[siblings[i]] == (forward == (pass == 1))) spare[n++] = siblings[i];
        memcpy(siblings, spare, (size_t)count * sizeof *siblings);
        return;
    }
    for (int k = 1; k < count; k++) {
        int i = forward ? count - 1 - k : k, other = forward ? i + 1 : i - 1;
        if (!chosen[siblings[i]] || chosen[siblings[other]]) continue;
        int moved = siblings[i];
        siblings[i] = siblings[other];
        siblings[other] = moved;
    }
}

/* Lists the objects of first..end with their contents, siblings in their new order. */
static void list_ordered(const bat_document *document, int first, int end, const bool *chosen,
                         bat_order order, bat_listing *listing) {
    int count = 0, *siblings = first < end ? malloc(2 * (size_t)(end - first) * sizeof *siblings) : NULL;
    if (first < end && !siblings) listing->failed = true;
    if (!siblings) return;
    for (int i = first; i < end; i = bat_document_end(document, i)) siblings[count++] = i;
    permute(siblings, chosen, siblings + (end - first), count, order);
    for (int i = 0; i < count && !listing->failed; i++) {
        int at = siblings[i];
        bat_listing_add(listing, bat_document_at(document, at));
        list_ordered(document, at + 1, bat_document_end(document, at), chosen, order, listing);
    }
    free(siblings);
}

bat_status bat_arrange_order(bat_context *c, bat_order order) {
    const bat_document *document = c->session->document;
    int *roots, count, all = bat_document_count(document);
    bat_status status = bat_arrange_roots(c, &roots, &count);
    if (status != BAT_OK) return status;
    bat_listing listing = {0};
    bool *chosen = calloc((size_t)all + 1, sizeof *chosen), same = true;
    if (!chosen) listing.failed = true;
    for (int i = 0; i < count && chosen; i++) chosen[roots[i]] = true;
    if (!listing.failed) list_ordered(document, 0, all, chosen, order, &listing);
    for (int i = 0; i < listing.count && same; i++) same = listing.objects[i] == bat_document_at(document, i);
    free(chosen);
    free(roots);
    if (same && !listing.failed) {
        bat_listing_free(&listing);
        return BAT_STATE;
    }
    return apply(c, &listing, BAT_STRING_STEP_ORDER);
}

/* ---- align and distribute ---- */

/* The roots in a line along the axis; those that take up nothing are left out. Returns how many there are. */
static int find_things(const bat_document *document, int *roots, int count, int axis, bat_in_line *things) {
    int n = 0;
    for (int i = 0; i < count; i++) {
        double box[4];
        if (!bat_arrange_box(document, roots[i], bat_document_end(document, roots[i]), box)) continue;
        roots[n] = roots[i];
        things[n++] = (bat_in_line){.low = box[axis], .high = box[axis + 2]};
    }
    return n;
}

bat_status bat_arrange_line_up(bat_context *c, const bat_line_up *how) {
    const bat_document *document = c->session->document;
    int *roots, count, n = 0;
    double page[4];
    bat_status status = bat_arrange_roots(c, &roots, &count);
    if (status != BAT_OK) return status;
    bat_in_line *things = malloc((size_t)count * sizeof *things);
    bat_document_page(document, page);
    const double whole[2] = {page[how->axis], page[how->axis] + page[how->axis + 2]};
    if (things) n = find_things(document, roots, count, how->axis, things);
    status = things ? bat_line_up_find(how, n, things, count == 1 && page[2] > 0 ? whole : NULL) : BAT_MEMORY;
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK) {
        for (int i = 0; i < n && status == BAT_OK; i++) {
            const double by = things[i].by;
            double rows[12];
            bat_pose_translation((double[]){how->axis ? 0 : by, how->axis ? by : 0, 0}, rows);
            if (by != 0) status = pose_range(c, roots[i], bat_document_end(document, roots[i]), rows);
        }
        status = bat_transaction_end(c, status, how->step);
    }
    free(roots);
    free(things);
    return status;
}
