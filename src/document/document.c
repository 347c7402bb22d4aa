/* The document: an ordered list of reference-counted objects, and the page. */
#include "document/document.h"

#include "document/kind.h"

#include "base/box.h"
#include "curve/curve.h"
#include "document/digest.h"
#include "document/list.h"
#include "document/nesting.h"
#include "document/object.h"
#include "document/unit.h"
#include <batten/recipe.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct bat_document {
    bat_list list; /* back to front */
    bat_id next;   /* greater than every id that was ever in the document */
    double page[4];
    double scale; /* millimetres of a unit */
    bat_unit unit;
    bat_stand stand;
    bat_source *source;
    int followers; /* objects that follow others */
};

static bool follows(const bat_object *object) {
    return bat_object_followed(object) != 0 || bat_object_sources(object, NULL) > 0;
}

bat_status bat_document_create(bat_document **out) {
    if (!out) return BAT_ARGUMENT;
    bat_document *document = malloc(sizeof *document);
    if (!document) return BAT_MEMORY;
    *document = (bat_document){.next = 1, .scale = BAT_PX_MILLIMETRES};
    *out = document;
    return BAT_OK;
}

void bat_document_free(bat_document *document) {
    if (!document) return;
    bat_list_free(&document->list);
    bat_source_release(document->source);
    free(document);
}

const bat_source *bat_document_origin(const bat_document *document) { return document->source; }

void bat_document_set_origin(bat_document *document, const bat_source *source) {
    bat_source *before = document->source;
    document->source = bat_source_retain(source);
    bat_source_release(before);
}

bat_status bat_document_copy(const bat_document *document, bat_document **out) {
    if (!document || !out) return BAT_ARGUMENT;
    bat_document *copy;
    bat_status status = bat_document_create(&copy);
    if (status != BAT_OK) return status;
    status = bat_list_copy(&document->list, &copy->list);
    if (status != BAT_OK) {
        bat_document_free(copy);
        return status;
    }
    copy->next = document->next;
    copy->followers = document->followers;
    copy->source = bat_source_retain(document->source);
    memcpy(copy->page, document->page, sizeof copy->page);
    copy->scale = document->scale, copy->unit = document->unit, copy->stand = document->stand;
    *out = copy;
    return BAT_OK;
}

int bat_document_count(const bat_document *document) { return document->list.count; }

const bat_object *bat_document_at(const bat_document *document, int index) {
    return index >= 0 && index < document->list.count ? bat_list_at(&document->list, index) : NULL;
}

int bat_document_find(const bat_document *document, bat_id id) { return bat_list_find(&document->list, id); }

bat_id bat_document_new_id(bat_document *document) {
    return document->next > BAT_ID_MAX ? 0 : document->next++;
}

bat_id bat_document_next(const bat_document *document) { return document->next; }

void bat_document_raise_next(bat_document *document, bat_id next) {
    if (next > BAT_ID_MAX + 1) next = BAT_ID_MAX + 1;
    if (next > document->next) document->next = next;
}

bat_status bat_document_insert(bat_document *document, int index, const bat_object *after) {
    if (!document || !after || index < 0 || index > document->list.count) return BAT_ARGUMENT;
    bat_id id = bat_object_id(after);
    if (bat_list_find(&document->list, id) >= 0) return BAT_ARGUMENT;
    bat_status status = bat_list_reserve(&document->list, document->list.count + 1);
    if (status != BAT_OK) return status;
    bat_list_insert(&document->list, index, bat_object_retain(after));
    document->followers += follows(after);
    bat_document_raise_next(document, id + 1);
    return BAT_OK;
}

bat_status bat_document_replace(bat_document *document, int index, const bat_object *after) {
    if (!document || !after || index < 0 || index >= document->list.count) return BAT_ARGUMENT;
    if (bat_object_id(after) != bat_object_id(bat_list_at(&document->list, index))) return BAT_ARGUMENT;
    document->followers += follows(after) - follows(bat_list_at(&document->list, index));
    bat_object_release(bat_list_exchange(&document->list, index, bat_object_retain(after)));
    return BAT_OK;
}

bat_status bat_document_remove(bat_document *document, int index) {
    if (!document || index < 0 || index >= document->list.count) return BAT_ARGUMENT;
    document->followers -= follows(bat_list_at(&document->list, index));
    bat_object_release(bat_list_take(&document->list, index));
    return BAT_OK;
}

