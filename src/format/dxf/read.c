/* The sections of a file: units, layers, blocks, and the entities, among which blocks are inserted. */
#include "base/real.h"
#include "format/dxf/dxf.h"
#include "text/json.h"
#include "text/utf8.h"
#include <batten/curve.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    DEPTH = 16,            /* blocks within blocks */
    SHAPES_MOST = 1 << 20, /* of a file, blocks inserted */
    LINES_MOST = 1 << 24,  /* of inserted blocks */
    COLOUR_OF_BLOCK = 0,
    COLOUR_OF_LAYER = 256
};
static const double WEIGHT = 100; /* line weights are hundredths of a millimetre */

typedef struct block {
    const char *name;
    size_t size;
    bat_dxf_scan from; /* after its own record */
    double base[3];
} block;

typedef struct parser {
    bat_dxf_scan scan;
    bat_dxf_record record;
    bat_dxf_record *vertices;
    size_t vertex_room, block_count, block_room;
    block *blocks;
    double unit;   /* millimetres */
    long inserted; /* lines of blocks that were read again */
    const bat_svg_options *how;
    bat_dxf *out;
    bat_losses *lost;
    bat_problem *problem;
} parser;

/* What an entity is in: the block's place, and what "by block" means there. */
typedef struct setting {
    bat_dxf_place place;
    uint32_t colour;
    double width;
    size_t layer;
    bool hidden;
    int depth;
} setting;

static bat_status no_memory(const parser *p) {
    return bat_problem_set(p->problem, BAT_MEMORY, "", bat_status_message(BAT_MEMORY));
}

/* A list with room for one more; NULL: no memory. */
static void *more(void *list, size_t count, size_t *room, size_t size) {
    if (count < *room) return list;
    void *grown = realloc(list, (2 * *room + 8) * size);
    if (grown) *room = 2 * *room + 8;
    return grown;
}

/* ---- text ---- */

