/* The halo in the accent around a line that is, or would be, drawn. */
#include "editor/tools/sketch/parts.h"
#include "editor/view/stage.h"
#include <math.h>

static const float HALO = 3, FAINT = 0.4F; /* px beside the line on either side, at most; its opacity */
static const float LEAST = 2;              /* px: of what is no line */

float bat_sketching_width(const bat_context *c, const bat_style *style, const bat_width_profile *profile) {
    double most = profile->count ? 0 : 1;
    for (size_t i = 0; i < profile->count; i++) most = fmax(most, profile->stops[i].share);
    return style->stroked ? (float)fmin(style->width * most * bat_stage_scale(c->stage), BAT_PIXELS_MAX) : 0;
}

void bat_sketching_halo(bat_overlay *overlay, bat_role role, float width) {
    bat_overlay_item(overlay, role, BAT_ITEM_STROKED, width > 0 ? fminf(2 * width, width + 2 * HALO) : LEAST);
    overlay->items[overlay->count - 1].opacity = FAINT;
}
