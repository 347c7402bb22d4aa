/* The pieces of text that take the place of others. */
#include "format/svg/patch.h"

#include <stdlib.h>

void bat_svg_patch_edit(bat_svg_patch *p, size_t from, size_t at, size_t cut) {
    if (p->edit_count == p->edit_room) {
        const int room = p->edit_room < 64 ? 64 : 2 * p->edit_room;
        bat_svg_edit *grown = realloc(p->edits, (size_t)room * sizeof *grown);
        if (!grown) {
            p->status = BAT_MEMORY;
            return;
        }
        p->edits = grown;
        p->edit_room = room;
    }
    p->edits[p->edit_count] = (bat_svg_edit){at, cut, from, p->made.size, p->edit_count};
    p->edit_count++;
}

void bat_svg_patch_mark(bat_svg_patch *p, bat_id id) {
    p->fresh[p->fresh_count++] = (bat_svg_mark){id, p->made.size};
}
