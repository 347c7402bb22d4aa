/* An object: curves of one dimension with one style, perhaps made of a spline or of levels. Copies share what they do not
 * change. */
#include "document/object.h"

#include "document/digest.h"
#include "document/picture.h"
#include "base/users.h"
#include "kinds/levelled.h"
#include "kinds/spline.h"
#include "text/utf8.h"

#include <batten/measure.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A curve with its box, counted: an object that differs in one curve of many costs one curve. */
typedef struct part {
    bat_users users;
    const bat_curve *curve; /* owned, or the finest of the shape, which is */
    bat_shape *shape;
    double box[4];
    uint64_t digest; /* of shape or curve: made once, since each step asks for that of the whole document */
} part;

/* What objects of every kind have, besides the name; copies take it over as a whole. */
typedef struct head {
    bat_id id;
    bat_id parent; /* of the group it is in, 0: in none */
    bool hidden, locked;
    bat_style style;
} head;

struct bat_object {
    bat_users users;
    bat_kind kind;
    head head;
    double box[4];
    int axis;  /* of a guide, else -1 */
    double at; /* of a guide, else 0 */
    int count;
    part **parts;
    bat_kept_spline *spline; /* SPLINE: what the one curve is made of; else NULL */
    bat_picture *picture;    /* IMAGE: what is placed by the matrix; else NULL */
    double matrix[6];
    const char *name; /* behind the parts, in the same block */
};

bat_style bat_style_defaults(void) {
    return (bat_style){.stroked = true,
                       .stroke = 0x000000ff,
                       .fill = 0x000000ff,
                       .width = 2,
                       .opacity = 1,
                       .cap = BAT_CAP_ROUND,
                       .join = BAT_JOIN_ROUND,
                       .miter_limit = 4};
}

bool bat_style_valid(const bat_style *style) {
    return style->width >= 0 && style->width <= BAT_COORDINATE_MAX && style->opacity >= 0 &&
           style->opacity <= 1 && style->miter_limit >= 1 && style->miter_limit <= BAT_COORDINATE_MAX &&
           (unsigned)style->cap <= BAT_CAP_SQUARE && (unsigned)style->join <= BAT_JOIN_BEVEL;
}

static part *part_create(void) {
    part *made = malloc(sizeof *made);
    if (made) *made = (part){.users = BAT_USERS_ONE};
    return made;
}

static void part_fill(part *made, const bat_curve *curve, bat_shape *shape) {
    double low[BAT_DIMENSION_MAX], high[BAT_DIMENSION_MAX];
    bat_curve_bounds(curve, low, high);
    made->curve = curve;
    made->shape = shape;
    made->digest = shape ? bat_kept_shape_digest(bat_digest_begin(), shape)
                         : bat_digest_curve(bat_digest_begin(), curve);
    made->box[0] = low[0], made->box[1] = low[1], made->box[2] = high[0], made->box[3] = high[1];
}

static void part_release(part *made) {
    if (!made || !bat_users_drop(&made->users)) return;
    if (made->shape)
        bat_shape_free(made->shape);
    else
        bat_curve_free((bat_curve *)made->curve);
    free(made);
}

/* One block: header, parts (unset), name. */
static bat_object *allocate(int count, const char *name) {
    size_t length = strlen(name) + 1;
    bat_object *object = malloc(sizeof *object + (size_t)count * sizeof(part *) + length);
    if (!object) return NULL;
    part **parts = (part **)(void *)(object + 1);
    char *text = (char *)(parts + count);
    memcpy(text, name, length);
    *object = (bat_object){.users = BAT_USERS_ONE,
                           .kind = BAT_KIND_PATH,
                           .axis = -1,
                           .count = count,
                           .parts = parts,
                           .name = text};
    return object;
}

void bat_object_corners(const bat_object *object, double corners[8]) {
    const double *m = object->matrix;
    double sides[2] = {0, 0};
    if (object->picture) bat_picture_sides(object->picture, sides);
    for (int i = 0; i < 4; i++) {
        double x = i == 1 || i == 2 ? sides[0] : 0, y = i >= 2 ? sides[1] : 0;
        corners[2 * i] = m[0] * x + m[2] * y + m[4];
        corners[2 * i + 1] = m[1] * x + m[3] * y + m[5];
    }
}

