#include "results.h"

#include "format/json/relief.h"
#include "format/json/surface.h"

#include "text/number.h"

#include "address.h"
#include "io.h"
#include "program.h"
#include <batten/relate.h>

#include <stdlib.h>
#include <string.h>
#include <strings.h>

int read_data(const char *name, data_reader *reader, void *out, bat_problem *problem) {
    char *data;
    size_t size;
    int failed = io_read(name, &data, &size);
    if (failed) return failed;
    *problem = (bat_problem){.place = ""};
    bat_status status = reader(data, size, out, problem);
    free(data);
    return status == BAT_OK ? EXIT_DONE : fail_problem(name, status, problem);
}

/* ---- OBJECTs: JSON, or a file whose name says what it is ---- */

static bat_status model_of(const char *data, size_t size, void *out, bat_problem *problem) {
    return bat_model_read(data, size, out, problem);
}
static bat_status obj_of(const char *data, size_t size, void *out, bat_problem *problem) {
    return bat_obj_read(data, size, out, problem);
}
static bat_status iges_of(const char *data, size_t size, void *out, bat_problem *problem) {
    return bat_iges_read(data, size, out, problem);
}
static bat_status step_of(const char *data, size_t size, void *out, bat_problem *problem) {
    return bat_step_read(data, size, out, problem);
}

/* The reader for files with this name; NULL: JSON. */
static data_reader *reader_of(const char *name) {
    static const struct {
        const char *ending;
        data_reader *reader;
    } readers[] = {
        {".obj", obj_of}, {".igs", iges_of}, {".iges", iges_of}, {".stp", step_of}, {".step", step_of}};
    const size_t length = strlen(name);
    for (size_t i = 0; i < sizeof readers / sizeof *readers; i++) {
        const size_t ending = strlen(readers[i].ending);
        if (length > ending && strcasecmp(name + length - ending, readers[i].ending) == 0)
            return readers[i].reader;
    }
    return NULL;
}

int read_model(const char *name, bat_model *out) {
    bat_problem problem;
    data_reader *reader = reader_of(name);
    return read_data(name, reader ? reader : model_of, out, &problem);
}

/* Reads the one thing of its kind that an OBJ file holds; the other things are freed. */
static int read_only_one(const char *name, const char *what, bat_model *model) {
    int failed = read_model(name, model);
    if (failed) return failed;
    const size_t found = strcmp(what, "mesh") == 0    ? model->mesh != NULL
                         : strcmp(what, "curve") == 0 ? model->curve_count
                                                      : model->surface_count;
    if (found == 1) return EXIT_DONE;
    bat_model_clear(model);
    return fail_data(name, NULL, "expected one %s, found %zu", what, found);
}

static bat_status curve_of(const char *data, size_t size, void *out, bat_problem *problem) {
    return bat_curve_read(data, size, out, problem);
}

int read_curve(const char *name, bat_curve **out) {
    bat_problem problem;
    bat_model model;
    if (is_address(name)) return address_read(name, out);
    if (!reader_of(name)) return read_data(name, curve_of, out, &problem);
    int failed = read_only_one(name, "curve", &model);
    if (failed) return failed;
    *out = model.curves[0];
    model.curves[0] = NULL;
    bat_model_clear(&model);
    return EXIT_DONE;
}

typedef struct stroke_to {
    bat_stroke *stroke;
    void **block;
} stroke_to;

static bat_status stroke_of(const char *data, size_t size, void *out, bat_problem *problem) {
    const stroke_to *to = out;
    return bat_stroke_read(data, size, to->stroke, to->block, problem);
}

/* Either a RELIEF or, when it has no base, a SURFACE. */
typedef struct levelled {
    bat_surface *surface;
    bat_relief *relief;
} levelled;

static bat_status levelled_of(const char *data, size_t size, void *out, bat_problem *problem) {
    levelled *to = out;
    bat_json json;
    bat_status status = bat_json_parse(data, size, &json, problem);
    if (status != BAT_OK) return status;
    if (bat_json_member(&json, 1, "base"))
        status = bat_relief_from_json(&json, 1, &to->relief, problem);
    else
        status = bat_surface_from_json(&json, 1, &to->surface, problem);
    bat_json_free(&json);
    return status;
}

static int read_levelled(const char *name, levelled *out) {
    bat_problem problem;
    bat_model model;
    *out = (levelled){NULL, NULL};
    if (!reader_of(name)) return read_data(name, levelled_of, out, &problem);
    int failed = read_only_one(name, "surface", &model);
    if (failed) return failed;
    out->surface = model.surfaces[0];
    model.surfaces[0] = NULL;
    bat_model_clear(&model);
    return EXIT_DONE;
}

