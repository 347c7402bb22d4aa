/* Binary glTF 2.0 (GLB): a header, a chunk of JSON, and a chunk of numbers: for each part its points, normals and
 * triangles, one after the other. Each part is a mesh with one primitive and a node of its own. */
#include "format/model/floats.h"
#include "format/model/model.h"

#include <math.h>

enum { FLOAT = 5126, UNSIGNED = 5125, VERTICES = 34962, INDICES = 34963 };
enum { HEADER = 12, CHUNK = 8 };

typedef struct writer {
    bat_text accessors, views, meshes, nodes, scene, numbers;
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
    put_member(&w->views, ",\"target\":", (uint64_t)target);
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

static void put_list(bat_text *text, const char *name, const bat_text *list) {
    bat_text_string(text, ",\n\"");
    bat_text_string(text, name);
    bat_text_string(text, "\":[");
    text->failed = text->failed || list->failed;
    bat_text_add(text, list->data, list->size);
    bat_text_string(text, "]");
}

/* The chunk of JSON, filled up to a multiple of 4 bytes. */
static void put_json(const writer *w, bat_text *text) {
    bat_text_string(text, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"Batten " BAT_VERSION
                          "\"},\"scene\":0,\"scenes\":[{\"nodes\":[");
    bat_text_add(text, w->scene.data, w->scene.size);
    bat_text_string(text, "]}],\n\"materials\":[{\"doubleSided\":true,\"pbrMetallicRoughness\":"
                          "{\"metallicFactor\":0,\"roughnessFactor\":0.6}}]");
    text->failed = text->failed || w->scene.failed;
    put_list(text, "nodes", &w->nodes);
    put_list(text, "meshes", &w->meshes);
    put_list(text, "accessors", &w->accessors);
    put_list(text, "bufferViews", &w->views);
    put_member(text, ",\n\"buffers\":[{\"byteLength\":", w->numbers.size);
    bat_text_string(text, "}]}");
    for (size_t fill = (4 - text->size % 4) % 4; fill > 0; fill--) bat_text_string(text, " ");
}

static bat_status put_file(const writer *w, char **bytes, size_t *size) {
    bat_text json = {0}, file = {0};
    put_json(w, &json);
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

bat_status bat_gltf_write(const bat_model *model, double tolerance, char **bytes, size_t *size) {
    if (!model || !bytes || !size) return BAT_ARGUMENT;
    bat_parts parts;
    writer w = {.part_count = 0};
    bat_status status = bat_parts_create(model, tolerance, &parts);
    if (status != BAT_OK) return status;
    for (size_t i = 0; i < parts.count && status == BAT_OK; i++) status = put_part(&w, &parts.part[i]);
    bat_parts_clear(&parts);
    if (status == BAT_OK) status = w.part_count ? put_file(&w, bytes, size) : BAT_COUNT;
    bat_text *const texts[] = {&w.accessors, &w.views, &w.meshes, &w.nodes, &w.scene, &w.numbers};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) bat_text_free(texts[i]);
    return status;
}
