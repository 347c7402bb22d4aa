/* Any bytes as STL, PLY, glTF and 3MF: a sound drawing or an error status; what was read is written, and reads back with as many
 * faces. */
#include "format/formats.h"

#include <batten/bezier.h>
#include <batten/document.h>
#include <batten/mesh.h>

#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static const bat_reading how = {.xml = NULL};

static size_t faces_of(const bat_document *document) {
    size_t count = 0;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_polymesh *mesh = bat_object_mesh(bat_document_at(document, i));
        if (!mesh) abort();
        count += bat_polymesh_triangle_count(mesh);
    }
    return count;
}

/* As STL, which may have fewer: of those that have an area. */
static void again(const bat_document *document) {
    const bat_format *stl = bat_format_named("stl");
    bat_document *back = NULL;
    bat_svg_report report = {0};
    bat_problem problem;
    char *bytes = NULL;
    size_t size;
    if (stl->write(document, &bytes, &size, &problem) != BAT_OK) return;
    const bat_status status = stl->read(&how, bytes, size, &back, &report, &problem);
    if (status != BAT_OK && status != BAT_COUNT) abort(); /* rounded to floats, all may be flat */
    if (back && faces_of(back) > faces_of(document)) abort();
    bat_free(bytes);
    bat_document_free(back);
}

static void read_as(const bat_format *format, const char *data, size_t size) {
    bat_document *document = NULL;
    bat_svg_report report = {0};
    bat_problem problem = {"", ""};
    const bat_status status = format->read(&how, data, size, &document, &report, &problem);
    if ((status == BAT_OK) != (document != NULL) || (status != BAT_OK && !problem.message[0])) abort();
    if (!document) return;
    if (bat_document_check(document)) abort();
    again(document);
    bat_document_free(document);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const char *const names[] = {"stl", "ply", "glb", "gltf", "3mf"};
    for (size_t i = 0; i < sizeof names / sizeof *names && size > 0; i++) {
        const bat_format *format = bat_format_named(names[i]);
        if (format && format->sniff((const char *)data, size) > 0) read_as(format, (const char *)data, size);
    }
    return 0;
}
