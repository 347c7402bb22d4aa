#include "text/text.h"

#include "text/utf8.h"
#include "text/number.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool make_room(bat_text *text, size_t more) {
    if (text->failed) return false;
    if (more < text->room - text->size) return true; /* one byte is left for the final zero */
    size_t room = text->room < 256 ? 256 : text->room + text->room / 2;
    if (room - text->size <= more) room = text->size + more + 1;
    char *data = room > more ? realloc(text->data, room) : NULL;
    if (!data) {
        text->failed = true;
        return false;
    }
    text->data = data;
    text->room = room;
    return true;
}

void bat_text_add(bat_text *text, const char *bytes, size_t size) {
    if (size == 0 || !make_room(text, size)) return;
    memcpy(text->data + text->size, bytes, size);
    text->size += size;
}

void bat_text_string(bat_text *text, const char *string) { bat_text_add(text, string, strlen(string)); }

void bat_text_number(bat_text *text, double number) {
    char out[BAT_NUMBER_ROOM];
    bat_text_add(text, out, (size_t)bat_number_print(number, out));
}

void bat_text_numbers(bat_text *text, const char *before, const double *numbers, int count) {
    bat_text_string(text, before);
    for (int i = 0; i < count; i++) {
        bat_text_string(text, i > 0 ? "," : "[");
        bat_text_number(text, numbers[i]);
    }
    bat_text_string(text, "]");
}

void bat_text_integer(bat_text *text, uint64_t number) {
    char digits[20];
    size_t at = sizeof digits;
    do digits[--at] = (char)('0' + number % 10);
    while (number /= 10);
    bat_text_add(text, digits + at, sizeof digits - at);
}

void bat_text_json_string(bat_text *text, const char *string) {
    bat_text_add(text, "\"", 1);
    size_t size = strlen(string);
    for (size_t i = 0; i < size;) {
        uint32_t code;
        int length = bat_utf8_decode(string + i, size - i, &code);
        if (length == 0) length = 1, code = 0xfffd;
        if (code == '"' || code == '\\') {
            char pair[2] = {'\\', (char)code};
            bat_text_add(text, pair, 2);
        } else if (code < 0x20 || code >= 0xfffd) {
            /* No character above U+FFFF needs an escape. */
            char escape[16];
            if (code <= 0xffff) {
                snprintf(escape, sizeof escape, "\\u%04x", (unsigned)code);
                bat_text_string(text, escape);
            } else
                bat_text_add(text, string + i, (size_t)length);
        } else
            bat_text_add(text, string + i, (size_t)length);
        i += (size_t)length;
    }
    bat_text_add(text, "\"", 1);
}

void bat_text_xml(bat_text *text, const char *bytes, size_t size, bool attribute) {
    for (size_t i = 0; i < size;) {
        uint32_t code;
        int length = bat_utf8_decode(bytes + i, size - i, &code);
        if (length == 0) length = 1, code = 0xfffe;
        if (code == '<')
            bat_text_string(text, "&lt;");
        else if (code == '>')
            bat_text_string(text, "&gt;");
        else if (code == '&')
            bat_text_string(text, "&amp;");
        else if (code == '"')
            bat_text_string(text, "&quot;");
        else if (code == '\t')
            bat_text_string(text, "&#9;");
        else if (code == '\n')
            bat_text_string(text, attribute ? "&#10;" : "\n");
        else if (code == '\r')
            bat_text_string(text, "&#13;");
        else if (code < 0x20 || code == 0xfffe || code == 0xffff)
            bat_text_string(text, "\xef\xbf\xbd");
        else
            bat_text_add(text, bytes + i, (size_t)length);
        i += (size_t)length;
    }
}

bat_status bat_text_finish(bat_text *text, char **data, size_t *size) {
    if (!make_room(text, 0)) {
        bat_text_free(text);
        return BAT_MEMORY;
    }
    text->data[text->size] = '\0';
    *data = text->data;
    *size = text->size;
    *text = (bat_text){0};
    return BAT_OK;
}

const char *bat_text_keep(bat_text *text, char **kept) {
    char *data;
    size_t size;
    if (bat_text_finish(text, &data, &size) != BAT_OK) return NULL;
    free(*kept);
    return *kept = data;
}

void bat_text_free(bat_text *text) {
    free(text->data);
    *text = (bat_text){0};
}
