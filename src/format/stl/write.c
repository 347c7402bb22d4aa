/* Binary STL: a header of 80 bytes, the number of triangles, and for each its normal and corners as 32-bit floats, least
 * byte first. */
#include "format/stl/stl.h"
#include "format/model/floats.h"
#include "base/vec.h"

static void put_triangle(bat_text *text, const bat_part *part, const int *triangle, uint32_t *count) {
    vec at[3];
    for (int k = 0; k < 3; k++) at[k] = vec_load(part->points + 3 * (size_t)triangle[k], 3);
    const vec normal = vec_unit(vec_cross(vec_sub(at[1], at[0]), vec_sub(at[2], at[0])));
    if (!(vec_dot(normal, normal) > 0)) return; /* it has no area */
    const double numbers[12] = {normal.x, normal.y, normal.z, at[0].x, at[0].y, at[0].z,
                                at[1].x,  at[1].y,  at[1].z,  at[2].x, at[2].y, at[2].z};
    for (int k = 0; k < 12; k++) bat_text_float(text, numbers[k]);
    bat_text_add(text, "\0", 2);
    ++*count;
}

bat_status bat_stl_put_parts(const bat_parts *parts, char **bytes, size_t *size) {
    enum { HEADER = 80 };
    static const char header[HEADER] = "Binary STL, made by Batten";
    bat_text text = {0};
    uint32_t count = 0;
    bat_status status = BAT_OK;
    bat_text_add(&text, header, sizeof header);
    bat_text_word(&text, 0);
    for (size_t i = 0; i < parts->count && status == BAT_OK; i++) {
        const bat_part *part = &parts->part[i];
        if (part->kind != BAT_PART_TRIANGLES) continue;
        status = bat_floats_check(part->points, 3 * part->vertex_count);
        for (size_t t = 0; t < part->triangle_count && status == BAT_OK; t++)
            put_triangle(&text, part, part->triangles + 3 * t, &count);
    }
    if (status == BAT_OK && count == 0) status = BAT_COUNT;
    if (status == BAT_OK) {
        bat_text_patch(&text, HEADER, count);
        return bat_text_finish(&text, bytes, size);
    }
    bat_text_free(&text);
    return status;
}

bat_status bat_stl_write(const bat_model *model, double tolerance, char **bytes, size_t *size) {
    return bat_parts_write(model, tolerance, bat_stl_put_parts, bytes, size);
}
