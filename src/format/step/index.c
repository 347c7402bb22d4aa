/* Finds the instances of a STEP file, and tells from their names what they are. */
#include "format/step/step.h"
#include "text/json.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bat_status bat_step_wrong(const bat_step_place *at, bat_status status, const char *message,
                          bat_problem *problem) {
    char place[40];
    snprintf(place, sizeof place, "line %ld", at->line);
    return bat_problem_set(problem, status, place, message);
}

static const struct {
    const char *name;
    int flags;
} NAMES[] = {{"CARTESIAN_POINT", BAT_STEP_POINT | BAT_STEP_PLAIN},
             {"B_SPLINE_CURVE", BAT_STEP_CURVE},
             {"B_SPLINE_CURVE_WITH_KNOTS", BAT_STEP_CURVE},
             {"BEZIER_CURVE", BAT_STEP_CURVE},
             {"UNIFORM_CURVE", BAT_STEP_CURVE},
             {"QUASI_UNIFORM_CURVE", BAT_STEP_CURVE},
             {"B_SPLINE_SURFACE", BAT_STEP_SURFACE},
             {"B_SPLINE_SURFACE_WITH_KNOTS", BAT_STEP_SURFACE},
             {"BEZIER_SURFACE", BAT_STEP_SURFACE},
             {"UNIFORM_SURFACE", BAT_STEP_SURFACE},
             {"QUASI_UNIFORM_SURFACE", BAT_STEP_SURFACE},
             {"ADVANCED_FACE", BAT_STEP_FACE},
             {"EDGE_CURVE", BAT_STEP_BOUNDS | BAT_STEP_PLAIN},
             {"SURFACE_CURVE", BAT_STEP_BOUNDS | BAT_STEP_PLAIN},
             {"SEAM_CURVE", BAT_STEP_BOUNDS | BAT_STEP_PLAIN},
             {"INTERSECTION_CURVE", BAT_STEP_BOUNDS | BAT_STEP_PLAIN},
             {"DEFINITIONAL_REPRESENTATION", BAT_STEP_BOUNDS | BAT_STEP_PLAIN},
             {"LENGTH_UNIT", BAT_STEP_LENGTH | BAT_STEP_PLAIN},
             {"GLOBAL_UNIT_ASSIGNED_CONTEXT", BAT_STEP_UNITS | BAT_STEP_PLAIN}};

/* Whatever bounds a face, or says who, when, in which product, how it looks. */
static const char *const PLAIN[] = {"ADVANCED_BREP_SHAPE_REPRESENTATION",
                                    "APPLICATION_CONTEXT",
                                    "APPLICATION_PROTOCOL_DEFINITION",
                                    "APPROVAL",
                                    "AXIS1_PLACEMENT",
                                    "AXIS2_PLACEMENT_2D",
                                    "AXIS2_PLACEMENT_3D",
                                    "CC_DESIGN_APPROVAL",
                                    "CLOSED_SHELL",
                                    "COLOUR_RGB",
                                    "COMPOSITE_CURVE",
                                    "COMPOSITE_CURVE_SEGMENT",
                                    "CONVERSION_BASED_UNIT",
                                    "CURVE_STYLE",
                                    "DATE_AND_TIME",
                                    "DIMENSIONAL_EXPONENTS",
                                    "DIRECTION",
                                    "DRAUGHTING_PRE_DEFINED_COLOUR",
                                    "DRAUGHTING_PRE_DEFINED_CURVE_FONT",
                                    "EDGE_LOOP",
                                    "FACE_BOUND",
                                    "FACE_OUTER_BOUND",
                                    "FILL_AREA_STYLE",
                                    "FILL_AREA_STYLE_COLOUR",
                                    "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION",
                                    "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION",
                                    "GEOMETRIC_CURVE_SET",
                                    "GEOMETRIC_REPRESENTATION_CONTEXT",
                                    "GEOMETRIC_SET",
                                    "LENGTH_MEASURE_WITH_UNIT",
                                    "LOCAL_TIME",
                                    "MANIFOLD_SOLID_BREP",
                                    "MANIFOLD_SURFACE_SHAPE_REPRESENTATION",
                                    "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION",
                                    "MEASURE_WITH_UNIT",
                                    "NAMED_UNIT",
                                    "OPEN_SHELL",
                                    "ORGANIZATION",
                                    "ORIENTED_EDGE",
                                    "PCURVE",
                                    "PERSON",
                                    "PERSON_AND_ORGANIZATION",
                                    "PLANE_ANGLE_MEASURE_WITH_UNIT",
                                    "PLANE_ANGLE_UNIT",
                                    "PRESENTATION_LAYER_ASSIGNMENT",
                                    "PRESENTATION_STYLE_ASSIGNMENT",
                                    "PRODUCT",
                                    "PRODUCT_CATEGORY",
                                    "PRODUCT_CONTEXT",
                                    "PRODUCT_DEFINITION",
                                    "PRODUCT_DEFINITION_CONTEXT",
                                    "PRODUCT_DEFINITION_FORMATION",
                                    "PRODUCT_DEFINITION_FORMATION_WITH_SPECIFIED_SOURCE",
                                    "PRODUCT_DEFINITION_SHAPE",
                                    "PRODUCT_RELATED_PRODUCT_CATEGORY",
                                    "PRODUCT_TYPE",
                                    "REPRESENTATION_CONTEXT",
                                    "SHAPE_DEFINITION_REPRESENTATION",
                                    "SHAPE_REPRESENTATION",
                                    "SHAPE_REPRESENTATION_RELATIONSHIP",
                                    "SHELL_BASED_SURFACE_MODEL",
                                    "STYLED_ITEM",
                                    "SURFACE_SIDE_STYLE",
                                    "SURFACE_STYLE_FILL_AREA",
                                    "SURFACE_STYLE_USAGE",
                                    "UNCERTAINTY_MEASURE_WITH_UNIT",
                                    "VECTOR",
                                    "VERTEX_POINT",
                                    "SI_UNIT",
                                    "SOLID_ANGLE_UNIT"};

