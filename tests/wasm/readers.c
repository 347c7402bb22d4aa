/* Files of every kind through their readers. What was read is written again; the witness sees all of it. */
#include "wasm/units.h"
#include "wasm/witness.h"

#include "support/xml.h"

#include <batten/bezier.h>
#include <batten/editor.h>
#include <batten/levels.h>

#include <stdio.h>

static void note_read(bat_status status, const bat_problem *problem) {
    char line[sizeof *problem + 40];
    const bool bad = status != BAT_OK;
    snprintf(line, sizeof line, "%d %s %s", (int)status, bad ? problem->place : "",
             bad ? problem->message : "");
    witness_note(line);
}

static void write_all(const bat_document *document) {
    char *text;
    size_t size;
    if (bat_document_write(document, &text, &size) == BAT_OK) bat_free(text);
    if (bat_svg_write(document, true, &text, &size) == BAT_OK) bat_free(text);
}

int read_svg(const uint8_t *data, size_t size) {
    (void)size;
    bat_svg_reader *reader;
    bat_document *document = NULL;
    bat_svg_report report;
    bat_problem problem = {"", ""};
    char line[200];
    if (bat_svg_reader_create(NULL, &reader) != BAT_OK) abort();
    if (!xml_feed(reader, (const char *)data)) {
        bat_svg_reader_free(reader);
        return 0;
    }
    bat_status status = bat_svg_reader_finish(reader, &document, &report, &problem);
    note_read(status, &problem);
    if (status != BAT_OK) return 0;
    bat_svg_report_line(&report, line, sizeof line);
    witness_note(line);
    write_all(document);
    bat_document_free(document);
    return 0;
}

int read_journal(const uint8_t *data, size_t size) {
    bat_editor *editor;
    bat_problem problem = {"", ""};
    if (bat_editor_create(&editor) != BAT_OK) abort();
    bat_editor_resize(editor, 1280, 800, 1);
    note_read(bat_editor_replay(editor, (const char *)data, size, true, &problem), &problem);
    witness_note(bat_editor_journal(editor, NULL));
    bat_editor_frame(editor);
    write_all(bat_editor_document(editor));
    bat_editor_free(editor);
    return 0;
}

/* Everything else: each reader says what it thinks of it. */
int read_text(const uint8_t *data, size_t size) {
    const char *text = (const char *)data;
    bat_problem problem = {"", ""};
    bat_document *document;
    bat_curve *curve;
    bat_shape *shape;
    bat_stroke stroke;
    bat_spline spline;
    void *block;
    bat_status status = bat_document_read(text, size, &document, &problem);
    note_read(status, &problem);
    if (status == BAT_OK) write_all(document), bat_document_free(document);
    status = bat_curve_read(text, size, &curve, &problem);
    note_read(status, &problem);
    if (status == BAT_OK) bat_curve_free(curve);
    status = bat_shape_read(text, size, &shape, &problem);
    note_read(status, &problem);
    if (status == BAT_OK) bat_shape_free(shape);
    status = bat_spline_read(text, size, &spline, &block, &problem);
    note_read(status, &problem);
    if (status == BAT_OK) bat_free(block);
    status = bat_stroke_read(text, size, &stroke, &block, &problem);
    note_read(status, &problem);
    if (status != BAT_OK) return 0;
    const bat_sketch_options options = bat_sketch_defaults();
    if (bat_sketch_new(&stroke, false, &options, &curve, NULL) == BAT_OK) bat_curve_free(curve);
    bat_free(block);
    return 0;
}
