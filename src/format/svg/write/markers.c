#include "format/svg/write/markers.h"

#include "base/matrix.h"
#include "base/real.h"
#include "document/digest.h"
#include "format/svg/digest.h"
#include "format/svg/write/see.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Where the parts of all markers of an object are written. */
typedef struct writing {
    bat_text *text;
    const bat_object *object;
    const double *pen;
    int number; /* of the next part */
    double precision;
    bat_outline *outline;
    uint64_t digest; /* of the marker that is being written */
    bool unmarked;   /* as of the element's ids */
} writing;

/* A part, which is taken over, as one path; its box is its clip path. */
static bat_status write_part(writing *w, bat_object *part, const bat_marker_part *from) {
    double pen[6], back[6];
    const bool uneven = bat_svg_pen(part, pen, back);
    bat_svg_ids ids = bat_svg_write_gradients(w->text, part, back, w->number);
    bat_status status = bat_svg_write_clip(w->text, part, back, w->number++, &ids);
    ids.inks[0] = from->fill, ids.inks[1] = from->stroke;
    ids.unmarked = w->unmarked;
    bat_text_string(w->text, "<path");
    if (uneven) {
        bat_text_string(w->text, " transform=\"");
        bat_svg_write_matrix(pen, w->text);
        bat_text_string(w->text, "\"");
    }
    bat_svg_write_style_attribute(w->text, part, bat_object_style(part), &ids);
    bat_text_string(w->text, " d=\"");
    const size_t start = w->text->size;
    if (status == BAT_OK) status = bat_svg_write_curves(w->text, part, uneven ? back : NULL, w->precision);
    if (status == BAT_OK && w->text->failed) status = BAT_MEMORY;
    if (status == BAT_OK) status = bat_svg_see_clip(part, pen, back, w->outline, &w->digest);
    if (status == BAT_OK) status = bat_svg_see_path(w->text, start, part, w->outline, &w->digest);
    w->digest = bat_svg_digest_inks(w->digest, from->fill, from->stroke);
    bat_text_string(w->text, "\"/>");
    bat_object_release(part);
    return status;
}

/* From a marker's own units to those of its element, so that the frame is that of the path: what turns with the curve
 * is as it is along it, the rest as it is on the page. */
static void find_units(const writing *w, const bat_marking *m, double out[6]) {
    const double *f = bat_markers_marked(bat_object_markers(w->object))->frame;
    const double area = f[0] * f[3] - f[1] * f[2], scale = sqrt(fabs(area)),
                 angle = m->angle * (BAT_PI / 180);
    const double size = m->by_width ? 1 / scale : 1, c = bat_cos(angle), s = bat_sin(angle);
    const bool slanted = w->pen[0] != 1 || w->pen[1] != 0 || w->pen[2] != 0 || w->pen[3] != 1;
    double frame[6] = {f[0] * size, f[1] * size, f[2] * size, f[3] * size, 0, 0}, turned[6];
    const double turn[6] = {c, s, -s, c, 0, 0};
    if (slanted || m->turn != BAT_MARKER_FIXED) {
        frame[0] = m->by_width ? 1 : scale, frame[1] = frame[2] = 0;
        frame[3] = slanted || area > 0 ? frame[0] : -frame[0];
    }
    bat_matrix_compose(frame, turn, turned);
    bat_matrix_compose(turned, m->matrix, out);
}

static bat_status write_marker(writing *w, const bat_marking *m, const char *id) {
    static const char *const turns[] = {"0", "auto", "auto-start-reverse"};
    double units[6];
    bat_status status = BAT_OK;
    find_units(w, m, units);
    w->digest = bat_digest_begin();
    bat_text_string(w->text, "<marker id=\"");
    bat_text_string(w->text, id);
    bat_text_string(w->text, "\" orient=\"");
    bat_text_string(w->text, turns[m->turn]);
    if (!m->by_width) bat_text_string(w->text, "\" markerUnits=\"userSpaceOnUse");
    bat_text_string(w->text, "\" style=\"overflow:visible;opacity:1\">");
    for (int i = 0; i < m->count && status == BAT_OK; i++) {
        bat_object *part = NULL, *own = NULL;
        status = bat_marking_part(m, i, units, NULL, &part);
        if (status == BAT_OK) status = bat_object_with_id(part, bat_object_id(w->object), &own);
        bat_object_release(part);
        if (status == BAT_OK) status = write_part(w, own, &m->parts[i]);
    }
    bat_text_string(w->text, "</marker>");
    const bat_marking read = {.turn = m->turn, .by_width = m->by_width, .matrix = {1, 0, 0, 1, 0, 0}};
    w->digest = bat_svg_digest_marking(w->digest, &read);
    return status;
}

bat_status bat_svg_write_markers(bat_text *text, const bat_object *object, const double pen[6], int number,
                                 double precision, bat_outline *outline, bat_svg_ids *ids, uint64_t *digest) {
    const bat_markers *markers = bat_object_markers(object);
    uint64_t digests[BAT_MARKER_PLACES] = {0};
    bat_status status = BAT_OK;
    *digest = 0;
    if (!markers) return BAT_OK;
    const bat_marked *m = bat_markers_marked(markers);
    writing w = {text, object, pen, number + 1, precision, outline, 0, ids->unmarked};
    *digest = bat_digest_number(bat_digest_begin(), (uint64_t)m->order);
    for (int k = 0; k < BAT_MARKER_PLACES && status == BAT_OK; k++) {
        int same = 0;
        while (m->markers[same] != m->markers[k]) same++;
        if (m->markers[k] && same == k) {
            snprintf(ids->markers[k], BAT_SVG_ID, BAT_SVG_PAINT_ID "%lu-marker-%d-%d",
                     (unsigned long)bat_object_id(object), k, number);
            status = write_marker(&w, bat_marker_marking(m->markers[k]), ids->markers[k]);
            digests[k] = w.digest;
        } else if (m->markers[k]) {
            memcpy(ids->markers[k], ids->markers[same], sizeof ids->markers[k]);
            digests[k] = digests[same];
        }
        *digest = bat_digest_number(*digest, digests[k]);
    }
    return status;
}
