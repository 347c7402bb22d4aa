/* Writes OBJ of triangles with their normals, lines and clouds: what programs read that know no B-splines. */
#include "format/obj/obj.h"

static void put_places(bat_text *text, const char *what, const double *places, size_t count) {
    for (size_t i = 0; i < count; i++) {
        bat_text_string(text, what);
        for (int k = 0; k < 3; k++) {
            bat_text_string(text, " ");
            bat_text_number(text, places[3 * i + (size_t)k]);
        }
        bat_text_string(text, "\n");
    }
}

/* Vertices of a line or a cloud, one after the other. */
static void put_row(bat_text *text, const char *what, size_t count, uint64_t vertices) {
    bat_text_string(text, what);
    for (size_t i = 0; i < count; i++) {
        bat_text_string(text, " ");
        bat_text_integer(text, vertices + i + 1);
    }
    bat_text_string(text, "\n");
}

static void put_faces(bat_text *text, const bat_part *part, uint64_t vertices, uint64_t normals) {
    for (size_t t = 0; t < part->triangle_count; t++) {
        bat_text_string(text, "f");
        for (size_t k = 0; k < 3; k++) {
            const uint64_t corner = (uint64_t)part->triangles[3 * t + k] + 1;
            bat_text_string(text, " ");
            bat_text_integer(text, vertices + corner);
            bat_text_string(text, "//");
            bat_text_integer(text, normals + corner);
        }
        bat_text_string(text, "\n");
    }
}

bat_status bat_obj_put_parts(const bat_parts *parts, char **bytes, size_t *size) {
    bat_text text = {0};
    uint64_t vertices = 0, normals = 0;
    for (size_t i = 0; i < parts->count; i++) {
        const bat_part *part = &parts->part[i];
        bat_text_string(&text, "o part");
        bat_text_integer(&text, i + 1);
        bat_text_string(&text, "\n");
        put_places(&text, "v", part->points, part->vertex_count);
        if (part->kind == BAT_PART_TRIANGLES) {
            put_places(&text, "vn", part->normals, part->vertex_count);
            put_faces(&text, part, vertices, normals);
            normals += part->vertex_count;
        } else {
            put_row(&text, part->kind == BAT_PART_LINE ? "l" : "p", part->vertex_count, vertices);
        }
        vertices += part->vertex_count;
    }
    if (vertices > 0) return bat_text_finish(&text, bytes, size);
    bat_text_free(&text);
    return BAT_COUNT;
}
