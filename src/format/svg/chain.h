/* Gradients and patterns are made of themselves and of those that they refer to (SVG 2, 14.2.2 and 14.3). */
#ifndef BATTEN_FORMAT_SVG_CHAIN_H
#define BATTEN_FORMAT_SVG_CHAIN_H

#include "format/svg/walk.h"

enum { BAT_SVG_HOPS_MAX = 32 };

/* The element itself first. */
typedef struct bat_svg_chain {
    uint32_t elements[BAT_SVG_HOPS_MAX];
    int count;
} bat_svg_chain;

bat_svg_chain bat_svg_chain_of(const bat_svg_walk *w, uint32_t server);
/* The attribute of the first that has it; NULL: none has. */
const char *bat_svg_chain_attribute(const bat_svg_walk *w, const bat_svg_chain *chain, const char *name);

#endif
