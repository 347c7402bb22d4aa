/* Bytes become a document with objects of every kind, which are changed in every way. The document stays
 * valid, a copy of it is unchanged, and what an object was made from can be read from it again. */
#include "document/lettering.h"
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/paint.h>
#include <batten/recipe.h>
#include <batten/wires.h>
#include <batten/levels.h>
#include <batten/mesh.h>

#include "support/pictures.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

typedef struct source {
    const uint8_t *data;
    size_t left;
} source;

static void demand(bool holds) {
    if (!holds) abort();
}

static int byte(source *s) { return s->left == 0 ? 0 : (s->left--, *s->data++); }
static double number(source *s) {
    static const double odd[] = {NAN, INFINITY, 1e300, -1e100, 1e-310, 0, -0.0, 1e9};
    int b = byte(s);
    return b < 8 ? odd[b] : (b - 128) * 0.75;
}

static const char *const names[] = {"roof", "", "\xed\x95\x9c", "\xff", NULL, "a \"name\" & <more>"};
static const char *name(source *s) { return names[byte(s) % 6]; }

static bat_style style(source *s) {
    bat_style made = bat_style_defaults();
    int b = byte(s);
    made.stroked = b & 1, made.filled = b & 2, made.even_odd = b & 4;
    if (b & 8) made.width = number(s), made.opacity = number(s), made.miter_limit = number(s);
    if (b & 16) made.stroke = 0x336699ff, made.cap = (bat_cap)(b >> 5);
    return made;
}

static bat_curve *curve(source *s) {
    double points[24], knots[20];
    int degree = 1 + byte(s) % 4;
    int n = degree + 1 + byte(s) % 4;
    bool closed = n > 3 && byte(s) % 2;
    for (int i = 0; i < 2 * n; i++) points[i] = number(s);
    for (int i = 0; i <= n + degree; i++)
        knots[i] = closed || (i > degree && i <= n) ? i : i > n ? n : degree;
    bat_curve *made = NULL;
    return bat_curve_create(2, degree, closed, (size_t)n, points, closed ? n + 1 : n + degree + 1, knots,
                            &made) == BAT_OK
               ? made
               : NULL;
}

static bat_shape *levels(source *s) {
    bat_curve *base = curve(s);
    bat_shape *made = NULL;
    if (base && bat_shape_create(base, NULL, &made) == BAT_OK &&
        bat_shape_add_level(made, 0, NULL, NULL, NULL) != BAT_OK) {
        bat_shape_free(made);
        made = NULL;
    }
    bat_curve_free(base);
    return made;
}

static bat_spline spline(source *s, double points[16], double tangents[16]) {
    bat_spline made = {.dimension = 2,
                       .closed = byte(s) % 2,
                       .count = 2 + (size_t)byte(s) % 7,
                       .points = points,
                       .tangents = tangents};
    for (int i = 0; i < 16; i++) points[i] = number(s), tangents[i] = i % 3 ? 0 : number(s);
    return made;
}

static bat_status with_curves(source *s, const bat_object *from, bat_object **out) {
    bat_curve *curves[3];
    for (int i = 0; i < 3; i++) curves[i] = curve(s);
    int count = byte(s) % 4, given = 0;
    for (int i = 0; i < 3; i++)
        if (curves[i]) curves[given++] = curves[i];
    if (count > given) count = given;
    bat_style own = style(s);
    bat_id id = (bat_id)byte(s) + 1;
    const char *called = name(s);
    bat_status status = from ? bat_object_with_curves(from, count, curves, out)
                             : bat_object_create_path(id, called, &own, count, curves, out);
    for (int i = count; i < given; i++) bat_curve_free(curves[i]);
    return status;
}

