/* The other side out: normals point the other way at the same places, of surfaces, with levels and bound to wires, and of meshes;
 * twice, the object is what it was; what is bound follows its wires to the same places. */
#include "document/bound.h"
#include "document/document.h"
#include "document/kind.h"

#include <batten/mesh.h>
#include <batten/relief.h>
#include <batten/wires.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "support/alloc_fail.h"
#include "support/objects.h"
#include "support/random_surface.h"

enum { WIRE = 7 };

static bat_object *flipped(const bat_object *object) {
    bat_object *out = NULL;
    const char *fault;
    assert_int_equal(bat_object_type(object)->flip(object, &out), BAT_OK);
    fault = bat_object_type(out)->check(out);
    if (fault) fail_msg("%s", fault);
    return out;
}

/* Of what its kind holds. */
static uint64_t digest(const bat_object *object) {
    const bat_kind_type *type = bat_object_type(object);
    return type->digest(0, bat_object_own(object, type));
}

static bat_surface *sheet(void) {
    random_source r = {4};
    return random_surface(&r, (const int[2]){3, 2}, (const int[2]){0, 2}, (const int[2]){8, 6});
}

static bat_object *surface_object(const bat_surface *surface) {
    const bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_surface(4, "jug", &style, surface, &object), BAT_OK);
    return object;
}

static void is_turned(const bat_surface *before, const bat_surface *after, double within) {
    double u[5], v[5];
    bat_surface_spread(before, BAT_U, 5, u), bat_surface_spread(before, BAT_V, 5, v);
    for (int i = 0; i < 25; i++) {
        double at[3], now[3], normal[3], turned[3];
        bat_surface_eval(before, u[i / 5], v[i % 5], 0, at),
            bat_surface_eval(after, v[i % 5], u[i / 5], 0, now);
        assert_int_equal(bat_surface_normal(before, u[i / 5], v[i % 5], normal), BAT_OK);
        assert_int_equal(bat_surface_normal(after, v[i % 5], u[i / 5], turned), BAT_OK);
        for (int k = 0; k < 3; k++) {
            assert_true(fabs(at[k] - now[k]) <= within);
            assert_true(fabs(normal[k] + turned[k]) <= 1e-6);
        }
    }
}

static void levels(void **state) {
    (void)state;
    bat_surface *surface = sheet();
    bat_relief *relief = NULL;
    bat_object *plain = surface_object(surface), *object = NULL;
    assert_int_equal(bat_relief_decompose(surface, 2, &relief), BAT_OK);
    assert_int_equal(bat_relief_set_gain(relief, 2, 1.25), BAT_OK);
    assert_int_equal(bat_relief_set_muted(relief, 1, true), BAT_OK);
    assert_int_equal(bat_object_with_relief(plain, relief, &object), BAT_OK);
    bat_object *turned = flipped(object), *again = flipped(turned);
    const bat_relief *was = bat_object_relief(object), *now = bat_object_relief(turned);
    const double size = bat_surface_size(surface);
    assert_int_equal(bat_relief_levels(now), 2);
    for (int level = 0; level <= 2; level++) {
        assert_true(bat_relief_gain(now, level) == bat_relief_gain(was, level));
        assert_true(bat_relief_is_muted(now, level) == bat_relief_is_muted(was, level));
        is_turned(bat_relief_surface(was, level), bat_relief_surface(now, level), 1e-10 * size);
    }
    for (size_t i = 0; i < 3 * bat_object_type(object)->points(object, NULL); i++)
        assert_true(bat_relief_details(bat_object_relief(again), 2)[i] == bat_relief_details(was, 2)[i]);
    bat_object_release(object), bat_object_release(plain), bat_object_release(turned);
    bat_object_release(again);
    bat_relief_free(relief), bat_surface_free(surface);
}

static bat_object *wire_object(double lift) {
    const bat_style style = bat_style_defaults();
    bat_curve *curve = NULL;
    bat_object *object = NULL;
    assert_int_equal(bat_curve_create(3, 1, false, 2, (double[]){0, 0, lift, 9, 9, 2 * lift}, 4,
                                      (double[]){0, 0, 1, 1}, &curve),
                     BAT_OK);
    assert_int_equal(bat_object_create_path(WIRE, "", &style, 1, &curve, &object), BAT_OK);
    return object;
}

