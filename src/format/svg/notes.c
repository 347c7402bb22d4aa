#include "format/svg/notes.h"

#include "format/json/losses.h"
#include "format/svg/svg.h"
#include "format/svg/walk.h"

#include <stdlib.h>
#include <string.h>

/* Kinds from BAT_LOSS_RULE on concern the whole file and need no bit per element, which leaves room for these
 * two. */
#define REFERRED (1u << 31)
#define DRAWN (1u << 30)
_Static_assert(BAT_LOSS_RULE <= 30, "a bit a kind");

static void refer(bat_svg_notes *notes, uint32_t element) {
    if (element) notes->seen[element] |= REFERRED;
}

/* Marks the elements to which the url()s in a text refer. */
static void refer_all(bat_svg_notes *notes, const char *text) {
    while ((text = strstr(text, "url("))) {
        text += 4;
        refer(notes, bat_svg_tree_refer(notes->tree, text));
    }
}

/* Path data (d) contain no references and make up most of a file: names of one letter are skipped. */
static void refer_attributes(bat_svg_notes *notes) {
    const bat_svg_tree *tree = notes->tree;
    for (uint32_t i = 0; i < tree->attribute_count; i += 2) {
        const char *name = tree->strings.data + tree->attributes[i],
                   *value = tree->strings.data + tree->attributes[i + 1];
        size_t size = strlen(name);
        if (size >= 4 && strcmp(name + size - 4, "href") == 0)
            refer(notes, bat_svg_tree_refer(tree, value));
        else if (size > 1)
            refer_all(notes, value);
    }
}

bat_status bat_svg_notes_begin(bat_svg_notes *notes, const bat_svg_tree *tree, const bat_svg_sheet *sheet,
                               const int *hidden, bat_losses *lost) {
    *notes = (bat_svg_notes){
        .tree = tree, .lost = lost, .hidden = hidden, .seen = calloc(tree->count + 1, sizeof *notes->seen)};
    if (!notes->seen) return BAT_MEMORY;
    refer_attributes(notes);
    if (sheet->text) refer_all(notes, sheet->text);
    lost->count[BAT_LOSS_RULE] = sheet->blocks;
    return BAT_OK;
}

void bat_svg_notes_free(bat_svg_notes *notes) { free(notes->seen); }

void bat_svg_note(bat_svg_notes *notes, uint32_t element, bat_loss kind) {
    if (*notes->hidden > 0 && bat_loss_is_seen(kind)) kind = BAT_LOSS_INVISIBLE;
    if (kind >= BAT_LOSS_RULE || notes->seen[element] & 1u << kind) return;
    notes->seen[element] |= 1u << kind;
    if (kind == BAT_LOSS_ANIMATION)
        notes->seen[notes->tree->elements[element].parent] |= 1u << kind; /* it moves */
    notes->lost->count[kind]++;
}

void bat_svg_note_odd(bat_svg_notes *notes, uint32_t element, uint32_t odd, uint32_t mask) {
    odd &= mask;
    for (int bit = 0; odd; bit++, odd >>= 1)
        if (odd & 1) bat_svg_note(notes, element, bat_svg_odd_loss(bit));
}

uint32_t bat_svg_noted(const bat_svg_notes *notes, uint32_t element) {
    /* These are no objects, or foreign content, which is shown as it is. */
    const uint32_t apart = 1u << BAT_LOSS_TEXT | 1u << BAT_LOSS_IMAGE | 1u << BAT_LOSS_EMBEDDED;
    uint32_t mask = 0;
    for (int kind = 0; kind < BAT_LOSS_RULE; kind++)
        mask |= (uint32_t)bat_loss_is_seen((bat_loss)kind) << kind;
    return notes->seen[element] & mask & ~apart;
}

bool bat_svg_note_once(bat_svg_notes *notes, uint32_t element) {
    bool first = !(notes->seen[element] & DRAWN);
    notes->seen[element] |= DRAWN;
    return first;
}

/* Whether the element, or one within it, is referred to. Descendants follow their element directly, and none
 * has a parent before it. */
static bool is_referred(const bat_svg_notes *notes, uint32_t element) {
    const bat_svg_tree *tree = notes->tree;
    for (uint32_t i = element; i < tree->count && (i == element || tree->elements[i].parent >= element); i++)
        if (notes->seen[i] & REFERRED) return true;
    return false;
}

