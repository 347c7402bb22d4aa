/* batten info: what is in a file. */
#include "clean.h"
#include "drawing.h"
#include "io.h"
#include "program.h"
#include "format/json/losses.h"

#include "document/scale.h"
#include "kinds/primitive.h"
#include "results.h"

#include "text/number.h"

#include <batten/measure.h>
#include <batten/paint.h>

#include <stdio.h>
#include <string.h>

static void put_member(bat_text *text, const char *name, uint64_t value) {
    bat_text_string(text, ",\"");
    bat_text_string(text, name);
    bat_text_string(text, "\":");
    bat_text_integer(text, value);
}

static double length_of(const bat_curve *curve) {
    double domain[2];
    bat_curve_domain(curve, domain);
    return bat_curve_length(curve, domain[0], domain[1], 1e-9);
}

static void put_curve(bat_text *text, const bat_curve *curve) {
    bat_text_string(text, "{\"degree\":");
    bat_text_integer(text, (uint64_t)bat_curve_degree(curve));
    put_member(text, "dimension", (uint64_t)bat_curve_dimension(curve));
    bat_text_string(text, bat_curve_is_closed(curve) ? ",\"closed\":true" : ",\"closed\":false");
    put_member(text, "points", (uint64_t)bat_curve_count(curve));
    put_member(text, "knots", (uint64_t)bat_curve_knot_count(curve));
    bat_text_string(text, ",\"length\":");
    bat_text_number(text, length_of(curve));
    bat_text_string(text, "}");
}

/* What a shape is, and its numbers, as members or in words. */
static void put_shape(bat_text *text, const bat_primitive *p, bool json) {
    static const char *const names[] = {"radius", "start", "end", "sides", "depth", "roundness"};
    double value;
    bat_text_string(text, json ? "{\"is\":\"" : "    ");
    bat_text_string(text, bat_primitive_name(p));
    bat_text_string(text, json ? "\"" : "");
    for (int i = 0; i < BAT_PRIMITIVE_NUMBERS; i++) {
        char line[64];
        if (!bat_primitive_get(p, (bat_primitive_number)i, &value)) continue;
        snprintf(line, sizeof line, json ? ",\"%s\":" : ", %s ", names[i]);
        bat_text_string(text, line);
        if (json)
            bat_text_number(text, value);
        else {
            snprintf(line, sizeof line, "%.6g%s", value, i < BAT_PRIMITIVE_DEPTH ? "" : "%");
            bat_text_string(text, line);
        }
    }
    bat_text_string(text, json ? "}" : "\n");
}

static void put_object(bat_text *text, const bat_object *object) {
    bat_text_string(text, "{\"id\":");
    bat_text_integer(text, bat_object_id(object));
    bat_text_string(text, ",\"name\":");
    bat_text_json_string(text, bat_object_name(object));
    bat_text_string(text, ",\"curves\":[");
    for (int i = 0; i < bat_object_curve_count(object); i++) {
        if (i) bat_text_string(text, ",");
        put_curve(text, bat_object_curve(object, i));
    }
    bat_text_string(text, "]");
    if (bat_object_primitive(object)) {
        bat_text_string(text, ",\"shape\":");
        put_shape(text, bat_object_primitive(object), true);
    }
    const bat_width_profile profile = bat_object_widths(object);
    for (size_t i = 0; i < profile.count; i++) {
        bat_text_string(text, i ? ",[" : ",\"widths\":[[");
        bat_text_number(text, profile.stops[i].at);
        bat_text_string(text, ",");
        bat_text_number(text, profile.stops[i].share * bat_object_style(object)->width);
        bat_text_string(text, i + 1 < profile.count ? "]" : "]]");
    }
    bat_text_string(text, "}");
}

typedef struct curve_totals {
    int curves, knots;
    size_t points;
} curve_totals;

static curve_totals count(const bat_document *document) {
    curve_totals totals = {0};
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        for (int j = 0; j < bat_object_curve_count(object); j++) {
            totals.curves++;
            totals.points += bat_curve_count(bat_object_curve(object, j));
            totals.knots += bat_curve_knot_count(bat_object_curve(object, j));
        }
    }
    return totals;
}

