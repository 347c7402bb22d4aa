/* Binary glTF 2.0 (GLB): a header, a chunk of JSON, and a chunk of numbers: for each part its points, normals and
 * triangles, one after the other. Each part is a mesh with one primitive and a node of its own. */
#include "format/gltf/gltf.h"
#include "format/model/floats.h"

#include "base/real.h"
#include "text/base64.h"
#include <batten/camera.h>

#include <math.h>
#include <stdlib.h>

enum { FLOAT = 5126, UNSIGNED = 5125, VERTICES = 34962, INDICES = 34963 };
enum { HEADER = 12, CHUNK = 8 };

typedef struct writer {
    bat_text accessors, views, meshes, nodes, scene, numbers, move;
    unsigned accessor_count, part_count;
} writer;

static void put_member(bat_text *text, const char *name, uint64_t value) {
    bat_text_string(text, name);
    bat_text_integer(text, value);
}

/* One accessor with a view of its own, over what was written since `from`. */
static void put_accessor(writer *w, size_t from, size_t count, int type, int target, const char *shape) {
    const char *separator = w->accessor_count ? ",\n" : "";
    bat_text_string(&w->views, separator);
    put_member(&w->views, "{\"buffer\":0,\"byteOffset\":", from);
    put_member(&w->views, ",\"byteLength\":", w->numbers.size - from);
    if (target) put_member(&w->views, ",\"target\":", (uint64_t)target);
    bat_text_string(&w->views, "}");
    bat_text_string(&w->accessors, separator);
    put_member(&w->accessors, "{\"bufferView\":", w->accessor_count++);
    put_member(&w->accessors, ",\"componentType\":", (uint64_t)type);
    put_member(&w->accessors, ",\"count\":", count);
    bat_text_string(&w->accessors, ",\"type\":\"");
    bat_text_string(&w->accessors, shape);
    bat_text_string(&w->accessors, "\"");
}

static void put_floats(writer *w, const double *numbers, size_t count) {
    for (size_t i = 0; i < count; i++) bat_text_float(&w->numbers, numbers[i]);
}

/* The box of the points as they were rounded. */
static void put_box(bat_text *text, const bat_part *part) {
    for (int side = 0; side < 2; side++) {
        bat_text_string(text, side ? "],\"max\":[" : ",\"min\":[");
        for (int c = 0; c < 3; c++) {
            double most = part->points[c];
            for (size_t i = 1; i < part->vertex_count; i++) {
                const double x = part->points[3 * i + (size_t)c];
                most = side ? fmax(most, x) : fmin(most, x);
            }
            if (c) bat_text_string(text, ",");
            bat_text_number(text, (double)(float)most);
        }
    }
    bat_text_string(text, "]}");
}

static void put_vertices(writer *w, const bat_part *part) {
    size_t from = w->numbers.size;
    put_floats(w, part->points, 3 * part->vertex_count);
    put_accessor(w, from, part->vertex_count, FLOAT, VERTICES, "VEC3");
    put_box(&w->accessors, part);
    if (part->kind != BAT_PART_TRIANGLES) return;
    from = w->numbers.size;
    put_floats(w, part->normals, 3 * part->vertex_count);
    put_accessor(w, from, part->vertex_count, FLOAT, VERTICES, "VEC3");
    bat_text_string(&w->accessors, "}");
}

static void put_triangles(writer *w, const bat_part *part) {
    const size_t from = w->numbers.size;
    for (size_t i = 0; i < 3 * part->triangle_count; i++)
        bat_text_word(&w->numbers, (uint32_t)part->triangles[i]);
    put_accessor(w, from, 3 * part->triangle_count, UNSIGNED, INDICES, "SCALAR");
    bat_text_string(&w->accessors, "}");
}

