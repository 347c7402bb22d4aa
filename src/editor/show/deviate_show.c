/* Colours by distance, the place of the greatest, and the legend. */
#include "editor/choice/choice.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/deviate.h"
#include "editor/show/inspect.h"
#include "editor/tables/tables.h"
#include "editor/view/stage.h"
#include "editor/view/unit.h"
#include "document/document.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Steps of viridis (van der Walt, Smith, 2015): lightness rises evenly, and they differ for colour-blind people, too. */
static const uint32_t COLOURS[] = {0x440154ff, 0x46327eff, 0x365c8dff, 0x277f8eff,
                                   0x1fa187ff, 0x4ac16dff, 0xa0da39ff, 0xfde725ff};
enum { STEPS = 8, NAME_LONG = 32 /* bytes */ };
static const uint32_t EDGE = 0x777777ff; /* around lines: seen on light and on dark paper */
static const double WIDE = 4, RIM = 6.5, POINT = 3, MARK = 6;                           /* px */
static const double SWATCH = 30, HIGH = 12, LEFT = 64, TOP = 64, LINE = 18, LABEL = 16; /* px: the legend */

static void item(bat_overlay *overlay, uint32_t flags, double width, uint32_t colour, double opacity) {
    bat_overlay_item(overlay, BAT_ROLE_VALUE, flags, bat_path_float(width));
    bat_item *last = overlay->items + overlay->count - 1;
    last->stroke = last->fill = colour;
    last->opacity = bat_path_float(opacity);
}

static int step_of(const bat_deviating *d, const bat_deviation_patch *patch) {
    double sum = 0;
    for (int i = 0; i < patch->corners; i++) sum += d->samples[patch->corner[i]].distance;
    const double share = d->found.greatest > 0 ? sum / (patch->corners * d->found.greatest) : 0;
    return (int)fmin(fmax(floor(share * STEPS), 0), STEPS - 1);
}

/* Those of one step (below 0: of all), lines or areas and points. */
static void show_patches(const bat_context *c, const bat_deviating *d, int step, bool lines,
                         bat_overlay *overlay) {
    for (size_t i = 0; i < d->patch_count; i++) {
        const bat_deviation_patch *patch = d->patches + i;
        double at[12], seen[2];
        if ((patch->corners == 2) != lines || (step >= 0 && step_of(d, patch) != step)) continue;
        for (int k = 0; k < patch->corners && k < 4; k++)
            memcpy(at + 3 * k, d->samples[patch->corner[k]].at, 3 * sizeof *at);
        if (patch->corners > 1)
            bat_path_polygon(&overlay->path, 3, patch->corners, at, !lines);
        else if (bat_stage_look(c->stage, 3, at, seen))
            bat_overlay_square(overlay, seen, POINT * bat_stage_pixel(c->stage));
    }
}

static void write_at(const bat_stage *stage, double x, double y, const char *text, bat_overlay *overlay) {
    double at[2];
    bat_stage_seen(stage, (const double[]){x, y}, at);
    bat_overlay_label(overlay, BAT_ROLE_VALUE, at, 0, 0, text);
}

/* The title, the numbers at the ends and the middle of the scale, and all numbers in words. */
static void show_legend_words(const bat_context *c, const bat_deviating *d, bat_overlay *overlay) {
    const bat_document *document = c->session->document;
    const bat_object *reference = bat_document_at(document, bat_document_find(document, d->reference));
    char text[BAT_DEVIATION_ROOM];
    const double middle = LEFT + 0.5 * STEPS * SWATCH;
    if (reference) {
        const char *name = bat_object_name(reference);
        if (!*name || strlen(name) > NAME_LONG) name = bat_word(c, bat_kind_word(bat_object_type(reference)));
        bat_word_fill(c, BAT_STRING_DEVIATION_FROM, 1, &name, text, sizeof text);
        write_at(c->stage, middle, TOP - LABEL, text, overlay);
    }
    for (int i = 0; i <= 2; i++) {
        bat_unit_about(c, 0.5 * i * d->found.greatest, text);
        write_at(c->stage, LEFT + 0.5 * i * STEPS * SWATCH, TOP + HIGH + LABEL, text, overlay);
    }
    bat_deviating_write(c, text);
    write_at(c->stage, middle, TOP + HIGH + LABEL + LINE, text, overlay);
}

/* The place that is furthest away, a line to the point that is closest to it, and how far that is. */
static void show_greatest(const bat_context *c, const bat_deviating *d, bat_overlay *overlay) {
    const double pixel = bat_stage_pixel(c->stage);
    double line[6], seen[2];
    char text[BAT_UNIT_ROOM];
    memcpy(line, d->found.at, 3 * sizeof *line), memcpy(line + 3, d->found.to, 3 * sizeof *line);
    if (!bat_stage_look(c->stage, 3, d->found.at, seen)) return;
    bat_overlay_item(overlay, BAT_ROLE_COMB, BAT_ITEM_STROKED, 2);
    bat_path_polygon(&overlay->path, 3, 2, line, false);
    bat_overlay_circle(overlay, seen, MARK * pixel);
    bat_unit_about(c, d->found.greatest, text);
    bat_overlay_label(overlay, BAT_ROLE_VALUE, seen, 0, -20, text);
}

void bat_deviating_show(bat_context *c, const bat_deviation_change *change, bat_overlay *overlay) {
    const bat_deviating *d = &c->insight->deviating;
    if (!bat_deviating_follow(c, change)) return;
    for (int step = 0; step < STEPS; step++) {
        item(overlay, BAT_ITEM_FILLED | BAT_ITEM_STROKED, 1, COLOURS[step], 1);
        show_patches(c, d, step, false, overlay);
        const double low[2] = {LEFT + step * SWATCH, TOP};
        bat_overlay_window_box(overlay, c->stage, low, (const double[2]){low[0] + SWATCH, low[1] + HIGH});
    }
    item(overlay, BAT_ITEM_STROKED, RIM, EDGE, 1);
    show_patches(c, d, -1, true, overlay);
    for (int step = 0; step < STEPS; step++) {
        item(overlay, BAT_ITEM_STROKED, WIDE, COLOURS[step], 1);
        show_patches(c, d, step, true, overlay);
    }
    show_greatest(c, d, overlay);
    show_legend_words(c, d, overlay);
}