static int print_json(const char *name, const drawing_file *drawing) {
    const bat_document *document = drawing->document;
    bat_text text = {0};
    bat_text_string(&text, "{\"file\":");
    bat_text_json_string(&text, name);
    bat_text_string(&text, ",\"format\":");
    bat_text_json_string(&text, drawing->format->name);
    double page[4];
    bat_document_page(document, page);
    bat_text_string(&text, ",\"page\":");
    if (page[2] > 0)
        put_numbers(&text, page, 4);
    else
        bat_text_string(&text, "null");
    if (bat_unit_is_said(document)) {
        bat_text_string(&text, ",\"unit\":");
        bat_text_json_string(&text, bat_unit_name(bat_document_unit(document)));
        bat_text_string(&text, ",\"scale\":");
        bat_text_number(&text, bat_document_scale(document));
    }
    curve_totals totals = count(document);
    put_member(&text, "curves", (uint64_t)totals.curves);
    put_member(&text, "points", (uint64_t)totals.points);
    put_member(&text, "knots", (uint64_t)totals.knots);
    const bat_svg_report *report = &drawing->report;
    const bool keeps = !bat_losses_total(&report->lost) || drawing_keeps_file(drawing);
    bat_text_string(&text, keeps ? ",\"keeps_all\":true" : ",\"keeps_all\":false");
    bat_text_string(&text, report->edited ? ",\"edited\":true" : ",\"edited\":false");
    bat_text_string(&text, ",\"left_out\":{");
    for (int i = 0; i < BAT_LOSS_COUNT; i++) {
        if (i) bat_text_string(&text, ",");
        bat_text_json_string(&text, bat_loss_key((bat_loss)i));
        bat_text_string(&text, ":");
        bat_text_integer(&text, (uint64_t)report->lost.count[i]);
    }
    bat_text_string(&text, "},\n\"objects\":[");
    for (int i = 0; i < bat_document_count(document); i++) {
        bat_text_string(&text, i ? ",\n" : "\n");
        put_object(&text, bat_document_at(document, i));
    }
    bat_text_string(&text, "]}");
    return write_text(&text);
}

static void put_line(bat_text *text, const char *left, const char *right) {
    char line[64];
    snprintf(line, sizeof line, "%-8s ", left);
    bat_text_string(text, line);
    bat_text_string(text, right);
    bat_text_string(text, "\n");
}

/* The physical size, where the file says it: of the page, or of a unit. */
static void put_scale(bat_text *text, const bat_document *document, const double page[4]) {
    const bat_unit unit = bat_document_unit(document);
    const double scale = bat_document_scale(document) / bat_unit_millimetres(unit);
    char line[128];
    if (!bat_unit_is_said(document)) return;
    if (page[2] > 0)
        snprintf(line, sizeof line, "%g x %g %s", page[2] * scale, page[3] * scale, bat_unit_name(unit));
    else
        snprintf(line, sizeof line, "a unit is %g %s", scale, bat_unit_name(unit));
    put_line(text, "size", line);
}

/* Names come from files, so they are cleaned. */
static void put_name(bat_text *text, const char *name) {
    char piece[CLEAN_ROOM];
    for (size_t read = clean_next(name, piece); read; read = clean_next(name, piece)) {
        bat_text_string(text, piece);
        name += read;
    }
}

static void put_object_lines(bat_text *text, const bat_object *object) {
    char line[160];
    snprintf(line, sizeof line, "  %llu ", (unsigned long long)bat_object_id(object));
    bat_text_string(text, line);
    put_name(text, bat_object_name(object)[0] ? bat_object_name(object) : "(no name)");
    bat_text_string(text, "\n");
    if (bat_object_primitive(object)) put_shape(text, bat_object_primitive(object), false);
    for (int i = 0; i < bat_object_curve_count(object); i++) {
        const bat_curve *curve = bat_object_curve(object, i);
        snprintf(line, sizeof line, "    %s, degree %d, %zu points, %d knots, length %.6g%s\n",
                 bat_curve_is_closed(curve) ? "closed" : "open", bat_curve_degree(curve),
                 bat_curve_count(curve), bat_curve_knot_count(curve), length_of(curve),
                 bat_curve_dimension(curve) == 3 ? ", in space" : "");
        bat_text_string(text, line);
    }
}

