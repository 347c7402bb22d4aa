/* The SVG reader as exports: the page walks the document parsed by the browser and passes it element by element. */
#include "module.h"

#include <stdlib.h>
#include <string.h>

MODULE_EXPORT(svg_begin) bat_svg_reader *svg_begin(void);
MODULE_EXPORT(svg_start) int svg_start(bat_svg_reader *reader, const char *strings, size_t pairs);
MODULE_EXPORT(svg_text) int svg_text(bat_svg_reader *reader, const char *text, size_t size);
MODULE_EXPORT(svg_source) int svg_source(bat_svg_reader *reader, const char *text, size_t size);
MODULE_EXPORT(svg_end) int svg_end(bat_svg_reader *reader);
MODULE_EXPORT(svg_cancel) void svg_cancel(bat_svg_reader *reader, bat_problem *problem);
MODULE_EXPORT(svg_paste) int svg_paste(bat_svg_reader *reader, bat_editor *editor, bat_problem *problem);
MODULE_EXPORT(svg_finish)
int svg_finish(bat_svg_reader *reader, bat_editor *editor, const char *name, bat_problem *problem);

/* NULL when out of memory. */
bat_svg_reader *svg_begin(void) {
    const bat_svg_options options = bat_svg_merging();
    bat_svg_reader *reader = NULL;
    return bat_svg_reader_create(&options, &reader) == BAT_OK ? reader : NULL;
}

/* strings: the element's name, then `pairs` attributes as name, value; each string ends with a NUL. */
int svg_start(bat_svg_reader *reader, const char *strings, size_t pairs) {
    MODULE_CHECK(reader && strings);
    const char **attributes = calloc(2 * pairs + 1, sizeof *attributes);
    if (!attributes) {
        return BAT_MEMORY;
    }
    const char *next = strings;
    for (size_t i = 0; i < 2 * pairs; i++) {
        next += strlen(next) + 1;
        attributes[i] = next;
    }
    const bat_status status = bat_svg_reader_start(reader, strings, attributes);
    free(attributes);
    return (int)status;
}

int svg_text(bat_svg_reader *reader, const char *text, size_t size) {
    MODULE_CHECK(reader);
    return (int)bat_svg_reader_text(reader, text, size);
}

/* The whole file, which the document keeps so as to write it again. */
int svg_source(bat_svg_reader *reader, const char *text, size_t size) {
    MODULE_CHECK(reader);
    return (int)bat_svg_reader_source(reader, text, size);
}

int svg_end(bat_svg_reader *reader) {
    MODULE_CHECK(reader);
    return (int)bat_svg_reader_end(reader);
}

/* Frees the reader, and says what it did not take. */
void svg_cancel(bat_svg_reader *reader, bat_problem *problem) {
    bat_document *document = NULL;
    bat_svg_report report;
    *problem = (bat_problem){.place = ""};
    bat_svg_reader_finish(reader, &document, &report, problem);
    bat_document_free(document);
}

/* Frees the reader whatever it returns, opens what was read, and notes what was lost of the file. */
int svg_finish(bat_svg_reader *reader, bat_editor *editor, const char *name, bat_problem *problem) {
    MODULE_CHECK(reader && editor);
    bat_document *document = NULL;
    bat_svg_report report;
    bat_status status = bat_svg_reader_finish(reader, &document, &report, problem);
    if (status != BAT_OK) {
        return (int)status;
    }
    status = bat_editor_open(editor, document, name);
    if (status != BAT_OK) {
        return (int)status;
    }
    return (int)bat_editor_set_losses(editor, &report.lost);
}

/* Frees the reader whatever it returns, and pastes what was read. Without a document (nothing read) nothing is
 * pasted, and a notice says so. */
int svg_paste(bat_svg_reader *reader, bat_editor *editor, bat_problem *problem) {
    MODULE_CHECK(reader && editor && problem);
    bat_document *document = NULL;
    bat_svg_report report;
    bat_status status = bat_svg_reader_finish(reader, &document, &report, problem);
    if (status != BAT_OK) {
        return (int)status;
    }
    bat_editor_paste(editor, document, report.native); /* reports by notices */
    bat_document_free(document);
    return BAT_OK;
}
