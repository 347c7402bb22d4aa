/* The properties common to objects of every kind (id, name, parent, hidden, locked, style) survive every copy that
 * changes something else, and both formats. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "base/pose.h"
#include "document/lettering.h"
#include "document/object.h"
#include "document/document.h"
#include "editor/edit/affine.h"
#include "kinds/primitive.h"
#include "support/pen.h"
#include "support/pictures.h"
#include "support/random_surface.h"
#include "support/xml.h"

enum { ID = 12, PARENT = 3, WIRE = 9 };
static const bat_kind kinds[] = {
    BAT_KIND_PATH,     BAT_KIND_SPLINE, BAT_KIND_GROUP,   BAT_KIND_LAYER,     BAT_KIND_SHAPE, BAT_KIND_IMAGE,
    BAT_KIND_GUIDE,    BAT_KIND_PLANE,  BAT_KIND_SURFACE, BAT_KIND_CAMERA,    BAT_KIND_VIEW,  BAT_KIND_MESH,
    BAT_KIND_SKELETON, BAT_KIND_BOUND,  BAT_KIND_FOREIGN, BAT_KIND_PRIMITIVE, BAT_KIND_TEXT};
enum { KINDS = sizeof kinds / sizeof *kinds };

static bat_style style_of(void) {
    bat_style style = bat_style_defaults();
    style.stroke = 0x11223344;
    style.filled = true;
    style.fill = 0x55667788;
    style.width = 3.25;
    style.opacity = 0.5;
    style.cap = BAT_CAP_BUTT;
    style.join = BAT_JOIN_MITER;
    style.miter_limit = 7;
    return style;
}

/* Takes `made` in place of *object. */
static void become(bat_object **object, bat_object *made) {
    bat_object_release(*object);
    *object = made;
}

