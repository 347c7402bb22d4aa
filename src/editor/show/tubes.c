#include "editor/show/tubes.h"
#include "base/real.h"
#include "document/bound.h"
#include "document/document.h"
#include "document/kind.h"
#include "editor/choice/choice.h"
#include "editor/session/session.h"
#include "editor/view/stage.h"
#include "editor/view/unit.h"
#include <batten/mesh.h>

#include <math.h>
#include <stdlib.h>

enum { SAMPLES = 64, TORN = 256, EDGES = 1 << 16 /* of larger things torn edges are not looked for */ };

static bool has(const bat_tube *tubes, int count, bat_id id) {
    for (int i = 0; i < count; i++)
        if (tubes[i].curve == id) return true;
    return false;
}

static int add_wires(const bat_context *c, const bat_object *object, bat_tube *out, int count) {
    const bat_document *document = c->session->document;
    const bat_selection *selection = &c->choice->selection;
    const bat_wire *wires;
    const bat_id *ids;
    const int n = bat_object_wires(object, &wires, NULL);
    if (n == 0) return count;
    bat_object_sources(object, &ids);
    const bool chosen = bat_selection_has(selection, bat_object_id(object));
    for (int i = 0; i < n && count < BAT_BOUND_WIRES; i++) {
        if ((!chosen && !bat_selection_has(selection, ids[i])) || has(out, count, ids[i])) continue;
        const bat_object *led = bat_document_at(document, bat_document_find(document, ids[i]));
        if (led) out[count++] = (bat_tube){ids[i], bat_object_curve(led, 0), &wires[i]};
    }
    return count;
}

int bat_tubes_of(const bat_context *c, bat_tube out[BAT_BOUND_WIRES]) {
    const bat_document *document = c->session->document;
    int count = 0;
    if (!bat_document_has_followers(document) || c->choice->selection.count == 0) return 0;
    for (int i = 0; i < bat_document_count(document) && count < BAT_BOUND_WIRES; i++)
        count = add_wires(c, bat_document_at(document, i), out, count);
    return count;
}

double bat_tube_radius(const bat_tube *tube, double at) {
    double jet[3];
    bat_function_eval(&tube->wire->radius, at, jet);
    return jet[0];
}

bool bat_tube_look(const bat_context *c, const bat_tube *tube, double at, bat_tube_place *out) {
    const int size = bat_curve_dimension(tube->now);
    double domain[2], jet[6], point[3] = {0, 0, 0}, way[3] = {0, 0, 0}, seen[2], sum = 0, cross = 0,
                              squares[2] = {0, 0};
    bat_curve_domain(tube->now, domain);
    bat_curve_eval(tube->now, domain[0] + at * (domain[1] - domain[0]), 1, jet);
    for (int k = 0; k < size; k++) point[k] = jet[k], way[k] = jet[size + k];
    if (!bat_stage_look(c->stage, 3, point, out->at)) return false;
    bat_stage_look_along(c->stage, 3, point, way, seen);
    const double length = sqrt(seen[0] * seen[0] + seen[1] * seen[1]);
    out->across[0] = length > 0 ? -seen[1] / length : 0;
    out->across[1] = length > 0 ? seen[0] / length : 1;
    for (int k = 0; k < 3; k++) { /* the greatest stretch: of a sphere about the point, half its width */
        const double axis[3] = {k == 0, k == 1, k == 2};
        bat_stage_look_along(c->stage, 3, point, axis, seen);
        squares[0] += seen[0] * seen[0], squares[1] += seen[1] * seen[1], cross += seen[0] * seen[1];
    }
    sum = squares[0] + squares[1];
    const double spread = squares[0] - squares[1];
    out->scale = sqrt((sum + sqrt(spread * spread + 4 * cross * cross)) / 2);
    return true;
}

/* ---- shown ---- */

static void wall_point(const bat_tube_place *p, double radius, int side, double out[2]) {
    for (int k = 0; k < 2; k++) out[k] = p->at[k] + side * radius * p->scale * p->across[k];
}

/* Half a circle from the wall at the end of a tube to the other wall: beyond its ends a wire is felt all around them. way: 1
 * at the last end, -1 at the first. */
static void add_cap(const bat_tube_place *p, double radius, int way, bat_overlay *overlay) {
    const double from = bat_atan2(way * p->across[1], way * p->across[0]);
    bat_overlay_arc(overlay, p->at, radius * p->scale, from, from - BAT_PI, true);
}

/* There on one side, back on the other, round the ends; each wall of a closed wire a line of its own when not filled. */
static void add_walls(const bat_context *c, const bat_tube *tube, bool filled, bat_overlay *overlay) {
    const bool closed = bat_curve_is_closed(tube->now);
    bool on = false;
    for (int i = 0; i < 2 * SAMPLES; i++) {
        const int k = i < SAMPLES ? i : 2 * SAMPLES - 1 - i;
        const double at = k / (SAMPLES - 1.0), radius = bat_tube_radius(tube, at);
        bat_tube_place p;
        double wall[2];
        if (i == SAMPLES && closed && !filled) on = false;
        if (!bat_tube_look(c, tube, at, &p)) continue;
        wall_point(&p, radius, i < SAMPLES ? 1 : -1, wall);
        (on ? bat_path_line : bat_path_move)(&overlay->path, wall[0], wall[1]);
        on = true;
        if (!closed && (i == SAMPLES - 1 || i == 2 * SAMPLES - 1))
            add_cap(&p, radius, i < SAMPLES ? 1 : -1, overlay);
    }
    if (on && (filled || !closed)) bat_path_close(&overlay->path);
}

