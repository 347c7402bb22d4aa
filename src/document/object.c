/* An object: a head, curves, and the own part of its kind. Copies share everything that is not changed in
 * them. */
#include "document/object.h"

#include "base/users.h"
#include "curve/curve.h"
#include "document/clip.h"
#include "document/digest.h"
#include "document/document.h"
#include "document/kind.h"
#include "document/levelled.h"
#include "document/markers.h"
#include "document/paint.h"
#include "document/style.h"
#include "text/json.h"
#include "text/utf8.h"

#include <batten/measure.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A reference-counted curve with its box: an object that differs in one curve of many costs only that curve. */
typedef struct part {
    bat_users users;
    const bat_curve *curve; /* owned; or the finest curve of `shape`, which is then owned */
    bat_shape *shape;
    double box[4], depth[2];
    uint64_t digest; /* of shape or curve: computed once, as each step digests the whole document */
} part;

/* What objects of every kind have besides the name; copies keep all of it. */
typedef struct head {
    bat_id id;
    bat_id parent; /* id of the group that it is in; 0: none */
    bool hidden, locked;
    bat_style style;
    bat_painted *paint;   /* NULL: none */
    bat_clip *clip;       /* NULL: none */
    bat_markers *markers; /* NULL: none */
} head;

struct bat_object {
    bat_users users;
    const bat_kind_type *type;
    head head;
    double box[4], depth[2];
    int count;
    void *own; /* follows the object in the same block, as do the parts and the name */
    part **parts;
    const char *name;
};

static part *part_create(void) {
    part *made = malloc(sizeof *made);
    if (made) *made = (part){.users = BAT_USERS_ONE};
    return made;
}

static void part_fill(part *made, const bat_curve *curve, bat_shape *shape) {
    double low[BAT_DIMENSION_MAX] = {0}, high[BAT_DIMENSION_MAX] = {0};
    bat_curve_bounds(curve, low, high);
    made->curve = curve;
    made->shape = shape;
    made->digest = shape ? bat_digest_shape(bat_digest_begin(), shape)
                         : bat_digest_curve(bat_digest_begin(), curve);
    made->box[0] = low[0], made->box[1] = low[1], made->box[2] = high[0], made->box[3] = high[1];
    made->depth[0] = low[2], made->depth[1] = high[2];
}

static void part_release(part *made) {
    if (!made || !bat_users_drop(&made->users)) return;
    if (made->shape)
        bat_shape_free(made->shape);
    else
        bat_curve_free((bat_curve *)made->curve);
    free(made);
}

int bat_object_share_curves(bat_object *object, const bat_object *other) {
    int count = 0;
    for (int i = 0; i < object->count && i < other->count; i++) {
        part *own = object->parts[i], *its = other->parts[i];
        if (own->shape || its->shape || own->digest != its->digest ||
            !bat_curve_is_equal(own->curve, its->curve))
            continue;
        bat_users_add(&its->users);
        object->parts[i] = its;
        part_release(own);
        count++;
    }
    return count;
}

/* One block: header, own part (zeros), parts (not set), name. */
static bat_object *allocate(const bat_kind_type *type, int count, const char *name) {
    size_t length = strlen(name) + 1;
    bat_object *object = malloc(sizeof *object + type->size + (size_t)count * sizeof(part *) + length);
    if (!object) return NULL;
    char *own = (char *)(object + 1);
    part **parts = (part **)(void *)(own + type->size);
    char *text = (char *)(parts + count);
    memset(own, 0, type->size);
    memcpy(text, name, length);
    *object = (bat_object){
        .users = BAT_USERS_ONE, .type = type, .count = count, .own = own, .parts = parts, .name = text};
    return object;
}

static void measure(bat_object *object) {
    object->box[0] = object->box[1] = INFINITY;
    object->box[2] = object->box[3] = -INFINITY;
    object->depth[0] = INFINITY, object->depth[1] = -INFINITY;
    for (int i = 0; i < object->count; i++) {
        const double *box = object->parts[i]->box;
        for (int k = 0; k < 2; k++) {
            object->box[k] = fmin(object->box[k], box[k]);
            object->box[k + 2] = fmax(object->box[k + 2], box[k + 2]);
        }
        object->depth[0] = fmin(object->depth[0], object->parts[i]->depth[0]);
        object->depth[1] = fmax(object->depth[1], object->parts[i]->depth[1]);
    }
    if (object->type->bounds) object->type->bounds(object->own, object->box);
    if (!object->count && object->box[0] <= object->box[2]) object->depth[0] = object->depth[1] = 0;
}