static bat_object *bare(bat_kind kind, bat_id id) {
    bat_style style = style_of();
    bat_object *object = NULL, *made = NULL;
    unsigned char head[HEAD_ROOM];
    double points[] = {0, 0, 40, 60, 110, 60};
    bat_spline spline = {.dimension = 2, .count = 3, .points = points};
    bat_picture *picture = NULL;
    bat_shape *shape = NULL;
    bat_surface *sheet = NULL;
    bat_polymesh *mesh = NULL;
    bat_bone bone;
    bat_take *take = NULL;
    bat_motion *motion = NULL;
    bat_primitive oval;
    bat_object *wire = NULL;
    bat_wire bound = {.radius = bat_function_of(30), .scale = bat_function_of(1)};
    bat_camera *camera = NULL;
    bat_camera_options along = bat_camera_defaults();
    bat_shape_options options = bat_shape_defaults();
    bat_curve *curve = pen_curve(10, 20, 10, 3, 12);
    bat_lettering letters = bat_lettering_defaults();
    switch (kind) {
    case BAT_KIND_SPLINE:
        assert_int_equal(bat_object_create_spline(id, "", &style, &spline, NULL, &object), BAT_OK);
        break;
    case BAT_KIND_GROUP:
    case BAT_KIND_LAYER:
        assert_int_equal(bat_object_create_group(id, "", kind == BAT_KIND_LAYER, &object), BAT_OK);
        break;
    case BAT_KIND_IMAGE:
        assert_int_equal(bat_picture_create(head, head_png(head, 30, 20), &picture), BAT_OK);
        assert_int_equal(bat_object_create_image(id, "", picture, (double[]){1, 0, 0, 1, 5, 6}, 0.5, &object),
                         BAT_OK);
        bat_picture_release(picture);
        break;
    case BAT_KIND_FOREIGN:
        assert_int_equal(bat_picture_create(ALONE, sizeof ALONE - 1, &picture), BAT_OK);
        assert_int_equal(
            bat_object_create_foreign(id, "", picture, (double[]){1, 0, 0, 1, 5, 6}, 0.5, &object), BAT_OK);
        bat_picture_release(picture);
        break;
    case BAT_KIND_TEXT:
        letters.content = "Hello", letters.box[2] = 60, letters.box[1] = -20;
        assert_int_equal(
            bat_object_create_text(id, "", &letters, (double[]){1, 0, 0, 1, 5, 6}, 0x123456ff, 0.5, &object),
            BAT_OK);
        break;
    case BAT_KIND_GUIDE: assert_int_equal(bat_object_create_guide(id, 1, 40, &object), BAT_OK); break;
    case BAT_KIND_PLANE:
        assert_int_equal(
            bat_object_create_plane(id, "", (double[]){1, 2, 3}, (double[]){1, 0, 0, 1, 1, 1}, &object),
            BAT_OK);
        break;
    case BAT_KIND_VIEW:
        assert_int_equal(
            bat_object_create_view(
                id, "",
                &(bat_viewpoint){.eye = {3, -4, -5}, .up = {0, 0, -1}, .size = {400, 300}, .height = 50},
                &object),
            BAT_OK);
        break;
    case BAT_KIND_SURFACE:
        sheet = some_surface(&(random_source){4}, 8);
        assert_int_equal(bat_object_create_surface(id, "", &style, sheet, &object), BAT_OK);
        bat_surface_free(sheet);
        break;
    case BAT_KIND_CAMERA:
        along.mode = BAT_CAMERA_ALONG;
        assert_int_equal(bat_camera_create(curve, &along, &camera), BAT_OK);
        assert_int_equal(bat_object_create_camera(id, "", &style, camera, 0, &object), BAT_OK);
        bat_camera_free(camera);
        break;
    case BAT_KIND_MESH:
        assert_int_equal(bat_polymesh_create(4, (double[]){0, 0, 0, 9, 0, 0, 9, 9, 4, 0, 9, 0}, 1, (int[]){4},
                                             (int[]){0, 1, 2, 3}, &mesh, NULL),
                         BAT_OK);
        assert_int_equal(bat_object_create_mesh(id, "", &style, mesh, &object), BAT_OK);
        bat_polymesh_free(mesh);
        break;
    case BAT_KIND_SKELETON:
        bone = (bat_bone){.name = "hip",
                          .parent = -1,
                          .channel_count = 3,
                          .channels = {BAT_X_POSITION, BAT_Z_ROTATION, BAT_X_ROTATION}};
        assert_int_equal(bat_take_create(1, &bone, 3, 0.1, (double[]){1, 2, 3, 4, 5, 6, 7, 8, 9}, &take),
                         BAT_OK);
        assert_int_equal(bat_motion_fit(take, NULL, &motion, NULL), BAT_OK);
        assert_int_equal(bat_object_create_skeleton(id, "", &style, motion, NULL, &object), BAT_OK);
        bat_motion_free(motion), bat_take_free(take);
        break;
    case BAT_KIND_BOUND:
        assert_int_equal(bat_object_create_path(WIRE, "", &style, 1, &curve, &wire), BAT_OK);
        curve = pen_curve(10, 20, 10, 3, 12);
        assert_int_equal(bat_object_create_path(id, "", &style, 1, &curve, &made), BAT_OK);
        curve = NULL;
        bound.reference = bat_object_curve(wire, 0);
        assert_int_equal(
            bat_object_bind(made, 1, &bound, (const bat_object *const *)&wire, NULL, NULL, &object), BAT_OK);
        bat_object_release(wire), bat_object_release(made);
        break;
    case BAT_KIND_PRIMITIVE:
        oval = bat_primitive_ellipse((double[]){10, 20, 110, 60});
        assert_int_equal(bat_object_create_primitive(id, "", &style, &oval, &object), BAT_OK);
        break;
    case BAT_KIND_PATH:
    case BAT_KIND_SHAPE:
        if (kind == BAT_KIND_SHAPE) assert_int_equal(bat_shape_decompose(curve, 1, &options, &shape), BAT_OK);
        assert_int_equal(bat_object_create_path(id, "", &style, 1, &curve, &object), BAT_OK);
        curve = NULL;
        if (shape) {
            assert_int_equal(bat_object_with_shape(object, 0, shape, &made), BAT_OK);
            become(&object, made);
        }
        break;
    }
    bat_curve_free(curve);
    assert_int_equal(bat_object_kind(object), kind);
    return object;
}

static bat_object *make(bat_kind kind, bat_id id, bat_id parent) {
    bat_object *object = bare(kind, id), *made = NULL;
    assert_int_equal(bat_object_with_parent(object, parent, &made), BAT_OK);
    become(&object, made);
    assert_int_equal(bat_object_with_name(object, "Wölbung \"9\"", &made), BAT_OK);
    become(&object, made);
    assert_int_equal(bat_object_with_state(object, true, true, &made), BAT_OK);
    become(&object, made);
    return object;
}

/* All of it but what the caller has changed on purpose. */
static void same_head(const bat_object *a, const bat_object *b, bat_id id, bat_id parent) {
    assert_int_equal(bat_object_id(a), id);
    assert_int_equal(bat_object_parent(a), parent);
    assert_string_equal(bat_object_name(a), bat_object_name(b));
    assert_int_equal(bat_object_is_hidden(a), bat_object_is_hidden(b));
    assert_int_equal(bat_object_is_locked(a), bat_object_is_locked(b));
    const bat_style *s = bat_object_style(a), *o = bat_object_style(b); /* member by member: there are gaps */
    assert_true(s->stroked == o->stroked && s->filled == o->filled && s->even_odd == o->even_odd);
    assert_true(s->stroke == o->stroke && s->fill == o->fill && s->width == o->width &&
                s->opacity == o->opacity);
    assert_true(s->cap == o->cap && s->join == o->join && s->miter_limit == o->miter_limit);
}