static void show_stops(const bat_context *c, const bat_tube *tube, int held, bat_overlay *overlay) {
    const bat_stops stops = bat_stops_of(&tube->wire->radius, bat_curve_is_closed(tube->now));
    const double px = bat_stage_pixel(c->stage);
    for (int i = 0; i < stops.count; i++) {
        bat_tube_place p;
        double wall[2];
        if (!bat_tube_look(c, tube, stops.at[i], &p)) continue;
        bat_overlay_item(overlay, i == held ? BAT_ROLE_CHOSEN : BAT_ROLE_HANDLE,
                         BAT_ITEM_STROKED | BAT_ITEM_FILLED, 1.5F);
        for (int side = -1; side <= 1; side += 2) {
            wall_point(&p, stops.radius[i], side, wall);
            bat_overlay_circle(overlay, wall, 5 * px);
        }
        if (i != held) continue;
        char text[BAT_UNIT_ROOM];
        bat_unit_write(c, stops.radius[i], text);
        bat_overlay_label(overlay, BAT_ROLE_VALUE, wall, 0, -20, text);
    }
}

/* ---- torn ---- */

static size_t edges_of(const bat_object *object, int *out) {
    const bat_polymesh *mesh = bat_object_mesh(object);
    const bat_surface *surface = bat_object_surface(object);
    size_t count = 0;
    for (size_t f = 0; mesh && f < bat_polymesh_face_count(mesh); f++) {
        size_t n;
        const int *face = bat_polymesh_face(mesh, f, &n);
        for (size_t k = 0; k < n && count < EDGES; k++, count++)
            if (out) out[2 * count] = face[k], out[2 * count + 1] = face[(k + 1) % n];
    }
    if (surface) {
        const int rows = (int)bat_surface_count(surface, BAT_U),
                  width = (int)bat_surface_count(surface, BAT_V);
        for (int i = 0; i < rows * width && count + 2 < EDGES; i++) {
            if (i % width + 1 < width && ++count && out) out[2 * count - 2] = i, out[2 * count - 1] = i + 1;
            if (i / width + 1 < rows && ++count && out)
                out[2 * count - 2] = i, out[2 * count - 1] = i + width;
        }
    }
    for (int i = 0, first = 0; !mesh && !surface && i < bat_object_curve_count(object); i++) {
        const int n = (int)bat_curve_count(bat_object_curve(object, i));
        for (int k = 0; k + 1 < n && count < EDGES; k++, count++)
            if (out) out[2 * count] = first + k, out[2 * count + 1] = first + k + 1;
        first += n;
    }
    return count;
}

/* Edges whose ends feel different stretches of a wire: what lies between them is torn when the wire moves. */
size_t bat_torn_show(const bat_context *c, const bat_object *object, bat_overlay *overlay) {
    const bat_hold *hold = bat_object_hold(object);
    if (!hold) return 0;
    const size_t edges = edges_of(object, NULL);
    int *all = malloc((2 * edges + 1) * sizeof *all), torn[2 * TORN];
    double *points = malloc((3 * hold->bound->point_count + 1) * sizeof *points);
    size_t count = 0;
    if (all && points && edges < EDGES) {
        edges_of(object, all);
        if (bat_binding_torn(hold->bound->binding, edges, all, TORN, torn, &count) != BAT_OK) count = 0;
    }
    const size_t found = count;
    if (count > TORN) count = TORN;
    if (count > 0) {
        bat_object_type(object)->points(object, points);
        bat_overlay_item(overlay, BAT_ROLE_ERASED, BAT_ITEM_STROKED, 2.5F);
    }
    for (size_t i = 0; i < count; i++) {
        double ends[4];
        if (bat_stage_look(c->stage, 3, points + (ptrdiff_t)3 * torn[2 * i], ends) &&
            bat_stage_look(c->stage, 3, points + (ptrdiff_t)3 * torn[2 * i + 1], ends + 2))
            bat_overlay_polyline(overlay, 2, ends);
    }
    free(all), free(points);
    return found;
}

static void show_all_torn(const bat_context *c, const bat_tube *tubes, int count, bat_overlay *overlay) {
    const bat_document *document = c->session->document;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        const bat_id *ids;
        bool shown = false;
        if (bat_object_wires(object, NULL, NULL) == 0) continue;
        const int n = bat_object_sources(object, &ids);
        for (int k = 0; k < n && !shown; k++) shown = has(tubes, count, ids[k]);
        if (shown) bat_torn_show(c, object, overlay);
    }
}

void bat_tubes_show(const bat_context *c, bat_id held, int stop, bat_overlay *overlay) {
    bat_tube tubes[BAT_BOUND_WIRES];
    const int count = bat_tubes_of(c, tubes);
    const bool handles = bat_tool_at(c->choice->tool)->traits & BAT_CHOOSES;
    if (count == 0) return;
    bat_overlay_item(overlay, BAT_ROLE_WEDGE, BAT_ITEM_FILLED, 0);
    for (int i = 0; i < count; i++) add_walls(c, &tubes[i], true, overlay);
    bat_overlay_item(overlay, BAT_ROLE_REACH, BAT_ITEM_STROKED | BAT_ITEM_DASHED, 1);
    for (int i = 0; i < count; i++) add_walls(c, &tubes[i], false, overlay);
    show_all_torn(c, tubes, count, overlay);
    for (int i = 0; i < count && handles && i < 4; i++)
        show_stops(c, &tubes[i], tubes[i].curve == held ? stop : -1, overlay);
}
