/* Files that hold curves and nothing else: one CURVE, or a list of them, as JSON; and JSON Lines, a CURVE a line. */
#include "document/format.h"
#include "format/json/curve.h"
#include "format/model/model.h"
#include "kinds/kinds.h"

#include <stdio.h>
#include <string.h>

/* ---- what both share ---- */

/* Makes the drawing, if all went well, and releases what was read. */
static bat_status finish(bat_model *from, bat_status status, bat_document **out, bat_problem *problem) {
    if (status == BAT_OK && from->curve_count == 0)
        status = bat_problem_set(problem, BAT_COUNT, "", "expected a curve, found none");
    if (status == BAT_OK) {
        const int count = (int)from->curve_count;
        from->curve_count = 0; /* the call takes the curves over */
        status = bat_document_of_curves(count, from->curves, NULL, 0, out);
        if (status != BAT_OK) bat_problem_set(problem, status, "", bat_status_message(status));
    }
    bat_model_clear(from);
    return status;
}

static int count_curves(const bat_document *document) {
    int count = 0;
    for (int i = 0; i < bat_document_count(document); i++)
        count += bat_object_curve_count(bat_document_at(document, i));
    return count;
}

/* All curves, in order: what stands before the first, between two, and after the last. */
static bat_status write_between(const bat_document *document, const char *const marks[3], char **out,
                                size_t *size, bat_problem *problem) {
    bat_text text = {0};
    bool any = false;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        for (int k = 0; k < bat_object_curve_count(object); k++, any = true) {
            bat_text_string(&text, marks[any]);
            bat_curve_to_json(bat_object_curve(object, k), 0, &text);
        }
    }
    bat_text_string(&text, marks[2]);
    const bat_status status = bat_text_finish(&text, out, size);
    return status == BAT_OK ? status : bat_problem_set(problem, status, "", bat_status_message(status));
}

/* ---- JSON ---- */

/* Broken JSON counts too: the reader says what is wrong. */
static int sniff(const char *text, size_t size) {
    size_t at = bat_format_start(text, size);
    bat_json json;
    if (at == size || (text[at] != '{' && text[at] != '[')) return 0;
    if (bat_json_parse(text, size, &json, NULL) != BAT_OK) return 50;
    bool objects = bat_json_member(&json, 1, "objects");
    bat_json_free(&json);
    return objects ? 0 : 50;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    bat_json json;
    bat_model model = {.mesh = NULL};
    (void)how;
    (void)report;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    const bool list = bat_json_type_of(&json, 1) == BAT_JSON_LIST;
    for (uint32_t at = list ? bat_json_first(&json, 1) : 1; at && status == BAT_OK;
         at = list ? json.nodes[at].next : 0) {
        bat_curve *curve = NULL;
        status = bat_curve_from_json(&json, at, &curve, problem);
        if (status == BAT_OK) status = bat_model_add_curve(&model, curve);
    }
    bat_json_free(&json);
    return finish(&model, status, out, problem);
}

static bat_status write(const bat_document *document, char **text, size_t *size, bat_problem *problem) {
    static const char *const one[3] = {"", "", "\n"}, *const several[3] = {"[", ",\n ", "]\n"};
    const int count = count_curves(document);
    if (count == 0)
        return bat_problem_set(problem, BAT_COUNT, "",
                               "a .json file holds curves, expected 1 at least, found none");
    return write_between(document, count == 1 ? one : several, text, size, problem);
}

const bat_format bat_format_of_json = {"json", "application/json", false, sniff, read, write};

/* ---- JSON Lines ---- */

typedef struct row {
    const char *text;
    size_t size;
    long number;
} row;

/* The next line that is not empty; false: there is none. row.size 0 before the first. */
static bool next_row(const char *end, row *at) {
    const char *text = at->text + at->size;
    while (text < end && strchr(" \t\r\n", *text)) at->number += *text++ == '\n';
    const char *stop = text < end ? memchr(text, '\n', (size_t)(end - text)) : NULL;
    if (!stop) stop = end;
    at->text = text, at->size = (size_t)(stop - text);
    return text < end;
}

static row before_rows(const char *text, size_t size) {
    const size_t mark = size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    return (row){text + mark, 0, 1};
}

/* Two lines or more, of which the first is whole. */
static int sniff_rows(const char *text, size_t size) {
    row at = before_rows(text, size);
    bat_json json;
    if (!next_row(text + size, &at) || *at.text != '{' ||
        bat_json_parse(at.text, at.size, &json, NULL) != BAT_OK)
        return 0;
    bat_json_free(&json);
    return next_row(text + size, &at) && *at.text == '{' ? 60 : 0;
}

/* A reader of one line finds everything in line 1. */
static void move_place(long number, bat_problem *problem) {
    static const char first[] = "line 1";
    char rest[sizeof problem->place];
    if (!problem || strncmp(problem->place, first, sizeof first - 1) != 0) return;
    strcpy(rest, problem->place + sizeof first - 1);
    snprintf(problem->place, sizeof problem->place, "line %ld%.40s", number, rest);
}

static bat_status read_rows(const bat_reading *how, const char *text, size_t size, bat_document **out,
                            bat_svg_report *report, bat_problem *problem) {
    bat_model model = {.mesh = NULL};
    bat_status status = BAT_OK;
    (void)how;
    (void)report;
    for (row at = before_rows(text, size); status == BAT_OK && next_row(text + size, &at);) {
        bat_curve *curve = NULL;
        status = bat_curve_read(at.text, at.size, &curve, problem);
        if (status == BAT_OK)
            status = bat_model_add_curve(&model, curve);
        else
            move_place(at.number, problem);
    }
    return finish(&model, status, out, problem);
}

static bat_status write_rows(const bat_document *document, char **text, size_t *size, bat_problem *problem) {
    static const char *const rows[3] = {"", "\n", "\n"};
    if (count_curves(document) == 0)
        return bat_problem_set(problem, BAT_COUNT, "",
                               "a .jsonl file holds curves, expected 1 at least, found none");
    return write_between(document, rows, text, size, problem);
}

const bat_format bat_format_of_jsonl = {"jsonl",    "application/jsonl", false,
                                        sniff_rows, read_rows,           write_rows};