/* An object's head that it shares with another: what it refers to has one more user. */
static void set_head(bat_object *object, const head *with) {
    object->head = *with;
    bat_painted_retain(with->paint);
    bat_clip_retain(with->clip);
    bat_markers_retain(with->markers);
}

static bat_status make(const bat_kind_type *type, const head *with, const char *name, const void *own,
                       int count, bat_curve *const *curves, bat_object **out) {
    bat_object *object = allocate(type, count, name);
    if (!object) return BAT_MEMORY;
    for (int i = 0; i < count; i++) {
        object->parts[i] = part_create();
        if (!object->parts[i]) {
            while (i > 0) free(object->parts[--i]); /* the curves still belong to the caller */
            free(object);
            return BAT_MEMORY;
        }
    }
    set_head(object, with);
    for (int i = 0; i < count; i++) part_fill(object->parts[i], curves[i], NULL);
    if (own) memcpy(object->own, own, type->size);
    measure(object);
    *out = object;
    return BAT_OK;
}

static bat_status check_curves(const bat_kind_type *type, int count, bat_curve *const *curves) {
    if (!(type->traits & BAT_CURVES)) return BAT_OK;
    if (!curves) return BAT_ARGUMENT;
    if (count < 1 || count > BAT_POINTS_MAX) return BAT_COUNT;
    for (int i = 0; i < count; i++) {
        if (!curves[i]) return BAT_ARGUMENT;
        if (bat_curve_dimension(curves[i]) != bat_curve_dimension(curves[0])) return BAT_DIMENSION;
    }
    return BAT_OK;
}

bat_status bat_object_head_check(bat_id id, const char *name, const bat_style *style, bat_problem *problem) {
    if (bat_problem_outside(problem, "id", 0, 1, (double)BAT_ID_MAX, (double)id)) return BAT_ARGUMENT;
    if (name && !bat_utf8_valid(name, strlen(name)))
        return bat_problem_set(problem, BAT_ARGUMENT, "name", "expected UTF-8, found other bytes");
    return style ? bat_problem_inside(problem, bat_style_check(style, problem), "style") : BAT_OK;
}

bat_status bat_object_make(const bat_kind_type *type, bat_id id, const char *name, const bat_style *style,
                           const void *own, int count, bat_curve *const *curves, bat_object **out) {
    bat_status status = out ? bat_object_head_check(id, name, style, NULL) : BAT_ARGUMENT;
    if (status == BAT_OK) status = check_curves(type, count, curves);
    head with = {.id = id, .style = style ? *style : bat_style_defaults()};
    return status == BAT_OK ? make(type, &with, name ? name : "", own, count, curves, out) : status;
}

bat_status bat_object_remake(const bat_object *object, const bat_kind_type *type, const void *own, int count,
                             bat_curve *const *curves, bat_object **out) {
    if (!out) return BAT_ARGUMENT;
    bat_status status = check_curves(type, count, curves);
    return status == BAT_OK ? make(type, &object->head, object->name, own, count, curves, out) : status;
}

/* A copy that shares every part; of the same type, or of another type without an own part. */
static bat_object *share_as(const bat_object *object, const bat_kind_type *type, const char *name) {
    bat_object *copy = allocate(type, object->count, name);
    if (!copy) return NULL;
    set_head(copy, &object->head);
    memcpy(copy->box, object->box, sizeof copy->box);
    memcpy(copy->depth, object->depth, sizeof copy->depth);
    for (int i = 0; i < object->count; i++) {
        copy->parts[i] = object->parts[i];
        bat_users_add(&copy->parts[i]->users);
    }
    if (type != object->type) return copy;
    memcpy(copy->own, object->own, type->size);
    if (type->share) type->share(copy->own);
    return copy;
}

static bat_object *share(const bat_object *object) { return share_as(object, object->type, object->name); }

