/* A blend between two surfaces, or a surface and a curve: its edges, and the lines that show it. */
#ifndef BATTEN_EDITOR_COMMANDS_BLEND_EDGES_H
#define BATTEN_EDITOR_COMMANDS_BLEND_EDGES_H

#include "document/document.h"
#include "editor/commands/tuning.h"
#include <batten/blend.h>
#include <batten/sweep.h>

/* The nearest edges of two objects, the first of which is a surface. */
typedef struct bat_edge_pair {
    const bat_object *object[2];
    bat_side side[2];
} bat_edge_pair;

/* Of two objects, at least one of them a surface, the other a surface or one curve. False: they are not, or have no edges that go together. */
bool bat_edge_pair_find(int count, bat_object *const *objects, bat_edge_pair *out);
bat_status bat_edge_pair_blend(const bat_edge_pair *pair, const bat_blend_options *options,
                               bat_surface **out);
/* Shows lines across the surface, the middle one's ends as the places of the sliders. */
bat_status bat_edge_pair_show(bat_tuning *tuning, const bat_surface *made);
/* The surface as an object, with the style of the first. */
bat_status bat_edge_pair_object(const bat_edge_pair *pair, const bat_surface *made, bat_object **out);
/* Whether such a pair is selected, and nothing else. */
bool bat_edge_pair_fits(const bat_context *c);

#endif
