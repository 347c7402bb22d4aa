/* Failures and remarks: a failure is always exactly one line on standard error, so that remarks wait until there is none. */
#include "clean.h"
#include "program.h"
#include "progress.h"

#include "text/text.h"

#include <errno.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum {
    LINE_ROOM = 8192,
    CLEANED_ROOM = 12 * LINE_ROOM
}; /* a line has room for any path, but not for more than two */

static bat_text waiting; /* remarks, each ended by a zero */
static bat_text also;    /* what a failure says, too */
static char *kept;       /* where lines go instead */
static size_t kept_room;

void fail_into(char *line, size_t room) { kept = line, kept_room = room; }

/* Written in one piece, so that lines of several processes do not mix. */
static void put_line(const char *line) {
    if (kept) {
        kept[clean_text(line, kept, kept_room - 1)] = '\0';
        return;
    }
    char cleaned[CLEANED_ROOM];
    size_t size = clean_text(line, cleaned, sizeof cleaned - 1);
    cleaned[size] = '\n';
    cleaned[size + 1] = '\0';
    progress_end();
    fputs(cleaned, stderr);
}

static void put_failure(const char *line) {
    char whole[3 * LINE_ROOM];
    waiting.size = 0;
    if (also.size) snprintf(whole, sizeof whole, "%s; %s", line, also.data);
    put_line(also.size ? whole : line);
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
    put_failure(line);
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
    put_failure(line);
    return EXIT_DATA;
}

int fail_problem(const char *file, bat_status status, const bat_problem *problem) {
    const char *message = problem->message[0] ? problem->message : bat_status_message(status);
    return fail_data(file, problem->place, "%s", message);
}

int fail_memory(void) {
    put_failure("batten: out of memory");
    return EXIT_DATA;
}

int fail_output(const char *name) {
    if (errno != EPIPE) return fail_data(name, NULL, "cannot be written: %s", strerror(errno));
    progress_end();
    signal(SIGPIPE, SIG_DFL);
    raise(SIGPIPE);
    return 128 + SIGPIPE; /* the status a shell would report; reached where the signal is blocked */
}

void fail_also(const char *text) {
    bat_text_free(&also);
    bat_text_add(&also, text, strlen(text) + 1);
}

void remark(const char *format, ...) {
    char line[LINE_ROOM];
    va_list list;
    va_start(list, format);
    vsnprintf(line, sizeof line, format, list);
    va_end(list);
    if (!kept) bat_text_add(&waiting, line, strlen(line) + 1);
}

void remarks_show(void) {
    for (size_t at = 0; at < waiting.size; at += strlen(waiting.data + at) + 1) put_line(waiting.data + at);
    bat_text_free(&waiting);
}