bat_status bat_object_with_part(const bat_object *object, const bat_kind_type *type, int index,
                                const bat_curve *curve, bat_shape *shape, bat_object **out) {
    if (!object || !curve || !out || index < 0 || index >= object->count) return BAT_ARGUMENT;
    if (!bat_object_is_made_of_curves(object)) return BAT_ARGUMENT;
    if (bat_curve_dimension(curve) != bat_curve_dimension(object->parts[0]->curve)) return BAT_DIMENSION;
    part *made = part_create();
    bat_object *copy = made ? share_as(object, type, object->name) : NULL;
    if (!copy) {
        free(made);
        return BAT_MEMORY;
    }
    part_release(copy->parts[index]);
    part_fill(made, curve, shape);
    copy->parts[index] = made;
    measure(copy);
    *out = copy;
    return BAT_OK;
}

bat_status bat_object_regroup(const bat_object *object, const bat_kind_type *type, int count,
                              const bat_object_part *list, bat_object **out) {
    if (!object || !list || !out) return BAT_ARGUMENT;
    if (count < 1 || count > BAT_POINTS_MAX) return BAT_COUNT;
    for (int i = 0; i < count; i++) {
        if (!bat_object_is_made_of_curves(list[i].object)) return BAT_ARGUMENT;
        if (list[i].curve < 0 || list[i].curve >= list[i].object->count) return BAT_ARGUMENT;
        if (bat_curve_dimension(list[i].object->parts[list[i].curve]->curve) !=
            bat_curve_dimension(list[0].object->parts[list[0].curve]->curve))
            return BAT_DIMENSION;
    }
    bat_object *made = allocate(type, count, object->name);
    if (!made) return BAT_MEMORY;
    set_head(made, &object->head);
    for (int i = 0; i < count; i++) {
        made->parts[i] = list[i].object->parts[list[i].curve];
        bat_users_add(&made->parts[i]->users);
    }
    measure(made);
    *out = made;
    return BAT_OK;
}

/* A gradient goes when the colour that it stands for is changed. */
static bat_status keep_paint(bat_object *object, const bat_style *style) {
    const bat_style *was = &object->head.style;
    if (!object->head.paint || (was->fill == style->fill && was->stroke == style->stroke)) return BAT_OK;
    bat_paint paint = *bat_painted_paint(object->head.paint);
    if (was->fill != style->fill) paint.fill.count = 0;
    if (was->stroke != style->stroke) paint.stroke.count = 0;
    bat_painted *kept = NULL;
    const bat_status status = bat_painted_create(&paint, &kept);
    if (status != BAT_OK) return status;
    bat_painted_release(object->head.paint);
    object->head.paint = kept;
    return BAT_OK;
}

/* The same in another colour; takes `copy` over. */
static bat_status recolour(bat_object *copy, uint32_t colour, bat_object **out) {
    const bool same = copy->head.style.fill == colour;
    copy->head.style.fill = colour;
    if (same) {
        *out = copy;
        return BAT_OK;
    }
    bat_object *made = NULL;
    const bat_status status = copy->type->restyle(copy, &made);
    bat_object_release(copy);
    if (status == BAT_OK) *out = made;
    return status;
}

bat_status bat_object_with_style(const bat_object *object, const bat_style *style, bat_object **out) {
    if (!object || !style || !out || bat_style_check(style, NULL) != BAT_OK) return BAT_ARGUMENT;
    bat_object *copy = share(object);
    if (!copy) return BAT_MEMORY;
    const bat_status status = keep_paint(copy, style);
    if (status != BAT_OK) {
        bat_object_release(copy);
        return status;
    }
    if (bat_object_is(object, BAT_CURVES))
        copy->head.style = *style;
    else if (bat_object_is(object, BAT_DRAWN) ||
             bat_object_is(object, BAT_HOLDS)) /* what paints nothing has no style, and files store none */
        copy->head.style.opacity = style->opacity;
    if (copy->type->restyle) return recolour(copy, style->fill, out);
    *out = copy;
    return BAT_OK;
}

bat_status bat_object_faded(const bat_object *object, double factor, bat_object **out) {
    bat_style style = *bat_object_style(object);
    style.opacity *= factor;
    return bat_object_with_style(object, &style, out);
}

