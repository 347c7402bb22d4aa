#include "format/gltf/source.h"

#include "format/gltf/gltf.h"
#include "format/model/floats.h"
#include "text/base64.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { HEADER = 12, CHUNK = 8, MAGIC = 0x46546C67, JSON = 0x4E4F534A, BINARY = 0x004E4942 };
static const char *const names[BAT_GLTF_LISTS] = {"accessors", "bufferViews", "buffers",
                                                  "meshes",    "nodes",       "scenes"};

bat_status bat_gltf_wrong(const bat_gltf_source *source, bat_gltf_list list, size_t index, bat_status status,
                          const char *message) {
    char place[64];
    snprintf(place, sizeof place, "%s[%zu]", names[list], index);
    return bat_problem_set(source->problem, status, place, message);
}

bool bat_gltf_whole(const bat_json *json, uint32_t node, uint64_t most, uint64_t fallback, uint64_t *out) {
    *out = fallback;
    if (!node) return true;
    if (bat_json_type_of(json, node) != BAT_JSON_NUMBER) return false;
    const double value = json->nodes[node].value.number;
    if (!(value >= 0 && value <= (double)most && value == floor(value))) return false;
    *out = (uint64_t)value;
    return true;
}

bool bat_gltf_index(const bat_gltf_source *source, uint32_t node, bat_gltf_list list, size_t *out) {
    uint64_t value;
    if (!node || source->count[list] == 0 ||
        !bat_gltf_whole(&source->json, node, source->count[list] - 1, 0, &value))
        return false;
    *out = (size_t)value;
    return true;
}

/* ---- the file ---- */

bool bat_gltf_is_binary(const char *bytes, size_t size) { return size >= 4 && bat_word_at(bytes) == MAGIC; }

/* The JSON of a binary file, and where its numbers are. */
static bat_status unpack(const char *bytes, size_t size, bat_gltf_source *out, const char **text,
                         size_t *length) {
    char message[120];
    if (size < HEADER + CHUNK)
        return bat_problem_set(out->problem, BAT_SYNTAX, "",
                               "expected a whole GLB file, found its beginning");
    if (bat_word_at(bytes + 4) != 2)
        return bat_problem_set(out->problem, BAT_UNSUPPORTED, "", "expected glTF 2.0, found another version");
    const size_t total = bat_word_at(bytes + 8), first = bat_word_at(bytes + HEADER);
    if (total > size || total < HEADER + CHUNK || first > total - HEADER - CHUNK) {
        snprintf(message, sizeof message, "expected %zu bytes, as the file says, found %zu",
                 total > size ? total : first, size);
        return bat_problem_set(out->problem, BAT_SYNTAX, "", message);
    }
    if (bat_word_at(bytes + HEADER + 4) != JSON)
        return bat_problem_set(out->problem, BAT_SYNTAX, "", "expected a chunk of JSON first, found another");
    *text = bytes + HEADER + CHUNK, *length = first;
    while (*length && (*text)[*length - 1] == '\0') --*length;
    const size_t at = HEADER + CHUNK + first;
    if (total - at < CHUNK || bat_word_at(bytes + at + 4) != BINARY) return BAT_OK;
    out->binary_size = bat_word_at(bytes + at);
    out->binary = bytes + at + CHUNK;
    if (out->binary_size <= total - at - CHUNK) return BAT_OK;
    return bat_problem_set(out->problem, BAT_SYNTAX, "",
                           "expected a chunk of numbers as long as it says, found less");
}

static bat_status list_nodes(bat_gltf_source *source) {
    for (int l = 0; l < BAT_GLTF_LISTS; l++) {
        const uint32_t list = bat_json_member(&source->json, 1, names[l]);
        const size_t count = bat_json_count(&source->json, list);
        source->nodes[l] = malloc((count + 1) * sizeof *source->nodes[l]);
        if (!source->nodes[l]) return BAT_MEMORY;
        source->count[l] = 0;
        for (uint32_t at = bat_json_first(&source->json, list); at; at = source->json.nodes[at].next)
            source->nodes[l][source->count[l]++] = at;
    }
    source->buffers = calloc(source->count[BAT_GLTF_BUFFERS] + 1, sizeof *source->buffers);
    return source->buffers ? BAT_OK : BAT_MEMORY;
}

/* What makes other numbers of those that are in the file. */
static bat_status check_extensions(const bat_gltf_source *source) {
    static const char *const known[] = {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                        "KHR_meshopt_compression", "EXT_mesh_gpu_instancing"};
    const bat_json *json = &source->json;
    char message[120];
    const uint32_t list = bat_json_member(json, 1, "extensionsRequired");
    for (uint32_t at = bat_json_first(json, list); at; at = json->nodes[at].next)
        for (size_t i = 0; i < sizeof known / sizeof *known; i++)
            if (bat_json_text(json, at) && strcmp(bat_json_text(json, at), known[i]) == 0) {
                snprintf(message, sizeof message, "expected numbers as they are, found %s", known[i]);
                return bat_problem_set(source->problem, BAT_UNSUPPORTED, "extensionsRequired", message);
            }
    return BAT_OK;
}