bat_status bat_document_fill(bat_document *document, int count, bat_object *const *objects) {
    bat_list *list = &document->list;
    if (list->count > 0) return BAT_STATE;
    bat_status status = bat_list_reserve(list, count);
    if (status != BAT_OK) return status;
    for (int i = 0; i < count && status == BAT_OK; i++) {
        if (bat_list_find(list, bat_object_id(objects[i])) >= 0)
            status = BAT_ARGUMENT;
        else
            bat_list_insert(list, i, objects[i]);
    }
    while (status != BAT_OK && list->count) bat_list_take(list, list->count - 1); /* stay the caller's */
    for (int i = 0; i < list->count; i++) {
        bat_document_raise_next(document, bat_object_id(objects[i]) + 1);
        document->followers += follows(objects[i]);
    }
    return status;
}

void bat_document_page(const bat_document *document, double page[4]) {
    memcpy(page, document->page, sizeof document->page);
}

static bool page_valid(const double page[4]) {
    for (int i = 0; i < 4; i++)
        if (!(fabs(page[i]) <= BAT_COORDINATE_MAX)) return false;
    return page[2] >= 0 && page[3] >= 0;
}

bat_status bat_document_set_page(bat_document *document, const double page[4]) {
    if (!document || !page) return BAT_ARGUMENT;
    if (!page_valid(page)) return BAT_NUMBER;
    memcpy(document->page, page, sizeof document->page);
    return BAT_OK;
}

double bat_document_scale(const bat_document *document) { return document->scale; }

bat_unit bat_document_unit(const bat_document *document) { return document->unit; }

static bool scale_valid(double scale, bat_unit unit) {
    return scale >= 1e-12 && scale <= 1e12 && unit >= BAT_UNIT_PX && unit <= BAT_UNIT_NONE;
}

bat_status bat_document_set_scale(bat_document *document, double millimetres, bat_unit unit) {
    if (!document) return BAT_ARGUMENT;
    if (!scale_valid(millimetres, unit)) return BAT_NUMBER;
    document->scale = millimetres, document->unit = unit;
    return BAT_OK;
}

bat_stand bat_document_stand(const bat_document *document) { return document->stand; }

void bat_document_set_stand(bat_document *document, bat_stand stand) { document->stand = stand; }

static const char *const STANDS[] = {"", "wall", "floor"};

const char *bat_stand_word(bat_stand stand) { return STANDS[stand]; }

bat_stand bat_stand_of_word(const char *word) {
    bat_stand stand = BAT_STAND_FLOOR;
    while (stand && (!word || strcmp(STANDS[stand], word) != 0)) stand--;
    return stand;
}

void bat_document_bounds(const bat_document *document, double box[4]) {
    bat_box_nothing(box);
    for (int i = 0; i < document->list.count; i++) {
        double own[4];
        bat_object_bounds(bat_list_at(&document->list, i), own);
        bat_box_hold(box, own);
    }
}

int bat_document_end(const bat_document *document, int index) {
    const bat_object *object = bat_document_at(document, index);
    if (!object) return index < 0 ? 0 : document->list.count;
    int end = index + 1;
    if (!bat_object_is_group(object)) return end;
    bat_nesting nesting = {0};
    /* Within the group, every parent is the group itself or one opened after it. */
    nesting.open[nesting.depth++] = (bat_nesting_level){.id = bat_object_id(object)};
    while (end < document->list.count && bat_object_parent(bat_list_at(&document->list, end)) != 0 &&
           bat_nesting_next(&nesting, bat_list_at(&document->list, end), NULL))
        end++;
    return end;
}

const char *bat_document_check_nesting(const bat_document *document) {
    bat_nesting nesting = {0};
    for (int i = 0; i < document->list.count; i++) {
        const bat_object *object = bat_list_at(&document->list, i);
        if (!bat_nesting_next(&nesting, object, NULL)) return "an object is not with its group";
        if (bat_object_is(object, BAT_LAYER) && nesting.depth > 1 && !nesting.open[nesting.depth - 2].layer)
            return "a layer is in a group";
    }
    return NULL;
}

/* The group that the object is in; NULL: it is in none. */
static const bat_object *outside(const bat_document *document, const bat_object *object) {
    bat_id parent = bat_object_parent(object);
    return parent ? bat_document_at(document, bat_document_find(document, parent)) : NULL;
}

