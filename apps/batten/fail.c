/* Failures and remarks: always exactly one line on standard error. */
#include "program.h"
#include "progress.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { LINE_ROOM = 8192 }; /* longer than any path */

/* Texts from files may hold line ends and other controls: the line stays one line. */
static void put_line(char *line) {
    for (char *at = line; *at; at++) {
        if ((unsigned char)*at < 32 || *at == 127) *at = ' ';
    }
    progress_end();
    fprintf(stderr, "%s\n", line);
}

int fail_usage(const cli_command *command, const char *format, ...) {
    char message[LINE_ROOM], line[LINE_ROOM + 128];
    va_list list;
    va_start(list, format);
    vsnprintf(message, sizeof message, format, list);
    va_end(list);
    const char *name = command ? command->name : "";
    const char *space = command ? " " : "";
    snprintf(line, sizeof line, "batten%s%s: %s (see: batten%s%s --help)", space, name, message, space, name);
    put_line(line);
    return EXIT_USAGE;
}

int fail_data(const char *file, const char *place, const char *format, ...) {
    char message[LINE_ROOM], line[2 * LINE_ROOM];
    va_list list;
    va_start(list, format);
    vsnprintf(message, sizeof message, format, list);
    va_end(list);
    const char *name = strcmp(file, "-") == 0 ? "standard input" : file;
    bool placed = place && *place;
    snprintf(line, sizeof line, "%s: %s%s%s", name, placed ? place : "", placed ? ": " : "", message);
    put_line(line);
    return EXIT_DATA;
}

int fail_problem(const char *file, bat_status status, const bat_problem *problem) {
    const char *message = problem->message[0] ? problem->message : bat_status_message(status);
    return fail_data(file, problem->place, "%s", message);
}

int fail_memory(void) {
    progress_end();
    fputs("batten: out of memory\n", stderr);
    return EXIT_DATA;
}

void remark(const char *format, ...) {
    char line[LINE_ROOM];
    va_list list;
    va_start(list, format);
    vsnprintf(line, sizeof line, format, list);
    va_end(list);
    put_line(line);
}
