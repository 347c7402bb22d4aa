/* GeoJSON (RFC 7946) as a format of drawings: LineStrings and the rings of Polygons are polylines, whose names are their features'. */
#include "document/format.h"
#include "format/json/curve.h"
#include "format/points/lines.h"
#include "kinds/kinds.h"
#include "text/json.h"
#include "text/text.h"

#include <batten/bezier.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SURE = 70 }; /* above what any JSON gets */

/* How many lists lie around the places of a geometry: 0: they are a line's. -1: it has no lines. */
static int depth_of(const char *type) {
    static const struct {
        const char *type;
        int depth;
    } types[] = {{"LineString", 0}, {"MultiLineString", 1}, {"Polygon", 1}, {"MultiPolygon", 2}};
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (strcmp(type, types[i].type) == 0) return types[i].depth;
    return -1;
}

static int sniff(const char *text, size_t size) {
    static const char *const members[] = {"coordinates", "geometries", "geometry", "features"};
    const size_t at = bat_format_start(text, size);
    bat_json json;
    bool found = false;
    if (at == size || text[at] != '{' || bat_json_parse(text, size, &json, NULL) != BAT_OK) return 0;
    for (int i = 0; i < 4 && bat_json_text(&json, bat_json_member(&json, 1, "type")); i++)
        found = found || bat_json_member(&json, 1, members[i]);
    bat_json_free(&json);
    return found ? SURE : 0;
}

typedef struct reader {
    const bat_json *json;
    bat_curve **curves;
    char **names; /* borrowed from the JSON */
    size_t count, room;
    int left_out; /* geometries without lines */
    bat_problem *problem;
} reader;

/* Takes the curve over. */
static bat_status keep(reader *r, bat_curve *curve, const char *name) {
    if (r->count == r->room) {
        const size_t room = 2 * r->room + 8;
        bat_curve **curves = realloc(r->curves, room * sizeof *curves);
        if (curves) r->curves = curves;
        char **names = curves ? realloc(r->names, room * sizeof *names) : NULL;
        if (names) r->names = names;
        if (!names) {
            bat_curve_free(curve);
            return bat_problem_set(r->problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
        }
        r->room = room;
    }
    r->curves[r->count] = curve, r->names[r->count++] = (char *)name;
    return BAT_OK;
}

/* Its y points up and its z towards the eye, a drawing's the other way: places of either become those of the other. */
static void turn(size_t count, int dimension, double *points) {
    for (size_t i = 0; i < count; i++)
        for (int c = 1; c < dimension; c++) {
            double *number = points + i * (size_t)dimension + c;
            *number = 0 - *number; /* not -0 */
        }
}

static bat_status read_line(reader *r, uint32_t places, const char *name) {
    double *points = NULL;
    size_t count = 0;
    int dimension = 0;
    bat_curve *line = NULL;
    bat_status status = bat_points_from_json(r->json, places, "coordinates", &points, &count, &dimension,
                                             r->problem);
    if (status != BAT_OK) return status;
    turn(count, dimension, points);
    status = bat_line_of_points(dimension, count, points, &line);
    free(points);
    if (status == BAT_COUNT)
        return bat_json_say(r->json, places, BAT_COUNT, "coordinates: expected two places or more for a line",
                            r->problem);
    if (status == BAT_NUMBER)
        return bat_json_say(r->json, places, BAT_NUMBER,
                            "coordinates: expected numbers up to 1e75, found a greater one", r->problem);
    if (status != BAT_OK) return bat_problem_set(r->problem, status, "", bat_status_message(status));
    return keep(r, line, name);
}

static bat_status read_lines(reader *r, uint32_t node, int depth, const char *name) {
    if (depth == 0) return read_line(r, node, name);
    if (bat_json_type_of(r->json, node) != BAT_JSON_LIST)
        return bat_json_say(r->json, node, BAT_SYNTAX, "coordinates: expected a list of lines", r->problem);
    bat_status status = BAT_OK;
    for (uint32_t at = bat_json_first(r->json, node); at && status == BAT_OK; at = r->json->nodes[at].next)
        status = read_lines(r, at, depth - 1, name);
    return status;
}

static bat_status read_geometry(reader *r, uint32_t node, const char *name) {
    const char *type = bat_json_text(r->json, bat_json_member(r->json, node, "type"));
    const uint32_t places = bat_json_member(r->json, node, "coordinates");
    const int depth = type ? depth_of(type) : -1;
    if (depth < 0) {
        r->left_out++;
        return BAT_OK;
    }
    if (!places)
        return bat_json_say(r->json, node, BAT_SYNTAX, "expected coordinates, found none", r->problem);
    return read_lines(r, places, depth, name);
}

static const char *name_of(const bat_json *json, uint32_t feature) {
    const uint32_t properties = bat_json_member(json, feature, "properties");
    return bat_json_text(json, bat_json_member(json, properties, "name"));
}

/* A geometry, or what holds some; collections in collections are not walked into (RFC 7946, 3.1.8). */
static bat_status read_any(reader *r, uint32_t node) {
    const uint32_t features = bat_json_member(r->json, node, "features");
    bat_status status = BAT_OK;
    for (uint32_t at = features ? bat_json_first(r->json, features) : node; at && status == BAT_OK;
         at = features ? r->json->nodes[at].next : 0) {
        const uint32_t own = bat_json_member(r->json, at, "geometry"), geometry = own ? own : at;
        const uint32_t several = bat_json_member(r->json, geometry, "geometries");
        const char *name = name_of(r->json, at);
        for (uint32_t each = several ? bat_json_first(r->json, several) : geometry; each && status == BAT_OK;
             each = several ? r->json->nodes[each].next : 0)
            status = read_geometry(r, each, name);
    }
    return status;
}

/* A thousandth of the map's larger side, whatever its units are; 0: it has no size. */
static double width_of(const reader *r, size_t count) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (size_t i = 0; i < count; i++) {
        const size_t stride = (size_t)bat_curve_dimension(r->curves[i]);
        const double *points = bat_curve_points(r->curves[i]);
        for (size_t k = 0; k < bat_curve_count(r->curves[i]); k++)
            for (int c = 0; c < 2; c++) {
                low[c] = fmin(low[c], points[k * stride + (size_t)c]);
                high[c] = fmax(high[c], points[k * stride + (size_t)c]);
            }
    }
    const double side = fmax(high[0] - low[0], high[1] - low[1]);
    return side > 1e-9 && side < 1e9 ? side / 1000 : 0;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    bat_json json;
    (void)how;
    bat_status status = bat_json_parse(text, size, &json, problem);
    if (status != BAT_OK) return status;
    reader r = {.json = &json, .problem = problem};
    status = read_any(&r, 1);
    report->lost.count[BAT_LOSS_UNKNOWN] += r.left_out;
    if (status == BAT_OK && r.count == 0)
        status = bat_problem_set(problem, BAT_COUNT, "", "expected a LineString or a Polygon, found none");
    if (status == BAT_OK) {
        const int count = (int)r.count;
        r.count = 0; /* the call takes the curves over */
        status = bat_document_of_curves(count, r.curves, (const char *const *)r.names,
                                        width_of(&r, (size_t)count), out);
        if (status != BAT_OK) bat_problem_set(problem, status, "", bat_status_message(status));
    }
    for (size_t i = 0; i < r.count; i++) bat_curve_free(r.curves[i]);
    free(r.curves), free(r.names);
    bat_json_free(&json);
    return status;
}

