/* The native document as a file. */
#include "document/format.h"
#include "document/picture.h"
#include "format/native/native.h"
#include "text/json.h"

static int sniff(const char *text, size_t size) {
    size_t at = bat_format_start(text, size);
    bat_json json;
    if (at == size || text[at] != '{' || bat_json_parse(text, size, &json, NULL) != BAT_OK) return 0;
    bool objects = bat_json_member(&json, 1, "objects");
    bat_json_free(&json);
    return objects ? 100 : 0;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    bat_pictures none = {0};
    bool left = false;
    (void)how;
    const bat_status status = bat_document_read_with(text, size, &none, out, &left, problem);
    bat_pictures_free(&none);
    if (left) report->lost.count[BAT_LOSS_BROKEN]++;
    return status;
}

static bat_status write(const bat_document *document, char **text, size_t *size, bat_problem *problem) {
    bat_status status = bat_document_write(document, text, size);
    return status == BAT_OK ? status : bat_problem_set(problem, status, "", bat_status_message(status));
}

const bat_format bat_format_of_batten = {"batten", "application/json", true, sniff, read, write};