int read_surface(const char *name, bat_surface **out) {
    levelled read;
    int failed = read_levelled(name, &read);
    if (failed) return failed;
    if (read.relief) {
        const bat_surface *finest = bat_relief_surface(read.relief, bat_relief_levels(read.relief));
        if (bat_surface_copy(finest, &read.surface) != BAT_OK) failed = fail_memory();
        bat_relief_free(read.relief);
    }
    if (!failed) *out = read.surface;
    return failed;
}

int read_relief(const char *name, bat_relief **out) {
    levelled read;
    int failed = read_levelled(name, &read);
    if (failed) return failed;
    if (read.surface && bat_relief_create(read.surface, &read.relief) != BAT_OK) failed = fail_memory();
    bat_surface_free(read.surface);
    if (!failed) *out = read.relief;
    return failed;
}

int read_stroke(const char *name, bat_stroke *out, void **block) {
    bat_problem problem;
    return read_data(name, stroke_of, &(stroke_to){out, block}, &problem);
}

void put_numbers(bat_text *text, const double *numbers, size_t count) {
    bat_text_string(text, "[");
    for (size_t i = 0; i < count; i++) {
        if (i) bat_text_string(text, ",");
        bat_text_number(text, numbers[i]);
    }
    bat_text_string(text, "]");
}

void put_points(bat_text *text, const double *numbers, size_t count, int dimension, size_t stride) {
    bat_text_string(text, "[");
    for (size_t i = 0; i < count; i++) {
        if (i) bat_text_string(text, ",");
        put_numbers(text, numbers + i * stride, (size_t)dimension);
    }
    bat_text_string(text, "]");
}

int write_text(bat_text *text) {
    bat_text_string(text, "\n");
    char *data;
    size_t size;
    if (bat_text_finish(text, &data, &size) != BAT_OK) return fail_memory();
    int failed = io_write("-", data, size);
    bat_free(data);
    return failed;
}

static const char *back_to;
static bool back_lossy;

void write_back_to(const char *file, bool lossy) { back_to = file, back_lossy = lossy; }

int write_curve(const bat_curve *curve) {
    if (back_to) return address_write(curve, back_to, back_lossy);
    char *data;
    size_t size;
    if (bat_curve_write(curve, &data, &size) != BAT_OK) return fail_memory();
    int failed = io_write("-", data, size);
    bat_free(data);
    return failed;
}

static void put_flag(bat_text *text, bool flag) { bat_text_string(text, flag ? "true" : "false"); }

/* The members of a report, without the last brace. */
static void put_report(bat_text *text, const bat_sketch_report *report) {
    bat_text_string(text, "{\"max_error\":");
    bat_text_number(text, report->max_error);
    bat_text_string(text, ",\"noise\":");
    bat_text_number(text, report->noise);
    bat_text_string(text, ",\"knots_before\":");
    bat_text_integer(text, (uint64_t)report->knots_before);
    bat_text_string(text, ",\"knots_after\":");
    bat_text_integer(text, (uint64_t)report->knots_after);
    bat_text_string(text, ",\"solves\":");
    bat_text_integer(text, (uint64_t)report->solves);
    bat_text_string(text, ",\"changed\":");
    put_numbers(text, report->changed, 2);
    bat_text_string(text, ",\"changed_new\":");
    put_numbers(text, report->changed_new, 2);
    bat_text_string(text, ",\"transition\":");
    put_numbers(text, report->transition, 2);
    bat_text_string(text, ",\"reversed\":");
    put_flag(text, report->reversed);
    bat_text_string(text, ",\"extended\":[");
    put_flag(text, report->extended[0]);
    bat_text_string(text, ",");
    put_flag(text, report->extended[1]);
    bat_text_string(text, "],\"replaced\":");
    put_flag(text, report->replaced);
}

/* Adds an object, which is released, with the report as its last member ("": without one). */
static void put_reported(bat_text *text, char *data, size_t size, const char *report) {
    while (size && data[size - 1] != '}') size--;
    if (*report) {
        size -= size > 0;
        while (size && (data[size - 1] == '\n' || data[size - 1] == ' ')) size--;
    }
    bat_text_add(text, data, size);
    bat_free(data);
    if (!*report) return;
    bat_text_string(text, ",\n  \"report\": ");
    bat_text_string(text, report);
    bat_text_string(text, "\n}");
}

