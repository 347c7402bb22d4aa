#include "views.h"

#include "results.h"

#include <batten/bezier.h>
#include <batten/format.h>

static bat_status view_of(const char *data, size_t size, void *out, bat_problem *problem) {
    return bat_viewpoint_read(data, size, out, problem);
}

int read_view(const char *name, bat_viewpoint *out) {
    bat_problem problem;
    return read_data(name, view_of, out, &problem);
}

int read_pixels(const char *name, bat_stroke *out, void **block) {
    int failed = read_stroke(name, out, block);
    if (failed || out->dimension == 2) return failed;
    bat_free(*block);
    return fail_data(name, "points", "expected samples of 2 numbers, in pixels, found 3");
}
