/* What of an object is seen, where its element stays. */
#include "base/matrix.h"
#include "document/clip.h"
#include "document/kind.h"
#include "format/svg/alone.h"
#include "format/svg/svg.h"
#include "format/svg/write/patch.h"

#include <batten/measure.h>

#include <stdio.h>
#include <string.h>

/* Whether an object that was in the element is no longer in the group. */
static bool has_left(const bat_svg_plan *plan, int group, int end, const bat_sourced *entry) {
    for (int k = 0; k < bat_source_count(plan->source); k++) {
        const bat_sourced *own = bat_source_at(plan->source, k);
        if (!own->id || own->element == entry->element) continue;
        if (!bat_svg_plan_holds(plan, entry->element, own->element)) continue;
        const int index = bat_document_find(plan->document, own->id);
        if (index <= group || index >= end) return true;
    }
    return false;
}

/* Whether the box of what is in a group may be another one than it was. */
static bool is_refilled(const bat_svg_plan *plan, const bat_object *object, const bat_sourced *entry) {
    const int group = bat_document_find(plan->document, bat_object_id(object)),
              end = bat_document_end(plan->document, group);
    for (int i = group + 1; i < end; i++) {
        const bat_object *member = bat_document_at(plan->document, i);
        const bat_sourced *own = bat_svg_plan_entry(plan, i);
        if (!own || !bat_svg_plan_holds(plan, entry->element, own->element)) return true;
        if (own->hidden != (bat_object_is_hidden(member) || plan->hidden[i])) return true;
        if (!bat_object_is_group(member) && bat_svg_reshaped(member, own)) return true;
    }
    return has_left(plan, group, end, entry);
}

/* A clip path that is placed by a box follows it, which the object's does only as far as it is moved. */
static bool changes(const bat_svg_plan *plan, const bat_object *object, const bat_sourced *entry) {
    const bat_clip *clip = bat_object_clip(object);
    if (bat_clip_digest(clip) != entry->clip) return true;
    if (!clip || !entry->boxed) return false;
    return bat_object_is_group(object) ? is_refilled(plan, object, entry) : bat_svg_reshaped(object, entry);
}

/* From the document's units to those of the element as it will be written. False: there is no way. */
static bool find_units(const bat_svg_retag *r, const bat_object *object, const bat_sourced *entry,
                       double m[6]) {
    const double *matrix = bat_object_picture(object) ? bat_object_matrix(object) : NULL;
    double was[6], back[6], moved[6], own[6];
    if (!matrix || !bat_svg_reshaped(object, entry)) return bat_svg_inverse(entry->inner, m);
    if (!bat_object_is_foreign(object) || bat_svg_is_written_alone(r)) return bat_svg_inverse(matrix, m);
    if (!bat_drawing_matrix(bat_object_picture(object), was) || !bat_svg_inverse(was, back)) return false;
    bat_matrix_compose(matrix, back, moved);
    bat_matrix_compose(moved, entry->inner, own);
    return bat_svg_inverse(own, m);
}

void bat_svg_patch_clip(bat_svg_patch *p, const bat_object *object, const bat_sourced *entry,
                        bat_svg_ids *ids) {
    const bat_svg_tag *tag = &p->plan.tags.list[entry->element];
    double m[6];
    if (!bat_object_clip(object) || !changes(&p->plan, object, entry)) return;
    bat_svg_retag r;
    bat_svg_retag_begin(&r, p->plan.text + tag->open, tag->body - tag->open, p->plan.types,
                        p->plan.types_size, p->plan.sheets);
    /* The clip path and the mask of foreign content are part of its picture. */
    const bool has = bat_object_is_foreign(object) &&
                     (bat_svg_retag_says(&r, "clip-path") || bat_svg_retag_says(&r, "mask"));
    const bool can = !has && find_units(&r, object, entry, m);
    bat_svg_retag_free(&r);
    bat_status status = BAT_UNSUPPORTED;
    if (can) status = bat_svg_write_clip(&p->made, object, m, bat_svg_patch_number(p), ids);
    if (status != BAT_OK) p->status = status;
}

void bat_svg_patch_set_clip(bat_svg_retag *r, const bat_object *object, const bat_sourced *entry,
                            const bat_svg_ids *ids) {
    const char *const own[2] = {ids->clip, ids->mask};
    char value[BAT_SVG_ID + 8];
    for (int k = 0; k < 2; k++) {
        snprintf(value, sizeof value, "url(#%s)", own[k]);
        if (*own[k]) bat_svg_retag_style(r, k ? "mask" : "clip-path", value);
    }
    if (entry->clip && !bat_object_clip(object)) bat_svg_unclip(r);
}

void bat_svg_unclip(bat_svg_retag *r) {
    bat_svg_retag_style(r, "clip-path", "none");
    if (bat_svg_retag_says(r, "mask")) bat_svg_retag_style(r, "mask", "none");
}

/* ---- whether what was written shows as much ---- */

/* The box in which all that is seen of the object lies. */
static void box_of(const bat_document *document, const bat_object *object, double box[4]) {
    box[0] = box[1] = -BAT_COORDINATE_MAX, box[2] = box[3] = BAT_COORDINATE_MAX;
    for (int depth = 0; object && depth < 2 * BAT_CLIP_REGIONS_MAX * BAT_CLIP_REGIONS_MAX; depth++) {
        for (const bat_clip *clip = bat_object_clip(object); clip; clip = bat_clip_within(clip)) {
            double all[4] = {BAT_COORDINATE_MAX, BAT_COORDINATE_MAX, -BAT_COORDINATE_MAX,
                             -BAT_COORDINATE_MAX};
            for (int i = 0; i < bat_clip_curve_count(clip); i++) {
                double low[2], high[2];
                bat_curve_bounds(bat_clip_curve(clip, i), low, high);
                for (int k = 0; k < 2; k++) {
                    if (low[k] < all[k]) all[k] = low[k];
                    if (high[k] > all[k + 2]) all[k + 2] = high[k];
                }
            }
            for (int k = 0; k < 2; k++) {
                if (all[k] > box[k]) box[k] = all[k];
                if (all[k + 2] < box[k + 2]) box[k + 2] = all[k + 2];
            }
        }
        object = bat_document_at(document, bat_document_find(document, bat_object_parent(object)));
    }
}

bool bat_svg_is_clipped(const bat_document *document) {
    for (int i = 0; i < bat_document_count(document); i++)
        if (bat_object_clip(bat_document_at(document, i))) return true;
    return false;
}

bool bat_svg_same_clip(const bat_document *one, const bat_object *a, const bat_document *other,
                       const bat_object *b, double slack) {
    double here[4], there[4];
    box_of(one, a, here);
    box_of(other, b, there);
    const bool none = !(here[0] < here[2] && here[1] < here[3]);
    if (none || !(there[0] < there[2] && there[1] < there[3]))
        return none && !(there[0] < there[2] && there[1] < there[3]);
    for (int k = 0; k < 4; k++)
        if (!(here[k] - there[k] <= slack && there[k] - here[k] <= slack)) return false;
    return true;
}
