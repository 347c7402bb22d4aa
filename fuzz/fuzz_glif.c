/* Any text as a glyph: what can be read is written, comes back with as many curves, and put into a glyph's place it leaves
 * all else as it was. */
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/document.h>

#include "document/format.h"
#include "format/svg/write/feed.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

extern const bat_format bat_format_of_glif;

static const char BEFORE[] =
    "<glyph name=\"a\" format=\"2\">\n  <unicode hex=\"0061\"/>\n  <outline>\n    <component base=\"b\"/>";
static const char AFTER[] = "\n  </outline>\n  <!-- <contour> -->\n  <lib/>\n</glyph>\n";

static int curves_of(const bat_document *document) {
    int count = 0;
    for (int i = 0; i < bat_document_count(document); i++)
        count += bat_object_curve_count(bat_document_at(document, i));
    return count;
}

static bat_status read(const char *text, size_t size, bat_document **out) {
    bat_svg_reader *reader;
    bat_svg_report report;
    bat_problem problem;
    bat_status status = bat_svg_reader_create(NULL, &reader);
    if (status != BAT_OK) return status;
    status = bat_svg_feed(text, size, reader);
    if (status == BAT_OK) return bat_svg_reader_finish(reader, out, &report, &problem);
    bat_svg_reader_free(reader);
    return status;
}

static void check(const char *text, size_t size, int curves) {
    bat_document *document = NULL;
    const bat_status status = read(text, size, &document);
    if (status != BAT_OK && status != BAT_MEMORY) abort();
    if (document && curves_of(document) != curves) abort();
    bat_document_free(document);
}

static void put_in_place(const bat_document *document, bool extremes, int curves) {
    char old[sizeof BEFORE + sizeof AFTER + 80], *text;
    size_t size;
    snprintf(old, sizeof old, "%s\n    <contour><point x=\"1\" y=\"2\"/></contour>%s", BEFORE, AFTER);
    const bat_status status = bat_glif_replace(old, strlen(old), document, extremes, &text, &size, NULL);
    if (status == BAT_MEMORY) return;
    if (status != BAT_OK || size < strlen(BEFORE) + strlen(AFTER)) abort();
    if (memcmp(text, BEFORE, strlen(BEFORE)) != 0) abort();
    if (memcmp(text + size - strlen(AFTER), AFTER, strlen(AFTER)) != 0) abort();
    check(text, size, curves);
    bat_free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *text = (const char *)data;
    bat_document *document = NULL;
    char *glyph = NULL;
    size_t length;
    const bool extremes = size % 2;
    if (size == 0 || !bat_format_of_glif.sniff(text, size)) return 0;
    bat_status status = read(text, size, &document);
    if (status == BAT_OK) status = bat_glif_write(document, extremes, &glyph, &length);
    if (status == BAT_OK) {
        const int curves = curves_of(document);
        check(glyph, length, curves);
        bat_free(glyph);
        put_in_place(document, extremes, curves);
        if (bat_glif_replace(text, size, document, extremes, &glyph, &length, NULL) == BAT_OK)
            bat_free(glyph);
    }
    bat_document_free(document);
    return 0;
}