bat_status bat_gltf_open(const char *bytes, size_t size, bat_gltf_source *out, bat_problem *problem) {
    bat_gltf_source made = {.problem = problem};
    const char *text = bytes;
    size_t length = size;
    bat_status status = bat_gltf_is_binary(bytes, size) ? unpack(bytes, size, &made, &text, &length) : BAT_OK;
    if (status == BAT_OK) status = bat_json_parse(text, length, &made.json, problem);
    if (status != BAT_OK) return status;
    const uint32_t asset = bat_json_member(&made.json, 1, "asset");
    const char *version = bat_json_text(&made.json, bat_json_member(&made.json, asset, "version"));
    if (!version || version[0] != '2' || version[1] != '.')
        status = bat_problem_set(problem, BAT_UNSUPPORTED, "asset",
                                 "version: expected glTF 2.0, found another or none");
    if (status == BAT_OK) status = check_extensions(&made);
    if (status == BAT_OK) {
        status = list_nodes(&made);
        if (status != BAT_OK) bat_problem_set(problem, status, "", bat_status_message(status));
    }
    if (status == BAT_OK)
        *out = made;
    else
        bat_gltf_close(&made);
    return status;
}

void bat_gltf_close(bat_gltf_source *source) {
    for (size_t i = 0; source->buffers && i < source->count[BAT_GLTF_BUFFERS]; i++)
        free(source->buffers[i].own);
    free(source->buffers);
    for (int l = 0; l < BAT_GLTF_LISTS; l++) free(source->nodes[l]);
    bat_json_free(&source->json);
}

bool bat_gltf_is_text(const char *text, size_t size) {
    static const char word[] = "\"asset\"";
    const size_t start = bat_format_start(text, size), length = sizeof word - 1;
    bat_json json;
    bool found = false;
    if (start == size || text[start] != '{') return false;
    for (size_t at = start; at + length <= size && !found; at++)
        found = text[at] == '"' && memcmp(text + at, word, length) == 0;
    if (!found || bat_json_parse(text, size, &json, NULL) != BAT_OK) return false;
    const uint32_t asset = bat_json_member(&json, 1, "asset");
    found = bat_json_text(&json, bat_json_member(&json, asset, "version")) != NULL;
    bat_json_free(&json);
    return found;
}

/* ---- numbers ---- */

/* Where the numbers of a data URI begin; NULL: it is none. */
static const char *numbers_of(const char *uri) {
    static const char data[] = "data:", base[] = ";base64";
    const char *comma = strchr(uri, ',');
    if (strncmp(uri, data, sizeof data - 1) != 0 || !comma || comma - uri < (ptrdiff_t)sizeof base)
        return NULL;
    return strncmp(comma - (sizeof base - 1), base, sizeof base - 1) == 0 ? comma + 1 : NULL;
}

static bat_status load(bat_gltf_source *source, size_t index) {
    bat_gltf_buffer *buffer = &source->buffers[index];
    const uint32_t node = bat_json_member(&source->json, source->nodes[BAT_GLTF_BUFFERS][index], "uri");
    const char *uri = bat_json_text(&source->json, node);
    if (buffer->bytes) return BAT_OK;
    if (!uri && index == 0 && source->binary) {
        *buffer = (bat_gltf_buffer){source->binary, source->binary_size, NULL};
        return BAT_OK;
    }
    const char *text = uri ? numbers_of(uri) : NULL;
    if (!text)
        return bat_gltf_wrong(
            source, BAT_GLTF_BUFFERS, index, BAT_UNSUPPORTED,
            "expected numbers in the file itself, found another file's name or none: save it as .glb");
    const size_t length = strlen(text);
    unsigned char *own = malloc(length / 4 * 3 + 6);
    if (!own)
        return bat_gltf_wrong(source, BAT_GLTF_BUFFERS, index, BAT_MEMORY, bat_status_message(BAT_MEMORY));
    const bat_status status = bat_base64_read(text, length, own, &buffer->size);
    if (status == BAT_OK) {
        buffer->own = own, buffer->bytes = (const char *)own;
        return BAT_OK;
    }
    free(own);
    return bat_gltf_wrong(source, BAT_GLTF_BUFFERS, index, BAT_SYNTAX,
                          "uri: expected base 64, found something else");
}

/* How numbers lie in a buffer. */
typedef struct layout {
    size_t buffer;
    uint64_t at, stride, count;
    int type, width;
    bool normalized;
} layout;

static size_t size_of(int type) {
    return type == 5120 || type == 5121   ? 1
           : type == 5122 || type == 5123 ? 2
           : type == 5125 || type == 5126 ? 4
                                          : 0;
}

