#include "drawing.h"

#include "io.h"
#include "program.h"
#include "xml.h"

#include "text/json.h"

#include <batten/format.h>

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

static const struct {
    const char *ending, *name, *type;
    drawing_format format;
} formats[] = {
    {".batten", "batten", "application/json", DRAWING_NATIVE},
    {".svg", "svg", "image/svg+xml", DRAWING_SVG},
    {".json", "json", "application/json", DRAWING_CURVE},
};
enum { LEFT_OUT_ROOM = 1000 };
enum { FORMAT_COUNT = sizeof formats / sizeof formats[0] };

drawing_format drawing_format_of(const char *name) {
    const char *slash = strrchr(name, '/'), *dot = strrchr(slash ? slash : name, '.');
    for (size_t i = 0; dot && i < FORMAT_COUNT; i++) {
        if (strcasecmp(dot, formats[i].ending) == 0) return formats[i].format;
    }
    return DRAWING_UNKNOWN;
}

const char *drawing_format_name(drawing_format format) {
    for (size_t i = 0; i < FORMAT_COUNT; i++) {
        if (formats[i].format == format) return formats[i].name;
    }
    return "unknown";
}

const char *drawing_media_type(drawing_format format) {
    for (size_t i = 0; i < FORMAT_COUNT; i++) {
        if (formats[i].format == format) return formats[i].type;
    }
    return "application/octet-stream";
}

/* From the first character that is no space: XML, or JSON with or without "objects". */
static drawing_format format_of_text(const char *text, size_t size) {
    size_t at = size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    while (at < size && strchr(" \t\r\n", text[at]) && text[at]) at++;
    if (at < size && text[at] == '{') {
        bat_json json;
        if (bat_json_parse(text, size, &json, NULL) != BAT_OK)
            return DRAWING_CURVE; /* its reader tells why */
        bool curve = bat_json_member(&json, 1, "objects") == 0;
        bat_json_free(&json);
        return curve ? DRAWING_CURVE : DRAWING_NATIVE;
    }
    /* '<', or UTF-16 with its mark */
    if (at < size && (text[at] == '<' || text[at] == '\xFE' || text[at] == '\xFF')) return DRAWING_SVG;
    return DRAWING_UNKNOWN;
}

static bat_status document_of_curve(bat_curve *curve, bat_document **out) {
    bat_document *document = NULL;
    bat_object *object = NULL;
    bat_status status = bat_document_create(&document);
    if (status != BAT_OK) {
        bat_curve_free(curve);
        return status;
    }
    bat_style style = bat_style_defaults();
    status = bat_object_create_path(bat_document_new_id(document), NULL, &style, 1, &curve, &object);
    if (status != BAT_OK)
        bat_curve_free(curve);
    else
        status = bat_document_put(document, 0, object);
    bat_object_release(object);
    if (status != BAT_OK)
        bat_document_free(document);
    else
        *out = document;
    return status;
}

bat_status drawing_parse(const char *text, size_t size, drawing_format format, const bat_svg_options *options,
                         drawing_file *out, bat_problem *problem) {
    *problem = (bat_problem){.place = ""};
    drawing_file drawing = {.format = format};
    if (format == DRAWING_UNKNOWN || format == DRAWING_CURVE) {
        drawing_format found = format_of_text(text, size);
        if (format == DRAWING_UNKNOWN || found == DRAWING_NATIVE) drawing.format = found;
    }
    bat_status status;
    bat_curve *curve = NULL;
    bat_svg_options defaults = bat_svg_defaults();
    switch (drawing.format) {
    case DRAWING_NATIVE: status = bat_document_read(text, size, &drawing.document, problem); break;
    case DRAWING_SVG:
        status = xml_read_svg(text, size, options ? options : &defaults, &drawing.document, &drawing.report,
                              problem);
        break;
    case DRAWING_CURVE:
        status = bat_curve_read(text, size, &curve, problem);
        if (status == BAT_OK) status = document_of_curve(curve, &drawing.document);
        break;
    default:
        status = bat_problem_set(problem, BAT_SYNTAX, "line 1, column 1",
                                 size ? "expected SVG or JSON, found neither"
                                      : "expected SVG or JSON, found nothing");
    }
    if (status == BAT_OK) *out = drawing;
    return status;
}

int drawing_read(const char *name, const bat_svg_options *options, drawing_file *out) {
    char *text;
    size_t size;
    int failed = io_read(name, &text, &size);
    if (failed) return failed;
    bat_problem problem;
    bat_status status = drawing_parse(text, size, drawing_format_of(name), options, out, &problem);
    free(text);
    return status == BAT_OK ? EXIT_DONE : fail_problem(name, status, &problem);
}

void drawing_free(drawing_file *drawing) { bat_document_free(drawing->document); }

int drawing_curve_count(const bat_document *document) {
    int count = 0;
    for (int i = 0; i < bat_document_count(document); i++) {
        count += bat_object_curve_count(bat_document_at(document, i));
    }
    return count;
}

void drawing_remark(const char *name, const drawing_file *drawing) {
    if (drawing->format != DRAWING_SVG) return;
    char line[LEFT_OUT_ROOM] = "";
    bat_svg_report_line(&drawing->report, line, sizeof line);
    if (line[0]) remark("%s: %s", strcmp(name, "-") == 0 ? "standard input" : name, line);
}

/* "-": what standard input was taken from. */
static bool is_same_file(const char *in, const char *out) {
    struct stat a, b;
    int found = strcmp(in, "-") == 0 ? fstat(STDIN_FILENO, &a) : stat(in, &a);
    return strcmp(out, "-") != 0 && found == 0 && stat(out, &b) == 0 && a.st_dev == b.st_dev &&
           a.st_ino == b.st_ino;
}

int drawing_may_replace(const cli_arguments *arguments, const drawing_file *drawing, const char *in,
                        const char *out, bool picture) {
    int total = bat_losses_total(&drawing->report.lost);
    if ((total == 0 && !picture) || arguments_value(arguments, "--lossy") || !is_same_file(in, out))
        return EXIT_DONE;
    if (picture) return fail_data(out, NULL, "a picture would take the drawing's place; --lossy allows it");
    char line[LEFT_OUT_ROOM];
    bat_svg_report_line(&drawing->report, line, sizeof line);
    return fail_data(out, NULL, "writing over it would lose %d thing%s; --lossy allows it. %s", total,
                     total == 1 ? "" : "s", line);
}

int drawing_print(const bat_document *document, drawing_format format, const char *name, char **text,
                  size_t *size) {
    bat_status status;
    if (format == DRAWING_CURVE) {
        int count = drawing_curve_count(document);
        if (count != 1) {
            return fail_data(name, NULL, "a .json file holds one curve, expected 1, found %d", count);
        }
        int at = 0;
        while (bat_object_curve_count(bat_document_at(document, at)) == 0) at++;
        status = bat_curve_write(bat_object_curve(bat_document_at(document, at), 0), text, size);
    } else if (format == DRAWING_SVG) {
        status = bat_svg_write(document, true, text, size);
    } else {
        status = bat_document_write(document, text, size);
    }
    if (status == BAT_MEMORY) return fail_memory();
    return status == BAT_OK ? EXIT_DONE : fail_data(name, NULL, "%s", bat_status_message(status));
}
