/* Presets of the style: hairline, pen, marker, filled shape. */
#include "editor/tables/commands.h"
#include "editor/edit/style.h"
#include "editor/session/notice.h"

bat_status bat_command_style(bat_context *c, bat_command_id id) {
    static const struct preset {
        bat_command_id id;
        double width, opacity; /* width 0: filled, without a stroke */
    } presets[] = {{BAT_COMMAND_STYLE_HAIRLINE, 0.5, 1},
                   {BAT_COMMAND_STYLE_PEN, 2, 1},
                   {BAT_COMMAND_STYLE_MARKER, 12, 0.5},
                   {BAT_COMMAND_STYLE_SHAPE, 0, 1}};
    const struct preset *p = presets;
    while (p->id != id && p < presets + sizeof presets / sizeof *presets - 1) p++;
    bool stroked = p->width > 0;
    bat_styling values[] = {{BAT_PROPERTY_STROKED, stroked},
                            {BAT_PROPERTY_FILLED, !stroked},
                            {BAT_PROPERTY_OPACITY, p->opacity},
                            {BAT_PROPERTY_STROKE_CAP, BAT_CAP_ROUND},
                            {BAT_PROPERTY_STROKE_JOIN, BAT_JOIN_ROUND},
                            {BAT_PROPERTY_STROKE_WIDTH, p->width}};
    bat_status status = bat_styling_set(c, stroked ? 6 : 5, values);
    if (status != BAT_OK) bat_notice_failure(c, status);
    return status;
}
