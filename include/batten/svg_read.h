/*
 * Batten: whole SVG files. This is a library of its own, libbatten-svg, because it needs expat; libbatten needs libc
 * and libm only, and takes the same files from any XML parser (bat_svg_reader in format.h).
 */
#ifndef BATTEN_SVG_READ_H
#define BATTEN_SVG_READ_H

#include <batten/document.h>
#include <batten/format.h>

#ifdef __cplusplus
extern "C" {
#endif

#define BAT_SVG_SIZE ((size_t)1 << 28) /* bytes of a file, at most */

/*
 * Reads a whole file: UTF-8, UTF-16, or what its XML declaration names (ISO-8859-1, US-ASCII, Windows-1252). options
 * may be NULL: the defaults; so may report and problem. *out is the caller's (bat_document_free). Nothing is fetched:
 * a document type that refers to a file is skipped, an entity that does is refused, and so are entities that expand
 * out of proportion. BAT_SYNTAX: not XML, empty, or such an entity; BAT_COUNT: more than BAT_SVG_SIZE bytes; else as
 * bat_svg_reader_finish. problem then says where ("line 3, column 14") and why. Cost: linear in size and in what is
 * drawn.
 */
BAT_API bat_status bat_svg_read(const char *text, size_t size, const bat_svg_options *options,
                                bat_document **out, bat_svg_report *report, bat_problem *problem);

#ifdef __cplusplus
}
#endif
#endif
