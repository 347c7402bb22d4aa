#include "format/export.h"

#include "format/models.h"
#include "text/json.h"
#include "text/number.h"
#include "text/text.h"

#include <batten/bezier.h>
#include <string.h>

enum { NAME_ROOM = 8 };

typedef struct wish {
    char name[NAME_ROOM];
    bat_stand stand;
    bat_dividing how; /* tolerance: millimetres */
    bool tell;
} wish;

static bool is_word(const char *word, size_t size, const char *known) {
    return strlen(known) == size && memcmp(word, known, size) == 0;
}

static bool take(const char *word, size_t size, wish *out) {
    if (is_word(word, size, "wall") || is_word(word, size, "floor"))
        out->stand = size == 4 ? BAT_STAND_WALL : BAT_STAND_FLOOR;
    else if (is_word(word, size, "cap"))
        out->how.cap = true;
    else if (is_word(word, size, "tell"))
        out->tell = true;
    else
        return bat_number_scan(word, word + size, &out->how.tolerance) == word + size;
    return true;
}

static bool parse(const char *words, wish *out) {
    size_t size = strcspn(words, " ");
    if (size >= NAME_ROOM) return false;
    memcpy(out->name, words, size);
    for (words += size; *words == ' '; words += size) {
        words++;
        size = strcspn(words, " ");
        if (!take(words, size, out)) return false;
    }
    return true;
}

static void put_member(bat_text *text, const char *name, double value) {
    bat_text_string(text, name);
    bat_text_number(text, value);
}

/* In place of the file: what it holds. */
static bat_status put_told(const bat_model_format *format, const bat_model_told *told, char **bytes,
                           size_t *size) {
    bat_text text = {0};
    put_member(&text, "{\"wide\":", told->size[0] * format->unit);
    put_member(&text, ",\"deep\":", told->size[format->up_is_y ? 2 : 1] * format->unit);
    put_member(&text, ",\"tall\":", told->size[format->up_is_y ? 1 : 2] * format->unit);
    put_member(&text, ",\"triangles\":", (double)told->triangle_count);
    put_member(&text, ",\"open\":", (double)told->open_count);
    put_member(&text, ",\"bytes\":", (double)*size);
    bat_text_string(&text, "}");
    bat_free(*bytes);
    return bat_text_finish(&text, bytes, size);
}

static bat_status put_nothing(char **bytes, size_t *size) {
    bat_text text = {0};
    bat_text_string(&text, "{}");
    return bat_text_finish(&text, bytes, size);
}

static bat_status put_model(const bat_model_format *format, const bat_model *model, wish *wanted,
                            char **bytes, size_t *size) {
    bat_model_told told;
    wanted->how.tolerance /= format->unit;
    const bat_status status = bat_model_format_write(format, model, &wanted->how, bytes, size,
                                                     wanted->tell ? &told : NULL);
    if (!wanted->tell) return status;
    if (status == BAT_COUNT) return put_nothing(bytes, size);
    return status == BAT_OK ? put_told(format, &told, bytes, size) : status;
}

static bat_status put_stand(bat_stand stand, char **bytes, size_t *size) {
    bat_text text = {0};
    bat_text_string(&text, stand == BAT_STAND_FLOOR ? "{\"floor\":true}" : "{\"floor\":false}");
    return bat_text_finish(&text, bytes, size);
}

bat_status bat_export_model(const char *words, bat_stand found, const bat_document *document, char **bytes,
                            size_t *size, bat_problem *problem) {
    wish wanted = {.stand = found, .how = {0, false, true}};
    if (!parse(words, &wanted)) return BAT_ARGUMENT;
    const bool asked = strcmp(wanted.name, "space") == 0;
    const bat_model_format *format = bat_model_format_named(asked ? "glb" : wanted.name);
    if (!format) return BAT_ARGUMENT;
    const bat_room room = {wanted.stand, format->unit, format->up_is_y};
    bat_model model;
    int flat;
    bat_status status = bat_model_of_drawing(document, &room, &model, &flat);
    if (status == BAT_COUNT && wanted.tell) return put_nothing(bytes, size);
    if (status != BAT_OK) return bat_problem_set(problem, status, "", bat_status_message(status));
    status = asked ? put_stand(found, bytes, size) : put_model(format, &model, &wanted, bytes, size);
    bat_model_clear(&model);
    return status == BAT_OK ? status : bat_problem_set(problem, status, "", bat_status_message(status));
}