static void measure(bat_object *object) {
    object->box[0] = object->box[1] = INFINITY;
    object->box[2] = object->box[3] = -INFINITY;
    for (int i = 0; i < object->count; i++) {
        const double *box = object->parts[i]->box;
        for (int k = 0; k < 2; k++) {
            object->box[k] = fmin(object->box[k], box[k]);
            object->box[k + 2] = fmax(object->box[k + 2], box[k + 2]);
        }
    }
    if (!object->picture) return;
    double corners[8];
    bat_object_corners(object, corners);
    for (int i = 0; i < 8; i++) {
        object->box[i & 1] = fmin(object->box[i & 1], corners[i]);
        object->box[2 + (i & 1)] = fmax(object->box[2 + (i & 1)], corners[i]);
    }
}

bat_status bat_object_create_path(bat_id id, const char *name, const bat_style *style, int curve_count,
                                  bat_curve *const *curves, bat_object **out) {
    if (!style || !curves || !out || id == 0 || id > BAT_ID_MAX || !bat_style_valid(style))
        return BAT_ARGUMENT;
    if (curve_count < 1 || curve_count > BAT_POINTS_MAX) return BAT_COUNT;
    if (!name) name = "";
    if (!bat_utf8_valid(name, strlen(name))) return BAT_ARGUMENT;
    for (int i = 0; i < curve_count; i++) {
        if (!curves[i]) return BAT_ARGUMENT;
        if (bat_curve_dimension(curves[i]) != bat_curve_dimension(curves[0])) return BAT_DIMENSION;
    }
    bat_object *object = allocate(curve_count, name);
    if (!object) return BAT_MEMORY;
    object->head.id = id;
    object->head.style = *style;
    for (int i = 0; i < curve_count; i++) {
        object->parts[i] = part_create();
        if (!object->parts[i]) {
            while (i > 0) free(object->parts[--i]); /* the curves are still the caller's */
            free(object);
            return BAT_MEMORY;
        }
    }
    for (int i = 0; i < curve_count; i++) part_fill(object->parts[i], curves[i], NULL);
    measure(object);
    *out = object;
    return BAT_OK;
}

bat_status bat_object_create_spline(bat_id id, const char *name, const bat_style *style,
                                    const bat_spline *spline, const bat_tangents_options *options,
                                    bat_object **out) {
    bat_kept_spline *kept = NULL;
    bat_curve *curve = NULL;
    bat_object *object = NULL;
    bat_status status = bat_kept_spline_create(spline, options, &kept, &curve);
    if (status != BAT_OK) return status;
    status = out ? bat_object_create_path(id, name, style, 1, &curve, &object) : BAT_ARGUMENT;
    if (status != BAT_OK) {
        bat_curve_free(curve);
        bat_kept_spline_release(kept);
        return status;
    }
    object->kind = BAT_KIND_SPLINE;
    object->spline = kept;
    *out = object;
    return BAT_OK;
}

bat_status bat_object_create_group(bat_id id, const char *name, bool layer, bat_object **out) {
    if (!name) name = "";
    if (!out || id == 0 || id > BAT_ID_MAX || !bat_utf8_valid(name, strlen(name))) return BAT_ARGUMENT;
    bat_object *object = allocate(0, name);
    if (!object) return BAT_MEMORY;
    object->kind = layer ? BAT_KIND_LAYER : BAT_KIND_GROUP;
    object->head.id = id;
    object->head.style = bat_style_defaults();
    measure(object);
    *out = object;
    return BAT_OK;
}

/* Takes the matrix, -0 as 0 so that equal images have equal bits; false: it is out of range. */
static bool set_matrix(bat_object *object, const double matrix[6]) {
    for (int i = 0; i < 6; i++) object->matrix[i] = matrix[i] + 0.0;
    measure(object);
    bool good = matrix[0] * matrix[3] != matrix[1] * matrix[2];
    for (int i = 0; i < 4; i++) good = good && fabs(object->box[i]) <= BAT_COORDINATE_MAX;
    return good;
}

