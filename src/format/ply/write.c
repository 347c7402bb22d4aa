/* Binary PLY: a header of text, the vertices with their normals, and the triangles, least byte first. */
#include "format/ply/ply.h"

#include "format/model/floats.h"

static const char OPENING[] = "ply\nformat binary_little_endian 1.0\ncomment made by Batten\nelement vertex ";
static const char VERTEX[] = "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n"
                             "property float ny\nproperty float nz\nelement face ";
static const char FACE[] = "\nproperty list uchar int vertex_indices\nend_header\n";

static void put_header(bat_text *text, uint64_t vertices, uint64_t triangles) {
    bat_text_string(text, OPENING);
    bat_text_integer(text, vertices);
    bat_text_string(text, VERTEX);
    bat_text_integer(text, triangles);
    bat_text_string(text, FACE);
}

static void put_vertices(bat_text *text, const bat_part *part) {
    for (size_t i = 0; i < part->vertex_count; i++) {
        for (size_t k = 0; k < 3; k++) bat_text_float(text, part->points[3 * i + k]);
        for (size_t k = 0; k < 3; k++) bat_text_float(text, part->normals ? part->normals[3 * i + k] : 0);
    }
}

static void put_triangles(bat_text *text, const bat_part *part, size_t first) {
    for (size_t t = 0; t < part->triangle_count; t++) {
        bat_text_add(text, "\3", 1);
        for (size_t k = 0; k < 3; k++)
            bat_text_word(text, (uint32_t)(first + (size_t)part->triangles[3 * t + k]));
    }
}

bat_status bat_ply_put_parts(const bat_parts *parts, char **bytes, size_t *size) {
    size_t vertices = 0, triangles = 0, first = 0;
    bat_text text = {0};
    for (size_t i = 0; i < parts->count; i++) {
        const bat_part *part = &parts->part[i];
        if (part->kind == BAT_PART_LINE) continue;
        if (bat_floats_check(part->points, 3 * part->vertex_count) != BAT_OK) return BAT_NUMBER;
        vertices += part->vertex_count, triangles += part->triangle_count;
    }
    if (vertices == 0) return BAT_COUNT;
    if (vertices > INT32_MAX) return BAT_TOLERANCE;
    put_header(&text, vertices, triangles);
    for (size_t i = 0; i < parts->count; i++)
        if (parts->part[i].kind != BAT_PART_LINE) put_vertices(&text, &parts->part[i]);
    for (size_t i = 0; i < parts->count; i++) {
        if (parts->part[i].kind == BAT_PART_LINE) continue;
        put_triangles(&text, &parts->part[i], first);
        first += parts->part[i].vertex_count;
    }
    return bat_text_finish(&text, bytes, size);
}
