#include "address.h"

#include "document/follow.h"
#include "io.h"
#include "text/number.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { LIST_ROOM = 160 }; /* characters of a list of ids */

/* The parts of an address; file and name are one block. */
typedef struct address {
    char *file, *name;
    int curve;
} address;

/* The place of the first address that was read. */
static struct {
    drawing_file drawing;
    char *file;
    int object, curve;
} first;

static const char *hash_in(const char *word) {
    const char *hash = strrchr(word, '#');
    return hash && hash > word && hash[1] ? hash : NULL;
}

bool is_address(const char *word) {
    struct stat status;
    return hash_in(word) && stat(word, &status) != 0;
}

/* "/12" at the end of a name: which curve; the name ends before it. */
static void take_number(address *a) {
    char *slash = strrchr(a->name, '/');
    if (!slash || slash == a->name || !slash[1] || strlen(slash) > 9) return;
    if (strspn(slash + 1, "0123456789") != strlen(slash + 1)) return;
    a->curve = atoi(slash + 1);
    *slash = '\0';
}

bool address_names(const bat_object *object, const char *name) {
    char id[32];
    snprintf(id, sizeof id, "%llu", (unsigned long long)bat_object_id(object));
    return strcmp(bat_object_name(object), name) == 0 || strcmp(id, name) == 0;
}

/* Several objects bear the name: says their ids. */
static int fail_several(const address *a, const bat_document *document) {
    char ids[LIST_ROOM] = "";
    size_t used = 0;
    for (int i = 0; i < bat_document_count(document) && used + 24 < sizeof ids; i++) {
        const bat_object *object = bat_document_at(document, i);
        if (address_names(object, a->name))
            used += (size_t)snprintf(ids + used, sizeof ids - used, "%s%llu", used ? ", " : "",
                                     (unsigned long long)bat_object_id(object));
    }
    return fail_data(a->file, a->name, "expected one object of that name, found those with the ids %s", ids);
}

static int find(const address *a, const bat_document *document, int *out) {
    int found = -1;
    for (int i = 0; i < bat_document_count(document); i++) {
        if (!address_names(bat_document_at(document, i), a->name)) continue;
        if (found >= 0) return fail_several(a, document);
        found = i;
    }
    if (found < 0) return fail_data(a->file, a->name, "expected an object of that name or id, found none");
    const int count = bat_object_curve_count(bat_document_at(document, found));
    if (a->curve >= count)
        return fail_data(a->file, a->name, "expected a curve %d, found %d curve%s", a->curve, count,
                         count == 1 ? "" : "s");
    *out = found;
    return EXIT_DONE;
}

static int read_at(const address *a, bat_curve **out) {
    const bat_svg_options options = bat_svg_merging();
    drawing_file drawing;
    int object = 0, failed = drawing_read(a->file, &options, &drawing);
    if (failed) return failed;
    failed = find(a, drawing.document, &object);
    if (!failed &&
        bat_curve_copy(bat_object_curve(bat_document_at(drawing.document, object), a->curve), out) != BAT_OK)
        failed = fail_memory();
    if (failed || first.file) {
        drawing_free(&drawing);
        return failed;
    }
    first.drawing = drawing, first.object = object, first.curve = a->curve, first.file = a->file;
    return EXIT_DONE;
}

int address_read(const char *word, bat_curve **out) {
    const size_t size = strlen(word) + 1, at = (size_t)(hash_in(word) - word);
    address a = {.file = malloc(size)};
    if (!a.file) return fail_memory();
    memcpy(a.file, word, size);
    a.file[at] = '\0';
    a.name = a.file + at + 1;
    take_number(&a);
    const int failed = read_at(&a, out);
    if (first.file != a.file) free(a.file);
    return failed;
}

int address_read_drawing(const char *word, drawing_file *out) {
    bat_curve *curve = NULL;
    bat_object *object = NULL;
    const int failed = address_read(word, &curve);
    if (failed) return failed;
    *out = (drawing_file){.format = bat_format_named("json")};
    const bat_style style = bat_style_defaults();
    bat_status status = bat_document_create(&out->document);
    if (status != BAT_OK) bat_curve_free(curve);
    if (status == BAT_OK) status = bat_object_create_path(1, "", &style, 1, &curve, &object);
    if (status == BAT_OK) status = bat_document_insert(out->document, 0, object);
    bat_object_release(object);
    if (status != BAT_OK) bat_document_free(out->document);
    return status == BAT_OK ? EXIT_DONE : fail_memory();
}

/* What an object loses when another curve takes the place of one of its own. */
static void remark_lost(const bat_object *object) {
    if (bat_object_spline(object))
        remark("%s: the object is a path now, without the directions of its spline", first.file);
    else if (bat_object_shape(object, first.curve))
        remark("%s: the curve has no levels any more", first.file);
}

static int put_in_place(const bat_curve *curve) {
    bat_document *document = first.drawing.document;
    const bat_object *object = bat_document_at(document, first.object);
    bat_curve *copy = NULL;
    bat_object *changed = NULL;
    if (!bat_object_is_made_of_curves(object))
        return fail_data(first.file, bat_object_name(object), "expected an object of curves, found another");
    bat_status status = bat_curve_copy(curve, &copy);
    if (status == BAT_OK) status = bat_object_with_curve(object, first.curve, copy, &changed);
    if (status == BAT_OK) remark_lost(object);
    if (status == BAT_OK) status = bat_document_replace(document, first.object, changed);
    if (status == BAT_OK) status = bat_document_follow(document);
    bat_object_release(changed);
    return status == BAT_OK ? EXIT_DONE : fail_data(first.file, NULL, "%s", bat_status_message(status));
}

int address_write(const bat_curve *curve, const char *file, bool lossy) {
    if (!first.file)
        return fail_data(file, NULL, "expected the curve to come from a drawing, FILE#NAME, found another");
    const bat_format *format = drawing_format(file);
    if (!format) format = first.drawing.format;
    char *text;
    size_t size;
    int failed = drawing_may_replace(lossy, &first.drawing, first.file, file, false);
    if (!failed) failed = put_in_place(curve);
    if (!failed)
        failed = drawing_print_over(first.drawing.document, format,
                                    &(drawing_writing){first.file, file, lossy}, &text, &size);
    if (failed) return failed;
    failed = io_write(file, text, size);
    bat_free(text);
    if (!failed && !(format->keeps && drawing_keeps_file(&first.drawing)))
        drawing_remark(first.file, &first.drawing);
    return failed;
}

void address_release(void) {
    if (first.file) drawing_free(&first.drawing);
    free(first.file);
    first.file = NULL;
}
