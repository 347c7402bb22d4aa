/* Standard input, an SVG, read and written again without the native document: for test_rsvg.py. Of what is written
 * nothing may be lost. */
#include "support/xml.h"

#include <batten/bezier.h>
#include <batten/document.h>

#include <stdio.h>

int main(void) {
    static char text[1 << 16];
    size_t size = fread(text, 1, sizeof text - 1, stdin);
    text[size] = '\0';
    bat_document *document;
    char *again;
    if (xml_read(text, NULL, &document, NULL, NULL) != BAT_OK) return 1;
    if (bat_svg_write(document, false, &again, &size) != BAT_OK) return 1;
    bat_document *twice;
    bat_svg_report report;
    if (xml_read(again, NULL, &twice, &report, NULL) != BAT_OK || bat_losses_total(&report.lost) > 0)
        return 1;
    bat_document_free(twice);
    fwrite(again, 1, size, stdout);
    bat_free(again);
    bat_document_free(document);
    return 0;
}