static bat_object *mesh_object(void) {
    const bat_style style = bat_style_defaults();
    bat_polymesh *mesh = NULL;
    bat_object *object = NULL;
    assert_int_equal(bat_polymesh_create(5, (double[]){0, 0, 0, 9, 0, 0, 9, 9, 4, 0, 9, 0, 4, 4, -7}, 2,
                                         (int[]){4, 3}, (int[]){0, 1, 2, 3, 0, 3, 4}, &mesh, NULL),
                     BAT_OK);
    assert_int_equal(bat_object_create_mesh(4, "", &style, mesh, &object), BAT_OK);
    bat_polymesh_free(mesh);
    return object;
}

/* Moved by its wire and then turned it is what it is turned and then moved. */
static void bound(void **state) {
    (void)state;
    bat_surface *surface = sheet();
    for (int kind = 0; kind < 2; kind++) {
        bat_object *free_one = kind ? mesh_object() : surface_object(surface), *object = NULL, *moved = NULL,
                   *turned_moved = NULL;
        const bat_object *wire = wire_object(0), *lifted = wire_object(3);
        const bat_wire by = {
            .reference = bat_object_curve(wire, 0), .radius = {20, NULL}, .scale = {1, NULL}};
        assert_int_equal(bat_object_bind(free_one, 1, &by, &wire, NULL, NULL, &object), BAT_OK);
        bat_object *turned = flipped(object);
        assert_int_equal(bat_object_wires(turned, NULL, NULL), 1);
        assert_int_equal(bat_bound_remake(object, NULL, &lifted, &moved), BAT_OK);
        assert_int_equal(bat_bound_remake(turned, NULL, &lifted, &turned_moved), BAT_OK);
        bat_object *moved_turned = flipped(moved);
        assert_true(digest(moved_turned) == digest(turned_moved));
        assert_true(digest(moved) != digest(object));
        bat_object *again = flipped(turned);
        assert_true(digest(again) == digest(object));
        bat_object_release(free_one), bat_object_release(object), bat_object_release(moved);
        bat_object_release(turned), bat_object_release(turned_moved), bat_object_release(moved_turned);
        bat_object_release(again);
        bat_object_release((bat_object *)wire), bat_object_release((bat_object *)lifted);
    }
    bat_surface_free(surface);
}

static void mesh(void **state) {
    (void)state;
    bat_object *object = mesh_object(), *turned = flipped(object), *again = flipped(turned);
    double was[15], now[15];
    bat_polymesh_normals(bat_object_mesh(object), was), bat_polymesh_normals(bat_object_mesh(turned), now);
    for (int i = 0; i < 15; i++) assert_true(fabs(was[i] + now[i]) < 1e-12);
    assert_true(bat_polymesh_is_equal(bat_object_mesh(again), bat_object_mesh(object)));
    assert_true(digest(turned) != digest(object));
    bat_object_release(object), bat_object_release(turned), bat_object_release(again);
}

static void failing_allocations(void **state) {
    (void)state;
    bat_surface *surface = sheet();
    bat_relief *relief = NULL;
    bat_object *objects[3] = {surface_object(surface), NULL, mesh_object()};
    assert_int_equal(bat_relief_decompose(surface, 2, &relief), BAT_OK);
    assert_int_equal(bat_object_with_relief(objects[0], relief, &objects[1]), BAT_OK);
    for (int i = 0; i < 3; i++) {
        bat_object *out = NULL;
        bat_status status = BAT_OK;
        bool reached = true;
        for (int n = 1; reached; n++) {
            const long before = alloc_live();
            alloc_fail_at(n);
            status = bat_object_type(objects[i])->flip(objects[i], &out);
            reached = alloc_fail_reached();
            if (!reached) break;
            assert_int_equal(status, BAT_MEMORY);
            assert_int_equal(alloc_live(), before);
        }
        assert_int_equal(status, BAT_OK);
        bat_object_release(out);
        bat_object_release(objects[i]);
    }
    bat_relief_free(relief), bat_surface_free(surface);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(levels), cmocka_unit_test(bound),
                                       cmocka_unit_test(mesh), cmocka_unit_test(failing_allocations)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
