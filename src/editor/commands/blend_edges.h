/* A blend between two surfaces, or a surface and a curve: its edges, and the lines that show it. */
#ifndef BATTEN_EDITOR_COMMANDS_BLEND_EDGES_H
#define BATTEN_EDITOR_COMMANDS_BLEND_EDGES_H

#include "document/document.h"
#include "editor/commands/tuning.h"
#include <batten/blend.h>
#include <batten/sweep.h>

/* Of two objects, at least one of them a surface, the other a surface or one curve. False: they are not, or have no edges that go together. */
bool bat_edge_pair_find(int count, bat_object *const *objects, bat_edge_pair *out);
bat_status bat_edge_pair_blend(const bat_edge_pair *pair, const bat_blend_options *options,
                               bat_surface **out);
/* The first surface, with its edge moved to meet the second's. BAT_SINGULAR: it has levels, or the second is a curve; else as bat_surface_match. */
bat_status bat_edge_pair_match(const bat_edge_pair *pair, int continuity, double tension, bat_surface **out);
/* Shows lines across the edge on the surface, the middle one's ends as the places of the sliders. matched: it is the first one, moved; else a blend. */
bat_status bat_edge_pair_show(bat_tuning *tuning, const bat_surface *made, bool matched);
/* The surface as an object, with the style of the first. */
bat_status bat_edge_pair_object(const bat_edge_pair *pair, const bat_surface *made, bat_object **out);
/* Whether such a pair is selected, and nothing else. surfaces: two of them. */
bool bat_edge_pair_fits(const bat_context *c, bool surfaces);

#endif
