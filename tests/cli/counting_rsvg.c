/* Stands for librsvg and its library of objects where a test counts what the program asks of them: it reads anything, paints black,
 * and writes how often it did so to the file that RSVG_COUNTS names. RSVG_REFUSES: it reads nothing. */
#include <cairo.h>
#include <stdio.h>
#include <stdlib.h>

static int read, painted, released;

void *rsvg_handle_new_with_flags(int flags) {
    (void)flags;
    return malloc(1);
}

int rsvg_handle_write(void *handle, const unsigned char *data, size_t size, void **error) {
    (void)handle, (void)data, (void)size, (void)error;
    return 1;
}

int rsvg_handle_close(void *handle, void **error) {
    (void)handle, (void)error;
    if (getenv("RSVG_REFUSES")) return 0;
    read++;
    return 1;
}

int rsvg_handle_render_document(void *handle, cairo_t *cairo, const double *viewport, void **error) {
    (void)handle, (void)error;
    cairo_set_source_rgb(cairo, 0, 0, 0);
    cairo_rectangle(cairo, viewport[0], viewport[1], viewport[2], viewport[3]);
    cairo_fill(cairo);
    painted++;
    return 1;
}

void g_object_unref(void *object) {
    free(object);
    released++;
}

__attribute__((destructor)) static void tell(void) {
    const char *name = getenv("RSVG_COUNTS");
    FILE *file = name ? fopen(name, "w") : NULL;
    if (!file) return;
    fprintf(file, "%d %d %d\n", read, painted, released);
    fclose(file);
}
