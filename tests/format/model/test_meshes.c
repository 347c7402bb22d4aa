/* Readers of meshes: what the writers write comes back as it was, in millimetres; cut short or spoilt anywhere it is sound or
 * refused with a reason, and nothing leaks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "format/formats.h"
#include "support/alloc_fail.h"
#include <batten/bezier.h>
#include <batten/document.h>
#include <batten/mesh.h>

static const char *const names[] = {"stl", "ply", "glb", "gltf", "3mf"};
enum { NAMES = sizeof names / sizeof *names };
static const double places[12] = {1, 2, 3, 11, 2, 3, 1, 22.5, 3, 1, 2, 33.25};
static const int sizes[4] = {3, 3, 3, 3}, corners[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};

static bat_document *wedge(void) {
    const bat_style style = bat_style_defaults();
    bat_document *document = NULL;
    bat_polymesh *mesh = NULL;
    bat_object *object = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_document_set_scale(document, 1, BAT_UNIT_MM), BAT_OK);
    assert_int_equal(bat_polymesh_create(4, places, 4, sizes, corners, &mesh, NULL), BAT_OK);
    assert_int_equal(bat_object_create_mesh(bat_document_new_id(document), "wedge", &style, mesh, &object),
                     BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    bat_object_release(object);
    bat_polymesh_free(mesh);
    return document;
}

static bat_status open_as(const char *name, const char *bytes, size_t size, bat_document **out,
                          bat_problem *problem) {
    const bat_reading how = {.xml = NULL};
    bat_svg_report report = {0};
    *problem = (bat_problem){"", ""};
    const bat_status status = bat_format_named(name)->read(&how, bytes, size, out, &report, problem);
    assert_true((status == BAT_OK) == (*out != NULL));
    if (status != BAT_OK && !problem->message[0]) fail_msg("%s: refused without a reason", name);
    return status;
}

static void there_and_back(void **unused) {
    (void)unused;
    for (int i = 0; i < NAMES; i++) {
        bat_document *document = wedge(), *back = NULL;
        bat_problem problem;
        char *bytes = NULL;
        size_t size;
        assert_int_equal(bat_format_named(names[i])->write(document, &bytes, &size, &problem), BAT_OK);
        const bat_format *found = bat_format_sniffed(bytes, size);
        assert_ptr_equal(found, bat_format_named(names[i]));
        assert_int_equal(open_as(names[i], bytes, size, &back, &problem), BAT_OK);
        assert_true(bat_document_scale(back) == 1 && bat_document_unit(back) == BAT_UNIT_MM);
        assert_int_equal(bat_document_count(back), 1);
        const bat_polymesh *mesh = bat_object_mesh(bat_document_at(back, 0));
        assert_int_equal(bat_polymesh_vertex_count(mesh), 4);
        assert_int_equal(bat_polymesh_face_count(mesh), 4);
        for (size_t f = 0; f < 4; f++) { /* the same corners, whatever their order */
            size_t count;
            const int *face = bat_polymesh_face(mesh, f, &count);
            assert_int_equal(count, 3);
            for (size_t k = 0; k < 3; k++)
                for (int c = 0; c < 3; c++) {
                    const double had = places[3 * corners[3 * f + k] + c],
                                 has = bat_polymesh_vertices(mesh)[3 * face[k] + c];
                    if (!(fabs(had - has) < 1e-5)) fail_msg("%s: %g is %g", names[i], had, has);
                }
        }
        bat_free(bytes);
        bat_document_free(document), bat_document_free(back);
    }
}

static void try_one(const char *name, const char *bytes, size_t size) {
    const long held = alloc_live();
    bat_document *back = NULL;
    bat_problem problem;
    char *own = malloc(size + 1); /* so that a sanitizer sees its end */
    assert_non_null(own);
    memcpy(own, bytes, size);
    if (open_as(name, own, size, &back, &problem) == BAT_OK) assert_null(bat_document_check(back));
    bat_document_free(back);
    free(own);
    if (alloc_live() != held) fail_msg("%s: a leak", name);
}

static void cut_and_spoilt(void **unused) {
    (void)unused;
    static const unsigned char others[] = {0, 0xFF, 0x80, 1, ' ', '9', '-', '"'};
    for (int i = 0; i < NAMES; i++) {
        bat_document *document = wedge();
        bat_problem problem;
        char *bytes = NULL;
        size_t size;
        assert_int_equal(bat_format_named(names[i])->write(document, &bytes, &size, &problem), BAT_OK);
        bat_document_free(document);
        for (size_t cut = 0; cut < size; cut++) try_one(names[i], bytes, cut);
        for (size_t at = 0; at < size; at++) {
            const char kept = bytes[at];
            for (size_t k = 0; k < sizeof others; k++) {
                bytes[at] = k < 4 ? (char)(kept ^ (char)others[k]) : (char)others[k];
                try_one(names[i], bytes, size);
            }
            bytes[at] = kept;
        }
        bat_free(bytes);
    }
}

static void without_memory(void **unused) {
    (void)unused;
    for (int i = 0; i < NAMES; i++) {
        bat_document *document = wedge(), *back = NULL;
        bat_problem problem;
        char *bytes = NULL;
        size_t size;
        assert_int_equal(bat_format_named(names[i])->write(document, &bytes, &size, &problem), BAT_OK);
        bat_document_free(document);
        const long held = alloc_live();
        bat_status status;
        bool again = true;
        for (int n = 1; again; n++) {
            alloc_fail_at(n);
            status = open_as(names[i], bytes, size, &back, &problem);
            again = alloc_fail_reached();
            if (again && status != BAT_OK) assert_int_equal(status, BAT_MEMORY);
            bat_document_free(back);
            back = NULL;
            if (alloc_live() != held) fail_msg("%s: a leak", names[i]);
        }
        assert_int_equal(status, BAT_OK);
        bat_free(bytes);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(there_and_back), cmocka_unit_test(cut_and_spoilt),
                                       cmocka_unit_test(without_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
