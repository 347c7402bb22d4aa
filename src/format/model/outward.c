/* Which way the surfaces of a model face. */
#include "format/model/drawn.h"

#include "form/surface/surface.h"

/* Six times the volume between the triangles and their middle: its sign says which way they face, also of a tube. */
static bat_status signed_volume(const bat_surface *surface, double *out) {
    bat_tessellation *made = NULL;
    bat_mesh mesh;
    double middle[3] = {0, 0, 0}, sum = 0;
    bat_status status = bat_surface_tessellate(surface, NULL, &made, NULL);
    if (status != BAT_OK) return status;
    bat_tessellation_mesh(made, &mesh);
    const size_t count = mesh.rows * mesh.columns;
    for (size_t i = 0; i < 3 * count; i++) middle[i % 3] += mesh.points[i] / (double)count;
    for (size_t t = 0; t < mesh.triangle_count; t++) {
        double p[3][3];
        for (int k = 0; k < 3; k++)
            for (int c = 0; c < 3; c++)
                p[k][c] = mesh.points[3 * mesh.triangles[3 * t + (size_t)k] + c] - middle[c];
        sum += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
               p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
               p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    }
    bat_tessellation_free(made);
    *out = sum;
    return BAT_OK;
}

bat_status bat_model_face_outward(bat_model *model) {
    for (size_t i = 0; i < model->surface_count; i++) {
        bat_surface *surface = model->surfaces[i], *turned = NULL;
        double volume = 0;
        if (!bat_surface_is_closed(surface, BAT_U) && !bat_surface_is_closed(surface, BAT_V)) continue;
        bat_status status = signed_volume(surface, &volume);
        if (status == BAT_OK && volume < 0) status = bat_surface_transpose(surface, &turned);
        if (status != BAT_OK) return status;
        if (!turned) continue;
        bat_surface_free(surface);
        model->surfaces[i] = turned;
    }
    return BAT_OK;
}
