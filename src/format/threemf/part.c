#include "format/threemf/part.h"

#include "format/model/faces.h"
#include "base/pose.h"
#include "format/threemf/tags.h"
#include "text/json.h"
#include "text/utf8.h"
#include "text/xml.h"

#include <batten/mesh.h>

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct reader {
    const bat_unzip *zip;
    size_t file;
    bat_tag root;
    bat_threemf_part *out;
    bat_threemf_object *object; /* the one that is open; NULL: none */
    int *left_out;
    bat_problem *problem;
} reader;

static bat_status wrong(const reader *r, bat_status status, const char *message) {
    char place[40] = "build";
    if (r->object) snprintf(place, sizeof place, "object %lu", (unsigned long)r->object->id);
    return bat_problem_set(r->problem, status, place, message);
}

static bat_status no_memory(const reader *r) { return wrong(r, BAT_MEMORY, bat_status_message(BAT_MEMORY)); }

/* ---- meshes ---- */

static bat_status read_vertex(reader *r, const bat_tag *tag) {
    bat_threemf_part *p = r->out;
    double at[3];
    if (!bat_tag_numbers(tag, "x", 1, &at[0]) || !bat_tag_numbers(tag, "y", 1, &at[1]) ||
        !bat_tag_numbers(tag, "z", 1, &at[2]))
        return wrong(r, BAT_SYNTAX, "vertex: expected x, y and z, each a number");
    for (int k = 0; k < 3; k++)
        if (!(fabs(at[k]) <= BAT_COORDINATE_MAX))
            return wrong(r, BAT_NUMBER, "vertex: expected finite numbers, found another");
    if (r->object->vertex_count == BAT_VERTICES_MAX)
        return wrong(r, BAT_COUNT, "expected 16777216 vertices at most, found more");
    double *list = bat_grown(p->vertices, &p->vertex_room, p->vertex_count, 1, sizeof at);
    if (!list) return no_memory(r);
    p->vertices = list;
    memcpy(list + 3 * p->vertex_count++, at, sizeof at);
    r->object->vertex_count++;
    return BAT_OK;
}

static bat_status read_triangle(reader *r, const bat_tag *tag) {
    static const char *const names[] = {"v1", "v2", "v3"};
    bat_threemf_part *p = r->out;
    uint32_t corner;
    int *list = bat_grown(p->triangles, &p->triangle_room, p->triangle_count, 1, 3 * sizeof *list);
    if (!list) return no_memory(r);
    p->triangles = list;
    for (int k = 0; k < 3; k++) {
        if (!bat_tag_whole(tag, names[k], INT_MAX, &corner) || corner >= r->object->vertex_count)
            return wrong(r, BAT_PARAMETER,
                         "triangle: expected the numbers of three vertices, found none such");
        list[3 * p->triangle_count + (size_t)k] = (int)corner;
    }
    p->triangle_count++;
    r->object->triangle_count++;
    return BAT_OK;
}

/* ---- what is put somewhere ---- */

static bat_status read_use(const reader *r, const bat_tag *tag, bat_threemf_use *out) {
    const char *value;
    double v[12];
    size_t size;
    out->file = r->file;
    memcpy(out->pose, bat_pose_none, sizeof out->pose);
    if (!bat_tag_whole(tag, "objectid", UINT32_MAX, &out->id))
        return wrong(r, BAT_SYNTAX, "objectid: expected the number of an object");
    if (bat_tag_find(tag, "path", &value, &size)) {
        const long file = bat_unzip_find(r->zip, value, size);
        if (file < 0) return wrong(r, BAT_PARAMETER, "path: expected a file of the archive, found none such");
        out->file = (size_t)file;
    }
    if (!bat_tag_find(tag, "transform", &value, &size)) return BAT_OK;
    if (!bat_tag_numbers(tag, "transform", 12, v))
        return wrong(r, BAT_SYNTAX, "transform: expected 12 numbers");
    for (int i = 0; i < 12; i++) out->pose[i] = v[i / 4 + i % 4 * 3];
    return BAT_OK;
}

static bat_status read_component(reader *r, const bat_tag *tag) {
    bat_threemf_part *p = r->out;
    bat_threemf_use *list = bat_grown(p->components, &p->component_room, p->component_count, 1, sizeof *list);
    if (!list) return no_memory(r);
    p->components = list;
    const bat_status status = read_use(r, tag, &list[p->component_count]);
    if (status != BAT_OK) return status;
    p->component_count++;
    r->object->component_count++;
    return BAT_OK;
}

static bat_status read_item(reader *r, const bat_tag *tag) {
    bat_threemf_part *p = r->out;
    bat_threemf_use *list = bat_grown(p->items, &p->item_room, p->item_count, 1, sizeof *list);
    if (!list) return no_memory(r);
    p->items = list;
    const bat_status status = read_use(r, tag, &list[p->item_count]);
    p->item_count += status == BAT_OK;
    return status;
}

/* ---- objects ---- */

