/* A path: one or more curves of one dimension that share a style. A shape: the same, but some of its curves
 * are the finest ones of shapes with levels. Bound curves: the same, but wires take them along. */
#include "base/pose.h"
#include "base/matrix.h"
#include "curve/curve.h"
#include "document/bound.h"
#include "document/digest.h"
#include "document/levelled.h"
#include "format/json/bound.h"
#include "format/json/curve.h"
#include "format/json/shape.h"
#include "format/json/style.h"
#include "kinds/kinds.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* On failure, frees curves that were taken over and have not become part of an object. */
static bat_status dropped(bat_status status, int count, bat_curve *const *curves) {
    for (int i = 0; status != BAT_OK && curves && i < count; i++) bat_curve_free(curves[i]);
    return status;
}

bat_status bat_object_create_path(bat_id id, const char *name, const bat_style *style, int curve_count,
                                  bat_curve *const *curves, bat_object **out) {
    bat_status status = style ? bat_object_make(&bat_kind_of_path, id, name, style, NULL, curve_count, curves,
                                                out)
                              : BAT_ARGUMENT;
    return dropped(status, curve_count, curves);
}

bat_status bat_object_with_curves(const bat_object *object, int count, bat_curve *const *curves,
                                  bat_object **out) {
    bat_status status = bat_object_is_made_of_curves(object)
                            ? bat_object_remake(object, &bat_kind_of_path, NULL, count, curves, out)
                            : BAT_ARGUMENT;
    return dropped(status, count, curves);
}

/* What its curves are made from decides which kind an object is. */
bat_status bat_object_with_curve(const bat_object *object, int index, bat_curve *curve, bat_object **out) {
    bool levels = false;
    for (int i = 0; object && i < bat_object_curve_count(object); i++)
        levels = levels || (i != index && bat_object_shape(object, i));
    const bat_kind_type *type = levels ? &bat_kind_of_shape : &bat_kind_of_path;
    return dropped(bat_object_with_part(object, type, index, curve, NULL, out), 1, &curve);
}

bat_status bat_path_of_parts(const bat_object *head, int count, const bat_object_part *list,
                             bat_object **out) {
    bool levels = false;
    for (int i = 0; list && i < count && !levels; i++)
        levels = bat_object_shape(list[i].object, list[i].curve) != NULL;
    return bat_object_regroup(head, levels ? &bat_kind_of_shape : &bat_kind_of_path, count, list, out);
}

bat_status bat_object_with_shape(const bat_object *object, int index, bat_shape *shape, bat_object **out) {
    if (!shape) return BAT_ARGUMENT;
    const bat_curve *finest = bat_shape_curve(shape, bat_shape_levels(shape));
    bat_status status = bat_object_with_part(object, &bat_kind_of_shape, index, finest, shape, out);
    if (status != BAT_OK) bat_shape_free(shape);
    return status;
}

bat_status bat_object_with_each(const bat_object *object, bat_curve_maker *make, void *context,
                                bat_object **out) {
    int count = bat_object_curve_count(object), made = 0;
    bat_curve **curves = calloc((size_t)count + 1, sizeof *curves);
    bat_status status = curves ? BAT_OK : BAT_MEMORY;
    while (status == BAT_OK && made < count) {
        status = make(context, bat_object_curve(object, made), &curves[made]);
        made += status == BAT_OK;
    }
    if (status == BAT_OK)
        status = bat_object_with_curves(object, count, curves, out);
    else
        while (made > 0) bat_curve_free(curves[--made]);
    free(curves);
    return status;
}

bat_status bat_object_keep_levels(const bat_object *from, int dimension, bat_object **made) {
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_object_curve_count(from) && status == BAT_OK; i++) {
        bat_shape *shape = NULL;
        bat_object *more = NULL;
        if (!bat_object_shape(from, i)) continue;
        status = bat_shape_to_dimension(bat_object_shape(from, i), dimension, &shape);
        if (status == BAT_SINGULAR) {
            status = BAT_OK;
            continue;
        }
        if (status == BAT_OK) status = bat_object_with_shape(*made, i, shape, &more);
        if (status != BAT_OK) break;
        bat_object_release(*made);
        *made = more;
    }
    if (status != BAT_OK) {
        bat_object_release(*made);
        *made = NULL;
    }
    return status;
}

static bat_status copied(void *none, const bat_curve *curve, bat_curve **out) {
    (void)none;
    return bat_curve_copy(curve, out);
}

bat_status bat_object_to_path(const bat_object *object, bat_object **out) {
    if (!out || !bat_object_is_made_of_curves(object) || !bat_object_is(object, BAT_MADE))
        return BAT_ARGUMENT;
    return bat_object_with_each(object, copied, NULL, out);
}