bat_status bat_object_with_paint(const bat_object *object, const bat_paint *paint, bat_object **out) {
    if (!object || !out || !bat_object_is_made_of_curves(object)) return BAT_ARGUMENT;
    bat_painted *made = NULL;
    const bat_status status = paint ? bat_painted_create(paint, &made) : BAT_OK;
    if (status != BAT_OK) return status;
    bat_object *copy = share(object);
    if (!copy) {
        bat_painted_release(made);
        return BAT_MEMORY;
    }
    bat_painted_release(copy->head.paint);
    copy->head.paint = made;
    *out = copy;
    return BAT_OK;
}

bat_status bat_object_filled_as_stroke(const bat_object *object, bat_object **out) {
    bat_style style = *bat_object_style(object);
    const bat_paint *before = bat_object_paint(object);
    bat_object *styled = NULL;
    bat_paint paint = {0};
    style.stroked = false, style.filled = true, style.fill = style.stroke, style.even_odd = false;
    if (before) paint.fill = before->stroke;
    bat_status status = bat_object_with_style(object, &style, &styled);
    if (status == BAT_OK) status = bat_object_with_paint(styled, &paint, out);
    bat_object_release(styled);
    return status;
}

bat_status bat_object_with_clip(const bat_object *object, const bat_clip *clip, bat_object **out) {
    if (!object || !out || !(bat_object_is(object, BAT_DRAWN) || bat_object_is(object, BAT_HOLDS)))
        return BAT_ARGUMENT;
    bat_object *copy = share(object);
    if (!copy) return BAT_MEMORY;
    bat_clip_release(copy->head.clip);
    copy->head.clip = bat_clip_retain(clip);
    *out = copy;
    return BAT_OK;
}

const bat_clip *bat_object_clip(const bat_object *object) { return object->head.clip; }

bat_status bat_object_with_markers(const bat_object *object, const bat_markers *markers, bat_object **out) {
    if (!object || !out || !bat_object_is_made_of_curves(object)) return BAT_ARGUMENT;
    bat_object *copy = share(object);
    if (!copy) return BAT_MEMORY;
    bat_markers_release(copy->head.markers);
    copy->head.markers = bat_markers_retain(markers);
    *out = copy;
    return BAT_OK;
}

const bat_markers *bat_object_markers(const bat_object *object) { return object->head.markers; }

const bat_paint *bat_object_paint(const bat_object *object) { return bat_painted_paint(object->head.paint); }

bat_status bat_object_with_parent(const bat_object *object, bat_id parent, bat_object **out) {
    if (!object || !out || parent > BAT_ID_MAX || parent == object->head.id) return BAT_ARGUMENT;
    bat_object *copy = share(object);
    if (!copy) return BAT_MEMORY;
    copy->head.parent = parent;
    *out = copy;
    return BAT_OK;
}

bat_status bat_object_with_name(const bat_object *object, const char *name, bat_object **out) {
    if (!object || !name || !out || !bat_utf8_valid(name, strlen(name))) return BAT_ARGUMENT;
    bat_object *copy = share_as(object, object->type, name);
    if (!copy) return BAT_MEMORY;
    *out = copy;
    return BAT_OK;
}

bat_status bat_object_with_state(const bat_object *object, bool hidden, bool locked, bat_object **out) {
    if (!object || !out) return BAT_ARGUMENT;
    bat_object *copy = share(object);
    if (!copy) return BAT_MEMORY;
    copy->head.hidden = hidden;
    copy->head.locked = locked;
    *out = copy;
    return BAT_OK;
}

bat_status bat_object_with_id(const bat_object *object, bat_id id, bat_object **out) {
    if (!object || !out || id == 0 || id > BAT_ID_MAX || id == object->head.parent) return BAT_ARGUMENT;
    bat_object *copy = share(object);
    if (!copy) return BAT_MEMORY;
    copy->head.id = id;
    *out = copy;
    return BAT_OK;
}

bat_object *bat_object_retain(const bat_object *object) {
    bat_object *user = (bat_object *)object; /* the reference count is not part of the value */
    if (user) bat_users_add(&user->users);
    return user;
}

void bat_object_release(bat_object *object) {
    if (!object || !bat_users_drop(&object->users)) return;
    bat_painted_release(object->head.paint);
    bat_clip_release(object->head.clip);
    bat_markers_release(object->head.markers);
    for (int i = 0; i < object->count; i++) part_release(object->parts[i]);
    if (object->type->end) object->type->end(object->own);
    free(object);
}

const bat_kind_type *bat_object_type(const bat_object *object) { return object->type; }
const void *bat_object_own(const bat_object *object, const bat_kind_type *type) {
    return object->type == type ? object->own : NULL;
}