static int hexadecimal(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

/* \U+XXXX as older files write what is not ASCII; 0: none stands there. */
static uint32_t escaped(const char *at, size_t size) {
    uint32_t c = 0;
    if (size < 7 || memcmp(at, "\\U+", 3) != 0) return 0;
    for (int i = 3; i < 7; i++) {
        const int digit = hexadecimal(at[i]);
        if (digit < 0) return 0;
        c = c << 4 | (uint32_t)digit;
    }
    return c >= 0xD800 && c < 0xE000 ? 0xFFFD : c;
}

/* The text in UTF-8. Bytes that are none are read as Latin-1. Control characters become blanks. */
static char *name_of(const char *text, size_t size) {
    char *out = malloc(4 * size + 1), *to = out;
    const bool utf8 = bat_utf8_valid(text, size);
    for (size_t i = 0; out && i < size;) {
        const uint32_t c = escaped(text + i, size - i);
        const unsigned char byte = (unsigned char)text[i];
        i += c ? 7 : 1;
        if (!c && utf8)
            *to++ = byte < ' ' ? ' ' : (char)byte;
        else
            to += bat_utf8_encode(c >= ' ' ? c : byte < ' ' || c ? ' ' : byte, to);
    }
    if (out) *to = '\0';
    return out;
}

/* ---- layers ---- */

/* The layer of this name, made where there is none yet. */
static bat_status layer_named(parser *p, const char *text, size_t size, size_t *out) {
    bat_dxf *made = p->out;
    char *name = name_of(text, size);
    if (!name) return no_memory(p);
    for (size_t i = 0; i < made->layer_count; i++)
        if (strcmp(made->layers[i].name, name) == 0) {
            free(name);
            *out = i;
            return BAT_OK;
        }
    bat_dxf_layer *list = more(made->layers, made->layer_count, &made->layer_room, sizeof *list);
    if (!list) {
        free(name);
        return no_memory(p);
    }
    made->layers = list;
    *out = made->layer_count++;
    list[*out] = (bat_dxf_layer){.name = name, .colour = bat_dxf_colour(7)};
    return BAT_OK;
}

/* A colour of the record: true, by number, by layer or by block. */
static bat_status colour_of(parser *p, uint32_t layer, uint32_t around, uint32_t *out) {
    double rgb, index;
    bat_status status = bat_dxf_get(&p->record, 420, -1, &rgb, p->problem);
    if (status == BAT_OK) status = bat_dxf_get(&p->record, 62, COLOUR_OF_LAYER, &index, p->problem);
    if (rgb >= 0 && rgb <= 0xFFFFFF)
        *out = (uint32_t)rgb << 8 | 0xFF;
    else if (!(fabs(index) < COLOUR_OF_LAYER))
        *out = layer;
    else
        *out = index == COLOUR_OF_BLOCK ? around : bat_dxf_colour((int)fabs(index));
    return status;
}

static bat_status width_of(parser *p, double layer, double around, double *out) {
    double weight;
    const bat_status status = bat_dxf_get(&p->record, 370, -1, &weight, p->problem);
    *out = weight > 0 ? fmin(weight, 1000) / WEIGHT : weight == -2 ? around : weight == -1 ? layer : 0;
    return status;
}

static bat_status read_layer(parser *p) {
    enum { FROZEN = 1, LOCKED = 4 };
    const bat_dxf_pair *name = bat_dxf_find(&p->record, 2);
    size_t at;
    double state, colour;
    if (!name) return BAT_OK;
    bat_status status = layer_named(p, name->text, name->size, &at);
    if (status == BAT_OK) status = bat_dxf_get(&p->record, 70, 0, &state, p->problem);
    if (status == BAT_OK) status = bat_dxf_get(&p->record, 62, 7, &colour, p->problem);
    if (status != BAT_OK) return status;
    bat_dxf_layer *layer = &p->out->layers[at];
    const int flags = (int)fmin(fabs(state), 1e6);
    layer->hidden = flags & FROZEN || colour < 0;
    layer->locked = flags & LOCKED;
    status = colour_of(p, bat_dxf_colour(7), bat_dxf_colour(7), &layer->colour);
    return status == BAT_OK ? width_of(p, 0, 0, &layer->width) : status;
}

/* ---- entities ---- */

static bat_status add_shape(parser *p, bat_curve *curve, const bat_dxf_shape *like) {
    bat_dxf *made = p->out;
    bat_dxf_shape *list = more(made->shapes, made->shape_count, &made->shape_room, sizeof *list);
    if (!list || made->shape_count == SHAPES_MOST) {
        bat_curve_free(curve);
        if (!list) return no_memory(p);
        return bat_problem_set(p->problem, BAT_COUNT, "", "expected at most 1048576 curves, found more");
    }
    made->shapes = list;
    list[made->shape_count] = *like;
    list[made->shape_count++].curve = curve;
    made->layers[like->layer].shapes++;
    return BAT_OK;
}

/* Layer "0" in a block is the layer that the block is inserted on. */
static bat_status look_of(parser *p, const setting *in, bat_dxf_shape *out) {
    const bat_dxf_pair *name = bat_dxf_find(&p->record, 8);
    const bool own = name && !(in->depth > 0 && name->size == 1 && *name->text == '0');
    double hidden;
    out->layer = in->layer;
    bat_status status = BAT_OK;
    if (own || in->depth == 0)
        status = layer_named(p, name ? name->text : "0", name ? name->size : 1, &out->layer);
    if (status == BAT_OK) status = bat_dxf_get(&p->record, 60, 0, &hidden, p->problem);
    if (status != BAT_OK) return status;
    const bat_dxf_layer *layer = &p->out->layers[out->layer];
    out->hidden = in->hidden || hidden == 1;
    status = colour_of(p, layer->colour, in->colour, &out->colour);
    if (status == BAT_OK) status = width_of(p, layer->width, in->width, &out->width);
    double width;
    if (status == BAT_OK && bat_dxf_is(&p->record.pairs[0], 0, "LWPOLYLINE")) {
        status = bat_dxf_get(&p->record, 43, 0, &width, p->problem);
        if (status == BAT_OK && width > 0) out->width = width * p->unit;
    }
    return status;
}

/* Reads the vertices that follow a POLYLINE, up to its end. */
static bat_status read_vertices(parser *p, bat_dxf_pair *head, size_t *count) {
    bat_status status = BAT_OK;
    *count = 0;
    while (status == BAT_OK && bat_dxf_is(head, 0, "VERTEX")) {
        const size_t before = p->vertex_room;
        bat_dxf_record *list = more(p->vertices, *count, &p->vertex_room, sizeof *list);
        if (!list) return no_memory(p);
        p->vertices = list;
        for (size_t i = before; i < p->vertex_room; i++) list[i] = (bat_dxf_record){.pairs = NULL};
        status = bat_dxf_record_read(&p->scan, head, &list[(*count)++], p->problem);
    }
    return status;
}

static void count_lost(parser *p, const bat_dxf_pair *name) {
    static const struct {
        const char *name;
        int loss; /* -1: nothing that is drawn */
    } KNOWN[] = {{"TEXT", BAT_LOSS_TEXT},
                 {"MTEXT", BAT_LOSS_TEXT},
                 {"ATTRIB", BAT_LOSS_TEXT},
                 {"IMAGE", BAT_LOSS_IMAGE},
                 {"SEQEND", -1},
                 {"VIEWPORT", -1},
                 {"ATTDEF", -1},
                 {"VERTEX", -1}};
    int loss = BAT_LOSS_UNKNOWN;
    for (size_t i = 0; i < sizeof KNOWN / sizeof *KNOWN; i++)
        if (bat_dxf_is(name, 0, KNOWN[i].name)) loss = KNOWN[i].loss;
    if (loss >= 0) p->lost->count[loss]++;
}

static bat_status read_entities(parser *p, const setting *in, const char *end);

static const block *block_of(const parser *p, const bat_dxf_pair *name) {
    for (size_t i = 0; name && i < p->block_count; i++)
        if (p->blocks[i].size == name->size && memcmp(p->blocks[i].name, name->text, name->size) == 0)
            return &p->blocks[i];
    return NULL;
}

/* Numbers of an INSERT: scales, angle, rows and columns and their spacing. */
typedef struct insertion {
    double at[3], scale[3], angle, count[2], step[2], extrusion[3];
} insertion;

static bat_status read_insertion(parser *p, insertion *out) {
    static const int scales[3] = {41, 42, 43};
    const bat_dxf_record *r = &p->record;
    bat_status status = bat_dxf_get_point(r, 10, out->at, p->problem);
    for (int k = 0; k < 3 && status == BAT_OK; k++)
        status = bat_dxf_get(r, scales[k], 1, &out->scale[k], p->problem);
    if (status == BAT_OK) status = bat_dxf_get(r, 50, 0, &out->angle, p->problem);
    for (int k = 0; k < 2 && status == BAT_OK; k++) {
        status = bat_dxf_get(r, 70 + k, 1, &out->count[k], p->problem);
        if (status == BAT_OK) status = bat_dxf_get(r, 44 + k, 0, &out->step[k], p->problem);
        out->count[k] = fmin(fmax(floor(out->count[k]), 1), SHAPES_MOST);
    }
    if (status == BAT_OK) status = bat_dxf_get_point(r, 210, out->extrusion, p->problem);
    return status;
}

/* Where the block comes to lie: its base point at the row's and column's place, scaled, turned and put in. */
static bat_dxf_place place_of(const insertion *put, const double base[3], double column, double row) {
    const double angle = put->angle * (BAT_PI / 180);
    const bool turned = fabs(put->angle) < 1e6 && put->angle != 0;
    const double c = turned ? bat_cos(angle) : 1, s = turned ? bat_sin(angle) : 0;
    const double x = column * put->step[0] - put->scale[0] * base[0],
                 y = row * put->step[1] - put->scale[1] * base[1];
    const bat_dxf_place own = {{c * put->scale[0], -s * put->scale[1], 0, put->at[0] + c * x - s * y,
                                s * put->scale[0], c * put->scale[1], 0, put->at[1] + s * x + c * y, 0, 0,
                                put->scale[2], put->at[2] - put->scale[2] * base[2]}};
    const double *z = put->extrusion;
    if (z[0] == 0 && z[1] == 0 && z[2] >= 0) return own;
    const bat_dxf_place axes = bat_dxf_axes(z);
    return bat_dxf_within(&axes, &own);
}

static bat_status insert(parser *p, const setting *in, const bat_dxf_shape *look) {
    const block *of = block_of(p, bat_dxf_find(&p->record, 2));
    insertion put;
    if (!of || in->depth == DEPTH) {
        p->lost->count[BAT_LOSS_UNKNOWN]++;
        return BAT_OK;
    }
    bat_status status = read_insertion(p, &put);
    const bat_dxf_scan back = p->scan;
    const double base[3] = {of->base[0], of->base[1], of->base[2]};
    const bat_dxf_scan from = of->from;
    for (double row = 0; row < put.count[1] && status == BAT_OK; row++)
        for (double column = 0; column < put.count[0] && status == BAT_OK; column++) {
            const bat_dxf_place own = place_of(&put, base, column, row);
            const setting inner = {bat_dxf_within(&in->place, &own),
                                   look->colour,
                                   look->width,
                                   look->layer,
                                   look->hidden,
                                   in->depth + 1};
            const size_t before = p->out->shape_count;
            p->scan = from;
            status = read_entities(p, &inner, "ENDBLK");
            p->inserted += p->scan.line - from.line;
            if (status == BAT_OK && p->inserted > LINES_MOST)
                status = bat_problem_set(p->problem, BAT_COUNT, "", "expected fewer inserted blocks");
            if (p->out->shape_count == before) row = column = SHAPES_MOST; /* empty: once is enough */
        }
    p->scan = back;
    return status;
}

/* One entity; *head, which begins it, becomes what follows. */
static bat_status read_entity(parser *p, const setting *in, bat_dxf_pair *head) {
    bat_dxf_shape look = {.curve = NULL};
    double paper = 0;
    size_t vertices = 0;
    const bool polyline = bat_dxf_is(head, 0, "POLYLINE");
    bat_status status = bat_dxf_record_read(&p->scan, head, &p->record, p->problem);
    if (status == BAT_OK && polyline) status = read_vertices(p, head, &vertices);
    if (status == BAT_OK) status = bat_dxf_get(&p->record, 67, 0, &paper, p->problem);
    if (status != BAT_OK) return status;
    const bat_dxf_pair name = p->record.pairs[0];
    const bool inserted = bat_dxf_is(&name, 0, "INSERT");
    if (paper == 1 || !(inserted || bat_dxf_is_curve(&p->record))) {
        count_lost(p, &name);
        return BAT_OK;
    }
    status = look_of(p, in, &look);
    if (status != BAT_OK) return status;
    if (inserted) return insert(p, in, &look);
    bat_curve *curve;
    status = bat_dxf_curve(&p->record, p->vertices, vertices, &in->place, p->how, &curve, p->problem);
    if (status != BAT_OK) return status;
    if (curve) return add_shape(p, curve, &look);
    p->lost->count[BAT_LOSS_UNKNOWN]++;
    return BAT_OK;
}

/* Up to the end of the section or the block. */
static bat_status read_entities(parser *p, const setting *in, const char *end) {
    bat_dxf_pair head;
    bat_status status = bat_dxf_next(&p->scan, &head, p->problem);
    while (status == BAT_OK && !bat_dxf_is(&head, 0, end)) {
        if (bat_dxf_is(&head, 0, "EOF"))
            return bat_dxf_wrong(head.line, BAT_SYNTAX,
                                 "expected the end of the section, found the end of the file", p->problem);
        if (head.code != 0)
            status = bat_dxf_next(&p->scan, &head, p->problem);
        else
            status = read_entity(p, in, &head);
    }
    return status;
}

/* ---- sections ---- */

/* Millimetres of feet of the US survey, of which 3937 are 1200 m. */
#define SURVEY(feet) ((feet)*1.2e6 / 3937)

/* The units that $INSUNITS numbers: none, inch, foot, mile, mm, cm, m, km, microinch, mil, yard, angstrom, nanometre, micron,
 * decimetre, decametre, hectometre, gigametre, astronomical unit, light year, parsec, foot, inch, yard and mile of the US survey. unit: in which a drawing says its size then. */
static const struct {
    double millimetres;
    bat_unit unit;
} UNITS[] = {{1, BAT_UNIT_MM},
             {25.4, BAT_UNIT_IN},
             {304.8, BAT_UNIT_IN},
             {1609344, BAT_UNIT_IN},
             {1, BAT_UNIT_MM},
             {10, BAT_UNIT_CM},
             {1000, BAT_UNIT_CM},
             {1e6, BAT_UNIT_CM},
             {2.54e-5, BAT_UNIT_IN},
             {0.0254, BAT_UNIT_IN},
             {914.4, BAT_UNIT_IN},
             {1e-7, BAT_UNIT_MM},
             {1e-6, BAT_UNIT_MM},
             {1e-3, BAT_UNIT_MM},
             {100, BAT_UNIT_CM},
             {1e4, BAT_UNIT_CM},
             {1e5, BAT_UNIT_CM},
             {1e12, BAT_UNIT_CM},
             {1.495978707e14, BAT_UNIT_CM},
             {9.4607304725808e18, BAT_UNIT_CM},
             {3.0856775814913673e19, BAT_UNIT_CM},
             {SURVEY(1), BAT_UNIT_IN},
             {SURVEY(1.0 / 12), BAT_UNIT_IN},
             {SURVEY(3), BAT_UNIT_IN},
             {SURVEY(5280), BAT_UNIT_IN}};

static bat_status read_header(parser *p) {
    bat_dxf_pair pair;
    bat_status status = bat_dxf_next(&p->scan, &pair, p->problem);
    while (status == BAT_OK && pair.code != 0) {
        const bool units = bat_dxf_is(&pair, 9, "$INSUNITS");
        double value;
        status = bat_dxf_next(&p->scan, &pair, p->problem);
        if (status != BAT_OK || !units) continue;
        status = bat_dxf_number(&pair, &value, p->problem);
        if (value > 0 && value < (double)(sizeof UNITS / sizeof *UNITS)) {
            p->unit = UNITS[(int)value].millimetres;
            p->out->unit = UNITS[(int)value].unit;
        }
    }
    return status;
}

static bat_status read_tables(parser *p) {
    bat_dxf_pair head;
    bat_status status = bat_dxf_next(&p->scan, &head, p->problem);
    while (status == BAT_OK && !bat_dxf_is(&head, 0, "ENDSEC") && !bat_dxf_is(&head, 0, "EOF")) {
        const bool layer = bat_dxf_is(&head, 0, "LAYER");
        status = bat_dxf_record_read(&p->scan, &head, &p->record, p->problem);
        if (status == BAT_OK && layer) status = read_layer(p);
    }
    return status;
}

static bat_status add_block(parser *p, const bat_dxf_scan *from) {
    const bat_dxf_pair *name = bat_dxf_find(&p->record, 2);
    if (!name) return BAT_OK;
    block *list = more(p->blocks, p->block_count, &p->block_room, sizeof *list);
    if (!list) return no_memory(p);
    p->blocks = list;
    block *made = &list[p->block_count++];
    *made = (block){.name = name->text, .size = name->size, .from = *from};
    return bat_dxf_get_point(&p->record, 10, made->base, p->problem);
}

static bat_status read_blocks(parser *p) {
    bat_dxf_pair head;
    bat_status status = bat_dxf_next(&p->scan, &head, p->problem);
    while (status == BAT_OK && !bat_dxf_is(&head, 0, "ENDSEC") && !bat_dxf_is(&head, 0, "EOF")) {
        const bool begins = bat_dxf_is(&head, 0, "BLOCK");
        bat_dxf_scan from = p->scan, before = p->scan;
        bat_dxf_pair pair;
        while (begins && status == BAT_OK) { /* to before the pair that begins what follows */
            before = p->scan;
            status = bat_dxf_next(&p->scan, &pair, p->problem);
            if (pair.code == 0) break;
        }
        if (begins) p->scan = from, from = before;
        if (status == BAT_OK) status = bat_dxf_record_read(&p->scan, &head, &p->record, p->problem);
        if (status == BAT_OK && begins) status = add_block(p, &from);
    }
    return status;
}

static bat_status read_section(parser *p) {
    bat_dxf_pair name;
    bat_status status = bat_dxf_next(&p->scan, &name, p->problem);
    /* Half a turn about x: y of a document points down and z away from the eye. */
    const double u = p->unit;
    const setting outside = {{{u, 0, 0, 0, 0, -u, 0, 0, 0, 0, -u, 0}}, bat_dxf_colour(7), 0, 0, false, 0};
    if (status != BAT_OK) return status;
    if (bat_dxf_is(&name, 2, "HEADER")) return read_header(p);
    if (bat_dxf_is(&name, 2, "TABLES")) return read_tables(p);
    if (bat_dxf_is(&name, 2, "BLOCKS")) return read_blocks(p);
    return bat_dxf_is(&name, 2, "ENTITIES") ? read_entities(p, &outside, "ENDSEC") : BAT_OK;
}

void bat_dxf_clear(bat_dxf *dxf) {
    for (size_t i = 0; i < dxf->layer_count; i++) free(dxf->layers[i].name);
    for (size_t i = 0; i < dxf->shape_count; i++) bat_curve_free(dxf->shapes[i].curve);
    free(dxf->layers);
    free(dxf->shapes);
    *dxf = (bat_dxf){.layers = NULL};
}

bat_status bat_dxf_parse(const bat_svg_options *how, const char *text, size_t size, bat_dxf *out,
                         bat_losses *lost, bat_problem *problem) {
    bat_dxf made = {.unit = BAT_UNIT_MM};
    bat_problem local = {.message = ""};
    const size_t mark = size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    parser p = {.scan = {text + mark, text + size, 0},
                .unit = 1,
                .how = how,
                .out = &made,
                .lost = lost,
                .problem = problem ? problem : &local};
    p.problem->message[0] = '\0';
    if (size >= 6 && memcmp(text, "AutoCA", 6) == 0)
        return bat_problem_set(p.problem, BAT_UNSUPPORTED, "",
                               "expected a DXF file as text, found a binary one");
    bat_dxf_pair pair = {.code = -1};
    bat_status status = BAT_OK;
    while (status == BAT_OK && !bat_dxf_is(&pair, 0, "EOF")) {
        status = bat_dxf_next(&p.scan, &pair, p.problem);
        if (status == BAT_OK && bat_dxf_is(&pair, 0, "SECTION")) status = read_section(&p);
    }
    for (size_t i = 0; i < p.vertex_room; i++) bat_dxf_record_clear(&p.vertices[i]);
    bat_dxf_record_clear(&p.record);
    free(p.vertices);
    free(p.blocks);
    if (status == BAT_OK)
        *out = made;
    else
        bat_dxf_clear(&made);
    return status;
}
