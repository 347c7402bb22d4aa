#include "format/svg/write/basic.h"

#include "base/matrix.h"
#include "base/real.h"
#include "document/markers.h"
#include "format/svg/cubics.h"
#include "format/svg/svg.h"
#include "kinds/primitive.h"
#include "text/number.h"

#include <math.h>
#include <string.h>

static const double SAME = 1e-12; /* of an axis: what rounding leaves */

/* A place whose axes are at right angles, the first one to the right more than up or down. */
typedef struct frame {
    double at[2], a[2], b[2], sides[2], radii[2];
    bool elsewhere;
} frame;

static bool find_frame(const bat_primitive *p, frame *out) {
    const double *m = p->place;
    frame f = {.at = {m[4], m[5]}, .a = {m[0], m[1]}, .b = {m[2], m[3]}, .radii = {p->radii[0], p->radii[1]}};
    const double lengths[2] = {bat_hypot(m[0], m[1]), bat_hypot(m[2], m[3])};
    const bool box = p->kind == BAT_RECTANGLE;
    if (!(fabs(f.a[0] * f.b[0] + f.a[1] * f.b[1]) <= 1e-9 * lengths[0] * lengths[1])) return false;
    f.elsewhere = f.a[0] * f.b[1] - f.a[1] * f.b[0] < 0 || f.a[0] < fabs(f.a[1]);
    if (f.a[0] * f.b[1] - f.a[1] * f.b[0] < 0) /* mirrored: the same from the other side */
        for (int k = 0; k < 2; k++) f.at[k] += box ? f.b[k] : 0, f.b[k] = -f.b[k];
    for (int turns = 0; turns < 3 && f.a[0] < fabs(f.a[1]); turns++) { /* from the next corner */
        const frame g = f;
        for (int k = 0; k < 2; k++) {
            f.at[k] += box ? g.a[k] : 0;
            f.a[k] = g.b[k];
            f.b[k] = -g.a[k];
            f.radii[k] = g.radii[1 - k];
        }
    }
    f.sides[0] = bat_hypot(f.a[0], f.a[1]);
    f.sides[1] = bat_hypot(f.b[0], f.b[1]);
    *out = f;
    return true;
}

static void add(bat_svg_basic *e, const char *name, double number) {
    e->names[e->count] = name;
    e->numbers[e->count++] = number + 0.0; /* no -0 */
}

bool bat_svg_basic_of(const bat_primitive *p, bat_svg_basic *out) {
    frame f;
    bat_svg_basic e = {.turn = {1, 0, 0, 1, 0, 0}};
    if (p->kind == BAT_POLYGON || (p->kind == BAT_ELLIPSE && p->sweep < 360) || !find_frame(p, &f))
        return false;
    const bool circle = p->kind == BAT_ELLIPSE && fabs(f.sides[0] - f.sides[1]) <= SAME * f.sides[0];
    e.elsewhere = f.elsewhere;
    e.turned = !circle && fabs(f.a[1]) > SAME * f.sides[0];
    double at[2] = {f.at[0], f.at[1]};
    if (e.turned) {
        const double u[2] = {f.a[0] / f.sides[0], f.a[1] / f.sides[0]};
        memcpy(e.turn, (double[]){u[0], u[1], -u[1], u[0], 0, 0}, sizeof e.turn);
        at[0] = u[0] * f.at[0] + u[1] * f.at[1];
        at[1] = u[0] * f.at[1] - u[1] * f.at[0];
    }
    const bool box = p->kind == BAT_RECTANGLE;
    e.name = box ? "rect" : circle ? "circle" : "ellipse";
    add(&e, box ? "x" : "cx", at[0]);
    add(&e, box ? "y" : "cy", at[1]);
    if (box) add(&e, "width", f.sides[0]);
    if (box) add(&e, "height", f.sides[1]);
    if (circle) add(&e, "r", f.sides[0]);
    const double *r = box ? f.radii : f.sides;
    if (!circle && r[0] > 0 && r[1] > 0) {
        add(&e, "rx", r[0]);
        if (!box || r[0] != r[1]) add(&e, "ry", r[1]);
    }
    *out = e;
    return true;
}

bool bat_svg_has_basic(const bat_object *object, double precision, bat_text *text, bat_svg_basic *out) {
    const bat_primitive *p = bat_object_primitive(object);
    bat_svg_cubics cubics;
    const bat_paint *paint = bat_object_paint(object);
    if (!p || bat_object_markers(object) || !bat_svg_basic_of(p, out)) return false;
    if (out->elsewhere && paint && paint->dash_count) return false;
    const bat_status status = bat_svg_cubics_make(bat_object_curve(object, 0), NULL, precision, &cubics);
    text->failed = text->failed || status == BAT_MEMORY;
    if (status != BAT_OK) return false;
    for (int i = 0; i < out->count; i++) {
        double rounded[2];
        bat_svg_round(&cubics, (double[]){out->numbers[i], 0}, rounded);
        if (i < 2 || rounded[0] > 0) out->numbers[i] = rounded[0];
    }
    bat_svg_cubics_free(&cubics);
    return true;
}

void bat_svg_write_basic(bat_text *text, const bat_svg_basic *basic) {
    for (int i = 0; i < basic->count; i++) {
        bat_text_string(text, " ");
        bat_text_string(text, basic->names[i]);
        bat_text_string(text, "=\"");
        bat_text_number(text, basic->numbers[i]);
        bat_text_string(text, "\"");
    }
}

/* ---- seen ---- */

typedef struct written {
    const bat_svg_basic *basic;
    char values[BAT_SVG_BASIC_NUMBERS][BAT_NUMBER_ROOM + 8];
} written;

static const char *value_of(const void *from, const char *name) {
    const written *w = from;
    for (int i = 0; i < w->basic->count; i++)
        if (strcmp(w->basic->names[i], name) == 0) return w->values[i];
    return NULL;
}

void bat_svg_basic_outline(const bat_svg_basic *basic, bat_outline *outline) {
    written w = {.basic = basic};
    for (int i = 0; i < basic->count; i++)
        w.values[i][bat_number_print(basic->numbers[i], w.values[i])] = '\0';
    (void)bat_svg_shape_outline(&(bat_svg_shape){value_of, &w, 0, 0}, basic->name, outline);
}
