/* A file that holds one CURVE as JSON. */
#include "document/format.h"
#include "kinds/kinds.h"
#include "text/json.h"

#include <stdio.h>

/* Broken JSON counts too: the reader says what is wrong. */
static int sniff(const char *text, size_t size) {
    size_t at = bat_format_start(text, size);
    bat_json json;
    if (at == size || text[at] != '{') return 0;
    if (bat_json_parse(text, size, &json, NULL) != BAT_OK) return 50;
    bool objects = bat_json_member(&json, 1, "objects");
    bat_json_free(&json);
    return objects ? 0 : 50;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    bat_curve *curve = NULL;
    (void)how;
    (void)report;
    bat_status status = bat_curve_read(text, size, &curve, problem);
    return status == BAT_OK ? bat_document_of_curves(1, &curve, NULL, out) : status;
}

static bat_status write(const bat_document *document, char **text, size_t *size, bat_problem *problem) {
    const bat_curve *curve = NULL;
    int count = 0;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        if (bat_object_curve_count(object)) curve = bat_object_curve(object, 0);
        count += bat_object_curve_count(object);
    }
    if (count != 1) {
        char message[80];
        snprintf(message, sizeof message, "a .json file holds one curve, expected 1, found %d", count);
        return bat_problem_set(problem, BAT_COUNT, "", message);
    }
    bat_status status = bat_curve_write(curve, text, size);
    return status == BAT_OK ? status : bat_problem_set(problem, status, "", bat_status_message(status));
}

const bat_format bat_format_of_json = {"json", "application/json", false, sniff, read, write};
