/* What SVG cannot hold of a document that is written as the file it was read from: beside each such object stands what it takes
 * the place of, by a digest of what is shown there, so that an object which another program changed is read from its element
 * and all others keep every bit (docs/format.md). */
#ifndef BATTEN_FORMAT_SVG_HELD_H
#define BATTEN_FORMAT_SVG_HELD_H

#include "format/svg/reader.h"
#include "format/svg/walk.h"

/* What each object of a drawing shows, from what was noted while it was read; returns a digest of all, with its groups. */
uint64_t bat_svg_held_digests(const bat_document *drawing, const bat_svg_shown *shown, int shown_count,
                              uint64_t *digests);
uint64_t bat_svg_held_digest(const uint64_t *digests, int count); /* of neighbours */
/* Hands over what a text shows that is read again. */
void bat_svg_held_keep(bat_svg_walk *w, bat_svg_again *out);

/* Reads the file's nodes as they were when it was written. */
void bat_svg_held_begin(bat_svg_reader *reader);
/* Gives the document what the file holds beside its drawing. BAT_MEMORY, or BAT_OK. */
bat_status bat_svg_held_use(const bat_svg_reader *reader, bat_svg_walk *w, bat_document **document,
                            bat_svg_report *report);

#endif
