/* Prints points and B-splines as instances of a STEP file. */
#include "format/step/put.h"
#include "format/model/full.h"

enum { ROW = 10 };

void bat_step_put_id(bat_text *text, uint64_t id) {
    bat_text_string(text, "#");
    bat_text_integer(text, id);
}

static void put_number(bat_text *text, double number) {
    char word[40];
    bat_full_number(number, word);
    bat_text_string(text, word);
}

static void separate(bat_text *text, uint64_t i) {
    if (i > 0) bat_text_string(text, i % ROW == 0 ? ",\n" : ",");
}

uint64_t bat_step_put_point(bat_text *text, uint64_t id, const double *point, int size) {
    bat_step_put_id(text, id);
    bat_text_string(text, "=CARTESIAN_POINT('',(");
    for (int c = 0; c < 3; c++) {
        separate(text, (uint64_t)c);
        put_number(text, c < size ? point[c] : 0);
    }
    bat_text_string(text, "));\n");
    return id + 1;
}

/* (multiplicities) or (knots): both of the distinct knots. */
static void put_knots(bat_text *text, const bat_full_axis *axis, bool many) {
    const int last = axis->count + axis->degree;
    uint64_t written = 0;
    bat_text_string(text, "(");
    for (int i = 0, next; i <= last; i = next) {
        const double knot = bat_full_knot(axis, i);
        for (next = i + 1; next <= last && bat_full_knot(axis, next) == knot;) next++;
        separate(text, written++);
        if (many)
            bat_text_integer(text, (uint64_t)(next - i));
        else
            put_number(text, knot);
    }
    bat_text_string(text, ")");
}

static const char *logical(bool value) { return value ? ",.T." : ",.F."; }

uint64_t bat_step_put_curve(bat_text *text, uint64_t id, const bat_curve *curve) {
    const bat_full_axis axis = bat_full_axis_of_curve(curve);
    const int size = bat_curve_dimension(curve);
    const uint64_t points = id;
    for (int i = 0; i < axis.count; i++)
        id = bat_step_put_point(text, id, bat_curve_points(curve) + bat_full_point(&axis, i) * size, size);
    bat_step_put_id(text, id);
    bat_text_string(text, "=B_SPLINE_CURVE_WITH_KNOTS('',");
    bat_text_integer(text, (uint64_t)axis.degree);
    bat_text_string(text, ",(");
    for (uint64_t i = 0; i < (uint64_t)axis.count; i++) {
        separate(text, i);
        bat_step_put_id(text, points + i);
    }
    bat_text_string(text, "),.UNSPECIFIED.");
    bat_text_string(text, logical(bat_curve_is_closed(curve)));
    bat_text_string(text, ",.F.,");
    put_knots(text, &axis, true);
    bat_text_string(text, ",");
    put_knots(text, &axis, false);
    bat_text_string(text, ",.UNSPECIFIED.);\n");
    return id + 1;
}

uint64_t bat_step_put_surface(bat_text *text, uint64_t id, const bat_surface *surface) {
    bat_full_axis axis[2];
    const uint64_t points = id;
    for (bat_direction d = BAT_U; d <= BAT_V; d++) axis[d] = bat_full_axis_of_surface(surface, d);
    const int n = axis[0].count, m = axis[1].count;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++)
            id = bat_step_put_point(
                text, id,
                bat_surface_row(surface, bat_full_point(&axis[0], i)) + 3 * bat_full_point(&axis[1], j), 3);
    bat_step_put_id(text, id);
    bat_text_string(text, "=B_SPLINE_SURFACE_WITH_KNOTS('',");
    for (int d = 0; d < 2; d++) {
        bat_text_integer(text, (uint64_t)axis[d].degree);
        bat_text_string(text, d ? ",(" : ",");
    }
    for (int i = 0; i < n; i++) {
        bat_text_string(text, i ? ",\n(" : "(");
        for (int j = 0; j < m; j++) {
            separate(text, (uint64_t)j);
            bat_step_put_id(text, points + (uint64_t)i * (uint64_t)m + (uint64_t)j);
        }
        bat_text_string(text, ")");
    }
    bat_text_string(text, "),.UNSPECIFIED.");
    for (bat_direction d = BAT_U; d <= BAT_V; d++)
        bat_text_string(text, logical(bat_surface_is_closed(surface, d)));
    bat_text_string(text, ",.F.");
    for (int k = 0; k < 4; k++) {
        bat_text_string(text, ",");
        put_knots(text, &axis[k % 2], k < 2);
    }
    bat_text_string(text, ",.UNSPECIFIED.);\n");
    return id + 1;
}

void bat_step_put_list(bat_text *text, const bat_numbers *ids) {
    bat_text_string(text, "(");
    for (size_t i = 0; i < ids->count; i++) {
        separate(text, i);
        bat_step_put_id(text, (uint64_t)ids->list[i]);
    }
    bat_text_string(text, ")");
}
