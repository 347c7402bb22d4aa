/* Records what a drawing holds that a document cannot: each kind once per element. */
#ifndef BATTEN_FORMAT_SVG_NOTES_H
#define BATTEN_FORMAT_SVG_NOTES_H

#include "format/svg/style.h"
#include "format/svg/tree.h"

typedef struct bat_svg_notes {
    const bat_svg_tree *tree;
    bat_losses *lost;
    const int *hidden; /* greater than 0: what is noted is not displayed */
    uint32_t *seen;    /* for each element, its kinds as bits; owned */
} bat_svg_notes;

/* Searches the file for references, and counts the sheet's rules. tree must have its index. */
bat_status bat_svg_notes_begin(bat_svg_notes *notes, const bat_svg_tree *tree, const bat_svg_sheet *sheet,
                               const int *hidden, bat_losses *lost);
void bat_svg_notes_free(bat_svg_notes *notes);

/* BAT_LOSS_COUNT: nothing. What is hidden looks as it does in the file: it counts as such. */
void bat_svg_note(bat_svg_notes *notes, uint32_t element, bat_loss kind);
/* What has been noted at the element that changes how something looks: a bit 1 << bat_loss each. */
uint32_t bat_svg_noted(const bat_svg_notes *notes, uint32_t element);
/* True the first time for each element: `use` may draw it several times. */
bool bat_svg_note_once(bat_svg_notes *notes, uint32_t element);
/* Notes the odd properties of a style that are in the mask. */
void bat_svg_note_odd(bat_svg_notes *notes, uint32_t element, uint32_t odd, uint32_t mask);
/* Notes an element that is not drawn in place: a definition to which nothing refers, or anything else. */
void bat_svg_note_undrawn(bat_svg_notes *notes, uint32_t element);
/* Notes the children of an element that is drawn as a whole: titles, animations. */
void bat_svg_note_inside(bat_svg_notes *notes, uint32_t element);

#endif
