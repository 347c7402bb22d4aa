#include "format/svg/tree.h"

#include <stdlib.h>
#include <string.h>

typedef struct sort {
    const char *name;
    bat_svg_kind kind;
    bat_loss loss; /* of the element as such */
} sort;

static const sort sorts[] = {
    {"path", BAT_SVG_SHAPE, BAT_LOSS_COUNT},
    {"g", BAT_SVG_GROUP, BAT_LOSS_COUNT},
    {"rect", BAT_SVG_SHAPE, BAT_LOSS_COUNT},
    {"circle", BAT_SVG_SHAPE, BAT_LOSS_COUNT},
    {"ellipse", BAT_SVG_SHAPE, BAT_LOSS_COUNT},
    {"line", BAT_SVG_SHAPE, BAT_LOSS_COUNT},
    {"polyline", BAT_SVG_SHAPE, BAT_LOSS_COUNT},
    {"polygon", BAT_SVG_SHAPE, BAT_LOSS_COUNT},
    {"svg", BAT_SVG_ROOT, BAT_LOSS_COUNT},
    {"a", BAT_SVG_GROUP, BAT_LOSS_COUNT},
    {"switch", BAT_SVG_SWITCH, BAT_LOSS_SWITCH},
    {"symbol", BAT_SVG_SYMBOL, BAT_LOSS_UNUSED},
    {"use", BAT_SVG_USE, BAT_LOSS_COPY},
    {"text", BAT_SVG_TEXT, BAT_LOSS_TEXT},
    {"image", BAT_SVG_IMAGE, BAT_LOSS_COUNT},
    {"foreignObject", BAT_SVG_OTHER, BAT_LOSS_EMBEDDED},
    {"animate", BAT_SVG_OTHER, BAT_LOSS_ANIMATION},
    {"animateTransform", BAT_SVG_OTHER, BAT_LOSS_ANIMATION},
    {"animateMotion", BAT_SVG_OTHER, BAT_LOSS_ANIMATION},
    {"set", BAT_SVG_OTHER, BAT_LOSS_ANIMATION},
    {"video", BAT_SVG_OTHER, BAT_LOSS_EMBEDDED},
    {"iframe", BAT_SVG_OTHER, BAT_LOSS_EMBEDDED},
    {"canvas", BAT_SVG_OTHER, BAT_LOSS_EMBEDDED},
    {"audio", BAT_SVG_OTHER, BAT_LOSS_EMBEDDED},
    {"animateColor", BAT_SVG_OTHER, BAT_LOSS_ANIMATION},
    {"discard", BAT_SVG_OTHER, BAT_LOSS_ANIMATION},
    {"flowRoot", BAT_SVG_TEXT, BAT_LOSS_TEXT},
    {"defs", BAT_SVG_DEFS, BAT_LOSS_COUNT},
    {"linearGradient", BAT_SVG_GRADIENT, BAT_LOSS_UNUSED},
    {"radialGradient", BAT_SVG_GRADIENT, BAT_LOSS_UNUSED},
    {"pattern", BAT_SVG_NEVER, BAT_LOSS_UNUSED},
    {"clipPath", BAT_SVG_NEVER, BAT_LOSS_UNUSED},
    {"mask", BAT_SVG_NEVER, BAT_LOSS_UNUSED},
    {"marker", BAT_SVG_NEVER, BAT_LOSS_UNUSED},
    {"filter", BAT_SVG_NEVER, BAT_LOSS_UNUSED},
    {"stop", BAT_SVG_STOP, BAT_LOSS_COUNT},
    {"meshgradient", BAT_SVG_NEVER, BAT_LOSS_UNUSED},
    {"hatch", BAT_SVG_NEVER, BAT_LOSS_UNUSED},
    {"solidcolor", BAT_SVG_NEVER, BAT_LOSS_UNUSED},
    {"view", BAT_SVG_NEVER, BAT_LOSS_UNUSED},
    {"cursor", BAT_SVG_NEVER, BAT_LOSS_UNUSED},
    {"font", BAT_SVG_NEVER, BAT_LOSS_UNUSED},
    {"color-profile", BAT_SVG_NEVER, BAT_LOSS_UNUSED},
    {"title", BAT_SVG_NEVER, BAT_LOSS_TITLE},
    {"desc", BAT_SVG_NEVER, BAT_LOSS_TITLE},
    {"script", BAT_SVG_NEVER, BAT_LOSS_SCRIPT},
    {"metadata", BAT_SVG_METADATA, BAT_LOSS_METADATA},
    {"style", BAT_SVG_STYLE, BAT_LOSS_COUNT},
};

enum { TYPES = 1 + sizeof sorts / sizeof *sorts };

