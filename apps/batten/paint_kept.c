#include "paint_kept.h"
#include "paint_rsvg.h"

#include "document/picture.h"
#include "format/svg/markup.h"
#include "text/base64.h"
#include "text/text.h"

#include <stdlib.h>
#include <string.h>

/* The last pictures that were needed, as far as they take no more bytes than that: of the last one any number. */
enum { LISTED = 64, BYTES_MAX = 1 << 26 };

typedef struct read_picture {
    uint64_t digest;
    bool tile; /* else it is the picture as it was read */
    double opacity;
    int pixels[2];
    cairo_surface_t *surface;
    void *handle; /* of librsvg */
    bool good;    /* it can be painted */
    bool whole;   /* all of it, as far as can be told */
    size_t bytes;
} read_picture;

struct paint_kept {
    rsvg_library with;
    bool asked, loaded;
    read_picture list[LISTED]; /* the oldest first */
    int count;
    size_t bytes;
};

/* ---- the list ---- */

static void drop_first(paint_kept *k) {
    read_picture *first = &k->list[0];
    cairo_surface_destroy(first->surface);
    if (first->handle) k->with.release(first->handle);
    k->bytes -= first->bytes;
    memmove(k->list, k->list + 1, (size_t)--k->count * sizeof *k->list);
}

static const read_picture *keep(paint_kept *k, read_picture made) {
    while (k->count == LISTED || (k->count > 0 && k->bytes + made.bytes > BYTES_MAX)) drop_first(k);
    k->bytes += made.bytes;
    k->list[k->count] = made;
    return &k->list[k->count++];
}

static void end(void *kept) {
    paint_kept *k = kept;
    while (k->count > 0) drop_first(k);
    free(k);
}

paint_kept *paint_kept_of(cairo_t *cairo) {
    static const cairo_user_data_key_t key;
    paint_kept *k = cairo_get_user_data(cairo, &key);
    if (k || !(k = calloc(1, sizeof *k))) return k;
    if (cairo_set_user_data(cairo, &key, k, end) == CAIRO_STATUS_SUCCESS) return k;
    free(k);
    return NULL;
}

/* ---- reading ---- */

typedef struct bytes_left {
    const unsigned char *at;
    size_t left;
} bytes_left;

static cairo_status_t read_bytes(void *host, unsigned char *to, unsigned count) {
    bytes_left *r = host;
    if (count > r->left) return CAIRO_STATUS_READ_ERROR;
    memcpy(to, r->at, count);
    r->at += count, r->left -= count;
    return CAIRO_STATUS_SUCCESS;
}

static void read_png(const bat_picture *picture, read_picture *out) {
    bytes_left r;
    r.at = bat_picture_bytes(picture, &r.left);
    out->surface = cairo_image_surface_create_from_png_stream(read_bytes, &r);
    out->good = out->whole = cairo_surface_status(out->surface) == CAIRO_STATUS_SUCCESS;
    out->bytes = (size_t)cairo_image_surface_get_stride(out->surface) *
                 (size_t)cairo_image_surface_get_height(out->surface);
}

/* From the pixels of a JPEG, one of which is a unit, to the picture as it is meant to be seen, of those sides. */
static void find_turn(uint32_t turn, const double sides[2], double m[6]) {
    static const signed char turns[8][4] = {{1, 0, 0, 1}, {-1, 0, 0, 1}, {-1, 0, 0, -1}, {1, 0, 0, -1},
                                            {0, 1, 1, 0}, {0, 1, -1, 0}, {0, -1, -1, 0}, {0, -1, 1, 0}};
    const signed char *t = turns[turn - 1];
    for (int k = 0; k < 4; k++) m[k] = t[k];
    for (int k = 0; k < 2; k++) m[4 + k] = t[k] < 0 || t[2 + k] < 0 ? sides[k] : 0;
}

/* Its bytes, without the mark of Exif data: whether librsvg turns the picture by these depends on its version. */
static void write_bytes(const unsigned char *bytes, size_t size, bool turned, bat_text *out) {
    unsigned char *copy = malloc(size);
    if (!copy) {
        out->failed = true;
        return;
    }
    memcpy(copy, bytes, size);
    for (size_t i = 0; turned && i + 10 <= size; i++)
        if (copy[i] == 0xff && copy[i + 1] == 0xe1 && memcmp(copy + i + 4, "Exif", 4) == 0) copy[i + 4] = 'e';
    bat_base64_write(out, copy, size);
    free(copy);
}

/* A file of nothing else than the picture. */
static void wrap(const bat_picture *picture, bat_text *out) {
    static const char head[] = "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                               "xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"";
    static const char *const names[] = {head, "\" height=\"",
                                        "\"><image preserveAspectRatio=\"none\" width=\"", "\" height=\""};
    double sides[2], m[6];
    size_t size;
    const unsigned char *bytes = bat_picture_bytes(picture, &size);
    const uint32_t turn = bat_picture_turn(bytes, size);
    bat_picture_sides(picture, sides);
    find_turn(turn, sides, m);
    const int across = m[0] == 0; /* the pixels lie across */
    for (int k = 0; k < 4; k++) {
        bat_text_string(out, names[k]);
        bat_text_integer(out, (uint64_t)sides[k < 2 ? k : (k + across) % 2]);
    }
    bat_text_string(out, "\" transform=\"");
    bat_svg_write_matrix(m, out);
    bat_text_string(out, "\" xlink:href=\"data:");
    bat_text_string(out, bat_picture_type(picture));
    bat_text_string(out, ";base64,");
    write_bytes(bytes, size, turn > 1, out);
    bat_text_string(out, "\"/></svg>");
}

