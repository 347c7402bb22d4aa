/* Commands on the selection, the layers and the style, by the names that commands.def gives them. */
#ifndef BATTEN_EDITOR_COMMANDS_ACT_H
#define BATTEN_EDITOR_COMMANDS_ACT_H

#include "editor/session/context.h"
#include <batten/editor.h>

#define ACT(name) bat_status bat_do_##name(bat_context *c, bool down);
ACT(select_all)
ACT(deselect)
ACT(delete)
ACT(duplicate)
ACT(group)
ACT(ungroup)
ACT(order_forward)
ACT(order_backward)
ACT(order_front)
ACT(order_back)
ACT(align_left)
ACT(align_centre)
ACT(align_right)
ACT(align_top)
ACT(align_middle)
ACT(align_bottom)
ACT(distribute_across)
ACT(distribute_down)
ACT(curve_close)
ACT(curve_open)
ACT(curve_join)
ACT(curve_reverse)
ACT(curve_split)
ACT(layer_add)
ACT(layer_delete)
ACT(layer_up)
ACT(layer_down)
ACT(layer_take)
ACT(style_hairline)
ACT(style_pen)
ACT(style_marker)
ACT(style_shape)
ACT(take_apart)
ACT(level_add)
ACT(level_up)
ACT(level_down)
ACT(levels_copy)
ACT(levels_flatten)
#undef ACT

#endif
