/* A text that is known to be well formed, fed to a reader: what was written is read back to see what it shows. */
#ifndef BATTEN_FORMAT_SVG_WRITE_FEED_H
#define BATTEN_FORMAT_SVG_WRITE_FEED_H

#include <batten/format.h>

/* Reads the text as a parser would and feeds it to a reader. BAT_UNSUPPORTED: an entity that it does not know. */
bat_status bat_svg_feed(const char *text, size_t size, bat_svg_reader *reader);

#endif
