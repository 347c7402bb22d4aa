/*
 * The walk through the elements of a drawing, and what its source files share. Each drawing function
 * (bat_svg_way) takes the element and the scope inherited at its place, with the element's own style already in
 * it; a failure in w->status stops everything.
 */
#ifndef BATTEN_FORMAT_SVG_WALK_H
#define BATTEN_FORMAT_SVG_WALK_H

#include "document/markers.h"
#include "document/picture.h"
#include "document/source.h"
#include "format/svg/notes.h"
#include "format/svg/outline.h"
#include "format/svg/style.h"
#include "format/svg/tags.h"
#include "format/svg/tree.h"

#include <batten/format.h>

/* Most elements drawn (counted each time that `use` repeats them), and most style rules tried. */
enum { BAT_SVG_DRAWN_MAX = 1 << 20, BAT_SVG_TRIED_MAX = 1 << 25 };

/* What children inherit while drawing. */
typedef struct bat_svg_scope {
    double matrix[6];
    bat_svg_style style;
    double opacity;         /* product of the opacities of the containers */
    struct bat_clip *clip;  /* what of it is seen; NULL: all */
    struct bat_clip *boxed; /* within this, too, in parts of its box; NULL: all */
    uint32_t mask;          /* the element of the mask that it has still to be painted through; 0: none */
    uint64_t clip_digest;   /* of all, as they were read */
    double width, height;   /* of the viewport */
} bat_svg_scope;

/* The stops of a gradient. */
typedef struct bat_svg_stops {
    bat_stop *list; /* follows in the same block */
    int count;
    bool more;     /* than BAT_STOPS_MAX */
    uint32_t mean; /* colour */
} bat_svg_stops;

/* What an element has given to the group of the document that it is. */
typedef enum bat_svg_given {
    BAT_SVG_ITS_OPACITY = 1,
    BAT_SVG_ITS_CLIP = 2,
    BAT_SVG_ITS_MASK = 4
} bat_svg_given;

typedef struct bat_svg_walk bat_svg_walk;

/* What is drawn in a marker. */
typedef struct bat_svg_collected {
    bat_marker_part list[BAT_MARKER_PARTS_MAX]; /* retained */
    int count;
    bool whole; /* nothing was left out */
} bat_svg_collected;

/* What is seen of the shape that an object was made of. */
typedef struct bat_svg_shown {
    bat_id id;
    uint64_t digest;
} bat_svg_shown;

typedef void bat_svg_way(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s);

struct bat_svg_walk {
    const bat_svg_options *options;
    const bat_svg_tree *tree;
    const bat_svg_sheet *sheet;
    bat_document *document;
    bat_svg_report *report;
    bat_svg_notes notes;
    bat_svg_variables variables;     /* custom properties of styles */
    bat_svg_candidates candidates;   /* the rules of the element whose style is sought */
    bat_svg_stops **stops;           /* of gradients, by element; NULL: not known yet */
    struct bat_svg_tile **tiles;     /* of patterns and masks, by element: the last one made of it */
    struct bat_svg_marker **markers; /* by element; NULL: not known yet */
    bat_svg_collected *collected;    /* where shapes go that are drawn in a marker; NULL: into the document */
    bool boxed;                      /* a gradient of the shape being drawn is placed by its box */
    bat_outline outline;
    bat_pictures pictures; /* of the images drawn */
    uint64_t digest;
    uint32_t active[BAT_SVG_DEPTH]; /* elements being drawn, outermost first */
    uint8_t given[BAT_SVG_DEPTH];   /* of each: what the group has that it became (bat_svg_given) */
    int depth;
    long drawn, tried, put;
    bat_id group; /* the group being read; 0: none */
    int members;  /* members read into it so far */
    int groups;   /* nesting depth of that group */
    int unseen;   /* how many of the elements being drawn are not displayed */
    /* The file's text, where foreign content can be taken from it (stand.c). */
    const char *text; /* NULL: it cannot */
    size_t text_size;
    bool scanned;
    bat_svg_tags tags;
    uint32_t *stamps, stamp;       /* of each element: the last content that needed it */
    uint32_t *styles, style_count; /* elements of style sheets */
    double page[4];                /* the outermost viewBox */
    double pixel;                  /* how long one is in the document's units: of strokes that do not scale */
    /* What each element became, when the file is kept (place.c). */
    bool keeps, copied; /* it is; what is drawn now is drawn from another place */
    double *opacities;  /* of elements, their own */
    bat_sourced *places;
    int place_count, place_room;
    int place;            /* index of the place of the element being drawn */
    bat_svg_way *draw;    /* draws an element of any kind in place */
    bat_svg_shown *shown; /* of each shape, by id, where it is noted (held.c) */
    int shown_count, shown_room;
    bool shows;               /* it is */
    const bat_document *like; /* whose curves those made share that are the same; NULL: none */
    int liked;                /* the index of its object that the next one may be */
    bat_status status;        /* a failure stops everything */
};