static int flags_of(const bat_step_token *name) {
    for (size_t i = 0; i < sizeof NAMES / sizeof *NAMES; i++)
        if (bat_step_is(name, NAMES[i].name)) return NAMES[i].flags;
    for (size_t i = 0; i < sizeof PLAIN / sizeof *PLAIN; i++)
        if (bat_step_is(name, PLAIN[i])) return BAT_STEP_PLAIN;
    return 0;
}

/* Reads an instance up to its semicolon and gathers the flags of its names. */
static bat_status scan_body(bat_step_place *at, int *flags, bat_problem *problem) {
    const bat_step_place from = *at;
    int depth = 0;
    bool named = false;
    *flags = 0;
    for (;;) {
        const bat_step_token token = bat_step_next(at);
        if (token.type == BAT_STEP_BAD || token.type == BAT_STEP_END)
            return bat_step_wrong(token.type == BAT_STEP_BAD && at->at < at->end ? at : &from, BAT_SYNTAX,
                                  "expected an instance that ends in a semicolon", problem);
        if (token.type == BAT_STEP_NAME && (depth == 0 || (depth == 1 && !named))) {
            *flags |= flags_of(&token);
            named = depth == 0; /* a single record; else each of a list of records */
        }
        if (token.type != BAT_STEP_MARK) continue;
        depth += (token.mark == '(') - (token.mark == ')');
        if (depth < 0 || (token.mark == ';' && depth > 0))
            return bat_step_wrong(at, BAT_SYNTAX, "expected as many ) as (, found others", problem);
        if (token.mark == ';') return BAT_OK;
    }
}

static bat_status add(bat_step_file *file, size_t *room, const bat_step_instance *instance,
                      bat_problem *problem) {
    if (file->count == *room) {
        const size_t more = 2 * *room + 64;
        bat_step_instance *list = realloc(file->list, more * sizeof *list);
        if (!list) return bat_problem_set(problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
        file->list = list;
        *room = more;
    }
    file->list[file->count++] = *instance;
    return BAT_OK;
}

/* From after DATA up to ENDSEC. */
static bat_status read_section(bat_step_place *at, bat_step_file *file, size_t *room, bat_problem *problem) {
    bat_status status = BAT_OK;
    bat_step_token token = bat_step_next(at);
    while (token.type != BAT_STEP_END && token.type != BAT_STEP_BAD && token.mark != ';')
        token = bat_step_next(at);
    while (status == BAT_OK) {
        token = bat_step_next(at);
        if (bat_step_is(&token, "ENDSEC")) return BAT_OK;
        bat_step_instance instance = {.id = token.number};
        if (token.type != BAT_STEP_OBJECT)
            return bat_step_wrong(at, BAT_SYNTAX, "expected #, a number and =, or ENDSEC", problem);
        token = bat_step_next(at);
        if (token.mark != '=')
            return bat_step_wrong(at, BAT_SYNTAX, "expected = after the number of an instance", problem);
        instance.body = *at;
        status = scan_body(at, &instance.flags, problem);
        if (status == BAT_OK) status = add(file, room, &instance, problem);
    }
    return status;
}

static int by_id(const void *a, const void *b) {
    const bat_step_instance *x = a, *y = b;
    if (x->id == y->id) return (x->body.at > y->body.at) - (x->body.at < y->body.at);
    return x->id > y->id ? 1 : -1;
}

static bat_status sort(bat_step_file *file, bat_problem *problem) {
    bool sorted = true;
    for (size_t i = 1; i < file->count; i++) sorted = sorted && file->list[i - 1].id < file->list[i].id;
    if (!sorted) qsort(file->list, file->count, sizeof *file->list, by_id); /* no ties */
    for (size_t i = 1; i < file->count; i++)
        if (file->list[i - 1].id == file->list[i].id)
            return bat_step_wrong(&file->list[i].body, BAT_SYNTAX,
                                  "expected instances with numbers of their own, found one twice", problem);
    return BAT_OK;
}

bat_status bat_step_index(const char *text, size_t size, bat_step_file *out, bat_problem *problem) {
    bat_step_place at = {text, text + size, 1};
    bat_step_file made = {.end = text + size};
    size_t room = 0;
    bat_status status = BAT_OK;
    if (size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0) at.at += 3;
    bat_step_token token = bat_step_next(&at);
    if (!bat_step_is(&token, "ISO-10303-21"))
        return bat_step_wrong(&at, BAT_SYNTAX, "expected ISO-10303-21, found something else", problem);
    while (status == BAT_OK && token.type != BAT_STEP_END) {
        token = bat_step_next(&at);
        if (token.type == BAT_STEP_BAD)
            status = bat_step_wrong(&at, BAT_SYNTAX, "expected a word of STEP, found something else",
                                    problem);
        if (bat_step_is(&token, "END-ISO-10303-21")) break;
        if (bat_step_is(&token, "DATA")) status = read_section(&at, &made, &room, problem);
    }
    if (status == BAT_OK) status = sort(&made, problem);
    if (status == BAT_OK)
        *out = made;
    else
        free(made.list);
    return status;
}

bat_step_instance *bat_step_find(const bat_step_file *file, double id) {
    size_t low = 0, high = file->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (file->list[middle].id == id) return &file->list[middle];
        if (file->list[middle].id < id)
            low = middle + 1;
        else
            high = middle;
    }
    return NULL;
}