static void every_copy_keeps_it(void **state) {
    (void)state;
    for (int k = 0; k < KINDS; k++) {
        bat_object *object = make(kinds[k], ID, PARENT), *copy = NULL;
        const double shear[6] = {2, 0.25, -0.5, 3, 10, -7};
        if (!bat_object_is_group(object)) {
            assert_int_equal(bat_affine_object(object, shear, false, &copy), BAT_OK);
            same_head(copy, object, ID, PARENT);
            become(&copy, NULL);
        }
        assert_int_equal(bat_object_with_id(object, 99, &copy), BAT_OK);
        same_head(copy, object, 99, PARENT);
        become(&copy, NULL);
        assert_int_equal(bat_object_with_parent(object, 98, &copy), BAT_OK);
        same_head(copy, object, ID, 98);
        become(&copy, NULL);
        assert_int_equal(bat_object_with_style(object, bat_object_style(object), &copy), BAT_OK);
        same_head(copy, object, ID, PARENT);
        become(&copy, NULL);
        bat_style other = *bat_object_style(object);
        other.opacity = 0.25;
        assert_int_equal(bat_object_with_style(object, &other, &copy), BAT_OK);
        assert_true((bat_object_style(copy)->opacity == 0.25) ==
                    (bat_object_is_drawn(object) || bat_object_is_group(object)));
        become(&copy, NULL);
        assert_int_equal(bat_object_with_name(object, bat_object_name(object), &copy), BAT_OK);
        same_head(copy, object, ID, PARENT);
        become(&copy, NULL);
        double at;
        if (bat_object_guide(object, &at) >= 0) {
            assert_int_equal(bat_object_with_guide(object, 17, &copy), BAT_OK);
            same_head(copy, object, ID, PARENT);
            assert_true(bat_object_guide(copy, &at) == 1 && at == 17);
            become(&copy, NULL);
        } else {
            assert_int_equal(bat_object_with_guide(object, 17, &copy), BAT_ARGUMENT);
        }
        if (bat_object_to_path(object, &copy) == BAT_OK) {
            same_head(copy, object, ID, PARENT);
            become(&copy, NULL);
        }
        if (bat_object_spline(object)) {
            assert_int_equal(bat_object_with_spline(object, bat_object_spline(object), &copy), BAT_OK);
            same_head(copy, object, ID, PARENT);
            become(&copy, NULL);
        }
        if (bat_object_curve_count(object)) {
            bat_curve *curves[2] = {pen_curve(0, 0, 5, 1, 5), pen_curve(0, 50, 5, 1, 5)};
            const bat_status takes = bat_object_is_made_of_curves(object) ? BAT_OK : BAT_ARGUMENT;
            assert_int_equal(bat_object_with_curve(object, 0, curves[0], &copy), takes);
            if (copy) same_head(copy, object, ID, PARENT);
            become(&copy, NULL);
            curves[0] = pen_curve(0, 0, 5, 1, 5);
            assert_int_equal(bat_object_with_curves(object, 2, curves, &copy), takes);
            if (copy) same_head(copy, object, ID, PARENT);
            become(&copy, NULL);
        }
        become(&object, NULL);
    }
    bat_object *guide = bare(BAT_KIND_GUIDE, 1), *copy = NULL;
    assert_int_equal(bat_object_with_guide(guide, NAN, &copy), BAT_NUMBER);
    assert_int_equal(bat_object_with_guide(guide, 2 * BAT_COORDINATE_MAX, &copy), BAT_NUMBER);
    assert_int_equal(bat_object_with_guide(NULL, 0, &copy), BAT_ARGUMENT);
    assert_null(copy);
    become(&guide, NULL);
}

/* Where a curve is, on the page or in space. */
static void place_at(const bat_object *object, int curve, double share, double at[3]) {
    double domain[2], place[BAT_DIMENSION_MAX] = {0};
    const bat_curve *of = bat_object_curve(object, curve);
    bat_curve_domain(of, domain);
    bat_curve_eval(of, domain[0] + share * (domain[1] - domain[0]), 0, place);
    memcpy(at, place, 3 * sizeof *at);
}

/* Turned in space and lifted, every curve lies where the map takes it, levels are kept, and the range of z is the curves';
 * turned back it is where it was. Pictures and texts stay on the page, but turn in it. */
