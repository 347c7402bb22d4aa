/* What the reader of a drawing finds that a document cannot hold: each kind once an element. */
#ifndef BATTEN_FORMAT_SVG_NOTES_H
#define BATTEN_FORMAT_SVG_NOTES_H

#include "format/svg/style.h"
#include "format/svg/tree.h"

typedef struct bat_svg_notes {
    const bat_svg_tree *tree;
    bat_losses *lost;
    uint32_t *seen; /* an element's kinds, as bits; owned */
} bat_svg_notes;

/* Looks through the file for what is referred to, and counts the sheet's rules. tree has its index. */
bat_status bat_svg_notes_begin(bat_svg_notes *notes, const bat_svg_tree *tree, const bat_svg_sheet *sheet,
                               bat_losses *lost);
void bat_svg_notes_free(bat_svg_notes *notes);

void bat_svg_note(bat_svg_notes *notes, uint32_t element, bat_loss kind); /* BAT_LOSS_COUNT: nothing */
/* True the first time for each element: `use` may draw it often. */
bool bat_svg_note_once(bat_svg_notes *notes, uint32_t element);
/* The odd properties of a style: those in the mask. */
void bat_svg_note_odd(bat_svg_notes *notes, uint32_t element, uint32_t odd, uint32_t mask);
/* An element that is not drawn where it stands: definitions, when nothing refers to them, and all else. */
void bat_svg_note_undrawn(bat_svg_notes *notes, uint32_t element);
/* The children of one that is drawn as a whole: titles, animations. Once. */
void bat_svg_note_inside(bat_svg_notes *notes, uint32_t element);
/* The root's width and height, which become those of the page. */
void bat_svg_note_page(bat_svg_notes *notes, const double page[4]);

#endif