/* Whether anything of it is seen. */
static bool shows(const paint_kept *k, void *handle) {
    enum { SIDE = 16 };
    const rsvg_rectangle all = {0, 0, SIDE, SIDE};
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, SIDE, SIDE);
    cairo_t *cairo = cairo_create(surface);
    void *error = NULL;
    bool any = false;
    const bool painted = k->with.paint(handle, cairo, &all, &error) != 0;
    cairo_surface_flush(surface);
    const unsigned char *bytes = cairo_image_surface_get_data(surface);
    const size_t count = (size_t)cairo_image_surface_get_stride(surface) * SIDE;
    for (size_t i = 0; bytes && painted && i < count; i++) any = any || bytes[i];
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    return any;
}

static bool holds_image(const char *text, size_t size) {
    for (size_t i = 0; i + 6 <= size; i++)
        if ((text[i] == '<' || text[i] == ':') && memcmp(text + i + 1, "image", 5) == 0) return true;
    return false;
}

static void read_by_rsvg(const paint_kept *k, const bat_picture *picture, read_picture *out) {
    size_t size;
    const void *bytes = bat_picture_bytes(picture, &size);
    out->bytes = size;
    if (!k->loaded) return;
    if (strcmp(bat_picture_type(picture), "image/svg+xml") == 0) {
        out->handle = rsvg_read(&k->with, bytes, size, false);
        out->good = out->handle != NULL;
        out->whole = out->good && (!holds_image(bytes, size) || shows(k, out->handle));
        return;
    }
    bat_text text = {0};
    wrap(picture, &text);
    if (!text.failed) out->handle = rsvg_read(&k->with, text.data, text.size, true);
    bat_text_free(&text);
    out->good = out->handle != NULL;
    out->whole = out->good && shows(k, out->handle);
}

static const read_picture *read_of(paint_kept *k, const bat_picture *picture) {
    const uint64_t digest = bat_picture_digest(picture);
    for (int i = 0; i < k->count; i++)
        if (!k->list[i].tile && k->list[i].digest == digest) return &k->list[i];
    read_picture made = {.digest = digest};
    if (strcmp(bat_picture_type(picture), "image/png") == 0)
        read_png(picture, &made);
    else {
        if (!k->asked) k->loaded = rsvg_load(&k->with);
        k->asked = true;
        read_by_rsvg(k, picture, &made);
    }
    return keep(k, made);
}

/* ---- painting ---- */

bool paint_is_whole(paint_kept *kept, const bat_picture *picture) { return read_of(kept, picture)->whole; }

/* Up to its edges, however large its pixels are. */
static void paint_pixels(cairo_t *cairo, cairo_surface_t *surface, const double sides[2]) {
    cairo_set_source_surface(cairo, surface, 0, 0);
    cairo_pattern_set_extend(cairo_get_source(cairo), CAIRO_EXTEND_PAD);
    cairo_rectangle(cairo, 0, 0, sides[0], sides[1]);
    cairo_fill(cairo);
}

bool paint_picture(paint_kept *kept, cairo_t *cairo, const bat_picture *picture) {
    const read_picture *read = read_of(kept, picture);
    double sides[2];
    void *error = NULL;
    bat_picture_sides(picture, sides);
    if (!read->good) return false;
    const rsvg_rectangle all = {0, 0, sides[0], sides[1]};
    if (read->handle) return kept->with.paint(read->handle, cairo, &all, &error) != 0;
    paint_pixels(cairo, read->surface, sides);
    return true;
}

static bool fill_tile(paint_kept *kept, const bat_picture *picture, const read_picture *tile) {
    double sides[2];
    bat_picture_sides(picture, sides);
    cairo_t *cairo = cairo_create(tile->surface);
    if (tile->pixels[0] > 0) cairo_scale(cairo, tile->pixels[0] / sides[0], tile->pixels[1] / sides[1]);
    if (tile->opacity < 1) cairo_push_group(cairo);
    bool painted = paint_picture(kept, cairo, picture);
    if (tile->opacity < 1) {
        cairo_pop_group_to_source(cairo);
        cairo_paint_with_alpha(cairo, tile->opacity);
    }
    painted = painted && cairo_status(cairo) == CAIRO_STATUS_SUCCESS;
    cairo_destroy(cairo);
    return painted;
}

cairo_surface_t *paint_tile_surface(paint_kept *kept, const bat_picture *picture, double opacity,
                                    const int pixels[2]) {
    read_picture made = {.digest = bat_picture_digest(picture), .tile = true, .opacity = opacity};
    double sides[2];
    memcpy(made.pixels, pixels, sizeof made.pixels);
    for (int i = 0; i < kept->count; i++) {
        const read_picture *at = &kept->list[i];
        if (at->tile && at->digest == made.digest && at->opacity == opacity &&
            memcmp(at->pixels, pixels, sizeof at->pixels) == 0)
            return at->surface;
    }
    bat_picture_sides(picture, sides);
    const cairo_rectangle_t extents = {0, 0, sides[0], sides[1]};
    made.surface = pixels[0] > 0 ? cairo_image_surface_create(CAIRO_FORMAT_ARGB32, pixels[0], pixels[1])
                                 : cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, &extents);
    made.bytes = 4 * (size_t)pixels[0] * (size_t)pixels[1];
    if (fill_tile(kept, picture, &made)) return keep(kept, made)->surface;
    cairo_surface_destroy(made.surface);
    return NULL;
}
