#include "format/json/style.h"

#include <stdio.h>
#include <string.h>

static const char *const caps[] = {"butt", "round", "square"};
static const char *const joins[] = {"miter", "round", "bevel"};

bool bat_colour_scan(const char *text, uint32_t *colour) {
    bool good = text && text[0] == '#' && strlen(text) == 9;
    uint32_t made = 0;
    for (int i = 1; good && i < 9; i++) {
        char c = text[i];
        int digit = c >= '0' && c <= '9'   ? c - '0'
                    : c >= 'a' && c <= 'f' ? c - 'a' + 10
                    : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                           : -1;
        good = digit >= 0;
        made = made << 4 | (uint32_t)(digit & 15);
    }
    if (good) *colour = made;
    return good;
}

bat_status bat_colour_from_json(const bat_fields *f, uint32_t object, const char *name, uint32_t *value) {
    uint32_t node = bat_json_member(f->json, object, name);
    if (!node || bat_colour_scan(bat_json_text(f->json, node), value)) return BAT_OK;
    return bat_fields_complain(f, node, name, "a colour \"#rrggbbaa\"");
}

static bat_status read_choice(const bat_fields *f, uint32_t object, const char *name,
                              const char *const words[3], const char *expected, int *value) {
    uint32_t node = bat_json_member(f->json, object, name);
    if (!node) return BAT_OK;
    const char *text = bat_json_text(f->json, node);
    for (int i = 0; text && i < 3; i++)
        if (strcmp(text, words[i]) == 0) {
            *value = i;
            return BAT_OK;
        }
    return bat_fields_complain(f, node, name, expected);
}

bat_status bat_style_from_json(const bat_fields *f, uint32_t object, bat_style *style) {
    uint32_t node = bat_json_member(f->json, object, "style");
    if (!node) return BAT_OK;
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, node, "style", "an object");
    int cap = (int)style->cap, join = (int)style->join;
    bat_status status = bat_fields_flag(f, node, "stroked", &style->stroked);
    if (status == BAT_OK) status = bat_fields_flag(f, node, "filled", &style->filled);
    if (status == BAT_OK) status = bat_fields_flag(f, node, "even_odd", &style->even_odd);
    if (status == BAT_OK) status = bat_colour_from_json(f, node, "stroke", &style->stroke);
    if (status == BAT_OK) status = bat_colour_from_json(f, node, "fill", &style->fill);
    if (status == BAT_OK)
        status = bat_fields_number(f, node, "width", 0, BAT_COORDINATE_MAX, "a number from 0", &style->width);
    if (status == BAT_OK)
        status = bat_fields_number(f, node, "opacity", 0, 1, "a number from 0 to 1", &style->opacity);
    if (status == BAT_OK)
        status = bat_fields_number(f, node, "miter_limit", 1, BAT_COORDINATE_MAX, "a number from 1",
                                   &style->miter_limit);
    if (status == BAT_OK) status = read_choice(f, node, "cap", caps, "butt, round or square", &cap);
    if (status == BAT_OK) status = read_choice(f, node, "join", joins, "miter, round or bevel", &join);
    style->cap = (bat_cap)cap, style->join = (bat_join)join;
    return status;
}

void bat_colour_write(bat_text *text, const char *member, uint32_t colour) {
    char value[12];
    bat_text_string(text, member);
    snprintf(value, sizeof value, "\"#%08lx\"", (unsigned long)colour);
    bat_text_string(text, value);
}

static void write_flag(bat_text *text, const char *member, bool flag) {
    bat_text_string(text, member);
    bat_text_string(text, flag ? "true" : "false");
}

void bat_style_to_json(const bat_style *style, bat_text *text) {
    write_flag(text, "{\"stroked\":", style->stroked);
    bat_colour_write(text, ",\"stroke\":", style->stroke);
    bat_text_string(text, ",\"width\":");
    bat_text_number(text, style->width);
    bat_text_string(text, ",\"cap\":\"");
    bat_text_string(text, caps[style->cap]);
    bat_text_string(text, "\",\"join\":\"");
    bat_text_string(text, joins[style->join]);
    bat_text_string(text, "\",\"miter_limit\":");
    bat_text_number(text, style->miter_limit);
    write_flag(text, ",\"filled\":", style->filled);
    bat_colour_write(text, ",\"fill\":", style->fill);
    write_flag(text, ",\"even_odd\":", style->even_odd);
    bat_text_string(text, ",\"opacity\":");
    bat_text_number(text, style->opacity);
    bat_text_string(text, "}");
}