static bat_status image(source *s, bat_id id, bat_object **out) {
    unsigned char head[HEAD_ROOM];
    bat_picture *picture = NULL;
    double matrix[6];
    for (int i = 0; i < 6; i++) matrix[i] = number(s);
    bat_status status = bat_picture_create(head, head_png(head, (unsigned)byte(s), 9), &picture);
    if (status != BAT_OK) return status;
    const double opacity = number(s) / 90;
    status = bat_object_create_image(id, "tree", picture, matrix, opacity, out);
    bat_picture *alone = NULL;
    if (id % 3 == 0 && status == BAT_OK && bat_picture_create(ALONE, sizeof ALONE - 1, &alone) == BAT_OK) {
        bat_object_release(*out);
        *out = NULL;
        status = bat_object_create_foreign(id, "words", alone, matrix, opacity, out);
        bat_picture_release(alone);
    }
    if (id % 5 == 0 && status == BAT_OK) {
        bat_lettering letters = bat_lettering_defaults();
        letters.content = id % 2 ? "one\ntwo" : "\xff";
        letters.size = opacity, letters.box[2] = matrix[0], letters.box[3] = matrix[3];
        bat_object *text = NULL;
        if (bat_object_create_text(id, "text", &letters, matrix, (uint32_t)id, opacity, &text) == BAT_OK) {
            bat_object_release(*out);
            *out = text;
        }
    }
    bat_picture_release(bat_picture_retain(picture));
    bat_picture_release(picture);
    return status;
}

/* A surface of neighbours in the document; from: an object that becomes it. */
static bat_status made_of(source *s, const bat_document *document, const bat_object *from, bat_object **out) {
    const bat_object *sources[5];
    const bat_curve *curves[2];
    const int way = byte(s), all = bat_document_count(document), first = byte(s);
    const size_t count = 2 + (size_t)(way / 8 % 4);
    const bat_style own = style(s);
    bat_recipe recipe = bat_recipe_of((bat_recipe_kind)(way % 8));
    recipe.stand = (bat_recipe_stand)(way / 32 % 4);
    if (way & 128) recipe.twist = number(s), recipe.scale = number(s) / 9, recipe.angle = 4 * number(s);
    if (all == 0) return BAT_STATE;
    for (size_t i = 0; i < count; i++) sources[i] = bat_document_at(document, (first + (int)i) % all);
    for (int i = 0; i < 2; i++) curves[i] = bat_object_curve(sources[i], 0);
    demand(bat_recipe_stands(curves[0], curves[1]) < BAT_STAND_COUNT);
    const bat_status status = from ? bat_object_with_recipe(from, &recipe, count, sources, out)
                                   : bat_object_create_made((bat_id)byte(s) + 1, "", &own, &recipe, count,
                                                            sources, out);
    if (status != BAT_OK || !(way & 64)) return status;
    bat_surface *again = NULL;
    const bat_curve *given[5];
    bat_recipe_report report;
    for (size_t i = 0; i < count; i++) given[i] = bat_object_curve(sources[i], 0);
    demand(bat_recipe_check(&recipe, count, NULL) == BAT_OK);
    demand(bat_recipe_surface(&recipe, count, given, &again, &report) == BAT_OK && report.apart >= 0);
    demand(bat_surface_is_equal(again, bat_object_surface(*out)));
    bat_surface_free(again);
    return BAT_OK;
}

/* A mesh of a few vertices; faces use any of them. */
static bat_status mesh(source *s, bat_id id, bat_object **out) {
    double vertices[24];
    int sizes[4], corners[16];
    const bat_style own = style(s);
    const size_t count = (size_t)byte(s) % 9, faces = (size_t)byte(s) % 5;
    for (int i = 0; i < 24; i++) vertices[i] = number(s);
    for (int i = 0; i < 4; i++) sizes[i] = 3 + i % 2;
    for (int i = 0; i < 16; i++) corners[i] = byte(s) % 9;
    bat_polymesh *made = NULL;
    bat_status status = bat_polymesh_create(count, vertices, faces, sizes, corners, &made, NULL);
    if (status == BAT_OK) status = bat_object_create_mesh(id, name(s), &own, made, out);
    if (status == BAT_OK) demand(bat_polymesh_is_equal(bat_object_mesh(*out), made));
    bat_polymesh_free(made);
    return status;
}