/* What stands for a character: "&amp;". Returns how long it is; 0: it is none that is known. */
static size_t entity(const char *at, size_t size, char *out) {
    static const char *const names[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"};
    for (size_t i = 0; i < 5; i++) {
        const size_t length = strlen(names[i]);
        if (size < length || memcmp(at, names[i], length) != 0) continue;
        *out = "&<>\"'"[i];
        return length;
    }
    return 0;
}

static char *name_of(const bat_tag *tag, bool *failed) {
    const char *value;
    size_t size, made = 0;
    if (!bat_tag_find(tag, "name", &value, &size) || size == 0) return NULL;
    char *name = malloc(size + 1);
    *failed = !name;
    for (size_t i = 0; name && i < size;) {
        char c = value[i];
        const size_t length = c == '&' ? entity(value + i, size - i, &c) : 0;
        name[made++] = c;
        i += length ? length : 1;
    }
    if (name) name[made] = '\0';
    return name;
}

static bat_status open_object(reader *r, const bat_tag *tag) {
    bat_threemf_part *p = r->out;
    bat_threemf_object made = {
        .vertex = p->vertex_count, .triangle = p->triangle_count, .component = p->component_count};
    bool failed = false;
    if (!bat_tag_whole(tag, "id", UINT32_MAX, &made.id))
        return bat_problem_set(r->problem, BAT_SYNTAX, "object", "id: expected a whole number");
    bat_threemf_object *list = bat_grown(p->objects, &p->object_room, p->object_count, 1, sizeof *list);
    if (!list) return no_memory(r);
    p->objects = list;
    made.name = name_of(tag, &failed);
    if (failed) return no_memory(r);
    list[p->object_count] = made;
    r->object = tag->closes ? NULL : &list[p->object_count];
    p->object_count++;
    return BAT_OK;
}

static bool is_core(const reader *r, const bat_tag *tag) {
    return tag->prefix_size == r->root.prefix_size &&
           memcmp(tag->prefix, r->root.prefix, tag->prefix_size) == 0;
}

static bat_status read_tag(reader *r, const bat_tag *tag) {
    static const char *const others[] = {"beamlattice", "displacementmesh", "booleanshape", "levelset"};
    if (!tag->opens) {
        if (is_core(r, tag) && bat_tag_is(tag, "object")) r->object = NULL;
        return BAT_OK;
    }
    for (size_t i = 0; i < sizeof others / sizeof *others && r->object; i++)
        if (bat_tag_is(tag, others[i]) && *r->left_out < INT_MAX) ++*r->left_out;
    if (!is_core(r, tag)) return BAT_OK;
    if (r->object && bat_tag_is(tag, "vertex")) return read_vertex(r, tag);
    if (r->object && bat_tag_is(tag, "triangle")) return read_triangle(r, tag);
    if (r->object && bat_tag_is(tag, "component")) return read_component(r, tag);
    if (!r->object && bat_tag_is(tag, "object")) return open_object(r, tag);
    if (!r->object && bat_tag_is(tag, "item")) return read_item(r, tag);
    return BAT_OK;
}

static bat_status read_root(reader *r) {
    static const struct {
        const char *name;
        double millimetres;
    } units[] = {{"micron", 1e-3}, {"millimeter", 1}, {"centimeter", 10},
                 {"inch", 25.4},   {"foot", 304.8},   {"meter", 1000}};
    const char *value;
    size_t size;
    if (!bat_tag_is(&r->root, "model"))
        return bat_problem_set(r->problem, BAT_SYNTAX, "",
                               "expected a model in the archive, found something else");
    r->out->unit = 1;
    if (!bat_tag_find(&r->root, "unit", &value, &size)) return BAT_OK;
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strlen(units[i].name) == size && memcmp(units[i].name, value, size) == 0) {
            r->out->unit = units[i].millimetres;
            return BAT_OK;
        }
    return bat_problem_set(r->problem, BAT_SYNTAX, "model",
                           "unit: expected micron, millimeter, centimeter, inch, foot or meter");
}

static int by_id(const void *a, const void *b) {
    const bat_threemf_object *x = a, *y = b;
    if (x->id != y->id) return x->id < y->id ? -1 : 1;
    return (x->vertex > y->vertex) - (x->vertex < y->vertex); /* ties are refused */
}

static bat_status sort_objects(reader *r) {
    bat_threemf_part *p = r->out;
    bat_threemf_object *list = p->objects;
    if (!list) return BAT_OK;
    qsort(list, p->object_count, sizeof *list, by_id); /* no ties but those refused */
    for (size_t i = 1; i < p->object_count; i++)
        if (list[i].id == list[i - 1].id) {
            r->object = &list[i];
            return wrong(r, BAT_SYNTAX, "expected an id of its own, found it twice");
        }
    return BAT_OK;
}

bat_status bat_threemf_read_part(const bat_unzip *zip, size_t file, const char *text, size_t size,
                                 bat_threemf_part *out, int *left_out, bat_problem *problem) {
    bat_tags tags = {text, text + size};
    reader r = {.zip = zip, .file = file, .out = out, .left_out = left_out, .problem = problem};
    bat_tag tag;
    bat_status status = bat_xml_check(text, size);
    *out = (bat_threemf_part){.unit = 1};
    if (status != BAT_OK)
        return bat_problem_set(problem, status, "",
                               status == BAT_SYNTAX
                                   ? "expected XML in UTF-8 in the archive, found something else"
                                   : bat_status_message(status));
    if (!bat_tags_next(&tags, &r.root)) r.root = (bat_tag){.name = text, .prefix = text};
    status = read_root(&r);
    while (status == BAT_OK && bat_tags_next(&tags, &tag)) status = read_tag(&r, &tag);
    r.object = NULL;
    if (status == BAT_OK) status = sort_objects(&r);
    if (status != BAT_OK) bat_threemf_clear_part(out);
    return status;
}

void bat_threemf_clear_part(bat_threemf_part *part) {
    for (size_t i = 0; i < part->object_count; i++) free(part->objects[i].name);
    free(part->vertices);
    free(part->triangles);
    free(part->components);
    free(part->items);
    free(part->objects);
    *part = (bat_threemf_part){.unit = 1};
}

bat_threemf_object *bat_threemf_object_of(const bat_threemf_part *part, uint32_t id) {
    size_t low = 0, high = part->object_count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (part->objects[middle].id < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low < part->object_count && part->objects[low].id == id ? &part->objects[low] : NULL;
}
