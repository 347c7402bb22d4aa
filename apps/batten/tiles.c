#include "tiles.h"

#include "paint_bytes.h"

#include "document/unit.h"

#include <batten/bezier.h>

#include <cairo-pdf.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const double POINT = 25.4 / 72; /* mm */

bool tiles_sheet(const char *text, double sheet[2]) {
    static const struct {
        const char *name;
        double sides[2];
    } named[] = {{"A0", {841, 1189}},        {"A1", {594, 841}},        {"A2", {420, 594}},
                 {"A3", {297, 420}},         {"A4", {210, 297}},        {"A5", {148, 210}},
                 {"letter", {215.9, 279.4}}, {"legal", {215.9, 355.6}}, {"tabloid", {279.4, 431.8}}};
    for (size_t i = 0; i < sizeof named / sizeof *named; i++) {
        if (strcasecmp(text, named[i].name) != 0) continue;
        memcpy(sheet, named[i].sides, sizeof named[i].sides);
        return true;
    }
    char *end;
    const double wide = strtod(text, &end);
    if (end == text || (*end != 'x' && *end != 'X')) return false;
    const char *second = end + 1;
    const double high = strtod(second, &end);
    const bat_unit unit = bat_unit_of(end);
    if (end == second || !bat_unit_is_physical(unit) || strcmp(end, bat_unit_name(unit)) != 0) return false;
    sheet[0] = wide * bat_unit_millimetres(unit);
    sheet[1] = high * bat_unit_millimetres(unit);
    const double most = 14400 * POINT; /* PDF 1.7, annex C */
    return sheet[0] >= POINT && sheet[1] >= POINT && sheet[0] <= most && sheet[1] <= most;
}

static double white(const double sheet[2]) { return fmin(10, fmin(sheet[0], sheet[1]) / 10); }

void tiles_room(const double sheet[2], double room[2]) {
    for (int d = 0; d < 2; d++) room[d] = sheet[d] - 2 * white(sheet);
}

void tiles_plan(const double size[2], const double sheet[2], double overlap, tiles_layout *out) {
    double room[2];
    tiles_room(sheet, room);
    for (int d = 0; d < 2; d++) {
        const double same = 1e-9 * sheet[d]; /* rounding makes no page */
        const bool whole = size[d] <= sheet[d] + same;
        out->sheet[d] = sheet[d];
        out->shown[d] = whole ? size[d] : room[d];
        out->step[d] = whole ? size[d] : room[d] - overlap;
        out->margin[d] = (sheet[d] - out->shown[d]) / 2;
        out->count[d] = whole ? 1 : ceil((size[d] - room[d] - same) / out->step[d]) + 1;
    }
}

typedef struct sheets {
    const bat_document *document;
    const double *view;
    const tiles_layout *layout;
    double unit; /* mm of one of the document's */
    cairo_t *cairo;
} sheets;

static void line(cairo_t *cairo, double x, double y, double dx, double dy) {
    cairo_move_to(cairo, x, y);
    cairo_rel_line_to(cairo, dx, dy);
}

/* In the white around: where what is shown ends, longer, and where that of the neighbours does. */
static void put_marks(const sheets *s, const int at[2]) {
    const tiles_layout *l = s->layout;
    for (int d = 0; d < 2; d++) { /* marks at places of x, then of y */
        const double from = l->margin[d], to = from + l->shown[d], room = l->margin[1 - d];
        const double places[4] = {from, to, at[d] > 0 ? from + l->shown[d] - l->step[d] : from,
                                  at[d] + 1 < l->count[d] ? from + l->step[d] : to};
        for (int k = 0; k < 8; k++) {
            const double size = room * (k % 4 < 2 ? 0.6 : 0.3), start = room * 0.8 - size;
            const double along = k < 4 ? start : l->sheet[1 - d] - start - size;
            if (d == 0)
                line(s->cairo, places[k % 4], along, 0, size);
            else
                line(s->cairo, along, places[k % 4], size, 0);
        }
    }
    cairo_set_source_rgb(s->cairo, 0, 0, 0);
    cairo_set_line_width(s->cairo, 0.2);
    cairo_stroke(s->cairo);
}

static void put_words(cairo_t *cairo, double x, double y, const char *words) {
    cairo_set_source_rgb(cairo, 0, 0, 0);
    cairo_move_to(cairo, x, y);
    cairo_show_text(cairo, words);
    cairo_new_path(cairo);
}

