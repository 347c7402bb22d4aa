/* SVG files read with their text, so that it is kept when they are written. */
#ifndef BATTEN_TESTS_SVG_KEPT_H
#define BATTEN_TESTS_SVG_KEPT_H

#include "format/svg/write/feed.h"
#include <batten/format.h>

/* options and report may be NULL. */
static inline bat_status svg_read_kept(const bat_svg_options *options, const char *text, size_t size,
                                       bat_document **out, bat_svg_report *report) {
    bat_svg_reader *reader;
    bat_status status = bat_svg_reader_create(options, &reader);
    if (status != BAT_OK) return status;
    status = bat_svg_reader_source(reader, text, size);
    if (status == BAT_OK) status = bat_svg_feed(text, size, reader);
    if (status == BAT_OK) return bat_svg_reader_finish(reader, out, report, NULL);
    bat_svg_reader_free(reader);
    return status;
}

#endif