bat_status bat_document_of_curves(int count, bat_curve *const *curves, const char *const *names, double width,
                                  bat_document **out) {
    bat_document *document = NULL;
    bat_status status = bat_document_create(&document);
    bat_style style = bat_style_defaults();
    if (width > 0) style.width = width;
    if (status == BAT_OK) status = bat_document_set_scale(document, 1, BAT_UNIT_NONE);
    for (int i = 0; i < count; i++) {
        bat_object *object = NULL;
        if (status == BAT_OK)
            status = bat_object_create_path(bat_document_new_id(document), names ? names[i] : NULL, &style, 1,
                                            &curves[i], &object);
        else
            bat_curve_free(curves[i]);
        if (status == BAT_OK) status = bat_document_insert(document, i, object);
        bat_object_release(object);
    }
    if (status != BAT_OK)
        bat_document_free(document);
    else
        *out = document;
    return status;
}

static const char *check(const bat_object *object) {
    int shapes = 0;
    for (int i = 0; i < bat_object_curve_count(object); i++) {
        const bat_shape *shape = bat_object_shape(object, i);
        const char *wrong = shape ? bat_shape_check_kept(shape) : NULL;
        if (wrong) return wrong;
        shapes += shape != NULL;
    }
    return bat_object_is(object, BAT_MADE) == (shapes > 0) ? NULL : "a shape has no levels";
}

/* ---- affine images ---- */

static bat_status moved(void *rows, const bat_curve *curve, bat_curve **out) {
    return bat_curve_posed(curve, rows, out);
}

/* Whether details in the plane need not be measured again. */
static bool is_similar(const double m[6]) {
    double square = 0;
    for (int i = 0; i < 4; i++) square += m[i] * m[i];
    return fabs(square - 2 * bat_matrix_area(m)) <= 1e-12 * square;
}

/* The levels of that curve, to be moved; those of the page may be in space from now on. */
static bat_status take_shape(const bat_object *object, int i, bool flat, bat_shape **out) {
    const bat_shape *shape = bat_object_shape(object, i);
    const bool same = flat == (bat_curve_dimension(bat_object_curve(object, i)) == 2);
    return same ? bat_shape_copy(shape, out) : bat_shape_to_dimension(shape, 3, out);
}

/* Levels are transformed along with their curves; where the map flattens them, the plain curves remain.
 * *path is replaced. */
static bat_status image_shapes(const bat_object *object, const double *rows, bat_object **path) {
    double m[6], plane[12];
    const bool flat = bat_curve_dimension(bat_object_curve(*path, 0)) == 2 && bat_pose_in_plane(rows, m);
    const bool similar = flat && is_similar(m);
    if (flat) bat_matrix_rows(m, 2, plane);
    const double *matrix = flat ? plane : rows;
    for (int i = 0; i < bat_object_curve_count(object); i++) {
        bat_shape *shape = NULL;
        bat_object *next = NULL;
        if (!bat_object_shape(object, i)) continue;
        bat_status status = take_shape(object, i, flat, &shape);
        if (status == BAT_OK)
            status = similar ? bat_shape_transform(shape, matrix)
                             : bat_shape_reframe(shape, matrix, bat_shape_options_of(shape)->frame);
        if (status == BAT_OK)
            status = bat_object_with_shape(*path, i, shape, &next);
        else
            bat_shape_free(shape);
        if (status == BAT_OK) {
            bat_object_release(*path);
            *path = next;
        }
        if (status == BAT_MEMORY) return status;
    }
    return BAT_OK;
}

static bat_status transform(const bat_object *object, const double rows[12], bat_object **out) {
    bat_object *made = NULL;
    double numbers[12];
    memcpy(numbers, rows, sizeof numbers);
    bat_status status = bat_object_with_each(object, moved, numbers, &made);
    if (status == BAT_OK) status = image_shapes(object, rows, &made);
    if (status != BAT_OK)
        bat_object_release(made);
    else
        *out = made;
    return status;
}

/* ---- files ---- */

/* One of an object's curves, with or without levels. */
typedef struct making {
    bat_curve *curve;
    bat_shape *shape; /* owned, as is its finest curve; NULL: none */
} making;

static bat_status read_making(const bat_fields *f, uint32_t node, making *out) {
    if (!bat_json_member(f->json, node, "base"))
        return bat_curve_from_json(f->json, node, &out->curve, f->problem);
    bat_status status = bat_shape_from_json(f->json, node, &out->shape, f->problem);
    if (status != BAT_OK) return status;
    status = bat_curve_copy(bat_shape_curve(out->shape, bat_shape_levels(out->shape)), &out->curve);
    return bat_fields_say(f, node, status);
}

