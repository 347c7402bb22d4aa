/* The markers of what is written into a file that is kept. */
#include "format/svg/write/markers.h"
#include "format/svg/write/patch.h"

#include <string.h>

void bat_svg_patch_markers(bat_svg_patch *p, const bat_object *object, const double pen[6],
                           bat_svg_ids *ids) {
    bat_outline outline = {0};
    uint64_t digest;
    ids->unmarked = strstr(p->plan.text, "marker") != NULL;
    const bat_status status = bat_svg_write_markers(&p->made, object, pen, bat_svg_patch_number(p),
                                                    p->precision, &outline, ids, &digest);
    bat_outline_free(&outline);
    if (status != BAT_OK) p->status = status;
}
