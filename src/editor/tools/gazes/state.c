#include "editor/tools/gazes/state.h"
#include "editor/tools/toolbox.h"

bat_gazing *bat_gazing_of(const bat_context *c) {
    return c->toolbox->slots[BAT_TOOL_COUNT + BAT_MODE_GAZES].state;
}