static bat_status read_makings(const bat_fields *f, uint32_t list, making *makings, int *count) {
    for (uint32_t at = bat_json_first(f->json, list); at; at = f->json->nodes[at].next) {
        bat_status status = read_making(f, at, &makings[(*count)++]);
        if (status != BAT_OK) return status;
        if (bat_curve_dimension(makings[*count - 1].curve) != bat_curve_dimension(makings[0].curve))
            return bat_json_say(f->json, at, BAT_DIMENSION, "curves: expected one dimension, found two",
                                f->problem);
    }
    return BAT_OK;
}

/* Makes a path of the curves, then puts each shape in its place; whatever has been consumed,
 * even on failure, is removed from `makings`. */
static bat_status make_path(bat_id id, const char *name, const bat_style *style, int count, making *makings,
                            bat_object **out) {
    bat_curve **curves = calloc((size_t)count, sizeof *curves);
    bat_object *object = NULL;
    if (!curves) return BAT_MEMORY;
    for (int i = 0; i < count; i++) curves[i] = makings[i].curve;
    bat_status status = bat_object_create_path(id, name, style, count, curves, &object);
    free(curves);
    for (int i = 0; i < count; i++) makings[i].curve = NULL;
    for (int i = 0; i < count && status == BAT_OK; i++) {
        bat_object *next = NULL;
        if (!makings[i].shape) continue;
        status = bat_object_with_shape(object, i, makings[i].shape, &next);
        makings[i].shape = NULL;
        if (status != BAT_OK) break;
        bat_object_release(object);
        object = next;
    }
    if (status != BAT_OK)
        bat_object_release(object);
    else
        *out = object;
    return status;
}

static bat_status read_curves(const bat_fields *f, uint32_t node, bat_id id, const char *name, bool shape,
                              bat_object **out) {
    const bat_json *json = f->json;
    bat_style style = bat_style_defaults();
    bat_status status = bat_style_from_json(f, node, &style);
    if (status != BAT_OK) return status;
    uint32_t list = bat_json_member(json, node, "curves");
    uint32_t room = bat_json_count(json, list);
    if (room == 0)
        return bat_fields_complain(f, list ? list : node, "curves", "a list of at least one curve");
    making *makings = calloc(room, sizeof *makings);
    if (!makings) return bat_fields_say(f, node, BAT_MEMORY);
    int count = 0;
    bool any = false;
    status = read_makings(f, list, makings, &count);
    for (int i = 0; i < count; i++) any = any || makings[i].shape;
    if (status == BAT_OK && any != shape)
        status = bat_fields_complain(f, list, "curves",
                                     shape ? "one with a base and levels"
                                           : "no base and levels, which are of a shape");
    else if (status == BAT_OK) {
        status = make_path(id, name, &style, count, makings, out);
        bat_fields_say(f, node, status);
    }
    for (int i = 0; i < count; i++) {
        bat_curve_free(makings[i].curve);
        bat_shape_free(makings[i].shape);
    }
    free(makings);
    return status;
}

static bat_status read_path(const bat_fields *f, uint32_t node, bat_id id, const char *name,
                            bat_object **out) {
    return read_curves(f, node, id, name, false, out);
}

static bat_status read_shape(const bat_fields *f, uint32_t node, bat_id id, const char *name,
                             bat_object **out) {
    return read_curves(f, node, id, name, true, out);
}

static void write(const bat_object *object, bat_text *text) {
    bat_text_string(text, ",\n  \"style\":");
    bat_style_to_json(bat_object_style(object), text);
    bat_text_string(text, ",\n  \"curves\":[");
    for (int i = 0; i < bat_object_curve_count(object); i++) {
        bat_text_string(text, i > 0 ? ",\n   " : "\n   ");
        const bat_shape *shape = bat_object_shape(object, i);
        if (shape) /* its curve is computed from it */
            bat_shape_to_json(shape, text);
        else
            bat_curve_to_json(bat_object_curve(object, i), 4, text);
    }
    bat_text_string(text, "]");
}

/* ---- bound to wires: as another kind, which is a path again when it is free ---- */

static const bat_hold *hold(const void *own) { return own; }

static void share(const void *own) {
    if (hold(own)->bound) bat_bound_retain(hold(own)->bound);
}
static void end(void *own) { bat_bound_release(hold(own)->bound); }

static size_t curve_points(const bat_object *object, double *out) {
    size_t total = 0;
    for (int i = 0; i < bat_object_curve_count(object); i++) {
        const bat_curve *curve = bat_object_curve(object, i);
        const size_t count = bat_curve_count(curve), width = (size_t)bat_curve_dimension(curve);
        for (size_t k = 0; k < count && out; k++, out += 3) {
            out[2] = 0;
            memcpy(out, bat_curve_points(curve) + width * k, width * sizeof *out);
        }
        total += count;
    }
    return total;
}

