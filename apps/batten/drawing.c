#include "drawing.h"

#include "gzip.h"
#include "io.h"
#include "pdf.h"
#include "program.h"
#include "format/json/losses.h"
#include <batten/svg_read.h>

#include <batten/format.h>
#include <batten/document.h>

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LEFT_OUT_ROOM = 1000 };

bat_status drawing_parse(const char *text, size_t size, const bat_format *format,
                         const bat_svg_options *options, drawing_file *out, bat_problem *problem) {
    bat_reading how = {options ? *options : bat_svg_defaults(), bat_svg_read};
    drawing_file drawing = {.format = format};
    *problem = (bat_problem){.place = ""};
    bat_status status = bat_formats_read(&how, text, size, &drawing.format, &drawing.document,
                                         &drawing.report, problem);
    if (status == BAT_OK) *out = drawing;
    return status;
}

const bat_format *drawing_format(const char *name) {
    return gzip_is_called(name) ? bat_format_named("svg") : bat_format_called(name);
}

/* A PDF gives way to its first page as SVG. */
static int first_page(const char *name, char **text, size_t *size) {
    char *svg = NULL;
    size_t svg_size = 0;
    const char *wrong = pdf_first_page(*text, *size, &svg, &svg_size);
    free(*text);
    *text = svg, *size = svg_size;
    return wrong ? fail_data(name, NULL, "%s", wrong) : EXIT_DONE;
}

int drawing_read(const char *name, const bat_svg_options *options, drawing_file *out) {
    char *text;
    size_t size;
    int failed = io_read(name, &text, &size);
    if (failed) return failed;
    const bat_format *format = drawing_format(name);
    const bool pdf = pdf_is_one(text, size);
    if (pdf) {
        failed = first_page(name, &text, &size);
        if (failed) return failed;
        format = bat_format_named("svg");
    } else if (pdf_is_postscript(text, size)) {
        free(text);
        return fail_data(name, NULL,
                         "expected a drawing, found PostScript, which is written, not read; as PDF "
                         "it can be read");
    }
    bat_problem problem;
    bat_status status = drawing_parse(text, size, format, options, out, &problem);
    free(text);
    if (status == BAT_OK && pdf &&
        bat_document_unit(out->document) == BAT_UNIT_PX) /* its points, without a unit */
        status = bat_document_set_scale(out->document, 25.4 / 72, BAT_UNIT_PT);
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

void drawing_remark_size(const char *name, const bat_document *document) {
    if (bat_document_unit(document) == BAT_UNIT_PX)
        remark("%s: it says no physical size: 96 px are an inch",
               strcmp(name, "-") == 0 ? "standard input" : name);
}

/* What makes no picture in an SVG file is left out without a word. */
static void line_of_seen(const drawing_file *drawing, char line[LEFT_OUT_ROOM]) {
    bat_svg_report report = drawing->report;
    if (strcmp(drawing->format->name, "svg") == 0) report.lost = bat_losses_seen(&report.lost);
    bat_svg_report_line(&report, line, LEFT_OUT_ROOM);
}

void drawing_remark(const char *name, const drawing_file *drawing) {
    char line[LEFT_OUT_ROOM] = "";
    line_of_seen(drawing, line);
    if (line[0]) remark("%s: %s", strcmp(name, "-") == 0 ? "standard input" : name, line);
}

void drawing_remark_kept(const char *name, const drawing_file *drawing) {
    static const char before[] = "Left out: ";
    char line[LEFT_OUT_ROOM] = "";
    line_of_seen(drawing, line);
    if (strncmp(line, before, sizeof before - 1) != 0) return;
    remark("%s: not shown: %s Saving keeps all of it.", name, line + sizeof before - 1);
}

void drawing_remark_lost(const char *name, const drawing_file *drawing) {
    const int lost = bat_losses_total(&drawing->report.lost);
    char line[LEFT_OUT_ROOM] = "";
    if (!lost) {
        drawing_remark(name, drawing);
        return;
    }
    bat_svg_report_line(&drawing->report, line, sizeof line);
    remark("%s: saving over it loses %d thing%s; the editor asks first%s%s", name, lost, lost == 1 ? "" : "s",
           line[0] ? ". " : "", line);
}

/* in "-": the file that is open as standard input. */
static bool is_same_file(const char *in, const char *out) {
    struct stat a, b;
    int found = strcmp(in, "-") == 0 ? fstat(STDIN_FILENO, &a) : stat(in, &a);
    return strcmp(out, "-") != 0 && found == 0 && stat(out, &b) == 0 && a.st_dev == b.st_dev &&
           a.st_ino == b.st_ino;
}

bool drawing_keeps_file(const drawing_file *drawing) {
    return bat_svg_is_kept(drawing->document) && !drawing->report.lost.count[BAT_LOSS_NATIVE];
}

int drawing_may_replace(bool lossy, const drawing_file *drawing, const char *in, const char *out,
                        bool picture) {
    int total = bat_losses_total(&drawing->report.lost);
    if (!picture && drawing_keeps_file(drawing)) return EXIT_DONE;
    if ((total == 0 && !picture) || lossy || !is_same_file(in, out)) return EXIT_DONE;
    if (picture) return fail_data(out, NULL, "a picture would take the drawing's place; --lossy allows it");
    char line[LEFT_OUT_ROOM];
    bat_svg_report_line(&drawing->report, line, sizeof line);
    return fail_data(out, NULL, "writing over it would lose %d thing%s; --lossy allows it. %s", total,
                     total == 1 ? "" : "s", line);
}

int drawing_print(const bat_document *document, const bat_format *format, const char *name, char **text,
                  size_t *size) {
    bat_problem problem = {.place = ""};
    bat_status status = format->write(document, text, size, &problem);
    return status == BAT_OK ? EXIT_DONE : fail_problem(name, status, &problem);
}

int drawing_print_svg(const bat_document *document, bool native, double precision, const drawing_writing *how,
                      char **text, size_t *size) {
    bat_status status = bat_svg_write_kept(document, native, precision, text, size);
    if (status == BAT_UNSUPPORTED && !how->lossy && is_same_file(how->in, how->out))
        return fail_data(
            how->out, NULL,
            "this edit cannot be said in the file, which would be written anew, without what the "
            "drawing does not hold of it; --lossy allows it");
    if (status == BAT_UNSUPPORTED)
        remark("%s: this edit cannot be said in the file: it is written anew, without what the drawing does "
               "not hold of it",
               how->in);
    if (status == BAT_UNSUPPORTED || status == BAT_STATE)
        status = bat_svg_write_within(document, native, precision, text, size);
    return status == BAT_OK ? EXIT_DONE : fail_data(how->in, NULL, "%s", bat_status_message(status));
}

int drawing_print_over(const bat_document *document, const bat_format *format, const drawing_writing *how,
                       char **text, size_t *size) {
    if (strcmp(format->name, "svg") == 0)
        return drawing_print_svg(document, true, BAT_SVG_UNSEEN, how, text, size);
    return drawing_print(document, format, how->in, text, size);
}