/* Whether the metadata holds anything but Batten's own document. */
static bool is_foreign(const bat_svg_tree *tree, uint32_t metadata) {
    for (uint32_t at = tree->elements[metadata].first; at; at = tree->elements[at].next)
        if (tree->elements[at].kind != BAT_SVG_NATIVE) return true;
    return false;
}

void bat_svg_note_undrawn(bat_svg_notes *notes, uint32_t element) {
    const bat_svg_element *e = &notes->tree->elements[element];
    bat_loss loss = (bat_loss)e->loss;
    if (!bat_svg_note_once(notes, element)) return;
    if (e->kind == BAT_SVG_DEFS) {
        for (uint32_t at = e->first; at; at = notes->tree->elements[at].next) {
            bat_svg_kind kind = (bat_svg_kind)notes->tree->elements[at].kind;
            bool drawn = kind > BAT_SVG_UNKNOWN && kind < BAT_SVG_NEVER;
            if (!drawn)
                bat_svg_note_undrawn(notes, at);
            else if (!is_referred(notes, at))
                bat_svg_note(notes, at, BAT_LOSS_UNUSED);
        }
        return;
    }
    if (loss == BAT_LOSS_UNUSED && is_referred(notes, element)) return;
    if (loss == BAT_LOSS_METADATA && !is_foreign(notes->tree, element)) return;
    bat_svg_note(notes, element, loss);
}

void bat_svg_note_inside(bat_svg_notes *notes, uint32_t element) {
    for (uint32_t at = notes->tree->elements[element].first; at; at = notes->tree->elements[at].next)
        bat_svg_note_undrawn(notes, at);
}

/* ---- of what is drawn ---- */

/* Notes what is lost from an element, apart from its style. */
void bat_svg_note_element(bat_svg_walk *w, uint32_t element) {
    const bat_svg_element *e = &w->tree->elements[element];
    const uint32_t *pair = w->tree->attributes + e->attributes;
    const char *strings = w->tree->strings.data, *name = bat_svg_tree_name(w->tree, element);
    if (!bat_svg_note_once(&w->notes, element)) return;
    const bool whole = e->kind == BAT_SVG_TEXT ||
                       e->kind == BAT_SVG_OTHER; /* noted where they are not shown */
    if (whole) return;
    bat_svg_note(&w->notes, element, (bat_loss)e->loss);
    for (uint32_t i = 0; i < e->attribute_count; i++, pair += 2) {
        bat_svg_name what = bat_svg_name_of(strings + pair[0]);
        if (what > BAT_SVG_IDLE)
            bat_svg_note(&w->notes, element, bat_svg_attribute_loss(what, strings + pair[0]));
        if (strcmp(name, "a") == 0 && strstr(strings + pair[0], "href"))
            bat_svg_note(&w->notes, element, BAT_LOSS_LINK);
    }
    if (e->kind != BAT_SVG_ROOT && e->kind != BAT_SVG_GROUP && e->kind != BAT_SVG_SWITCH)
        bat_svg_note_inside(&w->notes, element);
}

/* Notes what is lost from a style at this element, of the properties that are not inherited. */
void bat_svg_note_own_style(bat_svg_walk *w, uint32_t element, const bat_svg_style *style) {
    const uint32_t later = BAT_SVG_BIT(BAT_SVG_EFFECT) | BAT_SVG_BIT(BAT_SVG_BLEND);
    bat_svg_note_odd(&w->notes, element, style->odd, ~(BAT_SVG_INHERITED | later));
}

/* Notes what is lost from a shape's style, as far as it would be visible. */
void bat_svg_note_style(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s,
                        const bat_svg_painted *painted) {
    const bat_style *style = &painted->style;
    const uint32_t idle = BAT_SVG_BIT(BAT_SVG_IMAGE_HINT) | BAT_SVG_BIT(BAT_SVG_COLOUR_HINT) |
                          BAT_SVG_BIT(BAT_SVG_INTERPOLATION); /* of images, of nothing, of gradients */
    uint32_t odd = s->style.odd, mask = BAT_SVG_INHERITED & ~idle;
    if (style->stroked) mask |= BAT_SVG_BIT(BAT_SVG_EFFECT);
    if (!style->stroked || painted->paint.dash_count || painted->solid) mask &= ~BAT_SVG_BIT(BAT_SVG_DASHES);
    bat_svg_note_odd(&w->notes, element, odd, mask);
}
