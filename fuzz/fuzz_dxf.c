/* Any bytes as DXF: a drawing or an error status; what was read is written, also as arcs, and reads back alike, and as G-code. */
#include "format/formats.h"

#include <batten/bezier.h>
#include <batten/document.h>

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static int curves(const bat_document *document) {
    int count = 0;
    for (int i = 0; i < bat_document_count(document); i++)
        count += bat_object_curve_count(bat_document_at(document, i));
    return count;
}

static void again(const bat_format *format, const bat_document *document, double arcs) {
    const bat_reading how = {.xml = NULL};
    bat_document *back = NULL;
    bat_svg_report report = {0};
    bat_problem problem;
    char *text = NULL;
    size_t length = 0;
    if (bat_dxf_write(document, arcs, &text, &length) != BAT_OK) return;
    if (format->read(&how, text, length, &back, &report, &problem) != BAT_OK) abort();
    if (bat_document_check(back) || (arcs == 0 && curves(back) != curves(document))) abort();
    bat_free(text);
    bat_document_free(back);
}

/* It ends as it must, and the tool goes up as often as down, but for the first time. */
static void cut(const bat_document *document, double tolerance) {
    bat_gcode_options options;
    char *text = NULL;
    size_t length = 0;
    int turns = -1;
    bat_gcode_options_init(&options, sizeof options);
    options.up = "M5", options.down = "M3";
    if (tolerance > 0) options.tolerance = tolerance;
    if (bat_gcode_write(document, &options, &text, &length) != BAT_OK) return;
    if (length < 3 || strcmp(text + length - 3, "M2\n") != 0) abort();
    for (size_t i = 0; i + 1 < length; i++)
        if (text[i] == 'M') turns += text[i + 1] == '5' ? 1 : text[i + 1] == '3' ? -1 : 0;
    if (turns != 0) abort();
    bat_free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const bat_reading how = {.xml = NULL};
    const bat_format *format = bat_format_named("dxf");
    bat_document *document = NULL;
    bat_svg_report report = {0};
    bat_problem problem;
    if (size > 0) (void)format->sniff((const char *)data, size);
    if (format->read(&how, (const char *)data, size, &document, &report, &problem) != BAT_OK) {
        if (document) abort();
        return 0;
    }
    if (bat_document_check(document)) abort();
    again(format, document, 0);
    double box[4];
    bat_document_bounds(document, box);
    if (curves(document) < 20 && box[2] - box[0] > 0) again(format, document, 1e-3 * (box[2] - box[0]));
    if (curves(document) < 20) cut(document, 1e-3 * (box[2] - box[0]));
    bat_document_free(document);
    return 0;
}
