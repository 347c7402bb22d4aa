/* Reads 3MF: what is in the build, where its items and components place it, in millimetres; also what other files of the archive
 * describe (the production extension). */
#include "format/threemf/threemf.h"

#include "base/pose.h"
#include "format/threemf/part.h"
#include "format/threemf/tags.h"
#include "text/json.h"
#include "text/xml.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEEPEST = 64 };

typedef struct reader {
    bat_unzip zip;
    bat_threemf_part **parts;     /* of each file of the archive; NULL: not read */
    size_t *wanted, wanted_count; /* files to read, in the order in which they were named */
    bat_faces faces;
    uint64_t left; /* of vertices, corners and components */
    bat_document *out;
    int *left_out;
    bat_problem *problem;
} reader;

static bat_status wrong(const reader *r, uint32_t id, bat_status status, const char *message) {
    char place[40];
    snprintf(place, sizeof place, "object %lu", (unsigned long)id);
    return bat_problem_set(r->problem, status, place, message);
}

static bat_status no_memory(const reader *r) {
    return bat_problem_set(r->problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
}

/* ---- files ---- */

/* The file that the archive names as its model; else the one that is called as all others call it. */
static bat_status find_model(reader *r, size_t *out) {
    static const char relations[] = "_rels/.rels", usual[] = "3D/3dmodel.model", kind[] = "/3dmodel";
    const long file = bat_unzip_find(&r->zip, relations, sizeof relations - 1);
    long found = -1;
    char *text = NULL;
    size_t size = 0, length;
    if (file >= 0) {
        bat_status status = bat_unzip_take(&r->zip, (size_t)file, &text, &size, r->problem);
        if (status != BAT_OK) return status;
        status = bat_xml_check(text, size);
        if (status != BAT_OK) {
            free(text);
            return bat_problem_set(r->problem, status, relations,
                                   status == BAT_SYNTAX ? "expected XML in UTF-8, found something else"
                                                        : bat_status_message(status));
        }
    }
    bat_tags tags = {text, text ? text + size : NULL};
    bat_tag tag;
    while (text && found < 0 && bat_tags_next(&tags, &tag)) {
        const char *value;
        if (!bat_tag_find(&tag, "Type", &value, &length) || length < sizeof kind - 1 ||
            memcmp(value + length - (sizeof kind - 1), kind, sizeof kind - 1) != 0)
            continue;
        if (bat_tag_find(&tag, "Target", &value, &length)) found = bat_unzip_find(&r->zip, value, length);
    }
    free(text);
    if (found < 0) found = bat_unzip_find(&r->zip, usual, sizeof usual - 1);
    if (found < 0)
        return bat_problem_set(r->problem, BAT_SYNTAX, "",
                               "expected 3MF, found an archive without 3D/3dmodel.model");
    *out = (size_t)found;
    return BAT_OK;
}

static bat_status want(reader *r, size_t file) {
    if (r->parts[file]) return BAT_OK;
    r->parts[file] = calloc(1, sizeof **r->parts);
    if (!r->parts[file]) return no_memory(r);
    r->wanted[r->wanted_count++] = file;
    return BAT_OK;
}

static bat_status read_file(reader *r, size_t file) {
    bat_threemf_part *part = r->parts[file];
    char *text = NULL;
    size_t size;
    bat_status status = bat_unzip_take(&r->zip, file, &text, &size, r->problem);
    if (status == BAT_OK)
        status = bat_threemf_read_part(&r->zip, file, text, size, part, r->left_out, r->problem);
    free(text);
    for (size_t i = 0; i < part->component_count && status == BAT_OK; i++)
        status = want(r, part->components[i].file);
    for (size_t i = 0; i < part->item_count && status == BAT_OK; i++) status = want(r, part->items[i].file);
    return status;
}

/* ---- placing ---- */

static bat_status spend(reader *r, uint32_t id, uint64_t count) {
    if (count > r->left)
        return wrong(r, id, BAT_COUNT, "expected fewer vertices and components for a file of this size");
    r->left -= count;
    return BAT_OK;
}

static bat_status place_mesh(reader *r, const bat_threemf_part *part, const bat_threemf_object *object,
                             const double pose[12]) {
    const int first = (int)r->faces.vertex_count;
    const bool mirrored = bat_pose_mirrors(pose);
    bat_status status = spend(r, object->id, object->vertex_count + 3 * object->triangle_count);
    for (size_t i = 0; i < object->vertex_count && status == BAT_OK; i++) {
        double at[3];
        bat_pose_apply(pose, 1, part->vertices + 3 * (object->vertex + i), at);
        status = bat_faces_add_vertex(&r->faces, at);
        if (status != BAT_OK)
            wrong(r, object->id, status,
                  status == BAT_NUMBER ? "transform: expected finite places, found another"
                                       : bat_status_message(status));
    }
    for (size_t t = 0; t < object->triangle_count && status == BAT_OK; t++) {
        const int *corners = part->triangles + 3 * (object->triangle + t);
        const int face[3] = {first + corners[0], first + corners[mirrored ? 2 : 1],
                             first + corners[mirrored ? 1 : 2]};
        status = bat_faces_add(&r->faces, face, 3);
        if (status != BAT_OK) wrong(r, object->id, status, bat_status_message(status));
    }
    return status;
}

static bat_status place(reader *r, const bat_threemf_use *use, const double pose[12], int depth) {
    const bat_threemf_part *part = r->parts[use->file];
    bat_threemf_object *object = bat_threemf_object_of(part, use->id);
    double all[12];
    if (!object)
        return wrong(r, use->id, BAT_PARAMETER,
                     "objectid: expected an object that there is, found none such");
    if (object->busy)
        return wrong(r, use->id, BAT_STATE, "expected components other than itself, found a circle");
    if (depth == DEEPEST)
        return wrong(r, use->id, BAT_COUNT, "expected components 64 deep at most, found more");
    bat_status status = spend(r, use->id, 1);
    bat_pose_multiply(pose, use->pose, all);
    object->busy = true;
    if (status == BAT_OK) status = place_mesh(r, part, object, all);
    for (size_t i = 0; i < object->component_count && status == BAT_OK; i++)
        status = place(r, &part->components[object->component + i], all, depth + 1);
    object->busy = false;
    return status;
}

static bat_status insert_item(reader *r, const bat_threemf_use *item, double unit) {
    const bat_room room = {BAT_STAND_WALL, unit, false};
    bat_faces_empty(&r->faces);
    bat_status status = place(r, item, bat_pose_none, 0);
    if (status != BAT_OK) return status;
    const char *name = bat_threemf_object_of(r->parts[item->file], item->id)->name;
    status = bat_faces_weld(&r->faces);
    if (status == BAT_OK && r->faces.face_count == 0) return BAT_OK;
    if (status == BAT_OK) status = bat_faces_insert(&r->faces, &room, name ? name : "", r->out);
    return status == BAT_OK ? status : wrong(r, item->id, status, bat_status_message(status));
}

static bat_status read_all(reader *r) {
    size_t model = 0;
    r->parts = calloc(r->zip.count + 1, sizeof(bat_threemf_part *));
    r->wanted = malloc((r->zip.count + 1) * sizeof *r->wanted);
    if (!r->parts || !r->wanted) return no_memory(r);
    bat_status status = find_model(r, &model);
    if (status == BAT_OK) status = want(r, model);
    for (size_t i = 0; i < r->wanted_count && status == BAT_OK; i++) status = read_file(r, r->wanted[i]);
    if (status != BAT_OK) return status;
    const bat_threemf_part *root = r->parts[model];
    r->left = bat_faces_bound(r->zip.taken);
    for (size_t i = 0; i < root->item_count && status == BAT_OK; i++)
        status = insert_item(r, &root->items[i], root->unit);
    if (status == BAT_OK && bat_document_count(r->out) == 0)
        return bat_problem_set(r->problem, BAT_COUNT, "build", "expected an item with triangles, found none");
    return status;
}

bat_status bat_threemf_parse(const char *bytes, size_t size, bat_document *out, int *left_out,
                             bat_problem *problem) {
    reader r = {.out = out, .left_out = left_out, .problem = problem};
    bat_status status = bat_unzip_open(bytes, size, &r.zip, problem);
    if (status != BAT_OK) return status;
    status = read_all(&r);
    for (size_t i = 0; i < r.wanted_count; i++) {
        bat_threemf_clear_part(r.parts[r.wanted[i]]);
        free(r.parts[r.wanted[i]]);
    }
    free(r.parts);
    free(r.wanted);
    bat_faces_clear(&r.faces);
    bat_unzip_close(&r.zip);
    return status;
}
