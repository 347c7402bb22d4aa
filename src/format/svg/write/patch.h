/* Writing a file again with nothing changed but what was edited: the order of things is the document's, the structure
 * the file's. */
#ifndef BATTEN_FORMAT_SVG_WRITE_PATCH_H
#define BATTEN_FORMAT_SVG_WRITE_PATCH_H

#include "format/svg/markup.h"
#include "format/svg/reader.h"
#include "format/svg/svg.h"
#include "format/svg/write/plan.h"
#include "format/svg/write/retag.h"
#include "text/text.h"

/* An object, and where it is written: its element, or its offset in the new text. */
typedef struct bat_svg_mark {
    bat_id id;
    size_t at;
} bat_svg_mark;

/* A piece of the new text: `cut` bytes of the file at `at` give way to the bytes from..to of `made`. */
typedef struct bat_svg_edit {
    size_t at, cut, from, to;
    int order;
    uint32_t carried; /* behind these bytes: that element as it is now; 0: none */
} bat_svg_edit;

typedef struct bat_svg_patch {
    bat_svg_plan plan;
    bat_text made;
    bat_svg_edit *edits;
    int edit_count, edit_room;
    bat_svg_mark *kept,
        *fresh; /* whose element stays, by its place in the file; written anew, by their place in made */
    int kept_count, fresh_count;
    double precision; /* as of bat_svg_write_within */
    int number;       /* of new gradients; 0: not known yet */
    bat_status status;
} bat_svg_patch;

/* The file as it is now, and where in it the objects are. */
typedef struct bat_svg_output {
    bat_text text;
    bat_svg_mark *marks;
    int count;
} bat_svg_output;

/* ---- edits.c ---- */
/* What has been added to p->made since it had `from` bytes takes the place of `cut` bytes of the file at `at`. */
void bat_svg_patch_edit(bat_svg_patch *p, size_t from, size_t at, size_t cut);
/* The element is written there, with all that is edited in it, and not at its place. */
void bat_svg_patch_carry(bat_svg_patch *p, uint32_t element, size_t at);
/* Where the line break and the spaces before that place begin. */
size_t bat_svg_patch_lead(const bat_svg_patch *p, size_t at);
void bat_svg_patch_mark(bat_svg_patch *p, bat_id id); /* the next thing written into p->made is this object */
/* Cuts what was written for shapes that have other gradients now: nothing in the new text refers to it. Returns how many;
 * O(size + n log n). */
int bat_svg_patch_sweep(bat_svg_patch *p, const bat_text *made);
/* A number with which no id of gradients and clip paths is taken in the file. */
int bat_svg_patch_number(bat_svg_patch *p);
/* Makes the new text of all pieces. out->marks has room for the objects that are kept and those that are fresh, twice. */
void bat_svg_patch_apply(bat_svg_patch *p, bat_svg_output *out);
/* ---- patch_tags.c: elements that stay ---- */
/* Writes the start tag of an object's element as it is now; `apart`: in another place than it was;
 * `hides`: a group without an element hides it; `anonymous`: without its id. False: it is as it
 * was, and nothing is written. */
bool bat_svg_patch_tag(bat_svg_patch *p, const bat_object *object, const bat_sourced *entry, bool apart,
                       bool hides, bool anonymous, const bat_svg_ids *ids);
/* Writes the gradients that the element cannot go on referring to, and gives their ids. */
bat_svg_ids bat_svg_patch_gradients(bat_svg_patch *p, const bat_object *object, const bat_sourced *entry,
                                    bool apart);
/* The same for the element of a group that is gone, where others are left in it. */
bool bat_svg_patch_group_tag(bat_svg_patch *p, uint32_t element);
/* Whether the element can keep its kind with the shape that the object has now; then the plan says so. */
void bat_svg_patch_try_shape(bat_svg_patch *p, const bat_object *object, const bat_sourced *entry);
void bat_svg_patch_page(bat_svg_patch *p);
void bat_svg_patch_end_tag(bat_svg_patch *p, const bat_object *object, const bat_sourced *entry);
/* ---- patch_shape.c: rectangles, circles, ellipses, lines ---- */
/* Sets the attributes of an element that still is what it is called. False: only a path can be that, and nothing is set. */
bool bat_svg_patch_shape(bat_svg_retag *r, const bat_object *object, const bat_sourced *entry,
                         double precision);
