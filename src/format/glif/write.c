/* The outlines of a drawing as a glyph: GLIF 2. y = 0 of the document is the baseline, the page's width the advance. */
#include "format/glif/contours.h"
#include "format/glyph/glyph.h"

#include <batten/format.h>
#include <string.h>

/* That of the first object that has one. */
static const char *name_of(const bat_document *document) {
    for (int i = 0; i < bat_document_count(document); i++) {
        const char *name = bat_object_name(bat_document_at(document, i));
        if (name && *name) return name;
    }
    return "glyph";
}

bat_status bat_glif_write(const bat_document *document, bool extremes, char **text, size_t *size) {
    bat_text all = {0};
    double page[4];
    if (!document || !text || !size) return BAT_ARGUMENT;
    bat_document_page(document, page);
    if (page[2] > BAT_GLYPH_FARTHEST) return BAT_NUMBER;
    const char *name = name_of(document);
    bat_text_string(&all, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<glyph name=\"");
    bat_text_xml(&all, name, strlen(name), true);
    bat_text_string(&all, "\" format=\"2\">\n");
    if (page[2] > 0) {
        bat_text_string(&all, "  <advance width=\"");
        bat_text_number(&all, page[2]);
        bat_text_string(&all, "\"/>\n");
    }
    bat_text_string(&all, "  <outline>");
    const bat_status status = bat_glif_contours(document, extremes, &all);
    bat_text_string(&all, "\n  </outline>\n</glyph>\n");
    if (status == BAT_OK) return bat_text_finish(&all, text, size);
    bat_text_free(&all);
    return status;
}
