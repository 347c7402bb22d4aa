/* The root of a file that stays: its page and its size, where they were changed, and no more. */
#include "document/scale.h"
#include "document/sheet.h"
#include "format/svg/markup.h"
#include "format/svg/svg.h"
#include "format/svg/write/patch.h"
#include "format/svg/write/retag.h"
#include "text/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROOM = 160, NUMBER = BAT_NUMBER_ROOM + 8 };

/* What the root says; "" where it has no such attribute. */
typedef struct sayings {
    char box[ROOM], width[ROOM], height[ROOM], ratio[ROOM];
    bool styled[2]; /* width and height are said by its style attribute */
} sayings;

static void find(const bat_svg_retag *r, const char *name, char value[ROOM]) {
    bat_svg_piece piece;
    value[0] = '\0';
    if (!bat_svg_retag_has(r, name, &piece) || piece.end - piece.value >= ROOM) return;
    memcpy(value, r->tag + piece.value, piece.end - piece.value);
    value[piece.end - piece.value] = '\0';
}

static const char *or_none(const char *value) { return *value ? value : NULL; }

/* What its style attribute says of a side, in place of the attribute. Returns whether it does. */
static bool find_styled(const bat_svg_retag *r, const char *name, char value[ROOM]) {
    char room[BAT_SVG_SIDE_ROOM];
    bat_svg_piece piece;
    if (!bat_svg_retag_has(r, "style", &piece)) return false;
    const char *said = bat_svg_root_side(r->tag + piece.value, piece.end - piece.value, name, NULL, room);
    if (said) snprintf(value, ROOM, "%s", said);
    return said != NULL;
}

/* Returns whether it has a viewBox. */
static bool read_root(const bat_svg_retag *r, sayings *said, bat_svg_root *root) {
    double box[4] = {0, 0, 0, 0};
    find(r, "viewBox", said->box);
    find(r, "width", said->width);
    find(r, "height", said->height);
    find(r, "preserveAspectRatio", said->ratio);
    said->styled[0] = find_styled(r, "width", said->width);
    said->styled[1] = find_styled(r, "height", said->height);
    const bool boxed = bat_svg_view_box(said->box, box);
    if (!boxed && !(bat_svg_length(said->width, 0, &box[2]) && bat_svg_length(said->height, 0, &box[3])))
        box[2] = box[3] = 0;
    bat_svg_root_read(box, boxed, or_none(said->width), or_none(said->height), or_none(said->ratio), root);
    return boxed;
}

static void set_box(bat_svg_retag *r, const double page[4], const double stretch[2]) {
    const double box[4] = {page[0] / stretch[0], page[1] / stretch[1], page[2] / stretch[0],
                           page[3] / stretch[1]};
    bat_text text = {0};
    bat_svg_write_pair(&text, box);
    bat_text_string(&text, " ");
    bat_svg_write_pair(&text, box + 2);
    bat_text_add(&text, "", 1);
    if (!text.failed) bat_svg_retag_set(r, "viewBox", text.data);
    bat_text_free(&text);
}

/* Where it is said. */
static void set_side(bat_svg_retag *r, const char *name, bool styled, const char *value) {
    if (styled)
        bat_svg_retag_declare(r, name, value, r->style.size > 0 && memchr(r->style.data, '!', r->style.size));
    else
        bat_svg_retag_set(r, name, value);
}

/* A length of the root: as much longer as the page is, in the unit that it had. */
static void scale_length(bat_svg_retag *r, const char *name, bool styled, const char *text, double before,
                         double now) {
    char value[NUMBER], made[ROOM + NUMBER];
    double length;
    const char *unit = *text ? bat_number_scan(text, text + strlen(text), &length) : NULL;
    if (!unit || strchr(unit, '%') || !(before > 0)) return;
    value[bat_number_print(length * now / before, value)] = '\0';
    snprintf(made, sizeof made, "%s%s", value, unit);
    set_side(r, name, styled, made);
}

/* The same in the unit of the document; one that it did not say is added only where another scale needs it. */
static void say_length(bat_svg_retag *r, const char *name, bool styled, const char *text, double length,
                       const bat_document *document) {
    bat_text made = {0};
    if ((!*text || strchr(text, '%')) && !bat_unit_is_said(document)) return;
    bat_svg_write_size(&made, "", length, document);
    if (made.size > 0) made.size--; /* the quotation mark behind it */
    bat_text_add(&made, "", 1);
    if (!made.failed) set_side(r, name, styled, made.data);
    bat_text_free(&made);
}

static void set_size(bat_svg_retag *r, const sayings *said, const bat_svg_plan *plan, bool same_scale) {
    const double *was = bat_source_page(plan->source);
    const bat_sheet now = bat_sheet_of(plan->document);
    if (same_scale) {
        scale_length(r, "width", said->styled[0], said->width, was[2], now.page[2]);
        scale_length(r, "height", said->styled[1], said->height, was[3], now.page[3]);
    } else {
        say_length(r, "width", said->styled[0], said->width, now.page[2], plan->document);
        say_length(r, "height", said->styled[1], said->height, now.page[3], plan->document);
    }
}

void bat_svg_patch_page(bat_svg_patch *p) {
    const bat_svg_plan *plan = &p->plan;
    const bat_svg_tag *tag = &plan->tags.list[1];
    const bat_sheet now = bat_sheet_of(plan->document);
    const size_t from = p->made.size;
    const double *was = bat_source_page(plan->source);
    sayings said;
    bat_svg_root root;
    bat_svg_retag r;
    bat_svg_retag_begin(&r, plan->text + tag->open, tag->body - tag->open, plan->types, plan->types_size,
                        false);
    const bool boxed = read_root(&r, &said, &root);
    const bool same_page = memcmp(now.page, was, sizeof now.page) == 0;
    const bool same_scale = now.unit == root.sheet.unit &&
                            fabs(now.scale - root.sheet.scale) <= 1e-8 * now.scale;
    if (bat_sheet_has_page(&now) && !(same_page && same_scale)) {
        if (!same_page || !boxed) set_box(&r, now.page, root.stretch);
        set_size(&r, &said, plan, same_scale);
        bat_svg_retag_write(&r, &p->made);
        bat_svg_patch_edit(p, from, tag->open, tag->body - tag->open);
    }
    bat_svg_retag_free(&r);
}