static bat_status put_part(writer *w, const bat_part *part) {
    static const int modes[] = {[BAT_PART_TRIANGLES] = 4, [BAT_PART_LINE] = 3, [BAT_PART_CLOUD] = 0};
    const bool triangles = part->kind == BAT_PART_TRIANGLES;
    const char *separator = w->part_count ? ",\n" : "";
    if (triangles && part->triangle_count == 0) return BAT_OK;
    if (bat_floats_check(part->points, 3 * part->vertex_count) != BAT_OK) return BAT_NUMBER;
    bat_text_string(&w->meshes, separator);
    put_member(&w->meshes, "{\"primitives\":[{\"attributes\":{\"POSITION\":", w->accessor_count);
    if (triangles) {
        put_member(&w->meshes, ",\"NORMAL\":", w->accessor_count + 1);
        put_member(&w->meshes, "},\"indices\":", w->accessor_count + 2);
    } else {
        bat_text_string(&w->meshes, "}");
    }
    put_member(&w->meshes, ",\"material\":0,\"mode\":", (uint64_t)modes[part->kind]);
    bat_text_string(&w->meshes, "}]}");
    bat_text_string(&w->nodes, separator);
    put_member(&w->nodes, "{\"mesh\":", w->part_count);
    bat_text_string(&w->nodes, "}");
    put_member(&w->scene, w->part_count ? "," : "", w->part_count);
    w->part_count++;
    put_vertices(w, part);
    if (triangles) put_triangles(w, part);
    return BAT_OK;
}

/* ---- a camera that moves ---- */

/* What is read by a player from `count` keys: for each the slope at which a value is reached, the value, and the slope at
 * which it is left. */
static void put_track(writer *w, const bat_camera_key *keys, size_t count, int first, int size, double scale,
                      const char *shape) {
    const size_t from = w->numbers.size;
    for (size_t i = 0; i < count; i++) {
        const double *const rows[3] = {keys[i].arrive, keys[i].value, keys[i].leave};
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < size; c++) bat_text_float(&w->numbers, scale * rows[r][first + c]);
    }
    put_accessor(w, from, 3 * count, FLOAT, 0, shape);
    bat_text_string(&w->accessors, "}");
}

static void put_times(writer *w, const bat_camera_key *keys, size_t count) {
    const size_t from = w->numbers.size;
    for (size_t i = 0; i < count; i++) bat_text_float(&w->numbers, keys[i].time);
    put_accessor(w, from, count, FLOAT, 0, "SCALAR");
    bat_text_string(&w->accessors, ",\"min\":[0],\"max\":[");
    bat_text_number(&w->accessors, (double)(float)keys[count - 1].time);
    bat_text_string(&w->accessors, "]}");
}

static void put_sampler(bat_text *text, unsigned times, unsigned track, const char *separator) {
    put_member(text, "{\"input\":", times);
    put_member(text, ",\"output\":", times + 1 + track);
    bat_text_string(text, ",\"interpolation\":\"CUBICSPLINE\"}");
    bat_text_string(text, separator);
}

static void put_channel(bat_text *text, unsigned track, unsigned node, const char *path) {
    put_member(text, "{\"sampler\":", track);
    put_member(text, ",\"target\":{\"node\":", node);
    bat_text_string(text, ",\"path\":\"");
    bat_text_string(text, path);
    bat_text_string(text, "\"}}");
}

/* Nothing but an extension moves a field of view, which players may pass over: they keep the first one. */
static void put_zoom(writer *w, const bat_camera_key *keys, size_t count) {
    put_track(w, keys, count, 7, 1, BAT_PI / 180, "SCALAR");
    bat_text_string(
        &w->move,
        ",{\"sampler\":2,\"target\":{\"path\":\"pointer\",\"extensions\":{\"KHR_animation_pointer\":"
        "{\"pointer\":\"/cameras/0/perspective/yfov\"}}}}");
}

/* What players that make rotations unit agree with the move to. */
typedef struct within {
    double place, angle; /* radians */
} within;

