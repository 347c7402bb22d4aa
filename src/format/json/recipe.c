#include "format/json/recipe.h"
#include <batten/recipe.h>

#include <math.h>
#include <string.h>

static const char *const kinds[] = {"sweep", "ruled", "revolve", "coons", "loft"};
static const char *const ways[] = {"lying", "across", "in-place"};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* Which of the words the member is; 0 without the member, when it may be left out. */
static bat_status read_word(const bat_fields *f, uint32_t object, const char *name, int count,
                            const char *const *words, const char *expected, bool needed, int *out) {
    const uint32_t node = bat_json_member(f->json, object, name);
    const char *text = node ? bat_json_text(f->json, node) : NULL;
    *out = 0;
    if (!node && !needed) return BAT_OK;
    for (; text && *out < count; ++*out)
        if (strcmp(text, words[*out]) == 0) return BAT_OK;
    return bat_fields_complain(f, node ? node : object, name, expected);
}

static bat_status read_ids(const bat_fields *f, uint32_t object, bat_id *ids, int *count) {
    static const char expected[] = "a list of the ids of 2 to 64 different objects";
    const uint32_t list = bat_json_member(f->json, object, "from");
    if (bat_json_type_of(f->json, list) != BAT_JSON_LIST)
        return bat_fields_complain(f, list ? list : object, "from", expected);
    *count = 0;
    for (uint32_t at = bat_json_first(f->json, list); at; at = f->json->nodes[at].next) {
        const double number = bat_json_type_of(f->json, at) == BAT_JSON_NUMBER
                                  ? f->json->nodes[at].value.number
                                  : 0;
        if (*count == BAT_RECIPE_CURVES || !(number >= 1 && number <= (double)BAT_ID_MAX) ||
            number != floor(number))
            return bat_fields_complain(f, at, "from", expected);
        ids[(*count)++] = (bat_id)number;
        for (int i = 0; i + 1 < *count; i++)
            if (ids[i] == ids[*count - 1]) return bat_fields_complain(f, at, "from", expected);
    }
    return BAT_OK;
}

bat_status bat_recipe_from_json(const bat_fields *f, uint32_t node, bat_recipe *recipe, bat_id *ids,
                                int *count) {
    int kind = 0, way = 0;
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT)
        return bat_fields_complain(f, node, "made", "an object");
    bat_status status = read_word(f, node, "by", KINDS, kinds, "sweep, ruled, revolve, coons or loft", true,
                                  &kind);
    if (status == BAT_OK)
        status = read_word(f, node, "stand", BAT_STAND_COUNT, ways, "lying, across or in-place", false, &way);
    if (status != BAT_OK) return status;
    *recipe = bat_recipe_of((bat_recipe_kind)(BAT_RECIPE_SWEEP + kind));
    recipe->stand = (bat_recipe_stand)way;
    status = bat_fields_number(f, node, "twist", -BAT_RECIPE_TWIST, BAT_RECIPE_TWIST,
                               "degrees from -36000 to 36000", &recipe->twist);
    if (status == BAT_OK)
        status = bat_fields_number(f, node, "scale", 0, BAT_RECIPE_SCALE, "a number from 0 to 1000",
                                   &recipe->scale);
    if (status == BAT_OK)
        status = bat_fields_number(f, node, "angle", -360, 360, "degrees from -360 to 360, not 0",
                                   &recipe->angle);
    if (status == BAT_OK && recipe->angle == 0)
        return bat_fields_complain(f, bat_json_member(f->json, node, "angle"), "angle",
                                   "degrees from -360 to 360, not 0");
    if (status == BAT_OK) status = read_ids(f, node, ids, count);
    if (status == BAT_OK && bat_recipe_check(recipe, (size_t)*count, NULL) != BAT_OK)
        return bat_fields_complain(f, bat_json_member(f->json, node, "from"), "from",
                                   "2 objects, 4 for coons, 2 to 64 for loft");
    return status;
}

static void write_number(bat_text *text, const char *member, double number) {
    bat_text_string(text, member);
    bat_text_number(text, number);
}

void bat_recipe_to_json(const bat_recipe *recipe, int count, const bat_id *ids, bat_text *text) {
    bat_text_string(text, "{\"by\":\"");
    bat_text_string(text, kinds[recipe->kind - BAT_RECIPE_SWEEP]);
    bat_text_string(text, "\",\"from\":[");
    for (int i = 0; i < count; i++) {
        if (i > 0) bat_text_string(text, ",");
        bat_text_integer(text, ids[i]);
    }
    bat_text_string(text, "]");
    if (recipe->kind == BAT_RECIPE_SWEEP) {
        bat_text_string(text, ",\"stand\":\"");
        bat_text_string(text, ways[recipe->stand]);
        bat_text_string(text, "\"");
        write_number(text, ",\"twist\":", recipe->twist);
        write_number(text, ",\"scale\":", recipe->scale);
    }
    if (recipe->kind == BAT_RECIPE_REVOLVE) write_number(text, ",\"angle\":", recipe->angle);
    bat_text_string(text, "}");
}
