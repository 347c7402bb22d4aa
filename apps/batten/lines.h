/* Many inputs in one run: a line of standard input each, and a line of standard output each. */
#ifndef BATTEN_APPS_LINES_H
#define BATTEN_APPS_LINES_H

#include "program.h"

/* Runs the command once a line. A line that fails gives {"error"} in its place, and EXIT_DATA at the end. */
int run_lines(const cli_arguments *arguments);

#endif