bat_status bat_object_create_image(bat_id id, const char *name, const bat_picture *picture,
                                   const double matrix[6], double opacity, bat_object **out) {
    if (!picture || !matrix || !(opacity >= 0 && opacity <= 1)) return BAT_ARGUMENT;
    bat_object *object;
    bat_status status = out ? bat_object_create_group(id, name, false, &object) : BAT_ARGUMENT;
    if (status != BAT_OK) return status;
    object->kind = BAT_KIND_IMAGE;
    object->head.style.stroked = false;
    object->head.style.filled = true; /* it covers what lies behind it */
    object->head.style.opacity = opacity;
    object->picture = bat_picture_retain(picture);
    if (!set_matrix(object, matrix)) {
        bat_object_release(object);
        return BAT_NUMBER;
    }
    *out = object;
    return BAT_OK;
}

bat_status bat_object_create_guide(bat_id id, int axis, double at, bat_object **out) {
    if (!out || id == 0 || id > BAT_ID_MAX || axis < 0 || axis > 1) return BAT_ARGUMENT;
    if (!(fabs(at) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    bat_object *object = allocate(0, "");
    if (!object) return BAT_MEMORY;
    object->kind = BAT_KIND_GUIDE;
    object->head.id = id;
    object->head.style = bat_style_defaults();
    object->axis = axis;
    object->at = at;
    measure(object);
    *out = object;
    return BAT_OK;
}

bat_status bat_object_with_curves(const bat_object *object, int count, bat_curve *const *curves,
                                  bat_object **out) {
    if (!object || !object->count) return BAT_ARGUMENT;
    bat_status status = bat_object_create_path(object->head.id, object->name, &object->head.style, count,
                                               curves, out);
    if (status == BAT_OK) (*out)->head = object->head;
    return status;
}

/* A copy that shares every part. */
static bat_object *share_as(const bat_object *object, const char *name) {
    bat_object *copy = allocate(object->count, name);
    if (!copy) return NULL;
    copy->kind = object->kind;
    copy->head = object->head;
    copy->axis = object->axis;
    copy->at = object->at;
    memcpy(copy->box, object->box, sizeof copy->box);
    for (int i = 0; i < object->count; i++) {
        copy->parts[i] = object->parts[i];
        bat_users_add(&copy->parts[i]->users);
    }
    copy->spline = object->spline;
    if (copy->spline) bat_users_add(&copy->spline->users);
    copy->picture = bat_picture_retain(object->picture);
    memcpy(copy->matrix, object->matrix, sizeof copy->matrix);
    return copy;
}

static bat_object *share(const bat_object *object) { return share_as(object, object->name); }

/* What curves are made of says what the object is. */
static void settle_kind(bat_object *object) {
    bat_kept_spline_release(object->spline);
    object->spline = NULL;
    object->kind = BAT_KIND_PATH;
    for (int i = 0; i < object->count; i++)
        if (object->parts[i]->shape) object->kind = BAT_KIND_SHAPE;
}

/* The curve, or the finest of the shape, in place of one of the object's. */
static bat_status with_part(const bat_object *object, int index, const bat_curve *curve, bat_shape *shape,
                            bat_object **out) {
    if (!object || !curve || !out || index < 0 || index >= object->count) return BAT_ARGUMENT;
    if (bat_curve_dimension(curve) != bat_curve_dimension(object->parts[0]->curve)) return BAT_DIMENSION;
    part *made = part_create();
    bat_object *copy = made ? share(object) : NULL;
    if (!copy) {
        free(made);
        return BAT_MEMORY;
    }
    part_release(copy->parts[index]);
    part_fill(made, curve, shape);
    copy->parts[index] = made;
    settle_kind(copy); /* nobody's points give this curve */
    measure(copy);
    *out = copy;
    return BAT_OK;
}

bat_status bat_object_with_curve(const bat_object *object, int index, bat_curve *curve, bat_object **out) {
    return with_part(object, index, curve, NULL, out);
}

bat_status bat_object_with_shape(const bat_object *object, int index, bat_shape *shape, bat_object **out) {
    return shape ? with_part(object, index, bat_shape_curve(shape, bat_shape_levels(shape)), shape, out)
                 : BAT_ARGUMENT;
}

bat_status bat_object_with_style(const bat_object *object, const bat_style *style, bat_object **out) {
    if (!object || !style || !out || !bat_style_valid(style)) return BAT_ARGUMENT;
    bat_object *copy = share(object);
    if (!copy) return BAT_MEMORY;
    if (object->picture)
        copy->head.style.opacity = style->opacity;
    else
        copy->head.style = *style;
    *out = copy;
    return BAT_OK;
}

bat_status bat_object_with_matrix(const bat_object *object, const double matrix[6], bat_object **out) {
    if (!object || !object->picture || !matrix || !out) return BAT_ARGUMENT;
    bat_object *copy = share(object);
    if (!copy) return BAT_MEMORY;
    if (!set_matrix(copy, matrix)) {
        bat_object_release(copy);
        return BAT_NUMBER;
    }
    *out = copy;
    return BAT_OK;
}

bat_status bat_object_with_guide(const bat_object *object, double at, bat_object **out) {
    if (!object || object->axis < 0 || !out) return BAT_ARGUMENT;
    if (!(fabs(at) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    bat_object *copy = share(object);
    if (!copy) return BAT_MEMORY;
    copy->at = at;
    *out = copy;
    return BAT_OK;
}

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
    bat_object *copy = share_as(object, name);
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

bat_status bat_object_with_spline(const bat_object *object, const bat_spline *spline, bat_object **out) {
    if (!object || !object->spline) return BAT_ARGUMENT;
    bat_status status = bat_object_create_spline(object->head.id, object->name, &object->head.style, spline,
                                                 &object->spline->options, out);
    if (status == BAT_OK) (*out)->head = object->head;
    return status;
}

/* The part without its levels. */
static bat_status flatten(part **at) {
    bat_curve *curve = NULL;
    part *plain = part_create();
    bat_status status = plain ? bat_curve_copy((*at)->curve, &curve) : BAT_MEMORY;
    if (status != BAT_OK) {
        free(plain);
        return status;
    }
    part_fill(plain, curve, NULL);
    part_release(*at);
    *at = plain;
    return BAT_OK;
}

bat_status bat_object_to_path(const bat_object *object, bat_object **out) {
    if (!object || !out || (object->kind != BAT_KIND_SPLINE && object->kind != BAT_KIND_SHAPE))
        return BAT_ARGUMENT;
    bat_object *copy = share(object);
    if (!copy) return BAT_MEMORY;
    for (int i = 0; i < copy->count; i++) {
        bat_status status = copy->parts[i]->shape ? flatten(&copy->parts[i]) : BAT_OK;
        if (status == BAT_OK) continue;
        bat_object_release(copy);
        return status;
    }
    settle_kind(copy);
    *out = copy;
    return BAT_OK;
}

bat_object *bat_object_retain(const bat_object *object) {
    bat_object *user = (bat_object *)object; /* the count is no part of the value */
    if (user) bat_users_add(&user->users);
    return user;
}

void bat_object_release(bat_object *object) {
    if (!object || !bat_users_drop(&object->users)) return;
    for (int i = 0; i < object->count; i++) part_release(object->parts[i]);
    bat_kept_spline_release(object->spline);
    bat_picture_release(object->picture);
    free(object);
}

bat_id bat_object_id(const bat_object *object) { return object->head.id; }
bat_kind bat_object_kind(const bat_object *object) { return object->kind; }
const char *bat_object_name(const bat_object *object) { return object->name; }
const bat_style *bat_object_style(const bat_object *object) { return &object->head.style; }
bat_id bat_object_parent(const bat_object *object) { return object->head.parent; }
bool bat_object_hidden(const bat_object *object) { return object->head.hidden; }
bool bat_object_locked(const bat_object *object) { return object->head.locked; }
bool bat_object_is_group(const bat_object *object) {
    return object->kind == BAT_KIND_GROUP || object->kind == BAT_KIND_LAYER;
}
bool bat_object_is_drawn(const bat_object *object) {
    return !bat_object_is_group(object) && object->kind != BAT_KIND_GUIDE;
}

int bat_object_guide(const bat_object *object, double *at) {
    if (object->axis >= 0) *at = object->at;
    return object->axis;
}

int bat_object_curve_count(const bat_object *object) { return object->count; }

const bat_curve *bat_object_curve(const bat_object *object, int index) {
    return index >= 0 && index < object->count ? object->parts[index]->curve : NULL;
}

const bat_spline *bat_object_spline(const bat_object *object) {
    return object->spline ? &object->spline->spline : NULL;
}

const bat_picture *bat_object_picture(const bat_object *object) { return object->picture; }
const double *bat_object_matrix(const bat_object *object) { return object->picture ? object->matrix : NULL; }

const bat_tangents_options *bat_object_spline_options(const bat_object *object) {
    return object->spline ? &object->spline->options : NULL;
}

const bat_shape *bat_object_shape(const bat_object *object, int index) {
    return index >= 0 && index < object->count ? object->parts[index]->shape : NULL;
}

const char *bat_object_check_makings(const bat_object *object) {
    int shapes = 0;
    for (int i = 0; i < object->count; i++) {
        const bat_shape *shape = object->parts[i]->shape;
        const char *wrong = shape ? bat_kept_shape_check(shape) : NULL;
        if (wrong) return wrong;
        shapes += shape != NULL;
    }
    if ((object->kind == BAT_KIND_SHAPE) != (shapes > 0)) return "a shape has no levels";
    if ((object->kind == BAT_KIND_SPLINE) != (object->spline != NULL)) return "a spline has no points";
    if (!object->spline) return NULL;
    if (object->count != 1) return "a spline has more than one curve";
    return bat_kept_spline_check(object->spline, object->parts[0]->curve);
}

void bat_object_bounds(const bat_object *object, double box[4]) { memcpy(box, object->box, 4 * sizeof *box); }

uint64_t bat_digest_object(uint64_t digest, const bat_object *object) {
    const bat_style *style = &object->head.style;
    digest = bat_digest_number(digest, (uint64_t)object->kind);
    digest = bat_digest_number(digest, object->head.id);
    digest = bat_digest_text(digest, object->name);
    digest = bat_digest_number(digest, style->stroked);
    digest = bat_digest_number(digest, style->filled);
    digest = bat_digest_number(digest, style->even_odd);
    digest = bat_digest_number(digest, style->stroke);
    digest = bat_digest_number(digest, style->fill);
    digest = bat_digest_double(digest, style->width);
    digest = bat_digest_double(digest, style->opacity);
    digest = bat_digest_number(digest, (uint64_t)style->cap);
    digest = bat_digest_number(digest, (uint64_t)style->join);
    digest = bat_digest_double(digest, style->miter_limit);
    digest = bat_digest_number(digest, (uint64_t)object->count);
    for (int i = 0; i < object->count; i++) digest = bat_digest_number(digest, object->parts[i]->digest);
    if (object->head.parent) digest = bat_digest_number(digest, object->head.parent << 2 | 1);
    if (object->head.hidden) digest = bat_digest_number(digest, 2);
    if (object->head.locked) digest = bat_digest_number(digest, 3);
    if (object->spline) digest = bat_kept_spline_digest(digest, object->spline);
    if (object->picture) {
        digest = bat_digest_number(digest, bat_picture_digest(object->picture));
        for (int i = 0; i < 6; i++) digest = bat_digest_double(digest, object->matrix[i]);
    }
    if (object->axis >= 0)
        digest = bat_digest_double(bat_digest_number(digest, (uint64_t)object->axis), object->at);
    return digest;
}