/* A copy of the curve with its points there, in the plane or in space. */
static bat_status with_points(const bat_curve *curve, const double *points, int width, bat_curve **out) {
    const size_t count = bat_curve_count(curve);
    double *plane = malloc(2 * count * sizeof *plane);
    if (!plane) return BAT_MEMORY;
    for (size_t i = 0; i < count; i++) plane[2 * i] = points[3 * i], plane[2 * i + 1] = points[3 * i + 1];
    const bat_status status = bat_curve_create(width, bat_curve_degree(curve), bat_curve_is_closed(curve),
                                               count, width == 2 ? plane : points,
                                               bat_curve_knot_count(curve), bat_curve_knots(curve), out);
    free(plane);
    return status;
}

/* They stay in the plane while no point leaves it. */
static int width_of(const bat_object *object, const double *points, const bat_hold *held) {
    const bat_hold *was = bat_object_hold(object);
    const bool flat = held->bound ? held->bound->flat
                      : was       ? was->bound->flat
                                  : bat_curve_dimension(bat_object_curve(object, 0)) == 2;
    const size_t count = curve_points(object, NULL);
    for (size_t i = 0; i < count && flat; i++)
        if (points[3 * i + 2] != 0) return 3;
    return flat ? 2 : 3;
}

static bat_status put_curves(const bat_object *object, const double *points, const bat_hold *held,
                             bat_object **out) {
    const int count = bat_object_curve_count(object), width = width_of(object, points, held);
    const bat_kind_type *type = held->bound ? &bat_kind_of_bound : &bat_kind_of_path;
    bat_curve **curves = calloc((size_t)count + 1, sizeof *curves);
    bat_status status = curves ? BAT_OK : BAT_MEMORY;
    for (int i = 0; i < count && status == BAT_OK; i++) {
        status = with_points(bat_object_curve(object, i), points, width, &curves[i]);
        points += 3 * bat_curve_count(bat_object_curve(object, i));
    }
    if (status == BAT_OK)
        status = bat_object_remake(object, type, held->bound ? held : NULL, count, curves, out);
    if (status == BAT_OK && held->bound) bat_bound_retain(held->bound);
    for (int i = 0; i < count && status != BAT_OK && curves; i++) bat_curve_free(curves[i]);
    free(curves);
    return status;
}

static const bat_id *sources(const bat_object *object, int *count) {
    const bat_hold *held = bat_object_hold(object);
    *count = held ? held->bound->source_count : 0;
    return held ? held->bound->ids : NULL;
}

static uint64_t digest(uint64_t digest, const void *own) {
    return bat_digest_number(digest, hold(own)->bound->digest);
}

static void write_bound(const bat_object *object, bat_text *text) {
    write(object, text);
    bat_bound_write(object, text);
}

static bat_status read_bound(const bat_fields *f, uint32_t node, bat_id id, const char *name,
                             bat_object **out) {
    if (!bat_json_member(f->json, node, "bound")) return bat_fields_complain(f, node, "bound", "an object");
    bat_object *object = NULL;
    bat_status status = read_path(f, node, id, name, &object);
    if (status == BAT_OK) status = bat_bound_read(f, node, &object);
    if (status == BAT_OK) *out = object;
    return status;
}

const bat_kind_type bat_kind_of_path = {.number = BAT_KIND_PATH,
                                        .name = "path",
                                        .traits = BAT_DRAWN | BAT_CURVES,
                                        .check = check,
                                        .transform = transform,
                                        .points = curve_points,
                                        .put = put_curves,
                                        .write = write,
                                        .read = read_path};

const bat_kind_type bat_kind_of_shape = {.number = BAT_KIND_SHAPE,
                                         .name = "shape",
                                         .traits = BAT_DRAWN | BAT_CURVES | BAT_MADE,
                                         .check = check,
                                         .transform = transform,
                                         .points = curve_points,
                                         .put = put_curves,
                                         .write = write,
                                         .read = read_shape};

const bat_kind_type bat_kind_of_bound = {.number = BAT_KIND_BOUND,
                                         .name = "bound",
                                         .traits = BAT_DRAWN | BAT_CURVES | BAT_MADE | BAT_NEW,
                                         .size = sizeof(bat_hold),
                                         .share = share,
                                         .end = end,
                                         .digest = digest,
                                         .transform = bat_bound_transform,
                                         .sources = sources,
                                         .remake = bat_bound_remake,
                                         .points = curve_points,
                                         .hold = hold,
                                         .put = put_curves,
                                         .write = write_bound,
                                         .read = read_bound};