/* The report as text, which is the caller's (bat_free); it is released. NULL: "". */
static char *take_report(bat_text *report) {
    bat_text nothing = {0};
    char *text = NULL;
    size_t size;
    return bat_text_finish(report ? report : &nothing, &text, &size) == BAT_OK ? text : NULL;
}

/* Writes an object with its report. Releases both. */
static int write_reported(char *data, size_t size, bat_text *report) {
    bat_text text = {0};
    char *end = take_report(report);
    if (!end) {
        bat_free(data);
        return fail_memory();
    }
    put_reported(&text, data, size, end);
    bat_free(end);
    return write_text(&text);
}

int write_curves(size_t count, bat_curve *const *curves, bat_text *report) {
    bat_text text = {0};
    char *end = take_report(report);
    bool made = end != NULL;
    bat_text_string(&text, "[");
    for (size_t i = 0; i < count && made; i++) {
        char *data;
        size_t size;
        made = bat_curve_write(curves[i], &data, &size) == BAT_OK;
        if (i) bat_text_string(&text, ",\n");
        if (made) put_reported(&text, data, size, end);
    }
    bat_text_string(&text, "]");
    bat_free(end);
    if (made) return write_text(&text);
    bat_text_free(&text);
    return fail_memory();
}

int write_curves_within(size_t count, bat_curve **curves, double max_error) {
    bat_text report = {0};
    bat_text_string(&report, "{\"max_error\":");
    bat_text_number(&report, max_error);
    bat_text_string(&report, "}");
    const int failed = write_curves(count, curves, &report);
    bat_curves_free(count, curves);
    return failed;
}

static int write_back(const bat_curve *curve, bat_text *report) {
    int failed = address_write(curve, back_to, back_lossy);
    char *line = NULL;
    size_t size;
    if (!report) return failed;
    if (bat_text_finish(report, &line, &size) != BAT_OK) return fail_memory();
    if (!failed) remark("{\"report\":%s}", line);
    bat_free(line);
    return failed;
}

int write_curve_reported(const bat_curve *curve, bat_text *report) {
    if (back_to) return write_back(curve, report);
    char *data;
    size_t size;
    if (bat_curve_write(curve, &data, &size) == BAT_OK) return write_reported(data, size, report);
    bat_text_free(report);
    return fail_memory();
}

int write_sketch(const bat_curve *curve, const bat_sketch_report *report) {
    bat_text text = {0};
    put_report(&text, report);
    bat_text_string(&text, "}");
    return write_curve_reported(curve, &text);
}

int write_pen(const bat_curve *curve, const bat_sketch_report *report, double raw_error) {
    bat_text text = {0};
    put_report(&text, report);
    bat_text_string(&text, ",\"raw_error\":");
    bat_text_number(&text, raw_error);
    bat_text_string(&text, "}");
    return write_curve_reported(curve, &text);
}

int write_surface(const bat_surface *surface, bat_text *report) {
    char *data;
    size_t size;
    if (bat_surface_write(surface, &data, &size) == BAT_OK) return write_reported(data, size, report);
    if (report) bat_text_free(report);
    return fail_memory();
}

int write_mesh(const bat_polymesh *mesh, bat_text *report) {
    char *data;
    size_t size;
    if (bat_polymesh_write(mesh, &data, &size) == BAT_OK) return write_reported(data, size, report);
    bat_text_free(report);
    return fail_memory();
}

int fail_sketch(const char *stroke, bat_status status, const bat_sketch_report *report,
                const bat_sketch_options *options) {
    const double tolerance = options->tolerance > 0 ? options->tolerance : options->pixel;
    char reached[BAT_NUMBER_ROOM], asked[BAT_NUMBER_ROOM];
    switch (status) {
    case BAT_MEMORY: return fail_memory();
    case BAT_DOT:
        return fail_data(stroke, "points", "expected a stroke, found one too short to mean anything");
    case BAT_FAR:
        return fail_data(stroke, "points", "expected a stroke near the curve, found one too far from it");
    case BAT_TOLERANCE:
        bat_number_print(report->max_error, reached);
        bat_number_print(tolerance, asked);
        return fail_data(stroke, "points", "expected a fit within %s%s, the best found reaches %s", asked,
                         report->max_error <= tolerance ? " with room to smooth it" : "", reached);
    default: return fail_data(stroke, NULL, "%s", bat_status_message(status));
    }
}
