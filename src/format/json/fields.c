#include "format/json/fields.h"

#include "format/json/curve.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bat_status bat_fields_complain(const bat_fields *f, uint32_t node, const char *what, const char *expected) {
    return bat_json_complain(f->json, node, BAT_SYNTAX, what, expected, f->problem);
}

bat_status bat_fields_say(const bat_fields *f, uint32_t node, bat_status status) {
    return status == BAT_OK ? status
                            : bat_json_say(f->json, node, status, bat_status_message(status), f->problem);
}

bat_status bat_fields_number(const bat_fields *f, uint32_t object, const char *name, double low, double high,
                             const char *expected, double *value) {
    uint32_t node = bat_json_member(f->json, object, name);
    if (!node) return BAT_OK;
    double number = f->json->nodes[node].value.number;
    if (bat_json_type_of(f->json, node) != BAT_JSON_NUMBER || !(number >= low && number <= high))
        return bat_fields_complain(f, node, name, expected);
    *value = number;
    return BAT_OK;
}

bat_status bat_fields_id(const bat_fields *f, uint32_t object, const char *name, bat_id high, bat_id *id) {
    char expected[48];
    double number = (double)*id;
    snprintf(expected, sizeof expected, "a whole number from 1 to %lu", (unsigned long)high);
    bat_status status = bat_fields_number(f, object, name, 1, (double)high, expected, &number);
    if (status == BAT_OK && number != floor(number))
        status = bat_fields_complain(f, bat_json_member(f->json, object, name), name, expected);
    if (status == BAT_OK) *id = (bat_id)number;
    return status;
}

bat_status bat_fields_flag(const bat_fields *f, uint32_t object, const char *name, bool *value) {
    uint32_t node = bat_json_member(f->json, object, name);
    if (!node) return BAT_OK;
    bat_json_type type = bat_json_type_of(f->json, node);
    if (type != BAT_JSON_TRUE && type != BAT_JSON_FALSE)
        return bat_fields_complain(f, node, name, "true or false");
    *value = type == BAT_JSON_TRUE;
    return BAT_OK;
}

bat_status bat_fields_numbers(const bat_fields *f, uint32_t object, const char *name, size_t count,
                              const char *expected, double *values) {
    uint32_t list = bat_json_member(f->json, object, name);
    double *numbers;
    size_t found;
    if (!list) return bat_fields_complain(f, object, name, expected);
    bat_status status = bat_numbers_from_json(f->json, list, name, &numbers, &found, f->problem);
    if (status != BAT_OK) return status;
    if (found == count) memcpy(values, numbers, count * sizeof *values);
    free(numbers);
    return found == count ? BAT_OK : bat_json_complain(f->json, list, BAT_COUNT, name, expected, f->problem);
}

bat_status bat_fields_vector(const bat_fields *f, uint32_t object, const char *name, double out[3]) {
    const uint32_t list = bat_json_member(f->json, object, name);
    double *numbers;
    size_t count;
    if (!list) {
        char message[80];
        snprintf(message, sizeof message, "%s: expected 2 or 3 numbers, found none", name);
        return bat_json_say(f->json, object, BAT_SYNTAX, message, f->problem);
    }
    bat_status status = bat_numbers_from_json(f->json, list, name, &numbers, &count, f->problem);
    if (status != BAT_OK) return status;
    if (count == 2 || count == 3)
        for (size_t i = 0; i < 3; i++) out[i] = i < count ? numbers[i] : 0;
    else
        status = bat_json_complain(f->json, list, BAT_COUNT, name, "2 or 3 numbers", f->problem);
    free(numbers);
    for (int i = 0; i < 3 && status == BAT_OK; i++)
        if (!(fabs(out[i]) <= BAT_COORDINATE_MAX))
            status = bat_json_complain(f->json, list, BAT_NUMBER, name, "numbers up to 1e75", f->problem);
    return status;
}