static void put_animation(writer *w, const bat_camera_key *keys, size_t count, const within *told,
                          bool zooms) {
    const unsigned node = w->part_count, times = w->accessor_count;
    bat_text_string(&w->nodes, node ? ",\n" : "");
    bat_text_string(&w->nodes, "{\"camera\":0,\"name\":\"camera\"}");
    put_member(&w->scene, node ? "," : "", node);
    put_times(w, keys, count);
    put_track(w, keys, count, 0, 3, 1, "VEC3");
    put_track(w, keys, count, 3, 4, 1, "VEC4");
    bat_text_string(&w->move, ",\n\"animations\":[{\"extras\":{\"within\":{\"position\":");
    bat_text_number(&w->move, told->place);
    bat_text_string(&w->move, ",\"degrees\":");
    bat_text_number(&w->move, told->angle * (180 / BAT_PI));
    bat_text_string(&w->move, "}},\"samplers\":[");
    put_sampler(&w->move, times, 0, ",");
    put_sampler(&w->move, times, 1, zooms ? "," : "");
    if (zooms) put_sampler(&w->move, times, 2, "");
    bat_text_string(&w->move, "],\"channels\":[");
    put_channel(&w->move, 0, node, "translation");
    bat_text_string(&w->move, ",");
    put_channel(&w->move, 1, node, "rotation");
    if (zooms) put_zoom(w, keys, count);
    bat_text_string(&w->move, zooms ? "]}],\n\"extensionsUsed\":[\"KHR_animation_pointer\"]" : "]}]");
}

static bat_status put_keys(writer *w, const bat_camera_key *keys, size_t count, const within *told,
                           double near) {
    bool zooms = false;
    for (size_t i = 0; i < count; i++) {
        if (!(keys[i].value[7] > 0 && keys[i].value[7] < 180)) return BAT_NUMBER;
        if (bat_floats_check(keys[i].arrive, 8) != BAT_OK || bat_floats_check(keys[i].value, 8) != BAT_OK ||
            bat_floats_check(keys[i].leave, 8) != BAT_OK)
            return BAT_NUMBER;
        zooms = zooms || keys[i].value[7] != keys[0].value[7] || keys[i].leave[7] != 0;
    }
    bat_text_string(&w->move, ",\n\"cameras\":[{\"type\":\"perspective\",\"perspective\":{\"yfov\":");
    bat_text_number(&w->move, keys[0].value[7] * (BAT_PI / 180));
    bat_text_string(&w->move, ",\"znear\":");
    bat_text_number(&w->move, near);
    bat_text_string(&w->move, "}}]");
    put_animation(w, keys, count, told, zooms);
    return BAT_OK;
}

/* ---- the file ---- */

static void put_list(bat_text *text, const char *name, const bat_text *list) {
    if (list->size == 0 && !list->failed) return; /* lists must not be empty */
    bat_text_string(text, ",\n\"");
    bat_text_string(text, name);
    bat_text_string(text, "\":[");
    text->failed = text->failed || list->failed;
    bat_text_add(text, list->data, list->size);
    bat_text_string(text, "]");
}

/* All but the end of JSON, which says where the numbers are. */
static void put_json(const writer *w, bat_text *text) {
    bat_text_string(text, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"Batten " BAT_VERSION
                          "\"},\"scene\":0,\"scenes\":[{\"nodes\":[");
    bat_text_add(text, w->scene.data, w->scene.size);
    bat_text_string(text, "]}],\n\"materials\":[{\"doubleSided\":true,\"pbrMetallicRoughness\":"
                          "{\"metallicFactor\":0,\"roughnessFactor\":0.6}}]");
    text->failed = text->failed || w->scene.failed || w->move.failed;
    bat_text_add(text, w->move.data, w->move.size);
    put_list(text, "nodes", &w->nodes);
    put_list(text, "meshes", &w->meshes);
    put_list(text, "accessors", &w->accessors);
    put_list(text, "bufferViews", &w->views);
    put_member(text, ",\n\"buffers\":[{\"byteLength\":", w->numbers.size);
}

/* JSON with the numbers in it. */
static bat_status put_text(const writer *w, char **bytes, size_t *size) {
    bat_text text = {0};
    put_json(w, &text);
    bat_text_string(&text, ",\"uri\":\"data:application/octet-stream;base64,");
    if (!w->numbers.failed) bat_base64_write(&text, w->numbers.data, w->numbers.size);
    bat_text_string(&text, "\"}]}\n");
    text.failed = text.failed || w->numbers.failed;
    return bat_text_finish(&text, bytes, size);
}

