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
    struct bat_glyph *glyph; /* of a file whose root is a glyph; NULL: it is SVG */
    uint64_t *drawn;         /* where the digest of the drawing goes; NULL: nowhere */
};

struct bat_svg_walk;
/* Keeps the file with the document that was read from it, if its elements are where they seem to be. */
bat_status bat_svg_keep(const bat_svg_reader *reader, const struct bat_svg_walk *w, bool native,
                        bat_document *document);

/* Replaces the document by the native one when the drawing still shows what was written with it. */
void bat_svg_use_native(const bat_svg_reader *reader, uint64_t digest, bat_pictures *pictures,
                        bat_document **document, bat_svg_report *report);

#endif
