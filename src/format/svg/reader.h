/* What a reader has collected from an SVG file. */
#ifndef BATTEN_FORMAT_SVG_READER_H
#define BATTEN_FORMAT_SVG_READER_H

#include "document/picture.h"
#include "format/svg/tree.h"

#include <batten/format.h>

struct bat_svg_reader {
    bat_svg_options options;
    bat_svg_tree tree;
    bat_text styles, native;
    uint32_t native_element;
    bat_status status;  /* the first failure */
    uint32_t failed_at; /* number of elements begun at that point */
    char *source;       /* the file's text, when it is to be kept */
    size_t source_size;
    bool lent;                   /* it is the caller's, who keeps it as long as the reader */
    struct bat_glyph *glyph;     /* of a file whose root is a glyph; NULL: it is SVG */
    bool held;                   /* beside the drawing it has only what SVG cannot hold */
    struct bat_svg_again *again; /* where goes what was read, of which no document is kept; NULL: nowhere */
};

struct bat_svg_walk;
struct bat_svg_shown;

/* What a text shows that is read again before it is handed over. Zeros but for `like` before; released by bat_svg_again_free. */
typedef struct bat_svg_again {
    const bat_document
        *like; /* what ought to be read: the document shares its curves. Set before; NULL: none */
    bat_document *document;
    uint64_t digest; /* of the drawing */
    struct bat_sourced *places;
    int place_count;
    struct bat_svg_shown *shown;
    int shown_count;
} bat_svg_again;

/* As bat_svg_reader_source, without a copy: text, which ends with a zero, must outlive the reader. */
void bat_svg_reader_lend(bat_svg_reader *reader, char *text, size_t size);
/* Keeps the file with the document that was read from it, if its elements are where they seem to be. */
bat_status bat_svg_keep(const bat_svg_reader *reader, const struct bat_svg_walk *w, bool native,
                        bat_document *document);
/* Gives each entry the object that the native document says: {"elements":[[id, element], ...]}. *out: whether it says so. */
bat_status bat_svg_name_native(const bat_svg_reader *reader, struct bat_sourced *list, int count, bool *out);
/* Counts what the native document has in the place of the drawing. */
void bat_svg_report_native(const bat_document *native, bat_svg_report *report);

/* Replaces the document by the native one when the drawing still shows what was written with it. */
void bat_svg_use_native(const bat_svg_reader *reader, uint64_t digest, bat_pictures *pictures,
                        bat_document **document, bat_svg_report *report);

#endif