static inline const char *bat_svg_attribute_of(const bat_svg_walk *w, uint32_t element, const char *name) {
    return bat_svg_tree_attribute(w->tree, element, name);
}

/* ---- walk.c ---- */
double bat_svg_length_of(const bat_svg_walk *w, uint32_t element, const char *name, double whole,
                         double otherwise);
/* What the element refers to; NULL: nothing. */
const char *bat_svg_find_href(const bat_svg_walk *w, uint32_t element);
bat_svg_way bat_svg_draw_children;

/* ---- place.c: where things come from ---- */
/* The element's place; what is drawn until the next call with another element belongs to it. */
void bat_svg_place(bat_svg_walk *w, uint32_t element, const bat_svg_scope *outer, const bat_svg_scope *inner);
void bat_svg_place_object(bat_svg_walk *w, const bat_object *object);

/* ---- walk.c, paint.c: style ---- */
/* outer: the scope around the element. */
void bat_svg_cascade(bat_svg_walk *w, uint32_t element, const bat_svg_scope *outer, bat_svg_style *style);
/* The style of an element at its place in the file, from all its ancestors. */
void bat_svg_cascade_in_place(bat_svg_walk *w, uint32_t element, bat_svg_scope *s);
/* What a shape is painted with; the numbers of its paint. */
typedef struct bat_svg_painted {
    bat_style style;
    bat_paint paint;
    bat_stop stops[2][BAT_STOPS_MAX];
    double dashes[BAT_DASHES_MAX];
    bool solid; /* there are dashes, of no length */
} bat_svg_painted;
/* box: of the shape, in its own units. */
void bat_svg_resolve_style(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, const double box[4],
                           bat_svg_painted *out);

/* ---- held.c ---- */
/* Notes what the shape in w->outline shows, of which the last object was made; marked: digest of its markers. */
void bat_svg_show(bat_svg_walk *w, const bat_svg_scope *s, const bat_svg_painted *painted, uint64_t marked);

/* ---- server.c: gradients ---- */
typedef enum bat_svg_served {
    BAT_SVG_SERVED,  /* as it is */
    BAT_SVG_PLAIN,   /* it is one colour */
    BAT_SVG_MEAN,    /* in its place the mean of its stops */
    BAT_SVG_NOTHING, /* it paints nothing */
} bat_svg_served;
/* stops: room for BAT_STOPS_MAX, to which *out refers; share: opacity; *colour: what stands for it. */
bat_svg_served bat_svg_gradient(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s,
                                const double box[4], double share, bat_stop *stops, bat_gradient *out,
                                uint32_t *colour);
/* Whether its colours are mixed in linear RGB. */
bool bat_svg_mixes_linearly(bat_svg_walk *w, uint32_t gradient);
void bat_svg_stops_free(bat_svg_walk *w);

/* ---- pattern.c ---- */
bool bat_svg_is_pattern(const bat_svg_walk *w, uint32_t element);
/* The same as bat_svg_gradient, for a pattern; BAT_SVG_MEAN: it cannot be painted. */
bat_svg_served bat_svg_pattern(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, const double box[4],
                               double share, bat_stop *stops, bat_gradient *out);
void bat_svg_tiles_free(bat_svg_walk *w);

/* ---- marker.c ---- */
/* Whether shapes of that kind have markers. */
bool bat_svg_takes_markers(const bat_svg_walk *w, uint32_t element);
/* Those of a shape, in the scope at its place; NULL: none. digest: of what is read of them. Uses w->outline. */
bat_markers *bat_svg_markers(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, uint64_t *digest);
/* How far the markers of a shape may reach beyond its vertices, in the document's units; 0: it has none. */
double bat_svg_marker_reach(const bat_svg_walk *w, uint32_t element, const bat_svg_scope *s);
void bat_svg_markers_free(bat_svg_walk *w);

/* ---- walk.c: what is drawn in a marker ---- */
/* Takes over an object that is drawn in a marker; s: the scope of a shape, else NULL. */
void bat_svg_collect(bat_svg_walk *w, const bat_svg_scope *s, bat_object *object);