bat_id bat_object_id(const bat_object *object) { return object->head.id; }
bat_kind bat_object_kind(const bat_object *object) { return object->type->number; }
const char *bat_object_name(const bat_object *object) { return object->name; }
const bat_style *bat_object_style(const bat_object *object) { return &object->head.style; }
bat_id bat_object_parent(const bat_object *object) { return object->head.parent; }
bool bat_object_is_hidden(const bat_object *object) { return object->head.hidden; }
bool bat_object_is_locked(const bat_object *object) { return object->head.locked; }
bool bat_object_is_group(const bat_object *object) { return bat_object_is(object, BAT_HOLDS); }
bat_id bat_object_followed(const bat_object *object) {
    return object->type->followed ? object->type->followed(object) : 0;
}
int bat_object_sources(const bat_object *object, const bat_id **ids) {
    int count = 0;
    const bat_id *found = object->type->sources ? object->type->sources(object, &count) : NULL;
    if (ids) *ids = found;
    return count;
}
bool bat_object_is_drawn(const bat_object *object) { return bat_object_is(object, BAT_DRAWN); }
bool bat_object_is_made_of_curves(const bat_object *object) {
    return object && bat_object_is(object, BAT_CURVES) && !bat_object_is(object, BAT_FIXED);
}

bool bat_object_is_one_curve(const bat_object *object) {
    return bat_object_is_made_of_curves(object) && object->count == 1;
}

bool bat_object_leads(const bat_object *object) {
    return bat_object_is_made_of_curves(object) && bat_object_sources(object, NULL) == 0;
}

int bat_object_curve_count(const bat_object *object) { return object->count; }

const bat_curve *bat_object_curve(const bat_object *object, int index) {
    return index >= 0 && index < object->count ? object->parts[index]->curve : NULL;
}

uint64_t bat_object_curve_digest(const bat_object *object, int index) {
    return index >= 0 && index < object->count ? object->parts[index]->digest : 0;
}

const bat_shape *bat_object_shape(const bat_object *object, int index) {
    return index >= 0 && index < object->count ? object->parts[index]->shape : NULL;
}

void bat_object_bounds(const bat_object *object, double box[4]) { memcpy(box, object->box, 4 * sizeof *box); }
void bat_object_depth(const bat_object *object, double z[2]) { memcpy(z, object->depth, 2 * sizeof *z); }

const char *bat_object_check(const bat_object *object) {
    if (bat_style_check(&object->head.style, NULL) != BAT_OK) return "a style is out of range";
    if (!bat_object_is(object, BAT_CURVES)) {
        if (object->count) return "an object has curves whose kind has none";
    } else if (object->count < 1) {
        return "a path has no curve";
    }
    for (int i = 0; i < object->count; i++) {
        const bat_curve *curve = object->parts[i]->curve;
        if (bat_curve_validate(curve) != BAT_OK) return "a curve is not valid";
        if (bat_curve_dimension(curve) != bat_curve_dimension(object->parts[0]->curve))
            return "the curves of a path differ in dimension";
    }
    return object->type->check ? object->type->check(object) : NULL;
}

uint64_t bat_digest_object(uint64_t digest, const bat_object *object) {
    digest = bat_digest_number(digest, (uint64_t)object->type->number);
    digest = bat_digest_number(digest, object->head.id);
    digest = bat_digest_text(digest, object->name);
    digest = bat_style_digest(digest, &object->head.style);
    digest = bat_digest_number(digest, (uint64_t)object->count);
    for (int i = 0; i < object->count; i++) digest = bat_digest_number(digest, object->parts[i]->digest);
    if (object->head.parent) digest = bat_digest_number(digest, object->head.parent << 2 | 1);
    if (object->head.hidden) digest = bat_digest_number(digest, 2);
    if (object->head.locked) digest = bat_digest_number(digest, 3);
    if (object->head.paint) digest = bat_digest_number(digest, bat_painted_digest(object->head.paint));
    if (object->head.clip) digest = bat_digest_number(digest, bat_clip_digest(object->head.clip));
    if (object->head.markers) digest = bat_digest_number(digest, bat_markers_digest(object->head.markers));
    return object->type->digest ? object->type->digest(digest, object->own) : digest;
}