bat_nesting_level bat_document_level(const bat_document *document, int index) {
    const bat_object *object = bat_document_at(document, index);
    bat_nesting_level level = {bat_object_id(object), bat_object_is(object, BAT_LAYER), false, false, 1};
    for (int depth = 0; object && depth <= BAT_NESTING_MAX; depth++) {
        level.hidden = level.hidden || bat_object_is_hidden(object);
        level.locked = level.locked || bat_object_is_locked(object);
        if (bat_object_is_group(object)) level.around *= bat_object_style(object)->opacity;
        object = outside(document, object);
    }
    return level;
}

bool bat_document_fits(const bat_document *document, int index) {
    const bat_object *object = bat_document_at(document, index);
    if (!object || !bat_object_parent(object)) return true;
    const bat_object *group = outside(document, object), *open = bat_document_at(document, index - 1);
    if (!group || !open) return false;
    if (bat_object_is(object, BAT_LAYER) && !bat_object_is(group, BAT_LAYER)) return false;
    if (!bat_object_is_group(open)) open = outside(document, open);
    for (int depth = 0; open && open != group && depth < BAT_NESTING_MAX; depth++)
        open = outside(document, open);
    int depth = bat_object_is_group(object);
    for (; group && depth <= BAT_NESTING_MAX; depth++) group = outside(document, group);
    return open && depth <= BAT_NESTING_MAX;
}

const bat_object *bat_document_source(const bat_document *document, const bat_object *object) {
    const bat_id id = bat_object_followed(object);
    const bat_object *source = id ? bat_document_at(document, bat_document_find(document, id)) : NULL;
    return source && bat_object_leads(source) ? source : NULL;
}

bool bat_document_is_left(const bat_document *document, int index) {
    const bat_object *object = bat_document_at(document, index);
    return bat_object_followed(object) && !bat_document_source(document, object);
}

bool bat_document_sources(const bat_document *document, const bat_object *object, const bat_object **out) {
    const bat_id *ids;
    const int count = bat_object_sources(object, &ids);
    bool all = true;
    for (int i = 0; i < count; i++) {
        const int at = bat_document_find(document, ids[i]);
        out[i] = bat_document_at(document, at);
        if (out[i] && !bat_object_leads(out[i])) out[i] = NULL;
        all = all && out[i];
    }
    return all;
}

bool bat_document_has_followers(const bat_document *document) { return document->followers > 0; }

const char *bat_document_check(const bat_document *document) {
    if (!page_valid(document->page)) return "the page is out of range";
    if (!scale_valid(document->scale, document->unit)) return "the scale is out of range";
    for (int i = 0; i < document->list.count; i++) {
        const bat_object *object = bat_list_at(&document->list, i);
        bat_id id = bat_object_id(object);
        if (id == 0 || id > BAT_ID_MAX || bat_object_parent(object) > BAT_ID_MAX)
            return "an id is out of range";
        if (id >= document->next) return "an id is not below the next one";
        const char *wrong = bat_object_check(object);
        if (wrong) return wrong;
    }
    if (!bat_list_holds(&document->list)) return "the list and its ids differ";
    int followers = 0;
    for (int i = 0; i < document->list.count; i++) {
        const bat_object *from[BAT_RECIPE_CURVES], *object = bat_list_at(&document->list, i);
        if (bat_document_is_left(document, i)) return "what an object follows is gone";
        if (!bat_document_sources(document, object, from)) return "what an object is made from is gone";
        followers += follows(object);
    }
    if (followers != document->followers) return "the objects that follow others are not counted";
    return bat_document_check_nesting(document);
}

uint64_t bat_document_digest(const bat_document *document) {
    uint64_t digest = bat_digest_begin();
    for (int i = 0; i < 4; i++) digest = bat_digest_double(digest, document->page[i]);
    if (bat_unit_is_said_by(document->unit, document->scale))
        digest = bat_digest_double(bat_digest_number(digest, (uint64_t)document->unit), document->scale);
    if (document->stand) digest = bat_digest_number(digest, (uint64_t)document->stand);
    digest = bat_digest_number(digest, (uint64_t)document->list.count);
    return bat_digest_number(digest, bat_list_digest(&document->list));
}