static bat_status put_file(const writer *w, char **bytes, size_t *size) {
    bat_text json = {0}, file = {0};
    put_json(w, &json);
    bat_text_string(&json, "}]}");
    for (size_t fill = (4 - json.size % 4) % 4; fill > 0; fill--) bat_text_string(&json, " ");
    const uint64_t total = HEADER + 2 * CHUNK + (uint64_t)json.size + w->numbers.size;
    bat_status status = json.failed || w->numbers.failed ? BAT_MEMORY
                        : total > UINT32_MAX             ? BAT_TOLERANCE
                                                         : BAT_OK;
    if (status == BAT_OK) {
        const uint32_t words[5] = {0x46546C67, 2, (uint32_t)total, (uint32_t)json.size, 0x4E4F534A};
        for (int k = 0; k < 5; k++) bat_text_word(&file, words[k]);
        bat_text_add(&file, json.data, json.size);
        bat_text_word(&file, (uint32_t)w->numbers.size);
        bat_text_word(&file, 0x004E4942);
        bat_text_add(&file, w->numbers.data, w->numbers.size);
        status = bat_text_finish(&file, bytes, size);
    }
    bat_text_free(&json);
    return status;
}

static void clear(writer *w) {
    bat_text *const texts[] = {&w->accessors, &w->views,   &w->meshes, &w->nodes,
                               &w->scene,     &w->numbers, &w->move};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) bat_text_free(texts[i]);
}

static bat_status put_model(writer *w, const bat_model *model, double tolerance) {
    bat_parts parts;
    bat_status status = bat_parts_create(model, tolerance, &parts);
    if (status != BAT_OK) return status;
    for (size_t i = 0; i < parts.count && status == BAT_OK; i++) status = put_part(w, &parts.part[i]);
    bat_parts_clear(&parts);
    return status;
}

static bat_status put_parts(const bat_parts *parts, bool as_text, char **bytes, size_t *size) {
    writer w = {.part_count = 0};
    bat_status status = BAT_OK;
    for (size_t i = 0; i < parts->count && status == BAT_OK; i++) status = put_part(&w, &parts->part[i]);
    if (status == BAT_OK)
        status = !w.part_count ? BAT_COUNT : as_text ? put_text(&w, bytes, size) : put_file(&w, bytes, size);
    clear(&w);
    return status;
}

bat_status bat_gltf_put_parts(const bat_parts *parts, char **bytes, size_t *size) {
    return put_parts(parts, false, bytes, size);
}

bat_status bat_gltf_put_parts_as_text(const bat_parts *parts, char **bytes, size_t *size) {
    return put_parts(parts, true, bytes, size);
}

bat_status bat_gltf_write(const bat_model *model, double tolerance, char **bytes, size_t *size) {
    return bat_parts_write(model, tolerance, bat_gltf_put_parts, bytes, size);
}

bat_status bat_gltf_write_move(const bat_camera *camera, double place, double angle, char **bytes,
                               size_t *size) {
    return bat_gltf_write_scene(camera, NULL, place, angle, bytes, size);
}

bat_status bat_gltf_write_scene(const bat_camera *camera, const bat_model *scene, double place, double angle,
                                char **bytes, size_t *size) {
    if (!camera || !bytes || !size) return BAT_ARGUMENT;
    writer w = {.part_count = 0};
    bat_camera_key *keys = NULL;
    size_t count = 0;
    bat_curve *path = (bat_curve *)bat_camera_path(camera); /* read only */
    const bat_model model = {.curve_count = 1, .curves = &path};
    const double extent = bat_curve_size(path);
    const within told = {place > 0 ? place : 1e-4 * (extent > 0 ? extent : 1),
                         angle > 0 ? angle : 0.1 * BAT_PI / 180};
    bat_status status = bat_camera_keys(camera, told.place, told.angle, &count, &keys);
    if (status == BAT_OK && extent > 0) status = put_model(&w, &model, told.place);
    if (status == BAT_OK && scene) status = put_model(&w, scene, 0);
    if (status == BAT_OK) status = put_keys(&w, keys, count, &told, 1e-3 * (extent > 0 ? extent : 1));
    if (status == BAT_OK) status = put_file(&w, bytes, size);
    free(keys);
    clear(&w);
    return status;
}
