#include "format/svg/chain.h"

#include <string.h>

static bool is_pattern(const bat_svg_walk *w, uint32_t element) {
    return strcmp(bat_svg_tree_name(w->tree, element), "pattern") == 0;
}

static bool are_alike(const bat_svg_walk *w, uint32_t a, uint32_t b) {
    return w->tree->elements[a].kind == w->tree->elements[b].kind && is_pattern(w, a) == is_pattern(w, b);
}

bat_svg_chain bat_svg_chain_of(const bat_svg_walk *w, uint32_t server) {
    bat_svg_chain c = {{server}, 1};
    while (c.count < BAT_SVG_HOPS_MAX) {
        const char *href = bat_svg_find_href(w, c.elements[c.count - 1]);
        const uint32_t next = href ? bat_svg_tree_refer(w->tree, href) : 0;
        if (!next || !are_alike(w, server, next)) break;
        c.elements[c.count++] = next;
    }
    return c;
}

const char *bat_svg_chain_attribute(const bat_svg_walk *w, const bat_svg_chain *c, const char *name) {
    for (int i = 0; i < c->count; i++) {
        const char *value = bat_svg_attribute_of(w, c->elements[i], name);
        if (value) return value;
    }
    return NULL;
}
