#include "format/svg/geometry.h"

#include "base/matrix.h"
#include "document/picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What values a property takes. */
typedef enum value_kind { PLACE, SIZE, RADIUS, PATH, FUNCTIONS, SINGLE, ORIGIN, BOX } value_kind;

static const struct {
    char name[17];
    uint8_t kind;
    char initial[5];
} properties[BAT_SVG_GEOMETRY_COUNT] = {
    {"cx", PLACE, "0"},
    {"cy", PLACE, "0"},
    {"d", PATH, "none"},
    {"height", RADIUS, "auto"},
    {"r", SIZE, "0"},
    {"rotate", SINGLE, "none"},
    {"rx", RADIUS, "auto"},
    {"ry", RADIUS, "auto"},
    {"scale", SINGLE, "none"},
    {"transform", FUNCTIONS, "none"},
    {"transform-box", BOX, ""},
    {"transform-origin", ORIGIN, "0"},
    {"translate", SINGLE, "none"},
    {"width", RADIUS, "auto"},
    {"x", PLACE, "0"},
    {"y", PLACE, "0"},
};

bat_svg_geometry bat_svg_geometry_of(const char *name) {
    if (strncmp(name, "-webkit-transform", 17) == 0) name += 8; /* another name of the same */
    int i = 0;
    while (i < BAT_SVG_GEOMETRY_COUNT && strcmp(properties[i].name, name) != 0) i++;
    return (bat_svg_geometry)i;
}

/* ---- values ---- */

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/* Data in path("..."), without what is around them. */
static bool unwrap(char *value) {
    const size_t size = strlen(value);
    char *at = value + 4, *end = value + size;
    if (strcmp(value, "none") == 0) return true;
    if (strncmp(value, "path", 4) != 0 || strchr(value, '\\')) return false;
    while (is_space(*at)) at++;
    if (*at++ != '(' || end[-1] != ')') return false;
    end--;
    while (is_space(*at)) at++;
    while (end > at && is_space(end[-1])) end--;
    if (end - at < 2 || (*at != '"' && *at != '\'') || end[-1] != *at) return false;
    memmove(value, at + 1, (size_t)(end - at - 2));
    value[end - at - 2] = '\0';
    bat_outline outline = {0};
    const bool good = bat_svg_path(value, strlen(value), &outline);
    bat_outline_free(&outline);
    return good;
}

static bool is_good(bat_svg_geometry property, char *value) {
    static const double sides[2] = {1, 1};
    static const char *const boxes[] = {"view-box", "fill-box", "content-box", "stroke-box", "border-box"};
    double number, m[6];
    switch (properties[property].kind) {
    case PATH: return unwrap(value);
    case FUNCTIONS: return bat_svg_functions(value, sides, m);
    case SINGLE: return bat_svg_function_of(properties[property].name, value, sides, m);
    case ORIGIN: return bat_svg_origin(value, sides, false, m);
    case BOX:
        for (size_t i = 0; i < sizeof boxes / sizeof *boxes; i++)
            if (strcmp(value, boxes[i]) == 0) return true;
        return false;
    case RADIUS:
        if (strcmp(value, "auto") == 0) return true;
        return bat_svg_length(value, 1, &number) && number >= 0;
    default: return bat_svg_length(value, 1, &number) && (properties[property].kind == PLACE || number >= 0);
    }
}

bool bat_svg_geometry_set(bat_svg_style *style, bat_svg_geometry property, const char *value, size_t size,
                          bool important) {
    while (size > 0 && is_space(*value)) value++, size--;
    while (size > 0 && is_space(value[size - 1])) size--;
    if (size == 0 || !style->store) return false;
    bat_svg_placing *made = malloc(sizeof *made + (size > 8 ? size : 8) + 1);
    if (!made) {
        style->store->failed = true;
        return true;
    }
    *made = (bat_svg_placing){style->placing, NULL, (uint8_t)property, important};
    memcpy(made->value, value, size);
    made->value[size] = '\0';
    if (strcmp(made->value, "initial") == 0 || strcmp(made->value, "unset") == 0) {
        strcpy(made->value, properties[property].initial);
    } else if (!is_good(property, made->value)) {
        free(made);
        return false;
    }
    made->made = style->store->placings;
    style->placing = style->store->placings = made;
    return true;
}

