/* Any bytes as OBJ: curves or an error status, never both; what was read is written and reads back the same. */
#include "format/formats.h"

#include <batten/bezier.h>

#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
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
