/* Reads the curves of an SVG file, simplifies them, moves their outlines apart, unites what overlaps, and writes an SVG file.
 * Usage: outline drawing.svg outline.svg */
#include <batten/batten.h>
#include <batten/svg_read.h>

#include <stdio.h>
#include <stdlib.h>

static void must(bat_status status) {
    if (status == BAT_OK) return;
    fprintf(stderr, "%s\n", bat_status_message(status));
    exit(1);
}

int main(int argc, char **argv) {
    static char text[1 << 16];
    FILE *file = argc > 2 ? fopen(argv[1], "rb") : NULL;
    if (file == NULL) return 2;
    const size_t size = fread(text, 1, sizeof text, file);
    fclose(file);
    bat_document *drawing = NULL, *out = NULL;
    bat_problem problem;
    if (bat_svg_read(text, size, NULL, &drawing, NULL, &problem) != BAT_OK) {
        fprintf(stderr, "%s: %s: %s\n", argv[1], problem.place, problem.message);
        return 1;
    }
    enum { MOST = 64 };
    bat_region regions[MOST];
    size_t apart = 0;
    for (int i = 0; i < bat_document_count(drawing); i++) {
        const bat_object *object = bat_document_at(drawing, i);
        for (int k = 0; k < bat_object_curve_count(object); k++) {
            bat_curve *simple = NULL, **parallel = NULL;
            size_t count = 0;
            must(bat_curve_simplify(bat_object_curve(object, k), 0.05, 0.05, &simple, NULL));
            const double outward = bat_curve_area(simple) > 0 ? -3 : 3;
            must(bat_curve_offset(simple, outward, 0.01, 0.05, &count, &parallel, NULL));
            bat_curve_free(simple);
            for (size_t j = 0; j < count && apart < MOST; j++) /* kept until the program ends */
                regions[apart++] = (bat_region){1, (const bat_curve *const *)&parallel[j], false};
        }
    }
    size_t count = 0, length = 0;
    bat_curve **united = NULL;
    must(bat_regions_combine(BAT_REGION_UNION, apart, regions, 0.01, &count, &united));

    bat_style style = bat_style_defaults();
    style.filled = true, style.stroked = false;
    bat_object *object = NULL;
    char *written = NULL;
    must(bat_document_create(&out));
    must(bat_document_set_page(out, (double[]){0, 0, 120, 80}));
    must(bat_object_create_path(bat_document_new_id(out), "outline", &style, (int)count, united, &object));
    must(bat_document_insert(out, 0, object));
    must(bat_svg_write(out, false, &written, &length));
    file = fopen(argv[2], "wb");
    if (file == NULL || fwrite(written, 1, length, file) != length || fclose(file) != 0) return 2;
    printf("%d objects, %zu outlines, %zu united\n", bat_document_count(drawing), apart, count);
    return 0;
}