/* ---- clip.c: what is seen ---- */
/* Sets what of an element is seen, in the scope at its place, from its style and the scope around it; ended by bat_svg_clip_end. */
void bat_svg_clip_begin(bat_svg_walk *w, uint32_t element, const bat_svg_scope *outer, bat_svg_scope *s);
void bat_svg_clip_end(bat_svg_scope *s);
/* Gives that to the object of the element, whose box is that in its own units. */
bat_status bat_svg_clip_object(const bat_svg_scope *s, const double box[4], bat_object **object);
/* The same for the group of that index, once it holds all that it does; with a mask that is placed by its box. */
void bat_svg_clip_group(bat_svg_walk *w, uint32_t element, bat_svg_scope *s, int index);

/* ---- mask.c ---- */
/* Sets the mask of an element in the scope at its place. */
void bat_svg_mask_begin(bat_svg_walk *w, uint32_t element, bat_svg_scope *s);
/* Whether that, of a scope with a mask, depends on the element's box. */
bool bat_svg_mask_is_boxed(const bat_svg_walk *w, const bat_svg_scope *s);
/* Adds it to the clip of the scope; box: of the element in its own units, of use only if it depends on it. What cannot be painted
 * is noted. */
void bat_svg_mask_paint(bat_svg_walk *w, uint32_t element, const double box[4], bat_svg_scope *s);

/* ---- notes.c: what is lost ---- */
/* Losses from an element apart from its style; from its style, apart from what is inherited; from a shape's
 * style, as far as it is visible. */
void bat_svg_note_element(bat_svg_walk *w, uint32_t element);
void bat_svg_note_own_style(bat_svg_walk *w, uint32_t element, const bat_svg_style *style);
void bat_svg_note_style(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s,
                        const bat_svg_painted *painted);

/* ---- walk.c: pictures ---- */
/* The picture in the element's data URI, as one of those drawn; NULL when there is none, or it must be left out. The caller
 * releases it. */
bat_picture *bat_svg_find_picture(bat_svg_walk *w, uint32_t element);

/* ---- walk.c: into the document ---- */
const char *bat_svg_find_name(const bat_svg_walk *w, uint32_t element);
/* Puts the object into the group being read, hidden and locked as the element says. Takes the object over. */
void bat_svg_put_object(bat_svg_walk *w, uint32_t element, bool shown, bat_object *object);

/* ---- place.c, draw_foreign.c: what is not edited ---- */
/* Where the elements stand in the text. *out: whether they are those that the parser reported: a name declared in the
 * document type may stand for elements, and then they are not. */
bat_status bat_svg_match(const char *text, size_t size, const bat_svg_tree *tree, bat_svg_tags *tags,
                         bool *out);
/* Whether foreign content can be taken from the file. */
bool bat_svg_may_stand_alone(bat_svg_walk *w);
void bat_svg_stand_free(bat_svg_walk *w);
/* draw_lettering.c: a text as this program writes it becomes one again. False: it is another. */
bool bat_svg_draw_lettering(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s);
/* Whether a text has no characters. */
bool bat_svg_is_blank(const bat_svg_walk *w, uint32_t element);
/* False: it is not shown. */
bool bat_svg_draw_text(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s);
bool bat_svg_draw_other_image(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s);
/* The state of the walk before an element that can only be shown whole is drawn as usual. The call puts foreign content in the
 * place of all that has been drawn since; false: it leaves it. */
typedef struct bat_svg_before {
    int objects, members, paths, curves, hidden;
    long put;
    uint64_t digest;
    bat_losses lost;
} bat_svg_before;
bool bat_svg_effect_end(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s,
                        const bat_svg_before *before);

void bat_svg_box_through(const double m[6], const double own[4], double box[4]);
/* What an object covers with its stroke, without its markers. False: it is not drawn. */
bool bat_svg_covers(const bat_object *object, double box[4]);
/* By their boxes: whether objects from an index on, unless one group holds them all, may lie over each other; over one before. */
bool bat_svg_overlap(const bat_svg_walk *w, int from);
bool bat_svg_lies_over(const bat_svg_walk *w, int from);

/* ---- draw*.c: each kind ---- */
bat_svg_way bat_svg_draw_group, bat_svg_draw_switch, bat_svg_draw_nested, bat_svg_draw_use,
    bat_svg_draw_shape, bat_svg_draw_image;
/* Draws everything, and sets the page. */
void bat_svg_draw_root(bat_svg_walk *w);

#endif