/* ---- what is in force ---- */

static const bat_svg_placing *find(const bat_svg_style *style, int property) {
    const bat_svg_placing *at = style->placing;
    while (at && at->property != property) at = at->before;
    return at;
}

const char *bat_svg_geometry_text(const bat_svg_tree *tree, uint32_t element, const bat_svg_style *style,
                                  const char *name) {
    const bat_svg_placing *found = style->placing ? find(style, (int)bat_svg_geometry_of(name)) : NULL;
    if (!found) return bat_svg_tree_attribute(tree, element, name);
    return strcmp(found->value, "auto") == 0 ? NULL : found->value;
}

double bat_svg_geometry_length(const bat_svg_walk *w, uint32_t element, const bat_svg_style *style,
                               const char *name, double whole, double otherwise) {
    const char *text = bat_svg_geometry_text(w->tree, element, style, name);
    double value;
    return text && bat_svg_length(text, whole, &value) ? value : otherwise;
}

unsigned bat_svg_geometry_declared(const bat_svg_style *style) {
    unsigned bits = 0;
    for (const bat_svg_placing *at = style->placing; at; at = at->before) {
        const int kind = properties[at->property].kind;
        bits |= kind <= PATH ? BAT_DECLARED_SHAPE : BAT_DECLARED_MATRIX;
        if (kind == SINGLE) bits |= BAT_DECLARED_SINGLY;
        if (at->important) bits |= BAT_DECLARED_IMPORTANT;
    }
    return bits;
}

static const char *text_of(const void *element, const char *name) {
    const bat_svg_shape_holder *e = element;
    return bat_svg_geometry_text(e->tree, e->element, e->style, name);
}

bat_svg_shape bat_svg_shape_of(const bat_svg_walk *w, uint32_t element, const bat_svg_scope *s,
                               bat_svg_shape_holder *holder) {
    *holder = (bat_svg_shape_holder){w->tree, element, &s->style};
    return (bat_svg_shape){text_of, holder, s->width, s->height};
}

bat_loss bat_svg_shape_loss(const bat_svg_walk *w, uint32_t element, const bat_svg_style *style) {
    static const char *const lengths[] = {"x",  "y",  "width", "height", "cx", "cy", "r",
                                          "rx", "ry", "x1",    "y1",     "x2", "y2"};
    const char *name = bat_svg_tree_name(w->tree, element);
    double value;
    if (strcmp(name, "path") == 0) return BAT_LOSS_UNKNOWN; /* drawn up to the same place (SVG 2, 9.5.4) */
    if (name[0] == 'p') return BAT_LOSS_BROKEN;
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        const char *text = bat_svg_geometry_text(w->tree, element, style, lengths[i]);
        if (text && !bat_svg_length(text, 1, &value) && strpbrk(text, "(0123456789"))
            return BAT_LOSS_BROKEN; /* a function, or another unit */
    }
    return BAT_LOSS_UNKNOWN;
}

/* ---- matrices ---- */

/* The element's box without its stroke, in its own units. False: it is not known. */
static bool find_box(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, double box[4]) {
    bat_svg_shape_holder holder;
    const bat_svg_shape shape = bat_svg_shape_of(w, element, s, &holder);
    bat_outline outline = {0};
    if (w->tree->elements[element].kind != BAT_SVG_SHAPE) return false;
    bool good = bat_svg_shape_outline(&shape, bat_svg_tree_name(w->tree, element), &outline);
    good = good && !outline.failed && !outline.full && outline.subpath_count > 0;
    if (good) bat_outline_box(&outline, box);
    if (outline.failed) w->status = BAT_MEMORY;
    bat_outline_free(&outline);
    return good;
}

