/* What a reader has collected of an SVG file. */
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
    uint32_t failed_at; /* elements begun when it came */
};

/* Takes the native document's place when the drawing still shows what was written with it. */
void bat_svg_use_native(const bat_svg_reader *reader, uint64_t digest, bat_pictures *pictures,
                        bat_document **document, bat_svg_report *report);

#endif
