/* USD as text: a prim for each part, under one that holds all. */
#include "format/usd/usd.h"

#include "text/text.h"

enum { ROW = 8 };

static const char POINTS[] = "point3f[] points = [";
static const char NORMALS[] = "\nnormal3f[] normals = [";
static const char OF_VERTEX[] = " (interpolation = \"vertex\")\n";
static const char COUNTS[] = "int[] faceVertexCounts = [";
static const char INDICES[] = "int[] faceVertexIndices = [";
static const char AS_IT_IS[] =
    "uniform token subdivisionScheme = \"none\"\nuniform bool doubleSided = true\n";
static const char LINE[] = "\nint[] curveVertexCounts = [";
static const char LINEAR[] =
    "]\nuniform token type = \"linear\"\nfloat[] widths = [1] (interpolation = \"constant\")\n";
static const char OPENING[] = "#usda 1.0\n(\n    defaultPrim = \"drawing\"\n    metersPerUnit = 0.001\n"
                              "    upAxis = \"Z\"\n)\n\ndef Xform \"drawing\"\n{\n";

static void put_places(bat_text *text, const char *before, const double *places, size_t count) {
    bat_text_string(text, before);
    for (size_t i = 0; i < count; i++) {
        bat_text_string(text, i == 0 ? "(" : i % ROW ? ", (" : ",\n(");
        for (size_t k = 0; k < 3; k++) {
            if (k) bat_text_string(text, ", ");
            bat_text_number(text, places[3 * i + k]);
        }
        bat_text_string(text, ")");
    }
    bat_text_string(text, "]");
}

/* A list of corners; without them of threes, one for each triangle. */
static void put_corners(bat_text *text, const char *before, const int *corners, size_t count) {
    bat_text_string(text, before);
    for (size_t i = 0; i < count; i++) {
        if (i) bat_text_string(text, i % (3 * ROW) ? ", " : ",\n");
        bat_text_integer(text, corners ? (uint64_t)corners[i] : 3);
    }
    bat_text_string(text, "]\n");
}

static void put_mesh(bat_text *text, const bat_part *part) {
    put_places(text, POINTS, part->points, part->vertex_count);
    put_places(text, NORMALS, part->normals, part->vertex_count);
    bat_text_string(text, OF_VERTEX);
    put_corners(text, COUNTS, NULL, part->triangle_count);
    put_corners(text, INDICES, part->triangles, 3 * part->triangle_count);
    bat_text_string(text, AS_IT_IS);
}

static void put_line(bat_text *text, const bat_part *part) {
    put_places(text, POINTS, part->points, part->vertex_count);
    bat_text_string(text, LINE);
    bat_text_integer(text, part->vertex_count);
    bat_text_string(text, LINEAR);
}

static void put_part(bat_text *text, const bat_part *part, uint64_t number) {
    static const char kinds[][12] = {
        [BAT_PART_TRIANGLES] = "Mesh", [BAT_PART_LINE] = "BasisCurves", [BAT_PART_CLOUD] = "Points"};
    bat_text_string(text, "def ");
    bat_text_string(text, kinds[part->kind]);
    bat_text_string(text, " \"part");
    bat_text_integer(text, number);
    bat_text_string(text, "\"\n{\n");
    if (part->kind == BAT_PART_TRIANGLES)
        put_mesh(text, part);
    else if (part->kind == BAT_PART_LINE)
        put_line(text, part);
    else
        put_places(text, POINTS, part->points, part->vertex_count);
    bat_text_string(text, part->kind == BAT_PART_CLOUD ? "\n}\n" : "}\n");
}

bat_status bat_usd_put_parts(const bat_parts *parts, char **bytes, size_t *size) {
    bat_text text = {0};
    if (parts->count == 0) return BAT_COUNT;
    bat_text_string(&text, OPENING);
    for (size_t i = 0; i < parts->count; i++) put_part(&text, &parts->part[i], i + 1);
    bat_text_string(&text, "}\n");
    return bat_text_finish(&text, bytes, size);
}
