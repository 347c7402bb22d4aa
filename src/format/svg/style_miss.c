/* Properties and values that are not understood: which of them browsers paint by. */
#include "format/svg/style.h"

#include "format/svg/svg.h"

#include <string.h>

/* Whether a property may have such a value: a number, or a function. Colours by rgb() and hsl() are known, if they are any. */
static bool may_be_value(const char *value, size_t size) {
    while (size > 0 && *value && strchr(" \t\n\r\f", *value)) value++, size--;
    if (size > 0 && strchr("0123456789.+-", *value)) return true;
    return memchr(value, '(', size) && strncmp(value, "rgb", 3) != 0 && strncmp(value, "hsl", 3) != 0;
}

void bat_svg_style_miss(bat_svg_style *style, const char *name, const char *value, size_t size) {
    static const char *const painting[] = {"transform", "rotate", "scale",    "translate", "animation",
                                           "offset",    "mask-",  "backdrop", "background"};
    const bat_svg_name what = bat_svg_name_of(name);
    bool seen = what == BAT_SVG_ATTRIBUTE || (what < BAT_SVG_IDLE && may_be_value(value, size));
    for (size_t i = 0; i < sizeof painting / sizeof *painting; i++)
        seen = seen || strncmp(name, painting[i], strlen(painting[i])) == 0;
    style->odd |= seen ? BAT_SVG_BIT(BAT_SVG_ODD_VALUE) : BAT_SVG_BIT(BAT_SVG_ODD_UNKNOWN);
}
