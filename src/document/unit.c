#include "document/unit.h"

#include <string.h>

static const struct {
    const char *name;
    double millimetres;
} UNITS[] = {[BAT_UNIT_PX] = {"px", BAT_PX_MILLIMETRES},
             [BAT_UNIT_MM] = {"mm", 1},
             [BAT_UNIT_CM] = {"cm", 10},
             [BAT_UNIT_IN] = {"in", 25.4},
             [BAT_UNIT_PT] = {"pt", 25.4 / 72},
             [BAT_UNIT_PC] = {"pc", 25.4 / 6},
             [BAT_UNIT_NONE] = {"", 1}};

double bat_unit_millimetres(bat_unit unit) { return UNITS[unit].millimetres; }

const char *bat_unit_name(bat_unit unit) { return UNITS[unit].name; }

const char *bat_unit_word(bat_unit unit) { return unit == BAT_UNIT_NONE ? "none" : UNITS[unit].name; }

bool bat_unit_of_word(const char *word, bat_unit *out) {
    for (int u = BAT_UNIT_PX; u <= BAT_UNIT_NONE; u++)
        if (!strcmp(word, bat_unit_word((bat_unit)u))) {
            *out = (bat_unit)u;
            return true;
        }
    return false;
}

bat_unit bat_unit_of(const char *length) {
    size_t end = strlen(length);
    while (end > 0 && strchr(" \t\r\n\f", length[end - 1])) end--;
    for (int u = BAT_UNIT_MM; end >= 2 && u <= BAT_UNIT_PC; u++)
        if ((length[end - 2] | 32) == UNITS[u].name[0] && (length[end - 1] | 32) == UNITS[u].name[1])
            return (bat_unit)u;
    return BAT_UNIT_PX;
}

bool bat_unit_is_physical(bat_unit unit) { return unit != BAT_UNIT_PX && unit != BAT_UNIT_NONE; }

bool bat_unit_is_said_by(bat_unit unit, double scale) {
    return bat_unit_is_physical(unit) || (unit == BAT_UNIT_PX && scale != BAT_PX_MILLIMETRES);
}
