/* Internal to formats: how a model (mesh, surfaces, curves) is put together, and taken apart into triangles. */
#ifndef BATTEN_FORMAT_MODEL_H
#define BATTEN_FORMAT_MODEL_H

#include <batten/format.h>
#include <batten/surface.h>

/* Adds one more. Takes it over, and frees it on failure. */
bat_status bat_model_add_surface(bat_model *model, bat_surface *surface);
bat_status bat_model_add_curve(bat_model *model, bat_curve *curve);

/* What is drawn as one: triangles, or without any the vertices in order (a line, or a cloud). */
typedef enum bat_part_kind { BAT_PART_TRIANGLES, BAT_PART_LINE, BAT_PART_CLOUD } bat_part_kind;
typedef struct bat_part {
    bat_part_kind kind;
    size_t vertex_count, triangle_count;
    const double *points, *normals; /* 3 numbers each; only triangles have normals */
    const int *triangles;
} bat_part;

typedef struct bat_parts {
    size_t count;
    bat_part *part;
    /* whose arrays the parts borrow */
    size_t surface_count, line_count;
    bat_tessellation **surfaces;
    double **lines, *normals;
    int *triangles;
    void **blocks; /* of parts that were closed; NULL: none was */
} bat_parts;

/* Statuses as of bat_gltf_write. tolerance 0: the default. The model must outlive the parts. */
bat_status bat_parts_create(const bat_model *model, double tolerance, bat_parts *out);
/*
 * Of parts made of that model: vertices of rims that are nearer than 1e-7 of its size become one, as at seams and poles. cap:
 * rims that lie in a plane within the tolerance (0: 1e-4 of the size) are filled, unless all that hangs together lies in that
 * plane; so are the ends of surfaces that are closed in a direction, whether they lie in a plane or not. What surfaces are
 * closed by that faces outward. *open: the edges that are left without a neighbour. On failure the parts are as they were or
 * closed. O(triangles log triangles).
 */
bat_status bat_parts_close(bat_parts *parts, const bat_model *model, double tolerance, bool cap,
                           size_t *open);
void bat_parts_clear(bat_parts *parts);
/* A file of triangles. */
typedef bat_status bat_parts_writer(const bat_parts *parts, char **bytes, size_t *size);
/* The parts of a model, as such a file. Statuses as of bat_gltf_write. */
bat_status bat_parts_write(const bat_model *model, double tolerance, bat_parts_writer *writer, char **bytes,
                           size_t *size);

#endif
