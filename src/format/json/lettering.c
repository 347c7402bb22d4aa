#include "format/json/lettering.h"

#include "format/json/word.h"

#include <float.h>

static const char *const aligns[] = {"start", "middle", "end", NULL};

static void write_number(bat_text *out, const char *before, double number) {
    bat_text_string(out, before);
    bat_text_number(out, number);
}

void bat_lettering_to_json(const bat_lettering *l, bat_text *out) {
    bat_text_string(out, ",\"text\":");
    bat_text_json_string(out, l->content);
    bat_text_string(out, ",\"family\":");
    bat_text_json_string(out, l->family);
    write_number(out, ",\"size\":", l->size);
    write_number(out, ",\"weight\":", l->weight);
    bat_text_string(out, l->italic ? ",\"italic\":true" : ",\"italic\":false");
    write_number(out, ",\"spacing\":", l->spacing);
    write_number(out, ",\"line\":", l->line);
    bat_text_string(out, ",\"align\":\"");
    bat_text_string(out, aligns[l->align]);
    bat_text_string(out, "\"");
    bat_text_numbers(out, ",\"at\":", l->at, 2);
    bat_text_numbers(out, ",\"box\":", l->box, 4);
}

static bat_status read_text(const bat_fields *f, uint32_t object, const char *name, const char **value) {
    const uint32_t node = bat_json_member(f->json, object, name);
    const char *text = bat_json_text(f->json, node);
    if (!node) return BAT_OK;
    if (!text) return bat_fields_complain(f, node, name, "a text");
    *value = text;
    return BAT_OK;
}

static bat_status read_numbers(const bat_fields *f, uint32_t object, bat_lettering *l) {
    bat_status status = bat_fields_number(f, object, "size", DBL_TRUE_MIN, BAT_COORDINATE_MAX,
                                          "a number above 0", &l->size);
    if (status == BAT_OK)
        status = bat_fields_number(f, object, "weight", 1, 1000, "a number from 1 to 1000", &l->weight);
    if (status == BAT_OK)
        status = bat_fields_number(f, object, "spacing", -BAT_COORDINATE_MAX, BAT_COORDINATE_MAX, "a number",
                                   &l->spacing);
    if (status == BAT_OK)
        status = bat_fields_number(f, object, "line", 0, 100, "a number from 0 to 100", &l->line);
    if (status == BAT_OK && bat_json_member(f->json, object, "at"))
        status = bat_fields_numbers(f, object, "at", 2, "two numbers", l->at);
    if (status == BAT_OK && bat_json_member(f->json, object, "box"))
        status = bat_fields_numbers(f, object, "box", 4, "four numbers, low x, low y, high x, high y",
                                    l->box);
    return status;
}

bat_status bat_lettering_from_json(const bat_fields *f, uint32_t object, bat_lettering *lettering) {
    bat_lettering l = *lettering;
    int align = (int)l.align;
    bat_status status = read_text(f, object, "text", &l.content);
    if (status == BAT_OK) status = read_text(f, object, "family", &l.family);
    if (status == BAT_OK) status = read_numbers(f, object, &l);
    if (status == BAT_OK) status = bat_fields_flag(f, object, "italic", &l.italic);
    if (status == BAT_OK)
        status = bat_word_from_json(f->json, object, "align", aligns, "start, middle or end", &align,
                                    f->problem);
    l.align = (bat_align)align;
    if (status == BAT_OK) *lettering = l;
    return status;
}