static bat_status find(const bat_gltf_source *source, size_t accessor, int width, layout *out) {
    const bat_json *json = &source->json;
    const uint32_t node = source->nodes[BAT_GLTF_ACCESSORS][accessor];
    const uint64_t most = (uint64_t)1 << 40;
    uint64_t at = 0, from = 0, length = 0, type = 0;
    size_t view;
    if (bat_json_member(json, node, "sparse") || !bat_json_member(json, node, "bufferView"))
        return bat_gltf_wrong(source, BAT_GLTF_ACCESSORS, accessor, BAT_UNSUPPORTED,
                              "expected numbers as they are, found sparse or compressed ones");
    const char *shape = bat_json_text(json, bat_json_member(json, node, "type"));
    if (!shape || strcmp(shape, width == 1 ? "SCALAR" : "VEC3") != 0 ||
        !bat_gltf_whole(json, bat_json_member(json, node, "componentType"), 1 << 16, 0, &type) ||
        !size_of((int)type) ||
        !bat_gltf_whole(json, bat_json_member(json, node, "count"), most, 0, &out->count) ||
        !bat_gltf_whole(json, bat_json_member(json, node, "byteOffset"), most, 0, &at) ||
        !bat_gltf_index(source, bat_json_member(json, node, "bufferView"), BAT_GLTF_VIEWS, &view))
        return bat_gltf_wrong(source, BAT_GLTF_ACCESSORS, accessor, BAT_SYNTAX,
                              width == 1 ? "expected the numbers of corners, found others"
                                         : "expected places, found others");
    const uint32_t lies = source->nodes[BAT_GLTF_VIEWS][view];
    const uint64_t each = size_of((int)type) * (uint64_t)width;
    if (!bat_gltf_index(source, bat_json_member(json, lies, "buffer"), BAT_GLTF_BUFFERS, &out->buffer) ||
        !bat_gltf_whole(json, bat_json_member(json, lies, "byteOffset"), most, 0, &from) ||
        !bat_gltf_whole(json, bat_json_member(json, lies, "byteLength"), most, 0, &length) ||
        !bat_gltf_whole(json, bat_json_member(json, lies, "byteStride"), 1 << 16, each, &out->stride) ||
        out->stride == 0)
        return bat_gltf_wrong(source, BAT_GLTF_VIEWS, view, BAT_SYNTAX,
                              "expected a buffer and where in it, found something else");
    if (out->count &&
        (out->count > length || at + each > length || (length - at - each) / out->stride < out->count - 1))
        return bat_gltf_wrong(source, BAT_GLTF_ACCESSORS, accessor, BAT_SYNTAX,
                              "expected numbers within their view, found more");
    out->at = from + at, out->type = (int)type, out->width = width;
    out->normalized = bat_json_type_of(json, bat_json_member(json, node, "normalized")) == BAT_JSON_TRUE;
    return BAT_OK;
}

static double number_at(const char *bytes, const layout *lies) {
    if (lies->type == 5126) return bat_float_at(bytes);
    if (lies->type == 5125) return (double)bat_word_at(bytes);
    const size_t size = size_of(lies->type);
    unsigned word = 0;
    for (size_t k = 0; k < size; k++) word |= (unsigned)(unsigned char)bytes[k] << 8 * k;
    const bool is_signed = lies->type == 5120 || lies->type == 5122;
    const double all = size == 1 ? 256 : 65536;
    const double value = is_signed && word >= all / 2 ? (double)word - all : (double)word;
    return lies->normalized ? fmax(value / (is_signed ? all / 2 - 1 : all - 1), -1) : value;
}

bat_status bat_gltf_numbers(bat_gltf_source *source, size_t accessor, int width, uint64_t *left,
                            size_t *count, double **numbers) {
    layout lies = {.buffer = 0};
    bat_status status = find(source, accessor, width, &lies);
    if (status == BAT_OK) status = load(source, lies.buffer);
    if (status != BAT_OK) return status;
    const bat_gltf_buffer *buffer = &source->buffers[lies.buffer];
    const uint64_t each = size_of(lies.type) * (uint64_t)width, last = lies.count ? lies.count - 1 : 0;
    if (lies.count && lies.at + last * lies.stride + each > buffer->size)
        return bat_gltf_wrong(source, BAT_GLTF_BUFFERS, lies.buffer, BAT_SYNTAX,
                              "expected more numbers, found the end");
    if (lies.count > *left)
        return bat_gltf_wrong(source, BAT_GLTF_ACCESSORS, accessor, BAT_COUNT,
                              "expected fewer vertices and corners for a file of this size");
    *left -= lies.count;
    double *made = malloc(((size_t)lies.count * (size_t)width + 1) * sizeof *made);
    if (!made)
        return bat_gltf_wrong(source, BAT_GLTF_ACCESSORS, accessor, BAT_MEMORY,
                              bat_status_message(BAT_MEMORY));
    for (size_t i = 0; i < lies.count; i++)
        for (size_t k = 0; k < (size_t)width; k++)
            made[i * (size_t)width + k] = number_at(
                buffer->bytes + lies.at + i * lies.stride + k * size_of(lies.type), &lies);
    *count = (size_t)lies.count;
    *numbers = made;
    return BAT_OK;
}
