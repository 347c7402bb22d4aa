/* Any bytes as a document, a curve, a list of curves and a stroke. What can be read is written, and reads back the same, bit for
 * bit. */
#include "format/formats.h"

#include <batten/bezier.h>
#include <batten/document.h>
#include <batten/view.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* An object that the library accepts must survive writing and reading, too. */
static void add_guide(bat_document *document, bat_id id) {
    bat_object *guide;
    if (bat_object_create_guide(id, 0, 1, &guide) != BAT_OK) return;
    bat_document_insert(document, 0, guide);
    bat_object_release(guide);
}

/* A plane made of any numbers, whether its axes are at right angles or not. */
static void add_plane(bat_document *document, const double *numbers) {
    bat_object *plane;
    if (bat_object_create_plane(bat_document_new_id(document), "plane", numbers, numbers + 3, &plane) !=
        BAT_OK)
        return;
    if (!bat_object_plane(plane)) abort();
    bat_document_insert(document, 0, plane);
    bat_object_release(plane);
}

/* A view made of any numbers. */
static void add_view(bat_document *document, const double *numbers) {
    bat_viewpoint view = {.height = numbers[9], .size = {fabs(numbers[0]), 30}};
    bat_object *object;
    for (int k = 0; k < 3; k++)
        view.eye[k] = numbers[k], view.target[k] = numbers[3 + k], view.up[k] = numbers[6 + k];
    if (bat_object_create_view(bat_document_new_id(document), "view", &view, &object) != BAT_OK) return;
    if (!bat_object_view(object)) abort();
    bat_document_insert(document, 0, object);
    bat_object_release(object);
}

/* What a surface is made into can be made again. */
static void look_at_surfaces(const bat_document *document) {
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        const bat_surface *surface = bat_object_surface(object);
        bat_object *again = NULL;
        if (!surface || bat_object_with_surface(object, surface, &again) != BAT_OK) continue;
        if (bat_object_curve_count(again) != bat_object_curve_count(object)) abort();
        bat_object_release(again), again = NULL;
        const bat_relief *relief = bat_object_relief(object);
        if (relief && bat_object_with_relief(object, relief, &again) == BAT_OK && !bat_object_relief(again))
            abort();
        bat_object_release(again);
        if (bat_object_create_surface(1, "s", bat_object_style(object), surface, &again) != BAT_OK) abort();
        bat_object_release(again);
    }
}

static void check_document(const char *text, size_t size) {
    bat_document *document, *back;
    bat_problem problem;
    char *written;
    if (bat_document_read(text, size, &document, &problem) != BAT_OK) {
        if (!memchr(problem.place, 0, sizeof problem.place) ||
            !memchr(problem.message, 0, sizeof problem.message))
            abort();
        return;
    }
    size_t before = size;
    if (bat_document_check(document)) abort();
    look_at_surfaces(document);
    add_guide(document, bat_document_new_id(document));
    add_guide(document, bat_document_digest(document) >> (bat_document_digest(document) & 63));
    double numbers[10] = {0};
    memcpy(numbers, text, before < sizeof numbers ? before : sizeof numbers);
    add_plane(document, numbers);
    add_view(document, numbers);
    if (bat_document_check(document)) abort();
    if (bat_document_write(document, &written, &size) == BAT_OK) {
        if (bat_document_read(written, size, &back, &problem) != BAT_OK) abort();
        if (bat_document_digest(back) != bat_document_digest(document)) abort();
        if (bat_document_new_id(back) != bat_document_new_id(document)) abort();
        bat_document_free(back);
        bat_free(written);
    }
    bat_document_free(document);
}

static void check_curve(const char *text, size_t size) {
    bat_curve *curve, *back;
    bat_problem problem;
    char *written;
    if (bat_curve_read(text, size, &curve, &problem) != BAT_OK) return;
    if (bat_curve_write(curve, &written, &size) == BAT_OK) {
        if (bat_curve_read(written, size, &back, &problem) != BAT_OK || !bat_curve_is_equal(curve, back))
            abort();
        bat_curve_free(back);
        bat_free(written);
    }
    bat_curve_free(curve);
}

/* As a list of curves, and as a curve a line: what was written is read and written again, the same. */
static void as_curves(const char *name, const char *data, size_t size) {
    const bat_reading how = {.xml = NULL};
    const bat_format *format = bat_format_named(name);
    bat_document *document = NULL, *back = NULL;
    bat_svg_report report = {0};
    bat_problem problem = {"", ""};
    char *text = NULL, *again = NULL;
    size_t length = 0, other = 0;
    if (size > 0) (void)format->sniff(data, size);
    if (format->read(&how, data, size, &document, &report, &problem) != BAT_OK) {
        if (document || !problem.message[0]) abort();
        return;
    }
    if (bat_document_check(document)) abort();
    if (format->write(document, &text, &length, &problem) != BAT_OK) abort();
    if (format->read(&how, text, length, &back, &report, &problem) != BAT_OK) abort();
    if (format->write(back, &again, &other, &problem) != BAT_OK) abort();
    if (length != other || memcmp(text, again, length)) abort();
    bat_free(text), bat_free(again);
    bat_document_free(document), bat_document_free(back);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    as_curves("json", (const char *)data, size);
    as_curves("jsonl", (const char *)data, size);
    as_curves("csv", (const char *)data, size);
    as_curves("geojson", (const char *)data, size);
    const char *text = (const char *)data;
    bat_stroke stroke;
    void *block;
    bat_problem problem;
    check_document(text, size);
    check_curve(text, size);
    if (bat_stroke_read(text, size, &stroke, &block, &problem) == BAT_OK) {
        double sum = 0;
        for (size_t i = 0; i < stroke.count * (size_t)stroke.dimension; i++) sum += stroke.points[i];
        for (size_t i = 0; i < stroke.count; i++) {
            if (stroke.pressure) sum += stroke.pressure[i];
            if (stroke.time) sum += stroke.time[i];
        }
        if (sum != sum) abort();
        bat_free(block);
    }
    int dimension;
    size_t count;
    double *points;
    if (bat_points_read(text, size, &dimension, &count, &points, &problem) == BAT_OK) {
        if (dimension < 2 || dimension > 3) abort();
        for (size_t i = 0; i < count * (size_t)dimension; i++)
            if (!(points[i] <= 1e75 && points[i] >= -1e75)) abort();
        bat_free(points);
    }
    return 0;
}
