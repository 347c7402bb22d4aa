/* Simplifying the selection: the tolerance and how the spans meet can be chosen anew afterwards (tuning.h). */
#ifndef BATTEN_EDITOR_COMMANDS_SIMPLIFY_H
#define BATTEN_EDITOR_COMMANDS_SIMPLIFY_H

#include <stddef.h>

/* How the spans of the result meet; kept for the next time. */
typedef enum bat_joints {
    BAT_JOINTS_C2, /* fewest points */
    BAT_JOINTS_G1, /* fewest cubics, as path editors count them */
    BAT_JOINTS_COUNT
} bat_joints;

/* Of all their curves, before and after. */
typedef struct bat_simplified {
    size_t points[2], cubics[2]; /* cubics: spans, of whatever degree they are */
    int changed;                 /* curves */
} bat_simplified;

typedef struct bat_simplifying {
    double tolerance; /* as the command was given, document units */
    bat_joints joints;
    bat_simplified sum;
} bat_simplifying;

#endif
