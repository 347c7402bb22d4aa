#include "editor/edit/mirror_record.h"
#include "editor/session/journal_line.h"
#include "format/json/curve.h"
#include <math.h>
#include <string.h>

void bat_mirror_write(const bat_mirror *mirror, bat_text *line) {
    if (!mirror->on) return;
    bat_text_string(line, ",\"mirror\":");
    bat_line_numbers(line, (double[]){mirror->at[0], mirror->at[1], mirror->along[0], mirror->along[1]}, 4,
                     1);
}

bat_status bat_mirror_read(const bat_json *json, uint32_t object, bat_mirror *out, bat_problem *problem) {
    const uint32_t node = bat_json_member(json, object, "mirror");
    double numbers[4];
    *out = (bat_mirror){.on = false};
    if (!node) return BAT_OK;
    bat_status status = bat_vector_from_json(json, node, "mirror", 4, numbers, problem);
    if (status != BAT_OK) return status;
    for (int k = 0; k < 4; k++)
        if (!(fabs(numbers[k]) <= BAT_COORDINATE_MAX))
            return bat_json_complain(json, node, BAT_SYNTAX, "mirror", "four numbers", problem);
    bat_mirror mirror = {.on = true};
    memcpy(mirror.at, numbers, sizeof mirror.at);
    memcpy(mirror.along, numbers + 2, sizeof mirror.along);
    if (!bat_mirror_is_good(&mirror))
        return bat_json_complain(json, node, BAT_ARGUMENT, "mirror", "a place and a direction of length 1",
                                 problem);
    *out = mirror;
    return BAT_OK;
}
