#include "editor/session/record.h"
#include "editor/session/context.h"
#include "editor/session/history.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/tables.h"
#include "text/json.h"
#include "text/text.h"
#include "format/native/native.h"
#include <math.h>
#include <string.h>

void bat_change_write(const bat_delta *deltas, int count, bat_string label, bat_text *line) {
    bat_text_string(line, "{\"do\":\"change\",\"label\":");
    bat_text_json_string(line, bat_string_key(label));
    bat_text_string(line, ",\"changes\":[");
    size_t from = line->size;
    for (int i = 0; i < count; i++) {
        bat_text_string(line, i ? ",{\"at\":" : "{\"at\":");
        bat_text_integer(line, (uint64_t)deltas[i].index);
        if (deltas[i].after) {
            bat_text_string(line, deltas[i].before ? ",\"replace\":" : ",\"insert\":");
            bat_object_to_json(deltas[i].after, line);
        } else {
            bat_text_string(line, ",\"remove\":");
            bat_text_integer(line, bat_object_id(deltas[i].before));
        }
        bat_text_string(line, "}");
    }
    bat_text_string(line, "]");
    /* A journal entry must be one line; outside strings a line break can be replaced by a space. */
    if (line->failed) return;
    for (size_t i = from; i < line->size; i++)
        if (line->data[i] == '\n') line->data[i] = ' ';
}