static void put_number(const sheets *s, const int at[2]) {
    char words[96];
    const tiles_layout *l = s->layout;
    const double size = white(l->sheet) * 0.35;
    snprintf(words, sizeof words, "row %d, column %d of %.0f x %.0f", at[1] + 1, at[0] + 1, l->count[1],
             l->count[0]);
    cairo_set_font_size(s->cairo, size);
    put_words(s->cairo, white(l->sheet) * 1.5, l->sheet[1] - size, words);
}

/* How many objects the box, in mm of the first sheet, may lie over. */
static int covered(const sheets *s, const double low[2], double side) {
    int count = 0;
    for (int i = 0; i < bat_document_count(s->document); i++) {
        double box[4];
        bool over = true;
        bat_object_bounds(bat_document_at(s->document, i), box);
        for (int d = 0; d < 2; d++) {
            const double start = s->layout->margin[d] - s->view[d] * s->unit;
            over = over && box[d] * s->unit + start <= low[d] + side &&
                   box[d + 2] * s->unit + start >= low[d];
        }
        count += over;
    }
    return count;
}

/* In the corner of the first sheet where it lies over the fewest objects. */
static void put_square(const sheets *s) {
    static const double sides[] = {50, 20, 10};
    const double *sheet = s->layout->sheet, gap = white(sheet) * 1.5;
    for (int i = 0; i < 3; i++) {
        const double side = sides[i];
        double best[2] = {0};
        int least = -1;
        if (side + 2 * gap > fmin(sheet[0], sheet[1])) continue;
        for (int corner = 0; corner < 4; corner++) {
            const double low[2] = {corner & 1 ? sheet[0] - gap - side : gap,
                                   corner & 2 ? sheet[1] - gap - side : gap};
            const int count = covered(s, low, side);
            if (least >= 0 && count >= least) continue;
            least = count;
            memcpy(best, low, sizeof best);
        }
        char words[32];
        snprintf(words, sizeof words, "%g mm", side);
        cairo_rectangle(s->cairo, best[0], best[1], side, side);
        cairo_set_source_rgb(s->cairo, 0, 0, 0);
        cairo_set_line_width(s->cairo, 0.2);
        cairo_stroke(s->cairo);
        cairo_set_font_size(s->cairo, side / 10);
        put_words(s->cairo, best[0] + side / 20, best[1] + side * 0.95, words);
        return;
    }
}

static bat_status put_sheet(const sheets *s, const int at[2], uint32_t background, paint_left *left) {
    const tiles_layout *l = s->layout;
    paint_area area = {.width = l->shown[0] / POINT, .height = l->shown[1] / POINT};
    for (int d = 0; d < 2; d++) {
        area.view[d] = s->view[d] + at[d] * l->step[d] / s->unit;
        area.view[2 + d] = l->shown[d] / s->unit;
    }
    cairo_save(s->cairo);
    cairo_translate(s->cairo, l->margin[0] / POINT, l->margin[1] / POINT);
    cairo_rectangle(s->cairo, 0, 0, area.width, area.height);
    cairo_clip(s->cairo);
    const bat_status status = paint_area_onto(s->cairo, s->document, &area, background, left);
    cairo_restore(s->cairo);
    cairo_save(s->cairo);
    cairo_scale(s->cairo, 1 / POINT, 1 / POINT);
    put_marks(s, at);
    put_number(s, at);
    if (at[0] == 0 && at[1] == 0) put_square(s);
    cairo_restore(s->cairo);
    cairo_show_page(s->cairo);
    return status;
}

const char *tiles_paint(const bat_document *document, const double view[4], const tiles_layout *layout,
                        uint32_t background, unsigned char **data, size_t *size, paint_left *left) {
    byte_list bytes = {0};
    cairo_surface_t *surface = page_create(PICTURE_PDF, &bytes, layout->sheet[0] / POINT,
                                           layout->sheet[1] / POINT);
    const sheets s = {document, view, layout, bat_document_scale(document), cairo_create(surface)};
    bat_status status = BAT_OK;
    for (int row = 0; row < layout->count[1] && status == BAT_OK; row++)
        for (int column = 0; column < layout->count[0] && status == BAT_OK; column++) {
            paint_left here = {0};
            status = put_sheet(&s, (int[2]){column, row}, background, &here);
            *left = here; /* the same on each */
        }
    const cairo_status_t painted = cairo_status(s.cairo);
    cairo_destroy(s.cairo);
    return page_end(surface, status, painted, &bytes, data, size);
}
