/* Texts: lettering in one colour, placed by a matrix. What it looks like is a picture that it makes itself. */
#include "base/pose.h"
#include "base/matrix.h"
#include "document/digest.h"
#include "document/lettering.h"
#include "document/placed.h"
#include "format/json/fields.h"
#include "format/json/lettering.h"
#include "format/json/style.h"
#include "kinds/kinds.h"

typedef struct text {
    bat_placed shown; /* its picture belongs to `lettered` */
    double place[6];  /* from units of the lettering to the document */
    bat_lettered *lettered;
} text;

static const char expected_matrix[] = "six numbers that do not flatten";

static void share(const void *own) { (void)bat_lettered_retain(((const text *)own)->lettered); }
static void end(void *own) { bat_lettered_release(((text *)own)->lettered); }

static bat_status set(bat_lettered *lettered, const double place[6], text *out) {
    double from_pixels[6], matrix[6];
    bat_picture *picture = bat_lettered_picture(lettered);
    if (!bat_drawing_matrix(picture, from_pixels)) return BAT_NUMBER;
    bat_matrix_compose(place, from_pixels, matrix);
    out->lettered = lettered;
    for (int i = 0; i < 6; i++) out->place[i] = place[i] + 0.0; /* -0 becomes 0 */
    return bat_placed_set(picture, matrix, &out->shown);
}

/* object NULL: a new one, of that id, name and style. Takes `lettered` over. */
static bat_status make(const bat_object *object, bat_id id, const char *name, const bat_style *style,
                       bat_lettered *lettered, const double place[6], bat_object **out) {
    text own;
    bat_status status = set(lettered, place, &own);
    if (status == BAT_OK)
        status = object ? bat_object_remake(object, &bat_kind_of_text, &own, 0, NULL, out)
                        : bat_object_make(&bat_kind_of_text, id, name, style, &own, 0, NULL, out);
    if (status != BAT_OK) bat_lettered_release(lettered);
    return status;
}

bat_status bat_object_create_text(bat_id id, const char *name, const bat_lettering *lettering,
                                  const double place[6], uint32_t colour, double opacity, bat_object **out) {
    bat_lettered *lettered = NULL;
    if (!lettering || !place || !out || !(opacity >= 0 && opacity <= 1)) return BAT_ARGUMENT;
    bat_style style = bat_style_defaults();
    style.stroked = false;
    style.filled = true;
    style.fill = colour;
    style.opacity = opacity;
    const bat_status status = bat_lettered_create(lettering, colour, &lettered);
    return status == BAT_OK ? make(NULL, id, name, &style, lettered, place, out) : status;
}

static const text *own_of(const bat_object *object) { return bat_object_own(object, &bat_kind_of_text); }

bat_status bat_object_with_lettering(const bat_object *object, const bat_lettering *lettering,
                                     bat_object **out) {
    const text *old = object ? own_of(object) : NULL;
    bat_lettered *lettered = NULL;
    if (!old || !lettering || !out) return BAT_ARGUMENT;
    const bat_status status = bat_lettered_create(lettering, bat_object_style(object)->fill, &lettered);
    return status == BAT_OK ? make(object, 0, NULL, NULL, lettered, old->place, out) : status;
}

const bat_lettering *bat_object_lettering(const bat_object *object) {
    const text *own = own_of(object);
    return own ? bat_lettered_of(own->lettered) : NULL;
}

const double *bat_object_place(const bat_object *object) {
    const text *own = own_of(object);
    return own ? own->place : NULL;
}

static bat_status restyle(const bat_object *object, bat_object **out) {
    return bat_object_with_lettering(object, bat_object_lettering(object), out);
}

static bat_status transform(const bat_object *object, const double rows[12], bat_object **out) {
    const text *old = own_of(object);
    double m[6], place[6];
    if (!bat_pose_in_plane(rows, m)) return BAT_UNSUPPORTED;
    bat_matrix_compose(m, old->place, place);
    return make(object, 0, NULL, NULL, bat_lettered_retain(old->lettered), place, out);
}

static uint64_t digest_text(uint64_t before, const void *own) {
    const text *t = own;
    uint64_t made = bat_lettering_digest(before, bat_lettered_of(t->lettered));
    for (int i = 0; i < 6; i++) made = bat_digest_double(made, t->place[i]);
    return made;
}

/* ---- JSON ---- */

static void write(const bat_object *object, bat_text *out) {
    bat_lettering_to_json(bat_object_lettering(object), out);
    bat_text_numbers(out, ",\"matrix\":", bat_object_place(object), 6);
    bat_colour_write(out, ",\"fill\":", bat_object_style(object)->fill);
    bat_text_string(out, ",\"opacity\":");
    bat_text_number(out, bat_object_style(object)->opacity);
}

static bat_status read(const bat_fields *f, uint32_t node, bat_id id, const char *name, bat_object **out) {
    bat_lettering l = bat_lettering_defaults();
    double place[6], opacity = 1;
    uint32_t colour = 0x000000ff;
    bat_status status = bat_lettering_from_json(f, node, &l);
    if (status == BAT_OK) status = bat_fields_numbers(f, node, "matrix", 6, expected_matrix, place);
    if (status == BAT_OK)
        status = bat_fields_number(f, node, "opacity", 0, 1, "a number from 0 to 1", &opacity);
    if (status == BAT_OK) status = bat_colour_from_json(f, node, "fill", &colour);
    if (status != BAT_OK) return status;
    return bat_fields_say(f, node, bat_object_create_text(id, name, &l, place, colour, opacity, out));
}

const bat_kind_type bat_kind_of_text = {.number = BAT_KIND_TEXT,
                                        .name = "text",
                                        .traits = BAT_DRAWN | BAT_PICTURED,
                                        .size = sizeof(text),
                                        .share = share,
                                        .end = end,
                                        .digest = digest_text,
                                        .bounds = bat_placed_bounds,
                                        .transform = transform,
                                        .restyle = restyle,
                                        .write = write,
                                        .read = read};
