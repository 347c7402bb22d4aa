/* One command for every drawing of a folder. */
#ifndef BATTEN_APPS_FOLDER_H
#define BATTEN_APPS_FOLDER_H

#include "program.h"

bool folder_is_one(const char *name);
/*
 * Runs `one` for each drawing that stands in the folder of the first operand, in the order of their names, with the second
 * operand a file of the same name in that folder, which is made if need be; ends with `kind`. Of a font (UFO) the folder is
 * that of its glyphs. One that fails says so and the others follow: the result is that of the first that failed. Two drawings
 * whose results would have one name: none is done.
 */
int folder_each(const cli_arguments *arguments, const char *kind, int (*one)(const cli_arguments *arguments));

#endif
