/* The levels of a curve or of a surface, by the same calls: what the strip shows and changes. */
#ifndef BATTEN_EDITOR_TOOLS_LEVELS_LADDER_H
#define BATTEN_EDITOR_TOOLS_LEVELS_LADDER_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include <batten/document.h>

/* At most one of both; neither: there are no levels. */
typedef struct bat_ladder {
    const bat_shape *shape;
    const bat_relief *relief;
} bat_ladder;

static inline bool bat_ladder_any(bat_ladder ladder) { return ladder.shape || ladder.relief; }
int bat_ladder_levels(bat_ladder ladder); /* over the base */
double bat_ladder_points(bat_ladder ladder, int level);
double bat_ladder_gain(bat_ladder ladder, int level);
bool bat_ladder_is_muted(bat_ladder ladder, int level);

/* A copy, which the caller owns: only such ladders are changed and freed. */
bat_status bat_ladder_copy(bat_ladder from, bat_ladder *out);
bat_status bat_ladder_set_gain(bat_ladder ladder, int level, double gain);
bat_status bat_ladder_set_muted(bat_ladder ladder, int level, bool muted);
void bat_ladder_free(bat_ladder *ladder); /* leaves none */

#endif
