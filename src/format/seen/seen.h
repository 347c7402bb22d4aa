/* The picture of a document in space: lines as Bezier curves, split where they become hidden. */
#ifndef BATTEN_FORMAT_SEEN_H
#define BATTEN_FORMAT_SEEN_H

#include <batten/document.h>
#include <batten/sight.h>

/* Calls `visit` for each object that pictures show, until it does not return BAT_OK. */
bat_status bat_seen_each(const bat_document *document,
                         bat_status (*visit)(const bat_object *object, void *user), void *user);
/* How much of an object is seen through: its own opacity and those of the groups that it is in. O(depth log objects). */
double bat_seen_opacity(const bat_document *document, const bat_object *object);
/* Whether all of the object lies in the page, z = 0; whether anything that is shown does not. */
bool bat_seen_in_page(const bat_object *object);
bool bat_seen_in_space(const bat_document *document);
/* The saved view: the last one in the list that is not hidden; NULL: there is none. */
const bat_viewpoint *bat_seen_view(const bat_document *document);
/* The view that an SVG file shows: the saved view, when anything lies in space. */
const bat_viewpoint *bat_seen_shown(const bat_document *document);

/* What is drawn, and how: styles[i] is that of curve i. Borrowed from the document. */
typedef struct bat_seen_content {
    const bat_surface **surfaces;
    const bat_curve **curves;
    const bat_style **styles;
    double *opacities; /* of curve i, with that of the groups around it */
    const bat_document *document;
    bat_line_scene scene;
    const bat_viewpoint *view;
    bat_line_drawing *lines; /* owned */
} bat_seen_content;

/* Statuses as bat_line_drawing_create; *out is to be cleared, too, when it fails. */
bat_status bat_seen_draw(const bat_document *document, const bat_viewpoint *view, bat_seen_content *out);
void bat_seen_clear(bat_seen_content *content);

/* How a line is drawn: 0xRRGGBBAA; pixels. */
typedef struct bat_seen_pen {
    uint32_t colour;
    double width;
} bat_seen_pen;
#define BAT_SEEN_DASH 4
#define BAT_SEEN_GAP 3

bat_seen_pen bat_seen_pen_of(const bat_seen_content *content, const bat_seen_line *line);

#endif