/* Remembers which prefixes stand for SVG and for Batten's own namespace. */
static void note_prefixes(bat_svg_tree *tree, const char *const *attributes) {
    for (; attributes[0] && attributes[1]; attributes += 2) {
        if (strncmp(attributes[0], "xmlns:", 6) != 0) continue;
        const char *prefix = attributes[0] + 6;
        if (strlen(prefix) >= sizeof tree->native_prefix) continue;
        if (strcmp(attributes[1], BAT_SVG_NAMESPACE) == 0) strcpy(tree->drawing_prefix, prefix);
        if (strcmp(attributes[1], BAT_SVG_NATIVE_NAMESPACE) == 0) strcpy(tree->native_prefix, prefix);
    }
}

static bool prefix_is(const char *name, size_t length, const char *prefix) {
    return prefix[0] && strlen(prefix) == length && memcmp(name, prefix, length) == 0;
}

/* *local: the name after its prefix. */
static const sort *sort_of(const bat_svg_tree *tree, const char *name, const char **local) {
    static const sort native = {"", BAT_SVG_NATIVE, BAT_LOSS_COUNT},
                      foreign = {"", BAT_SVG_UNKNOWN, BAT_LOSS_FOREIGN},
                      unknown = {"", BAT_SVG_UNKNOWN, BAT_LOSS_UNKNOWN},
                      part = {"", BAT_SVG_NEVER, BAT_LOSS_COUNT}; /* part of a filter, so it belongs to SVG */
    const char *colon = strchr(name, ':');
    *local = colon ? colon + 1 : name;
    if (colon) {
        size_t length = (size_t)(colon - name);
        if (prefix_is(name, length, tree->native_prefix) && strcmp(*local, "document") == 0 &&
            tree->depth > 0 && tree->elements[tree->open[tree->depth - 1]].kind == BAT_SVG_METADATA)
            return &native;
        if (!prefix_is(name, length, tree->drawing_prefix) && !prefix_is(name, length, "svg"))
            return &foreign;
    }
    for (size_t i = 0; i < sizeof sorts / sizeof *sorts; i++)
        if (strcmp(sorts[i].name, *local) == 0) return &sorts[i];
    return strncmp(*local, "fe", 2) == 0 && (*local)[2] >= 'A' && (*local)[2] <= 'Z' ? &part : &unknown;
}

/* Stores a string and returns its offset; check strings.failed at the end. */
static uint32_t keep(bat_svg_tree *tree, const char *string) {
    uint32_t at = (uint32_t)tree->strings.size;
    bat_text_add(&tree->strings, string, strlen(string) + 1);
    return at;
}

static bat_status make_room(bat_svg_tree *tree, uint32_t attributes) {
    if (tree->count + 1 >= tree->room) {
        uint32_t room = tree->room < 64 ? 64 : tree->room * 2;
        bat_svg_element *grown = realloc(tree->elements, room * sizeof *grown);
        if (!grown) return BAT_MEMORY;
        if (!tree->elements) grown[0] = (bat_svg_element){0}, tree->count = 1;
        tree->elements = grown;
        tree->room = room;
    }
    if (tree->attribute_count + 2 * attributes >= tree->attribute_room) {
        uint32_t room = tree->attribute_room * 2 + 2 * attributes + 128;
        uint32_t *grown = realloc(tree->attributes, room * sizeof *grown);
        if (!grown) return BAT_MEMORY;
        tree->attributes = grown;
        tree->attribute_room = room;
    }
    return BAT_OK;
}

bat_status bat_svg_tree_open(bat_svg_tree *tree, const char *name, const char *const *attributes) {
    static const char *const none[1] = {NULL};
    if (!attributes) attributes = none;
    if (tree->depth == 0 && tree->count > 0) return BAT_SYNTAX;
    size_t count = 0, size = strlen(name) + 1;
    for (; attributes[2 * count] && attributes[2 * count + 1]; count++)
        size += strlen(attributes[2 * count]) + strlen(attributes[2 * count + 1]) + 2;
    if (tree->depth == BAT_SVG_DEPTH || tree->count >= BAT_SVG_ELEMENTS_MAX || count > 1 << 16 ||
        tree->attribute_count > 1 << 28 || size > ((size_t)1 << 28) - tree->strings.size)
        return BAT_COUNT;
    bat_status status = make_room(tree, (uint32_t)count);
    if (status != BAT_OK) return status;
    note_prefixes(tree, attributes);
    bat_svg_element made = {.attributes = tree->attribute_count, .attribute_count = (uint32_t)count};
    const char *local;
    const sort *found = sort_of(tree, name, &local);
    made.kind = (uint8_t)found->kind;
    made.loss = (uint8_t)found->loss;
    made.type = found->name[0] ? (uint8_t)(1 + (found - sorts)) : 0; /* those beyond the table have none */
    made.name = keep(tree, local);
    for (size_t i = 0; i < 2 * count; i++)
        tree->attributes[tree->attribute_count++] = keep(tree, attributes[i]);
    uint32_t index = tree->count++;
    if (tree->depth > 0) {
        uint32_t *last = &tree->last[tree->depth - 1];
        made.parent = tree->open[tree->depth - 1];
        if (*last)
            tree->elements[*last].next = index;
        else
            tree->elements[made.parent].first = index;
        *last = index;
    }
    tree->elements[index] = made;
    tree->open[tree->depth] = index;
    tree->last[tree->depth++] = 0;
    return tree->strings.failed ? BAT_MEMORY : BAT_OK;
}

