/* Any bytes as OBJ: a drawing, a model or an error status; what was read is written and reads back the same. */
#include "format/formats.h"

#include <batten/bezier.h>
#include <batten/document.h>
#include <batten/mesh.h>
#include <batten/surface.h>

#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static bool alike(const bat_model *a, const bat_model *b) {
    if (!a->mesh != !b->mesh || a->surface_count != b->surface_count || a->curve_count != b->curve_count)
        return false;
    if (a->mesh && !bat_polymesh_is_equal(a->mesh, b->mesh)) return false;
    for (size_t i = 0; i < a->surface_count; i++)
        if (bat_surface_degree(a->surfaces[i], BAT_U) != bat_surface_degree(b->surfaces[i], BAT_U))
            return false;
    return true;
}

static void as_model(const char *data, size_t size) {
    bat_model model, again;
    bat_problem problem;
    char *text = NULL;
    size_t length = 0;
    if (bat_obj_read(data, size, &model, &problem) != BAT_OK) return;
    if (bat_obj_write(&model, &text, &length) != BAT_OK) abort();
    if (bat_obj_read(text, length, &again, &problem) != BAT_OK) abort();
    if (!alike(&model, &again) || again.left_out) abort();
    bat_free(text);
    bat_model_clear(&model);
    bat_model_clear(&again);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    as_model((const char *)data, size);
    const bat_reading how = {.xml = NULL};
    const bat_format *format = bat_format_named("obj");
    bat_document *document = NULL, *again = NULL;
    bat_svg_report report = {0};
    bat_problem problem;
    char *text = NULL;
    size_t length = 0;
    if (size > 0) (void)format->sniff((const char *)data, size);
    bat_status status = format->read(&how, (const char *)data, size, &document, &report, &problem);
    if (status != BAT_OK) {
        if (document) abort();
        return 0;
    }
    if (bat_document_check(document)) abort();
    if (format->write(document, &text, &length, &problem) == BAT_OK) {
        if (format->read(&how, text, length, &again, &report, &problem) != BAT_OK) abort();
        if (bat_document_count(again) != bat_document_count(document)) abort();
        for (int i = 0; i < bat_document_count(document); i++) {
            const bat_curve *a = bat_object_curve(bat_document_at(document, i), 0),
                            *b = bat_object_curve(bat_document_at(again, i), 0);
            if (bat_curve_degree(a) != bat_curve_degree(b)) abort();
        }
    }
    bat_free(text);
    bat_document_free(document);
    bat_document_free(again);
    return 0;
}
