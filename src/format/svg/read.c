/* Reading SVG: elements are collected, then drawn into a document once all are known. */
#include "base/options.h"
#include "document/digest.h"
#include "document/document.h"
#include "format/glyph/glyph.h"
#include "format/svg/reader.h"
#include "format/svg/held.h"
#include "format/svg/markup.h"
#include "format/svg/walk.h"
#include "text/json.h"
#include "text/utf8.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const bat_svg_options DEFAULTS = {sizeof DEFAULTS, .corner = 0.05};
static const bat_svg_options MERGING = {sizeof MERGING, .tolerance = 1e-3, .corner = 0.05, .share = 1e-4};
enum { LEAST = sizeof DEFAULTS }; /* size in version 0.2: the first member added later begins there */

void bat_svg_options_init(bat_svg_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

void bat_svg_options_init_merging(bat_svg_options *options, size_t size) {
    bat_options_give(&MERGING, sizeof MERGING, size, options);
}

bat_status bat_svg_reader_create(const bat_svg_options *options, bat_svg_reader **out) {
    bat_svg_options chosen = DEFAULTS;
    bat_status status = bat_options_read(options, LEAST, sizeof chosen, &chosen);
    if (status != BAT_OK) return status;
    if (!out || !(chosen.tolerance >= 0 && chosen.tolerance <= BAT_COORDINATE_MAX) ||
        !(chosen.corner >= 0 && chosen.corner <= 4) || !(chosen.share >= 0))
        return BAT_ARGUMENT;
    bat_svg_reader *reader = malloc(sizeof *reader);
    if (!reader) return BAT_MEMORY;
    *reader = (bat_svg_reader){.options = chosen};
    *out = reader;
    return BAT_OK;
}

void bat_svg_reader_free(bat_svg_reader *reader) {
    if (!reader) return;
    bat_svg_tree_free(&reader->tree);
    bat_text_free(&reader->styles);
    bat_text_free(&reader->native);
    if (reader->glyph) bat_glyph_free(reader->glyph);
    free(reader->glyph);
    if (!reader->lent) free(reader->source);
    free(reader);
}

static bat_status note(bat_svg_reader *reader, bat_status status) {
    if (status != BAT_OK && reader->status == BAT_OK) {
        reader->status = status;
        reader->failed_at = reader->tree.count;
    }
    return reader->status;
}

bat_status bat_svg_reader_start(bat_svg_reader *reader, const char *name, const char *const *attributes) {
    if (!reader || !name) return BAT_ARGUMENT;
    if (reader->status != BAT_OK) return reader->status;
    if (reader->tree.count == 0 && !reader->glyph && bat_glyph_is_root(name)) {
        reader->glyph = calloc(1, sizeof *reader->glyph);
        if (!reader->glyph) return note(reader, BAT_MEMORY);
    }
    if (reader->glyph) return note(reader, bat_glyph_start(reader->glyph, name, attributes));
    bat_status status = bat_svg_tree_open(&reader->tree, name, attributes);
    if (status != BAT_OK) return note(reader, status);
    uint32_t index = reader->tree.count - 1;
    if (reader->tree.elements[index].kind == BAT_SVG_NATIVE && !reader->native_element)
        reader->native_element = index;
    if (index == 1 && reader->tree.elements[1].kind != BAT_SVG_ROOT) return note(reader, BAT_UNSUPPORTED);
    return BAT_OK;
}

bat_status bat_svg_reader_text(bat_svg_reader *reader, const char *text, size_t size) {
    if (!reader || (!text && size > 0)) return BAT_ARGUMENT;
    if (reader->status != BAT_OK || reader->tree.depth == 0) return reader->status;
    bat_svg_tree *tree = &reader->tree;
    uint32_t element = tree->open[tree->depth - 1];
    bat_text *to = tree->elements[element].kind == BAT_SVG_STYLE  ? &reader->styles
                   : element == reader->native_element && element ? &reader->native
                                                                  : NULL;
    if (!to) return BAT_OK;
    if (size > BAT_JSON_SIZE - to->size) return note(reader, BAT_COUNT);
    bat_text_add(to, text, size);
    return note(reader, to->failed ? BAT_MEMORY : BAT_OK);
}

bat_status bat_svg_reader_end(bat_svg_reader *reader) {
    if (!reader) return BAT_ARGUMENT;
    if (reader->status != BAT_OK) return reader->status;
    return note(reader, reader->glyph ? bat_glyph_end(reader->glyph) : bat_svg_tree_close(&reader->tree));
}

static bool can_keep(const char *text, size_t size) {
    return size > 0 && size <= BAT_JSON_SIZE && bat_utf8_valid(text, size) && !memchr(text, '\0', size);
}

void bat_svg_reader_lend(bat_svg_reader *reader, char *text, size_t size) {
    if (!can_keep(text, size)) return;
    reader->source = text;
    reader->source_size = size;
    reader->lent = true;
}

bat_status bat_svg_reader_source(bat_svg_reader *reader, const char *text, size_t size) {
    if (!reader || (!text && size > 0)) return BAT_ARGUMENT;
    if (!can_keep(text, size)) return BAT_OK;
    char *kept = malloc(size + 1);
    if (!kept) return note(reader, BAT_MEMORY);
    memcpy(kept, text, size);
    kept[size] = '\0';
    free(reader->source);
    reader->source = kept;
    reader->source_size = size;
    return BAT_OK;
}

static bat_status read_drawing(bat_svg_reader *reader, bat_document **out, bat_svg_report *report) {
    bat_svg_sheet sheet;
    bat_document *document = NULL;
    const uint32_t native = reader->native_element;
    reader->held = native && bat_svg_tree_attribute(&reader->tree, native, "drawing");
    if (reader->held) bat_svg_held_begin(reader);
    bat_status status = bat_svg_tree_index(&reader->tree);
    if (status == BAT_OK) status = bat_svg_sheet_parse(reader->styles.data, reader->styles.size, &sheet);
    if (status != BAT_OK) return status;
    if (sheet.ranks) status = bat_svg_tree_number(&reader->tree);
    if (status == BAT_OK) status = bat_document_create(&document);
    bat_svg_walk *w = status == BAT_OK ? malloc(sizeof *w) : NULL;
    if (!w) {
        bat_svg_sheet_free(&sheet);
        bat_document_free(document);
        return BAT_MEMORY;
    }
    *w = (bat_svg_walk){.options = &reader->options,
                        .tree = &reader->tree,
                        .sheet = &sheet,
                        .document = document,
                        .report = report,
                        .keeps = reader->source || reader->again,
                        .like = reader->again ? reader->again->like : NULL,
                        .shows = reader->held || reader->again,
                        .text = reader->source,
                        .text_size = reader->source_size,
                        .digest = bat_digest_begin()};
    status = bat_svg_notes_begin(&w->notes, &reader->tree, &sheet, &w->unseen, &report->lost);
    if (status == BAT_OK) bat_svg_draw_root(w);
    if (status == BAT_OK) status = w->status;
    if (reader->again) {
        bat_svg_held_keep(w, reader->again);
    } else if (status == BAT_OK) {
        if (reader->held)
            status = bat_svg_held_use(reader, w, &document, report);
        else
            bat_svg_use_native(reader, w->digest, &w->pictures, &document, report);
    }
    if (status == BAT_OK && reader->source && !reader->again)
        status = bat_svg_keep(reader, w, report->native, document);
    bat_svg_candidates_free(&w->candidates);
    free(w->places);
    free(w->shown);
    free(w->opacities);
    bat_svg_stand_free(w);
    bat_outline_free(&w->outline);
    bat_pictures_free(&w->pictures);
    bat_svg_notes_free(&w->notes);
    bat_svg_stops_free(w);
    bat_svg_tiles_free(w);
    bat_svg_markers_free(w);
    bat_svg_variables_free(&w->variables);
    free(w);
    bat_svg_sheet_free(&sheet);
    if (status != BAT_OK) bat_document_free(document);
    if (status == BAT_OK) *out = document;
    return status;
}

/* The elements of the SVG file that shows the same as the glyph; those that no drawing holds are unknown there, too. */
static bat_status show_glyph(bat_svg_reader *reader) {
    const bat_glyph *glyph = reader->glyph;
    const double width = glyph->advance, height = fmax(glyph->bottom - glyph->top, 1);
    bat_text box = {0};
    bat_svg_write_pair(&box, (const double[2]){0, glyph->top});
    bat_text_string(&box, " ");
    bat_svg_write_pair(&box, (const double[2]){width, height});
    bat_text_add(&box, "", 1);
    bat_text path = {0};
    bat_text_add(&path, glyph->path.data, glyph->path.size);
    bat_text_add(&path, "", 1);
    const char *const root[] = {"viewBox", box.data, NULL}, *const shape[] = {"id", glyph->name, "d",
                                                                              path.data, NULL};
    bat_status status = box.failed || path.failed ? BAT_MEMORY : BAT_OK;
    if (status == BAT_OK) status = bat_svg_tree_open(&reader->tree, "svg", width > 0 ? root : NULL);
    if (status == BAT_OK) status = bat_svg_tree_open(&reader->tree, "path", shape);
    if (status == BAT_OK) status = bat_svg_tree_close(&reader->tree);
    for (int i = 0; i < glyph->left_out && status == BAT_OK; i++) {
        status = bat_svg_tree_open(&reader->tree, "component", NULL);
        if (status == BAT_OK) status = bat_svg_tree_close(&reader->tree);
    }
    if (status == BAT_OK) status = bat_svg_tree_close(&reader->tree);
    bat_text_free(&box), bat_text_free(&path);
    if (!reader->lent) free(reader->source); /* it is not SVG: nothing can be written into it */
    reader->source = NULL, reader->source_size = 0;
    return status;
}

static bat_status explain(const bat_svg_reader *reader, bat_status status, bat_problem *problem) {
    char place[64] = "";
    const char *message = bat_status_message(status);
    if (reader->status != BAT_OK && reader->failed_at > 0)
        snprintf(place, sizeof place, "element %lu", (unsigned long)reader->failed_at);
    if (status == BAT_UNSUPPORTED) message = "expected an svg element at the top, found another";
    if (status == BAT_COUNT)
        message =
            "expected at most 256 levels, 4 million elements, 1 million drawn and 33 million style rules "
            "tried on them, found more";
    if (status == BAT_SYNTAX)
        message = reader->tree.count == 0  ? "expected an svg element, found nothing"
                  : reader->tree.depth > 0 ? "expected the ends of all elements, found the end of the file"
                                           : "expected one element at the top, found more";
    if (reader->glyph && reader->glyph->wrong) message = reader->glyph->wrong;
    return bat_problem_set(problem, status, place, message);
}

bat_status bat_svg_reader_finish(bat_svg_reader *reader, bat_document **out, bat_svg_report *report,
                                 bat_problem *problem) {
    if (!reader || !out) {
        bat_svg_reader_free(reader);
        return bat_problem_set(problem, BAT_ARGUMENT, "", bat_status_message(BAT_ARGUMENT));
    }
    bat_svg_report facts = {0};
    bat_document *document = NULL;
    bat_status status = reader->status;
    if (status == BAT_OK && reader->glyph)
        status = reader->glyph->depth > 0 ? BAT_SYNTAX : show_glyph(reader);
    if (status == BAT_OK && (reader->tree.count == 0 || reader->tree.depth > 0)) status = BAT_SYNTAX;
    if (status == BAT_OK) status = read_drawing(reader, &document, &facts);
    if (status == BAT_OK) {
        *out = document;
        if (report) *report = facts;
    } else
        explain(reader, status, problem);
    bat_svg_reader_free(reader);
    return status;
}