/* Bound to neighbours in the document, or free again. */
static bat_status bind(source *s, const bat_document *document, const bat_object *object, bat_object **out) {
    const bat_object *curves[3], *domains[3];
    bat_wire wires[3];
    const int way = byte(s), all = bat_document_count(document), first = byte(s);
    const size_t count = (size_t)(way / 4 % 4);
    bat_wire_options options = bat_wire_defaults();
    if (way & 1) return bat_object_unbind(object, way & 2, out);
    options.blend = (bat_blend)(way / 16 % 4);
    for (size_t i = 0; i < 3; i++) {
        curves[i] = bat_document_at(document, (first + (int)i) % all);
        wires[i] = (bat_wire){.reference = bat_object_curve(curves[i], 0),
                              .radius = bat_function_of(number(s)),
                              .scale = bat_function_of(way & 64 ? number(s) / 50 : 1),
                              .domain = way & 128 ? bat_object_curve(object, 0) : NULL,
                              .turn = (bat_wire_turn)(first / 2 % 2)};
        domains[i] = way & 4 ? bat_document_at(document, (first + 3) % all) : NULL;
    }
    const bat_status status = bat_object_bind(object, count, wires, curves, first & 1 ? domains : NULL,
                                              way & 2 ? &options : NULL, out);
    if (status == BAT_OK) demand((size_t)bat_object_wires(*out, NULL, NULL) == count);
    return status;
}

static bat_status make(source *s, bat_document *document, bat_object **out) {
    double points[16], tangents[16];
    int kind = byte(s);
    bat_id id = kind & 128 ? (bat_id)byte(s) : bat_document_new_id(document);
    bat_style own = style(s);
    bat_spline made;
    switch (kind % 7) {
    case 6: return mesh(s, id, out);
    case 0: return bat_object_create_group(id, name(s), kind & 8, out);
    case 1: return bat_object_create_guide(id, kind / 8 % 3, number(s), out);
    case 2: return image(s, id, out);
    case 3:
        made = spline(s, points, tangents);
        return bat_object_create_spline(id, name(s), &own, &made, NULL, out);
    case 4: return made_of(s, document, NULL, out);
    default: return with_curves(s, NULL, out);
    }
}

static void gradient(source *s, bat_stop *stops, bat_gradient *out) {
    *out = (bat_gradient){.radial = byte(s) & 1, .spread = (bat_spread)(byte(s) % 4), .stops = stops};
    for (int k = 0; k < 3; k++) out->from[k] = number(s);
    for (int k = 0; k < 3; k++) out->to[k] = number(s);
    for (int k = 0; k < 6; k++) out->matrix[k] = number(s);
    out->count = (size_t)byte(s) % 5;
    for (int i = 0; i < 4; i++) {
        stops[i].at = i / 4.0 + number(s) * 1e-9;
        stops[i].colour = (uint32_t)byte(s) << 8 | 0x80;
    }
}

static bat_status with_paint(source *s, const bat_object *object, bat_object **out) {
    bat_stop stops[2][4];
    double dashes[4];
    bat_paint paint = {.dash_count = (size_t)byte(s) % 5, .dashes = dashes};
    gradient(s, stops[0], &paint.fill);
    gradient(s, stops[1], &paint.stroke);
    for (int k = 0; k < 4; k++) dashes[k] = number(s);
    for (int k = 0; k < 4; k++) paint.pen[k] = number(s);
    paint.dash_offset = number(s);
    if (byte(s) & 1) paint.stroke.count = 0;
    if (byte(s) & 1) memset(paint.pen, 0, sizeof paint.pen);
    return bat_object_with_paint(object, byte(s) & 15 ? &paint : NULL, out);
}