/* What overwriting the file would lose, or, of a file that is kept, what is not shown and, if asked for, what makes no picture:
 * one kind per line. */
static void put_losses(bat_text *text, const drawing_file *drawing, bool all) {
    char line[96];
    const bool kept = drawing_keeps_file(drawing);
    const bat_losses *lost = &drawing->report.lost, seen = bat_losses_seen(lost), *said = kept ? &seen : lost;
    const int total = bat_losses_total(said);
    snprintf(line, sizeof line, kept ? "all but %d thing%s; saving keeps them all" : "loses %d thing%s",
             total, total == 1 ? "" : "s");
    put_line(text, kept && total ? "shows" : "saving", total ? line : "keeps everything");
    for (int i = 0; i < BAT_LOSS_COUNT; i++) {
        if (!said->count[i]) continue;
        bat_loss_words((bat_loss)i, said->count[i], line, sizeof line);
        put_line(text, "", line);
    }
    const char *left = "keeps";
    for (int i = 0; kept && all && i < BAT_LOSS_COUNT; i++) {
        if (!lost->count[i] || seen.count[i]) continue;
        bat_loss_words((bat_loss)i, lost->count[i], line, sizeof line);
        put_line(text, left, line);
        left = "";
    }
    if (drawing->report.edited && drawing->report.native)
        put_line(
            text, "edited",
            "some objects were changed by another program since Batten saved them: their drawing counts");
    else if (drawing->report.edited)
        put_line(text, "edited", "changed by another program since Batten saved it: the drawing counts");
}

static int print_text(const char *name, const drawing_file *drawing, bool all) {
    const bat_document *document = drawing->document;
    bat_text text = {0};
    char line[256];
    bat_text_string(&text, "file     ");
    put_name(&text, name);
    bat_text_string(&text, "\n");
    bool saved = drawing->report.native;
    put_line(&text, "format", saved ? "svg, with its native document" : drawing->format->name);
    double page[4];
    bat_document_page(document, page);
    if (page[2] > 0) snprintf(line, sizeof line, "%g %g, %g x %g", page[0], page[1], page[2], page[3]);
    put_line(&text, "page", page[2] > 0 ? line : "none");
    put_scale(&text, document, page);
    curve_totals totals = count(document);
    snprintf(line, sizeof line, "%d objects, %d curves, %zu points, %d knots", bat_document_count(document),
             totals.curves, totals.points, totals.knots);
    put_line(&text, "holds", line);
    put_losses(&text, drawing, all);
    bat_text_string(&text, "objects  id, name, curves\n");
    for (int i = 0; i < bat_document_count(document); i++) {
        put_object_lines(&text, bat_document_at(document, i));
    }
    char *data;
    size_t size;
    if (bat_text_finish(&text, &data, &size) != BAT_OK) return fail_memory();
    int failed = io_write("-", data, size);
    bat_free(data);
    return failed;
}

static int run(const cli_arguments *arguments) {
    const char *name = arguments->operands[0];
    drawing_file drawing;
    int failed = drawing_read(name, NULL, &drawing);
    if (failed) return failed;
    failed = arguments_value(arguments, "--json")
                 ? print_json(name, &drawing)
                 : print_text(name, &drawing, arguments_value(arguments, "--kept") != NULL);
    drawing_free(&drawing);
    return failed;
}

const cli_command command_info = {
    .name = "info",
    .usage = "FILE [--json] [--kept]",
    .summary =
        "What is in a file: objects, curves, knots, page, and what of it is not shown or saving would lose.",
    .details = "As JSON, \"keeps_all\" is false when writing over the file would lose something, and "
               "\"left_out\"\ncounts what a drawing does not hold, by kind. With --kept what makes no "
               "picture is listed, too: metadata,\n"
               "settings of other programs, unused definitions, and the like, which saving keeps.",
    .example = "batten info drawing.svg --json",
    .operands = 1,
    .options = {{"--json", NULL, "as JSON"}, {"--kept", NULL, "also what is kept and makes no picture"}},
    .run = run,
};
