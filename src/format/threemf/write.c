/* 3MF: a ZIP archive of an XML file of meshes, and of two that say what it is. */
#include "format/threemf/threemf.h"

#include "format/model/floats.h"
#include "format/model/rim.h"
#include "format/model/zip.h"

#include <stdlib.h>

#define HEAD "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
#define MODEL "3D/3dmodel.model"
#define PACKAGE "http://schemas.openxmlformats.org/package/2006/"
static const char TYPES_NAME[] = "[Content_Types].xml", RELATIONS_NAME[] = "_rels/.rels",
                  MODEL_NAME[] = MODEL;
static const char TYPES[] = HEAD
    "<Types xmlns=\"" PACKAGE "content-types\"><Default Extension=\"rels\" "
    "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default Extension=\"model\" "
    "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n";
static const char RELATIONS[] = HEAD
    "<Relationships xmlns=\"" PACKAGE "relationships\"><Relationship Target=\"/" MODEL "\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";
static const char OPENING[] = HEAD "<model unit=\"millimeter\" xml:lang=\"en-US\" "
                                   "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
                                   "<metadata name=\"Application\">Batten " BAT_VERSION
                                   "</metadata>\n<resources>\n";
static const char BUILD[] = "</resources>\n<build>\n", CLOSING[] = "</build>\n</model>\n";
static const char OBJECT[] = "<object id=\"", VERTICES[] = "\" type=\"model\"><mesh>\n<vertices>\n",
                  TRIANGLES[] = "</vertices>\n<triangles>\n",
                  OBJECT_END[] = "</triangles>\n</mesh></object>\n", ITEM[] = "<item objectid=\"",
                  END[] = "\"/>\n";
static const char VERTEX[3][14] = {"<vertex x=\"", "\" y=\"", "\" z=\""};
static const char TRIANGLE[3][15] = {"<triangle v1=\"", "\" v2=\"", "\" v3=\""};

static void put_member(bat_text *text, const char *before, uint64_t number) {
    bat_text_string(text, before);
    bat_text_integer(text, number);
}

/* Vertices, each place once; same becomes which of these each vertex is. */
static void put_vertices(bat_text *text, const bat_part *part, int *same) {
    int count = 0;
    for (size_t i = 0; i < part->vertex_count; i++) {
        if (same[i] != (int)i) { /* the first at a place comes before the others */
            same[i] = same[same[i]];
            continue;
        }
        same[i] = count++;
        for (size_t k = 0; k < 3; k++) {
            bat_text_string(text, VERTEX[k]);
            bat_text_number(text, part->points[3 * i + k]);
        }
        bat_text_string(text, END);
    }
}

static size_t put_triangles(bat_text *text, const bat_part *part, const int *same) {
    size_t count = 0;
    for (size_t t = 0; t < part->triangle_count; t++) {
        const int *corners = part->triangles + 3 * t;
        const int at[3] = {same[corners[0]], same[corners[1]], same[corners[2]]};
        if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;
        for (int k = 0; k < 3; k++) put_member(text, TRIANGLE[k], (uint64_t)at[k]);
        bat_text_string(text, END);
        count++;
    }
    return count;
}

/* *id: the last object's. */
static bat_status put_object(bat_text *text, const bat_part *part, uint64_t *id) {
    int *same = malloc((part->vertex_count + 1) * sizeof *same);
    bat_status status = same ? bat_rim_same(part, same) : BAT_MEMORY;
    if (status == BAT_OK) status = bat_floats_check(part->points, 3 * part->vertex_count);
    if (status == BAT_OK) {
        const size_t before = text->size;
        put_member(text, OBJECT, *id + 1);
        bat_text_string(text, VERTICES);
        put_vertices(text, part, same);
        bat_text_string(text, TRIANGLES);
        if (put_triangles(text, part, same))
            ++*id;
        else
            text->size = before; /* meshes must have triangles */
        if (text->size > before) bat_text_string(text, OBJECT_END);
    }
    free(same);
    return status;
}

static bat_status put_model(const bat_parts *parts, bat_text *text) {
    uint64_t count = 0;
    bat_status status = BAT_OK;
    bat_text_string(text, OPENING);
    for (size_t i = 0; i < parts->count && status == BAT_OK; i++)
        if (parts->part[i].kind == BAT_PART_TRIANGLES) status = put_object(text, &parts->part[i], &count);
    bat_text_string(text, BUILD);
    for (uint64_t id = 1; id <= count; id++) {
        put_member(text, ITEM, id);
        bat_text_string(text, END);
    }
    bat_text_string(text, CLOSING);
    if (status == BAT_OK && count == 0) status = BAT_COUNT;
    return status == BAT_OK && text->failed ? BAT_MEMORY : status;
}

bat_status bat_threemf_put_parts(const bat_parts *parts, char **bytes, size_t *size) {
    bat_text model = {0};
    bat_zip zip = {.count = 0};
    bat_status status = put_model(parts, &model);
    if (status == BAT_OK) {
        bat_zip_add(&zip, TYPES_NAME, TYPES, sizeof TYPES - 1);
        bat_zip_add(&zip, RELATIONS_NAME, RELATIONS, sizeof RELATIONS - 1);
        bat_zip_add(&zip, MODEL_NAME, model.data, model.size);
        status = bat_zip_finish(&zip, bytes, size);
    }
    bat_text_free(&model);
    return status;
}
