/* Any bytes as path data, transforms, lengths and colours. Outlines contain no NaN, closed subpaths end where
 * they begin, and parsing path data a second time gives the same result, even after an error. Numbers are
 * finite. */
#include "format/svg/svg.h"
#include "format/svg/style.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bat_outline outline = {0}, again = {0};
    const char *text = (const char *)data;
    bool good = bat_svg_path(text, size, &outline);
    for (size_t i = 0; i < 2 * outline.count; i++)
        if (isnan(outline.points[i])) abort();
    for (int i = 0; i < outline.subpath_count; i++) {
        const bat_subpath *path = &outline.subpaths[i];
        const double *first = outline.points + 2 * path->first, *last = first + 6 * path->segments;
        if (path->segments < 1) abort();
        if (path->from > path->drawn || path->drawn >= size) abort();
        if (i > 0 && path->from <= path[-1].drawn) abort();
        if (path->closed && (first[0] != last[0] || first[1] != last[1])) abort();
    }
    if (bat_svg_path(text, size, &again) != good || again.count != outline.count) abort();
    if (outline.count > 0 && memcmp(again.points, outline.points, 2 * outline.count * sizeof(double)) != 0)
        abort();
    bat_outline_free(&outline);
    bat_outline_free(&again);

    char *copy = malloc(size + 1);
    if (!copy) return 0;
    memcpy(copy, data, size);
    copy[size] = '\0';
    double m[6], box[4], length;
    uint32_t colour;
    bat_svg_transform(copy, m);
    for (int i = 0; i < 6; i++)
        if (!isfinite(m[i])) abort();
    if (bat_svg_length(copy, 100, &length) && !isfinite(length)) abort();
    bat_svg_view_box(copy, box);
    bat_svg_colour(copy, &colour);
    free(copy);
    return 0;
}
