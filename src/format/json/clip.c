#include "format/json/clip.h"

#include "document/digest.h"
#include "document/picture.h"
#include "format/json/curve.h"

#include <stdlib.h>

/* A picture and where it lies. */
static bat_status read_mask(const bat_fields *f, uint32_t node, uint32_t named, const bat_clip *within,
                            bat_clip **out) {
    const char *word = bat_json_text(f->json, named);
    double matrix[6];
    uint64_t digest;
    const bat_picture *picture = word && f->pictures && bat_digest_scan(word, &digest)
                                     ? bat_pictures_find(f->pictures, digest)
                                     : NULL;
    if (!picture) return bat_fields_complain(f, named, "mask", "the digest of one of the pictures");
    const bat_status status = bat_fields_numbers(f, node, "matrix", 6, "six numbers", matrix);
    return status == BAT_OK ? bat_fields_say(f, node, bat_clip_mask(picture, matrix, within, out)) : status;
}

static void exchange(bat_clip **clip, bat_clip *made) {
    bat_clip_release(*clip);
    *clip = made;
}

/* Puts the region before those that there are. */
static bat_status read_region(const bat_fields *f, uint32_t node, bat_clip **clip) {
    const uint32_t list = bat_json_member(f->json, node, "curves"),
                   mask = bat_json_member(f->json, node, "mask");
    bat_clip *made = NULL;
    if (mask) {
        const bat_status status = read_mask(f, node, mask, *clip, &made);
        if (status == BAT_OK) exchange(clip, made);
        return status;
    }
    if (bat_json_type_of(f->json, node) != BAT_JSON_OBJECT ||
        bat_json_type_of(f->json, list) != BAT_JSON_LIST)
        return bat_fields_complain(f, list ? list : node, "clip", "a list of objects with curves");
    const int room = (int)bat_json_count(f->json, list);
    bat_curve **curves = calloc((size_t)room + 1, sizeof *curves);
    if (!curves) return bat_fields_say(f, list, BAT_MEMORY);
    int count = 0;
    bool even_odd = false;
    bat_status status = bat_fields_flag(f, node, "even_odd", &even_odd);
    for (uint32_t at = bat_json_first(f->json, list); at && status == BAT_OK; at = f->json->nodes[at].next) {
        status = bat_curve_from_json(f->json, at, &curves[count], f->problem);
        count += status == BAT_OK;
    }
    if (status == BAT_OK)
        status = bat_fields_say(f, node, bat_clip_create(count, curves, even_odd, *clip, &made));
    for (int i = 0; i < count; i++) bat_curve_free(curves[i]);
    free(curves);
    if (status == BAT_OK) exchange(clip, made);
    return status;
}

bat_status bat_clip_from_json(const bat_fields *f, uint32_t node, bat_object **object) {
    const uint32_t list = bat_json_member(f->json, node, "clip");
    if (bat_json_type_of(f->json, list) != BAT_JSON_LIST || bat_json_count(f->json, list) == 0)
        return bat_fields_complain(f, list, "clip", "a list of regions");
    bat_clip *clip = NULL;
    bat_object *made = NULL;
    bat_status status = BAT_OK;
    for (uint32_t at = bat_json_first(f->json, list); at && status == BAT_OK; at = f->json->nodes[at].next)
        status = read_region(f, at, &clip);
    if (status == BAT_OK) status = bat_fields_say(f, list, bat_object_with_clip(*object, clip, &made));
    bat_clip_release(clip);
    if (status != BAT_OK) return status;
    bat_object_release(*object);
    *object = made;
    return BAT_OK;
}

static void write_mask(const bat_clip *mask, bat_text *text) {
    char digest[17];
    bat_digest_print(bat_picture_digest(bat_clip_picture(mask)), digest);
    bat_text_string(text, "\"mask\":");
    bat_text_json_string(text, digest);
    bat_text_numbers(text, ",\"matrix\":", bat_clip_matrix(mask), 6);
    bat_text_string(text, "}");
}

/* The outermost region first. */
void bat_clip_to_json(const bat_clip *clip, bat_text *text) {
    const bat_clip *list[BAT_CLIP_REGIONS_MAX];
    int count = 0;
    for (; clip; clip = bat_clip_within(clip)) list[count++] = clip;
    bat_text_string(text, ",\n  \"clip\":");
    for (int k = count - 1; k >= 0; k--) {
        bat_text_string(text, k < count - 1 ? ",\n   {" : "[{");
        if (bat_clip_picture(list[k])) {
            write_mask(list[k], text);
            continue;
        }
        if (bat_clip_is_even_odd(list[k])) bat_text_string(text, "\"even_odd\":true,");
        bat_text_string(text, "\"curves\":[");
        for (int i = 0; i < bat_clip_curve_count(list[k]); i++) {
            bat_text_string(text, i > 0 ? ",\n    " : "\n    ");
            bat_curve_to_json(bat_clip_curve(list[k], i), 5, text);
        }
        bat_text_string(text, "]}");
    }
    bat_text_string(text, "]");
}
