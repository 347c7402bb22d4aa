/* The library's version, for the shell. */
#include <batten/base.h>

__attribute__((export_name("module_version"))) const char *module_version(void);
const char *module_version(void) { return bat_version(); }
