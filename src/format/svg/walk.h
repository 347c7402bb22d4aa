/*
 * The walk through the elements of a drawing, and what its files have from each other. Each way of drawing takes the
 * element, and the scope that its place hands down with its own style in it; w->status stops everything.
 */
#ifndef BATTEN_FORMAT_SVG_WALK_H
#define BATTEN_FORMAT_SVG_WALK_H

#include "document/picture.h"
#include "format/svg/notes.h"
#include "format/svg/outline.h"
#include "format/svg/style.h"
#include "format/svg/tree.h"

#include <batten/format.h>

/* Elements drawn (each time that `use` repeats them), and style rules tried, at most. */
enum { BAT_SVG_DRAWN_MAX = 1 << 20, BAT_SVG_TRIED_MAX = 1 << 28 };

/* What is handed down while drawing. */
typedef struct bat_svg_scope {
    double matrix[6];
    bat_svg_style style;
    double opacity;       /* product of the containers' */
    double width, height; /* of the viewport */
} bat_svg_scope;

typedef struct bat_svg_walk bat_svg_walk;
typedef void bat_svg_way(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s);

struct bat_svg_walk {
    const bat_svg_options *options;
    const bat_svg_tree *tree;
    const bat_svg_sheet *sheet;
    bat_document *document;
    bat_svg_report *report;
    bat_svg_notes notes;
    uint32_t *means; /* of the gradients that paint, by element, the last bit turned; 0: not known yet */
    bat_outline outline;
    bat_pictures pictures; /* of the images drawn */
    uint64_t digest;
    uint32_t active[BAT_SVG_DEPTH]; /* elements being drawn, outermost first */
    int depth;
    long drawn, tried, put;
    bat_id group;      /* the group being read, 0: none */
    int members;       /* read into it so far */
    int groups;        /* how deep that is */
    int unseen;        /* how many of the elements being drawn are not displayed */
    bat_svg_way *draw; /* an element of any kind, where it stands */
    bat_status status; /* stops everything */
};

static inline const char *bat_svg_attribute_of(const bat_svg_walk *w, uint32_t element, const char *name) {
    return bat_svg_tree_attribute(w->tree, element, name);
}

/* ---- walk.c ---- */
double bat_svg_length_of(const bat_svg_walk *w, uint32_t element, const char *name, double whole,
                         double otherwise);
/* What it points to; NULL: nothing. */
const char *bat_svg_find_href(const bat_svg_walk *w, uint32_t element);
bat_svg_way bat_svg_draw_children;

/* ---- cascade.c, paint.c: style ---- */
/* outer: what the element stands in. */
void bat_svg_cascade(bat_svg_walk *w, uint32_t element, const bat_svg_scope *outer, bat_svg_style *style);
/* The style of an element where it stands, by all that it is in. */
void bat_svg_cascade_in_place(bat_svg_walk *w, uint32_t element, bat_svg_scope *s);
bat_style bat_svg_resolve_style(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s);

/* ---- note_drawn.c: what is lost ---- */
/* Of an element apart from its style; of its style, apart from what is handed down; of a shape's style as it shows. */
void bat_svg_note_element(bat_svg_walk *w, uint32_t element);
void bat_svg_note_own_style(bat_svg_walk *w, uint32_t element, const bat_svg_style *style);
void bat_svg_note_style(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, const bat_style *style);

/* ---- put.c: into the document ---- */
const char *bat_svg_find_name(const bat_svg_walk *w, uint32_t element);
/* Into the group being read, hidden and locked as the element says. Takes the object over. */
void bat_svg_put_object(bat_svg_walk *w, uint32_t element, bool shown, bat_object *object);

/* ---- draw*.c: each kind ---- */
bat_svg_way bat_svg_draw_group, bat_svg_draw_switch, bat_svg_draw_nested, bat_svg_draw_use,
    bat_svg_draw_shape, bat_svg_draw_image;
/* All of it, and the page. */
void bat_svg_draw_root(bat_svg_walk *w);

#endif
