/* The vectors as exports of a module of their own. */
#include "wasm/parity.h"

#include <stdlib.h>

__attribute__((export_name("sections"))) int module_sections(void);
__attribute__((export_name("name"))) const char *module_name(int section);
__attribute__((export_name("run"))) int module_run(int section);
__attribute__((export_name("values"))) const double *module_values(void);

enum { ROOM = 1 << 18 };
static double values[ROOM];

int module_sections(void) { return parity_section_count; }
const char *module_name(int section) { return parity_sections[section].name; }
const double *module_values(void) { return values; }

/* How many values there are; -1: no room. */
int module_run(int section) {
    parity_sink sink = {values, ROOM, 0};
    parity_sections[section].run(&sink);
    return sink.count <= ROOM ? (int)sink.count : -1;
}