/* Sets a length that style says, in its style. */
void bat_svg_retag_pixels(bat_svg_retag *r, const char *property, double number, const bat_sourced *entry);
/* ---- patch_data.c: path data ---- */
/* Writes the path data of an object: subpaths that are as they were in the element keep their text. m: to its own units.
 * *raw: it stands in a tag as it is. */
bat_status bat_svg_patch_data(bat_text *out, const bat_svg_retag *r, const bat_object *object,
                              const bat_sourced *entry, const double m[6], double precision, bool *raw);
/* ---- patch_segments.c: one subpath ---- */
/* The text of a subpath. */
typedef struct bat_svg_subtext {
    const char *data;
    size_t
        from; /* where its text begins; SIZE_MAX: what is before it is not as it was, so that it says where it begins */
    const bat_svg_segment *segments; /* `count` of its cubics */
    const double *points;            /* of these, in the element's units: x y of 3 * count + 1 */
    int count;
    bool closed;
} bat_svg_subtext;
/* Writes the curve that was `before` as a reader had made it: segments that are as they were keep their text, if the segments that
 * they continue do. *done: there are some; else nothing is written. m: to the element's units. */
bat_status bat_svg_patch_segments(bat_text *out, const bat_svg_subtext *was, const bat_curve *before,
                                  const bat_curve *now, const double m[6], double precision, bool *done);
/* ---- patch_clip.c: what of it is seen ---- */
/* Writes the clip path that the element cannot go on referring to, and gives its id. */
void bat_svg_patch_clip(bat_svg_patch *p, const bat_object *object, const bat_sourced *entry,
                        bat_svg_ids *ids);
void bat_svg_patch_set_clip(bat_svg_retag *r, const bat_object *object, const bat_sourced *entry,
                            const bat_svg_ids *ids);
void bat_svg_unclip(bat_svg_retag *r); /* all of it is seen */
bool bat_svg_is_clipped(const bat_document *document);
/* Whether objects of two documents are seen in the same box. */
bool bat_svg_same_clip(const bat_document *one, const bat_object *a, const bat_document *other,
                       const bat_object *b, double slack);
/* ---- patch_markers.c ---- */
/* Writes the markers of what is written in the units that a pen makes of the document's, and gives their ids. */
void bat_svg_patch_markers(bat_svg_patch *p, const bat_object *object, const double pen[6], bat_svg_ids *ids);
/* ---- patch_new.c: what is written anew ---- */
/* Every object that is new or has moved is written behind the one below it. */
void bat_svg_patch_new(bat_svg_patch *p);
/* Writes such an object as what is new, in the place of its element. */
void bat_svg_patch_remake(bat_svg_patch *p, const bat_object *object, const bat_sourced *entry, bool hides);

/* ---- again.c: what is written is read again ---- */
/* As any reader will read it; BAT_UNSUPPORTED: none can. */
bat_status bat_svg_again_read(const bat_text *text, const bat_svg_options *options, bat_svg_again *out);
void bat_svg_again_free(bat_svg_again *again);
/* The number of the element that begins there, or 0. */
uint32_t bat_svg_element_at(const bat_svg_tags *tags, size_t at);
/* ---- beside.c: what SVG cannot hold ---- */
/* Writes the attributes and the content of the element that holds it. again: the text as it is read with merged nodes.
 * BAT_UNSUPPORTED: the document does not come back in this way. */
bat_status bat_svg_held_write(const bat_document *document, const bat_svg_output *out,
                              const bat_svg_again *again, bat_text *text);

/* ---- alike.c: what was read again beside the document ---- */
/* Whether the text that was read again shows what the document holds. *differs: objects are there that look otherwise; their
 * elements insist from now on. BAT_UNSUPPORTED: it does not, and nothing can be done about it. O(objects). */
bat_status bat_svg_patch_compare(bat_svg_plan *plan, const bat_document *again, bool *differs);

/* The file as it is now. BAT_UNSUPPORTED: it cannot be written so. O(size). */
bat_status bat_svg_patch_write(const bat_document *document, bool with_native, double precision,
                               bat_text *out);

#endif