/* outer becomes outer * inner. */
static void append(double outer[6], const double inner[6]) {
    double made[6];
    bat_matrix_compose(outer, inner, made);
    memcpy(outer, made, sizeof made);
}

/* In that box: about its origin `translate`, `rotate` and `scale`, then `transform`. */
static bool compose(const bat_svg_walk *w, uint32_t element, const bat_svg_style *style, const double box[4],
                    double m[6]) {
    static const uint8_t singly[] = {BAT_SVG_GEOMETRY_TRANSLATE, BAT_SVG_GEOMETRY_ROTATE,
                                     BAT_SVG_GEOMETRY_SCALE};
    const double sides[2] = {box[2] - box[0], box[3] - box[1]};
    const bat_svg_placing *declared = find(style, BAT_SVG_GEOMETRY_ORIGIN),
                          *functions = find(style, BAT_SVG_GEOMETRY_TRANSFORM);
    const char *origin = declared ? declared->value : bat_svg_attribute_of(w, element, "transform-origin"),
               *transform = bat_svg_attribute_of(w, element, "transform");
    double at[2] = {0, 0}, one[6];
    bool good = !origin || bat_svg_origin(origin, sides, !declared, at);
    bat_matrix_translation(at[0] + box[0], at[1] + box[1], m);
    for (int i = 0; i < 3; i++) {
        const bat_svg_placing *found = find(style, singly[i]);
        if (!found) continue;
        good = bat_svg_function_of(properties[singly[i]].name, found->value, sides, one) && good;
        append(m, one);
    }
    bat_matrix_identity(one);
    if (functions)
        good = bat_svg_functions(functions->value, sides, one) && good;
    else if (transform)
        good = bat_svg_transform(transform, one) && good;
    append(m, one);
    bat_matrix_translation(-at[0] - box[0], -at[1] - box[1], one);
    append(m, one);
    return good;
}

/* Whether it would be another in another box. */
static bool depends_on_box(const bat_svg_walk *w, uint32_t element, const bat_svg_style *style) {
    double one[6], other[6];
    (void)compose(w, element, style, (double[4]){0, 0, 1, 1}, one);
    (void)compose(w, element, style, (double[4]){3, 5, 10, 16}, other);
    for (int i = 0; i < 6; i++)
        if (!(fabs(one[i] - other[i]) <= 1e-9 * (1 + fabs(one[i])))) return true;
    return false;
}

bat_svg_moved bat_svg_matrix_of(bat_svg_walk *w, uint32_t element, const bat_svg_scope *s, double m[6]) {
    const char *transform = bat_svg_attribute_of(w, element, "transform");
    const bat_svg_style *style = &s->style;
    const bool says = bat_svg_geometry_declared(style) & BAT_DECLARED_MATRIX;
    bat_matrix_identity(m);
    if (!says && !transform) return BAT_SVG_MOVED_NOT;
    if (!says && !bat_svg_attribute_of(w, element, "transform-origin"))
        return bat_svg_transform(transform, m) ? BAT_SVG_MOVED_SO : BAT_SVG_MOVED_WRONGLY;
    const bat_svg_placing *of = find(style, BAT_SVG_GEOMETRY_BOX);
    double box[4] = {0, 0, s->width, s->height};
    bat_svg_moved moved = BAT_SVG_MOVED_SO;
    if (of && *of->value && strcmp(of->value, "view-box") != 0 && depends_on_box(w, element, style)) {
        const bool filled = of->value[0] == 'f' || of->value[0] == 'c'; /* without the stroke */
        moved = filled && find_box(w, element, s, box) ? BAT_SVG_MOVED_BY_BOX : BAT_SVG_MOVED_BADLY;
    }
    return compose(w, element, style, box, m) ? moved : BAT_SVG_MOVED_BADLY;
}