static bat_status alter(source *s, const bat_document *document, const bat_object *object, bat_object **out) {
    double points[16], tangents[16], matrix[6];
    bat_style own = style(s);
    bat_spline other;
    bat_curve *one;
    bat_shape *shape;
    int index = byte(s) % 5 - 1;
    switch (byte(s) % 16) {
    case 14:
    case 15: return bind(s, document, object, out);
    case 0:
        for (int i = 0; i < 6; i++) matrix[i] = number(s);
        return bat_object_with_matrix(object, matrix, out);
    case 1: return bat_object_with_guide(object, number(s), out);
    case 2: return with_curves(s, object, out);
    case 3: return bat_object_with_parent(object, (bat_id)byte(s), out);
    case 4: return bat_object_with_name(object, name(s), out);
    case 5: return bat_object_with_state(object, index & 1, index & 2, out);
    case 6: return bat_object_with_id(object, (bat_id)byte(s), out);
    case 7: one = curve(s); return one ? bat_object_with_curve(object, index, one, out) : BAT_ARGUMENT;
    case 8: return index & 1 ? with_paint(s, object, out) : bat_object_with_style(object, &own, out);
    case 9: shape = levels(s); return shape ? bat_object_with_shape(object, index, shape, out) : BAT_ARGUMENT;
    case 10: other = spline(s, points, tangents); return bat_object_with_spline(object, &other, out);
    case 11: return bat_object_to_path(object, out);
    case 12: return made_of(s, document, object, out);
    default: *out = bat_object_retain(object); return BAT_OK;
    }
}

/* Everything that can be queried of an object is consistent. */
static void ask(const bat_object *object) {
    double box[4], corners[8], sides[2], at;
    size_t bytes;
    bat_kind kind = bat_object_kind(object);
    bool drawn = bat_object_is_drawn(object), group = bat_object_is_group(object);
    demand(bat_object_id(object) > 0 && bat_object_name(object) && bat_object_style(object));
    demand(bat_object_parent(object) != bat_object_id(object));
    demand(bat_style_check(bat_object_style(object), NULL) == BAT_OK);
    demand(bat_object_head_check(bat_object_id(object), bat_object_name(object), bat_object_style(object),
                                 NULL) == BAT_OK);
    demand(!bat_object_paint(object) || bat_object_is_made_of_curves(object));
    demand(!bat_object_paint(object) || bat_paint_check(bat_object_paint(object), NULL) == BAT_OK);
    const bat_width_profile profile = bat_object_widths(object);
    demand(bat_width_check(&profile, NULL) == BAT_OK && (!profile.count || bat_object_paint(object)));
    size_t cubics;
    double *cover;
    const bat_status covered = bat_object_cover(object, 0, &cubics, &cover);
    demand((covered == BAT_ARGUMENT) == !profile.count);
    if (covered == BAT_OK) bat_free(cover);
    (void)(bat_object_is_hidden(object) && bat_object_is_locked(object));
    demand(group == (kind == BAT_KIND_GROUP || kind == BAT_KIND_LAYER) &&
           drawn == (!group && kind != BAT_KIND_GUIDE));
    demand((bat_object_guide(object, &at) >= 0) == (kind == BAT_KIND_GUIDE));
    demand((bat_object_spline(object) != NULL) == (kind == BAT_KIND_SPLINE));
    demand(!bat_object_spline(object) || bat_object_spline_options(object));
    demand(bat_object_is_made_of_curves(object) ==
           (bat_object_curve_count(object) > 0 && kind != BAT_KIND_SURFACE && kind != BAT_KIND_MESH));
    const bat_wire *wires;
    const bat_wire_options *options;
    const int bound = bat_object_wires(object, &wires, &options);
    demand((bound > 0) == (wires != NULL) && (bound > 0) == (options != NULL));
    demand(kind != BAT_KIND_BOUND || bound > 0);
    demand((bat_object_mesh(object) != NULL) == (kind == BAT_KIND_MESH));
    const bat_id *from = NULL;
    const bat_recipe *recipe = bat_object_recipe(object);
    const int sources = bat_object_sources(object, &from);
    demand((recipe != NULL || bound > 0) == (sources > 0) && (!recipe || kind == BAT_KIND_SURFACE));
    demand(!recipe || bound == 0);
    double folds[2 * BAT_RECIPE_FOLDS];
    const size_t folded = bat_object_folds(object, folds);
    demand(folded == 0 || (recipe && recipe->kind == BAT_RECIPE_SWEEP));
    for (size_t i = 0; i < folded && i < BAT_RECIPE_FOLDS; i++) demand(folds[2 * i] <= folds[2 * i + 1]);
    demand(!recipe || bat_recipe_check(recipe, (size_t)sources, NULL) == BAT_OK);
    for (int i = 0; i < sources; i++) demand(from[i] > 0 && from[i] != bat_object_id(object));
    bat_object_bounds(object, box);
    for (int i = 0; i < bat_object_curve_count(object); i++) {
        const bat_shape *shape = bat_object_shape(object, i);
        demand(bat_object_curve(object, i) != NULL);
        demand(!shape || bat_curve_is_equal(bat_shape_curve(shape, bat_shape_levels(shape)),
                                            bat_object_curve(object, i)));
    }
    const bat_picture *picture = bat_object_picture(object);
    demand((picture != NULL) ==
           (kind == BAT_KIND_IMAGE || kind == BAT_KIND_FOREIGN || kind == BAT_KIND_TEXT));
    demand(bat_object_is_foreign(object) == (kind == BAT_KIND_FOREIGN));
    if (!picture) return;
    bat_object_corners(object, corners);
    bat_picture_sides(picture, sides);
    demand(bat_object_matrix(object) && bat_picture_bytes(picture, &bytes) && bytes > 0);
    demand(strcmp(bat_picture_type(picture), kind == BAT_KIND_IMAGE ? "image/png" : "image/svg+xml") == 0 &&
           bat_picture_digest(picture) != 0);
    const double *m = bat_object_matrix(object);
    demand(corners[0] == m[4] && corners[1] == m[5]);
}

