/* Elements that show others: when what they show is edited, they would show the edit too. */
#ifndef BATTEN_FORMAT_SVG_WRITE_REFER_H
#define BATTEN_FORMAT_SVG_WRITE_REFER_H

#include "format/svg/write/plan.h"

/* Marks `use` elements that show something touched as touched, and elements that others refer to as needed. */
bat_status bat_svg_refer(bat_svg_plan *plan);

#endif