static void every_kind_turns_in_space(void **state) {
    (void)state;
    const double axis[3] = {0.6, 0, 0.8}, about[3] = {30, -10, 5};
    double turn[12], back[12], level[12], was[3], now[3], z[2];
    bat_pose_rotation(0.7, axis, about, turn);
    turn[11] += 40;
    bat_pose_rotation(-0.7, axis, (double[]){about[0], about[1], about[2] + 40}, back);
    back[11] -= 40;
    bat_pose_rotation(0.7, (double[]){0, 0, 1}, about, level);
    for (int k = 0; k < KINDS; k++) {
        bat_object *object = make(kinds[k], ID, PARENT), *turned = NULL, *again = NULL;
        const bool stays = kinds[k] == BAT_KIND_IMAGE || kinds[k] == BAT_KIND_FOREIGN ||
                           kinds[k] == BAT_KIND_TEXT;
        assert_int_equal(bat_affine_pose(object, level, false, &again), BAT_OK);
        become(&again, NULL);
        assert_int_equal(bat_affine_pose(object, turn, false, &turned), stays ? BAT_UNSUPPORTED : BAT_OK);
        if (!stays) {
            same_head(turned, object, ID, PARENT);
            assert_null(bat_object_check(turned));
            assert_int_equal(bat_affine_pose(turned, back, false, &again), BAT_OK);
        }
        /* How long a camera's gaze is shown depends on the box of its path. */
        const int count = stays ? 0 : bat_object_camera(object) ? 1 : bat_object_curve_count(object);
        if (count) bat_object_depth(turned, z);
        for (int i = 0; i < 9 * count; i++) {
            place_at(object, i / 9, i % 9 / 8.0, was);
            place_at(again, i / 9, i % 9 / 8.0, now);
            for (int d = 0; d < 3; d++)
                if (!(fabs(now[d] - was[d]) < 1e-6))
                    fail_msg("kind %d back: %g, not %g", (int)kinds[k], now[d], was[d]);
            bat_pose_apply(turn, 1, was, was);
            place_at(turned, i / 9, i % 9 / 8.0, now);
            for (int d = 0; d < 3; d++)
                if (!(fabs(now[d] - was[d]) < 1e-6))
                    fail_msg("kind %d: %g, not %g", (int)kinds[k], now[d], was[d]);
            assert_true(z[0] - 1e-9 <= now[2] && now[2] <= z[1] + 1e-9);
        }
        if (kinds[k] == BAT_KIND_SHAPE) assert_int_equal(bat_shape_levels(bat_object_shape(turned, 0)), 1);
        become(&object, NULL), become(&turned, NULL), become(&again, NULL);
    }
}

/* A layer with one of each kind, native and as SVG. */
static void both_formats_keep_it(void **state) {
    (void)state;
    bat_document *document = NULL, *again = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    int count = 0;
    bat_object *layer = make(BAT_KIND_LAYER, PARENT, 0);
    assert_int_equal(bat_document_insert(document, count++, layer), BAT_OK);
    become(&layer, NULL);
    bat_object *wire = make(BAT_KIND_PATH, WIRE, PARENT); /* of the bound one */
    assert_int_equal(bat_document_insert(document, count++, wire), BAT_OK);
    become(&wire, NULL);
    for (int k = 0; k < KINDS; k++) {
        bat_object *object = make(kinds[k], ID + (bat_id)k, PARENT);
        assert_int_equal(bat_document_insert(document, count++, object), BAT_OK);
        become(&object, NULL);
    }
    assert_null(bat_document_check(document));
    for (int svg = 0; svg < 2; svg++) {
        char *text = NULL;
        size_t size = 0;
        bat_svg_report report;
        bat_problem problem;
        if (svg) {
            assert_int_equal(bat_svg_write(document, true, &text, &size), BAT_OK);
            assert_int_equal(xml_read(text, NULL, &again, &report, &problem), BAT_OK);
        } else {
            assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
            assert_int_equal(bat_document_read(text, size, &again, &problem), BAT_OK);
        }
        assert_int_equal(bat_document_count(again), count);
        for (int i = 0; i < count; i++) {
            const bat_object *object = bat_document_at(document, i);
            same_head(bat_document_at(again, i), object, bat_object_id(object), bat_object_parent(object));
        }
        assert_true(bat_document_digest(again) == bat_document_digest(document));
        bat_document_free(again);
        bat_free(text);
    }
    bat_document_free(document);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_copy_keeps_it),
        cmocka_unit_test(every_kind_turns_in_space),
        cmocka_unit_test(both_formats_keep_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