static void step(source *s, bat_document *document) {
    bat_object *made = NULL;
    int count = bat_document_count(document), way = byte(s),
        at = count ? byte(s) % (count + 1) - (way > 250) : 0;
    const bat_object *there = count ? bat_document_at(document, at % count) : NULL;
    bat_status status = BAT_OK;
    if (way % 8 < 3 || !there) {
        status = make(s, document, &made);
        if (status == BAT_OK) status = bat_document_insert(document, at, made);
    } else if (way % 8 < 7) {
        status = alter(s, document, there, &made);
        demand((status == BAT_OK) == (made != NULL));
        if (made) ask(made);
        if (status == BAT_OK) status = bat_document_replace(document, at, made);
    } else {
        demand(bat_document_end(document, at % count) > at % count);
        status = bat_document_remove(document, at);
    }
    if (made) ask(made);
    demand(bat_status_message(status) != NULL);
    bat_object_release(made);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    source s = {data, size < 600 ? size : 600};
    bat_document *document = NULL, *copy = NULL;
    double page[4], box[4];
    if (bat_document_create(&document) != BAT_OK) return 0;
    for (int k = 0; k < 4; k++) page[k] = number(&s);
    bat_document_set_page(document, page);
    bat_document_page(document, page);
    demand(isfinite(page[2]) && page[2] >= 0);
    bat_document_set_scale(document, number(&s), (bat_unit)byte(&s));
    demand(bat_document_scale(document) > 0 && bat_document_unit(document) <= BAT_UNIT_NONE);
    for (int k = 0; k < 24 && s.left > 0; k++) {
        if (k == 12) demand(bat_document_copy(document, &copy) == BAT_OK);
        uint64_t before = copy ? bat_document_digest(copy) : 0;
        step(&s, document);
        demand(!copy || bat_document_digest(copy) == before);
    }
    for (int i = 0; i < bat_document_count(document); i++) {
        ask(bat_document_at(document, i));
        demand(bat_document_find(document, bat_object_id(bat_document_at(document, i))) == i);
    }
    bat_document_bounds(document, box);
    char *text = NULL;
    bat_document *back = NULL;
    if (!bat_document_check(document) && bat_document_write(document, &text, &size) == BAT_OK) {
        demand(bat_document_read(text, size, &back, NULL) == BAT_OK);
        bool follows = false; /* what changed here without its surfaces is made again when it is read */
        for (int i = 0; i < bat_document_count(document); i++)
            follows = follows || bat_object_sources(bat_document_at(document, i), NULL) > 0;
        demand(follows || bat_document_digest(back) == bat_document_digest(document));
        bat_free(text);
    }
    bat_document_free(back);
    bat_document_free(copy);
    bat_document_free(document);
    return 0;
}