bat_status bat_svg_tree_close(bat_svg_tree *tree) {
    if (tree->depth == 0) return BAT_SYNTAX;
    tree->depth--;
    return BAT_OK;
}

const char *bat_svg_tree_name(const bat_svg_tree *tree, uint32_t element) {
    return tree->strings.data + tree->elements[element].name;
}

const char *bat_svg_tree_attribute(const bat_svg_tree *tree, uint32_t element, const char *name) {
    const bat_svg_element *e = &tree->elements[element];
    const uint32_t *pair = tree->attributes + e->attributes;
    for (uint32_t i = 0; i < e->attribute_count; i++, pair += 2)
        if (strcmp(tree->strings.data + pair[0], name) == 0) return tree->strings.data + pair[1];
    return NULL;
}

bool bat_svg_says_more(const bat_svg_tree *tree, uint32_t element, const char *const *known) {
    const bat_svg_element *e = &tree->elements[element];
    const uint32_t *pair = tree->attributes + e->attributes;
    for (uint32_t i = 0; i < e->attribute_count; i++, pair += 2) {
        int k = 0;
        while (known[k] && strcmp(known[k], tree->strings.data + pair[0]) != 0) k++;
        if (!known[k]) return true;
    }
    return false;
}

/* qsort passes no context, so the entries carry their text. */
typedef struct entry {
    const char *id;
    uint32_t element;
} entry;

static int compare_entries(const void *a, const void *b) {
    const entry *x = a, *y = b;
    int order = strcmp(x->id, y->id);
    return order ? order : (x->element > y->element) - (x->element < y->element);
}

bat_status bat_svg_tree_index(bat_svg_tree *tree) {
    entry *entries = malloc((tree->count + 1) * sizeof *entries);
    tree->ids = malloc((tree->count + 1) * sizeof *tree->ids);
    if (!entries || !tree->ids) {
        free(entries);
        return BAT_MEMORY;
    }
    uint32_t n = 0;
    for (uint32_t i = 1; i < tree->count; i++) {
        const char *id = bat_svg_tree_attribute(tree, i, "id");
        if (id) entries[n++] = (entry){id, i};
    }
    if (n > 1) qsort(entries, n, sizeof *entries, compare_entries); /* no ties */
    for (uint32_t i = 0; i < n; i++) tree->ids[i] = entries[i].element;
    tree->id_count = n;
    free(entries);
    return BAT_OK;
}

bat_status bat_svg_tree_number(bat_svg_tree *tree) {
    bat_svg_element *elements = tree->elements;
    bat_svg_standing *standings = calloc((size_t)tree->count + 1, sizeof *standings);
    if (!standings) return BAT_MEMORY;
    for (uint32_t i = 1; i < tree->count; i++) {
        uint32_t all = 0, alike[TYPES] = {0};
        for (uint32_t at = elements[i].first; at; at = elements[at].next) {
            standings[at].before[0] = all++;
            standings[at].before[1] = alike[elements[at].type]++;
        }
        for (uint32_t at = elements[i].first; at; at = elements[at].next) {
            standings[at].after[0] = all - 1 - standings[at].before[0];
            standings[at].after[1] = alike[elements[at].type] - 1 - standings[at].before[1];
        }
    }
    tree->standings = standings;
    return BAT_OK;
}

uint32_t bat_svg_tree_find(const bat_svg_tree *tree, const char *id) {
    uint32_t low = 0, high = tree->id_count;
    while (low < high) {
        uint32_t middle = (low + high) / 2;
        if (strcmp(bat_svg_tree_attribute(tree, tree->ids[middle], "id"), id) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == tree->id_count || strcmp(bat_svg_tree_attribute(tree, tree->ids[low], "id"), id) != 0)
        return 0;
    return tree->ids[low];
}

uint32_t bat_svg_tree_refer(const bat_svg_tree *tree, const char *text) {
    char id[256];
    size_t size;
    while (*text && strchr(" \t\r\n\"'", *text)) text++;
    if (*text++ != '#') return 0;
    size = strcspn(text, " \t\r\n\"')");
    if (size >= sizeof id) return 0;
    memcpy(id, text, size);
    id[size] = '\0';
    return bat_svg_tree_find(tree, id);
}

void bat_svg_tree_free(bat_svg_tree *tree) {
    free(tree->elements);
    free(tree->attributes);
    free(tree->ids);
    free(tree->standings);
    bat_text_free(&tree->strings);
}
