/* batten cast: a stroke in the pixels of a view lands on a plane, a ruled surface or a surface. */
#include "program.h"
#include "results.h"
#include "views.h"

#include <batten/format.h>
#include <stdlib.h>

static bat_status canvas_of(const char *data, size_t size, void *out, bat_problem *problem) {
    return bat_canvas_read(data, size, out, problem);
}

static void put_dropped(bat_text *text, const bat_cast_point *cast, size_t count) {
    static const char *const why[] = {"", "edge-on", "miss", "behind", "far"};
    const char *separator = "";
    bat_text_string(text, ",\n\"dropped\":[");
    for (size_t i = 0; i < count; i++) {
        if (cast[i].fate == BAT_CAST_LANDED) continue;
        bat_text_string(text, separator);
        bat_text_string(text, "{\"index\":");
        bat_text_integer(text, i);
        bat_text_string(text, ",\"why\":\"");
        bat_text_string(text, why[cast[i].fate]);
        bat_text_string(text, "\"}");
        separator = ",";
    }
    bat_text_string(text, "]");
}

/* Puts what landed first, and returns how many. */
static size_t gather(bat_cast_point *cast, size_t count) {
    size_t kept = 0;
    for (size_t i = 0; i < count; i++)
        if (cast[i].fate == BAT_CAST_LANDED) cast[kept++] = cast[i];
    return kept;
}

static void put_list(bat_text *text, const char *name, const bat_cast_point *cast, size_t count, int own) {
    bat_text_string(text, name);
    for (size_t i = 0; i < count; i++) {
        if (i) bat_text_string(text, ",");
        if (own < 2)
            bat_text_number(text, cast[i].own[own]);
        else
            put_numbers(text, own == 2 ? cast[i].own : cast[i].point, (size_t)own);
    }
    bat_text_string(text, "]");
}

static int print(const bat_canvas *canvas, bat_cast_point *cast, size_t count) {
    bat_text text = {0}, dropped = {0};
    put_dropped(&dropped, cast, count);
    const size_t kept = gather(cast, count);
    put_list(&text, "{\"points\":[", cast, kept, 3);
    bat_text_add(&text, dropped.data, dropped.size);
    text.failed |= dropped.failed;
    bat_text_free(&dropped);
    if (canvas->curve) {
        put_list(&text, ",\n\"s\":[", cast, kept, 0);
        put_list(&text, ",\n\"h\":[", cast, kept, 1);
    } else if (canvas->surface) {
        put_list(&text, ",\n\"uv\":[", cast, kept, 2);
    }
    bat_text_string(&text, "}");
    return write_text(&text);
}

static int cast_stroke(const char *name, const bat_viewpoint *view, const bat_canvas *canvas) {
    bat_stroke stroke;
    void *block;
    int failed = read_pixels(name, &stroke, &block);
    if (failed) return failed;
    size_t landed = 0;
    bat_cast_point *cast = malloc((stroke.count + 1) * sizeof *cast);
    bat_status status = cast ? bat_cast(view, &stroke, canvas, cast, &landed) : BAT_MEMORY;
    if (status == BAT_MEMORY)
        failed = fail_memory();
    else if (status != BAT_OK)
        failed = fail_data(name, NULL, "%s", bat_status_message(status));
    else if (landed == 0)
        failed = fail_data(name, "points", "expected samples that land, found none of %zu", stroke.count);
    else
        failed = print(canvas, cast, stroke.count);
    free(cast);
    bat_free(block);
    return failed;
}

static int run(const cli_arguments *arguments) {
    bat_viewpoint view;
    bat_canvas canvas = {.curve = NULL};
    bat_problem problem;
    int failed = arguments_one_input(arguments, 3, "the files");
    if (!failed) failed = read_view(arguments->operands[1], &view);
    if (!failed) failed = read_data(arguments->operands[2], canvas_of, &canvas, &problem);
    if (!failed) failed = cast_stroke(arguments->operands[0], &view, &canvas);
    bat_canvas_clear(&canvas);
    return failed;
}

const cli_command command_cast = {
    .name = "cast",
    .usage = "STROKE VIEW ON",
    .summary = "Casts a stroke on a plane, on the ruled surface of a curve, or on a surface.",
    .details = "STROKE is in pixels of VIEW. ON is {\"plane\":{\"origin\", \"normal\"}}, {\"curve\":CURVE, "
               "\"along\":[x,y,z]}\nor a SURFACE. The result is {\"points\", \"dropped\"} with, on a curve, "
               "\"s\" and "
               "\"h\", on a surface \"uv\".\nA sample is dropped where ON is seen edge-on, is missed, lies "
               "behind the "
               "eye or, ruled, too far away.",
    .example = "batten cast stroke.json view.json ground.json",
    .operands = 3,
    .run = run,
};