/* scale: what lengths are multiplied by. */
static bat_status put_feature(bat_text *text, const bat_object *object, const bat_curve *curve,
                              double tolerance, double scale) {
    const size_t width = (size_t)bat_curve_dimension(curve);
    double *points = NULL;
    size_t count = 0;
    const bat_status status = bat_points_of_line(curve, tolerance, &count, &points);
    if (status == BAT_OK) turn(count, (int)width, points);
    bat_text_string(text, "{\"type\":\"Feature\",\"properties\":{");
    if (bat_object_name(object)[0]) {
        bat_text_string(text, "\"name\":");
        bat_text_json_string(text, bat_object_name(object));
    }
    bat_text_string(text, "},\"geometry\":{\"type\":\"LineString\",\"coordinates\":[");
    for (size_t i = 0; status == BAT_OK && i < count; i++)
        for (size_t c = 0; c < width; c++) {
            bat_text_string(text, c > 0 ? "," : i > 0 ? ",[" : "[");
            bat_text_number(text, points[i * width + c] * scale);
            if (c + 1 == width) bat_text_string(text, "]");
        }
    bat_text_string(text, "]}}");
    bat_free(points);
    return status;
}

static bat_status write(const bat_document *document, char **out, size_t *size, bat_problem *problem) {
    bat_text text = {0};
    bool any = false, space;
    const double tolerance = bat_lines_tolerance(document), scale = bat_document_scale(document);
    bat_status status = BAT_OK;
    if (bat_lines_count(document, &space) == 0)
        return bat_problem_set(
            problem, BAT_COUNT, "",
            "a .geojson file holds lines of curves, expected 1 curve at least, found none");
    bat_text_string(&text, "{\"type\":\"FeatureCollection\",\"features\":[\n");
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        for (int k = 0; k < bat_object_curve_count(object) && status == BAT_OK; k++, any = true) {
            if (any) bat_text_string(&text, ",\n");
            status = put_feature(&text, object, bat_object_curve(object, k), tolerance, scale);
        }
    }
    bat_text_string(&text, "\n]}\n");
    if (status == BAT_OK)
        status = bat_text_finish(&text, out, size);
    else
        bat_text_free(&text);
    return status == BAT_OK ? status : bat_problem_set(problem, status, "", bat_status_message(status));
}

const bat_format bat_format_of_geojson = {"geojson", "application/geo+json", false, sniff, read, write};
