/*
 * With symmetry, a surface's mirror image in the upright plane through the axis: the surface itself, or another one. No
 * pairing is stored: it is what mirrors it to within 1e-4 of its size.
 */
#ifndef BATTEN_EDITOR_EDIT_SURFACE_PAIR_H
#define BATTEN_EDITOR_EDIT_SURFACE_PAIR_H

#include "curve/mirror.h"
#include "form/surface/mirror.h"
#include <batten/document.h>

typedef struct bat_surface_pair {
    bat_id image;        /* the surface itself, or its twin; 0: none */
    bat_surface_way way; /* how the parameters run there */
} bat_surface_pair;

/* The mirror off, or no such surface: none. What is hidden or locked is nobody's twin. O(objects + points). */
bat_surface_pair bat_surface_pair_of(const bat_document *document, bat_id object, const bat_mirror *mirror);

#endif
