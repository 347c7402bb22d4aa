/* Batten: JSON of what is made of several curves in space: sweeps and wires. */
#ifndef BATTEN_FORMAT_SPACE_H
#define BATTEN_FORMAT_SPACE_H

#include <batten/sweep.h>
#include <batten/wires.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One SWEEP, released by bat_sweep_source_clear. */
typedef struct bat_sweep_source {
    bat_curve *path, *profile;
    bat_sweep_options options;
} bat_sweep_source;
BAT_API bat_status bat_sweep_read(const char *text, size_t size, bat_sweep_source *out, bat_problem *problem);
BAT_API void bat_sweep_source_clear(bat_sweep_source *source);
/* WIRES, released by bat_wires_source_clear: wires, the curve that each becomes, and how they blend. */
enum { BAT_WIRE_CURVES = 3 };
typedef struct bat_wires_source {
    size_t count;
    bat_wire *wires;
    bat_curve **curves, **owned; /* owned: reference, curve and domain curve (may be NULL) of each */
    bat_wire_options options;
} bat_wires_source;
BAT_API bat_status bat_wires_read(const char *text, size_t size, bat_wires_source *out, bat_problem *problem);
BAT_API void bat_wires_source_clear(bat_wires_source *source);

#ifdef __cplusplus
}
#endif
#endif
