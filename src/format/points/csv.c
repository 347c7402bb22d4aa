/* Columns of numbers as a format of drawings: polylines, with a column "curve" where there are several. */
#include "document/format.h"
#include "format/json/points.h"
#include "format/model/model.h"
#include "format/points/lines.h"
#include "kinds/kinds.h"
#include "text/json.h"
#include "text/text.h"

#include <batten/bezier.h>
#include <stdio.h>

enum { LIKELY = 20 };

static size_t past_mark(const char *text, size_t size) {
    return size >= 3 && text[0] == '\xEF' && text[1] == '\xBB' && text[2] == '\xBF' ? 3 : 0;
}

static int sniff(const char *text, size_t size) {
    const size_t mark = past_mark(text, size);
    return bat_point_rows_are(text + mark, size - mark) ? LIKELY : 0;
}

static bat_status lines_of(const bat_point_rows *rows, bat_model *out, bat_problem *problem) {
    bat_status status = BAT_OK;
    for (size_t i = 0; i < rows->part_count && status == BAT_OK; i++) {
        bat_curve *line = NULL;
        const size_t from = rows->starts[i];
        status = bat_line_of_points(rows->dimension, rows->starts[i + 1] - from,
                                    rows->points + from * (size_t)rows->dimension, &line);
        if (status == BAT_COUNT)
            return bat_problem_set(problem, BAT_COUNT, "",
                                   "expected two points or more for a curve, found one");
        if (status == BAT_OK) status = bat_model_add_curve(out, line);
    }
    return status == BAT_OK ? status : bat_problem_set(problem, status, "", bat_status_message(status));
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    const size_t mark = past_mark(text, size);
    bat_point_rows rows;
    bat_model model = {.mesh = NULL};
    (void)how, (void)report;
    bat_status status = bat_point_rows_read(text + mark, size - mark, &rows, problem);
    if (status != BAT_OK) return status;
    status = lines_of(&rows, &model, problem);
    if (status == BAT_OK && model.curve_count == 0)
        status = bat_problem_set(problem, BAT_COUNT, "", "expected points, found a header alone");
    if (status == BAT_OK) {
        const int count = (int)model.curve_count;
        model.curve_count = 0; /* the call takes the curves over */
        status = bat_document_of_curves(count, model.curves, NULL, 0, out);
        if (status != BAT_OK) bat_problem_set(problem, status, "", bat_status_message(status));
    }
    bat_point_rows_clear(&rows);
    bat_model_clear(&model);
    return status;
}

typedef struct writer {
    bat_text text;
    double tolerance;
    bool several, space; /* which columns there are */
    size_t curves;
} writer;

static bat_status put_curve(writer *w, const bat_curve *curve) {
    const size_t width = (size_t)bat_curve_dimension(curve);
    double *points = NULL;
    size_t count = 0;
    const bat_status status = bat_points_of_line(curve, w->tolerance, &count, &points);
    w->curves++;
    for (size_t i = 0; status == BAT_OK && i < count; i++) {
        if (w->several) bat_text_integer(&w->text, w->curves), bat_text_string(&w->text, ",");
        for (size_t c = 0; c < (w->space ? 3 : 2); c++) {
            if (c > 0) bat_text_string(&w->text, ",");
            bat_text_number(&w->text, c < width ? points[i * width + c] : 0);
        }
        bat_text_string(&w->text, "\n");
    }
    bat_free(points);
    return status;
}

static bat_status write(const bat_document *document, char **text, size_t *size, bat_problem *problem) {
    writer w = {.tolerance = bat_lines_tolerance(document)};
    const size_t count = bat_lines_count(document, &w.space);
    bat_status status = BAT_OK;
    if (count == 0)
        return bat_problem_set(problem, BAT_COUNT, "",
                               "a .csv file holds points of curves, expected 1 curve at least, found none");
    w.several = count > 1;
    bat_text_string(&w.text, w.several ? "curve,x,y" : "x,y");
    bat_text_string(&w.text, w.space ? ",z\n" : "\n");
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        for (int k = 0; k < bat_object_curve_count(object) && status == BAT_OK; k++)
            status = put_curve(&w, bat_object_curve(object, k));
    }
    if (status == BAT_OK)
        status = bat_text_finish(&w.text, text, size);
    else
        bat_text_free(&w.text);
    return status == BAT_OK ? status : bat_problem_set(problem, status, "", bat_status_message(status));
}

const bat_format bat_format_of_csv = {"csv", "text/csv", false, sniff, read, write};
