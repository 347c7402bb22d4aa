/* The batten program: finds the subcommand and passes its arguments to it. */
#include "address.h"
#include "lines.h"
#include "program.h"
#include "progress.h"
#include "results.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* In the order of the manual. */
static const cli_command *const commands[] = {
    &command_edit,
    &command_eval,
    &command_nearest,
    &command_frames,
    &command_fit,
    &command_sketch,
    &command_tangents,
    &command_levels,
    &command_convert,
    &command_render,
    &command_simplify,
    &command_width,
    &command_blend,
    &command_match,
    &command_curve_length,
    &command_curve_bounds,
    &command_curve_curvature,
    &command_curve_split,
    &command_curve_join,
    &command_curve_reverse,
    &command_curve_elevate,
    &command_curve_insert,
    &command_curve_flatten,
    &command_curve_offset,
    &command_curve_arcs,
    &command_curve_intersect,
    &command_curve_distance,
    &command_curve_region,
    &command_curve_outline,
    &command_compare,
    &command_info,
    &command_completion,
    &command_replay,
    &command_surface_eval,
    &command_surface_isocurve,
    &command_surface_closest,
    &command_surface_hit,
    &command_surface_pick,
    &command_surface_redraw,
    &command_surface_sketch,
    &command_surface_intersect,
    &command_surface_blend,
    &command_surface_match,
    &command_surface_levels,
    &command_surface_convert,
    &command_cast,
    &command_wire,
    &command_sweep,
    &command_revolve,
    &command_coons,
    &command_loft,
    &command_motion,
    &command_camera,
};
enum { COMMAND_COUNT = sizeof commands / sizeof commands[0] };

const cli_command *const *all_commands(size_t *count) {
    *count = COMMAND_COUNT;
    return commands;
}

/* The command named by the first words; *used: how many words the name has. */
static const cli_command *command_find(int count, char **words, int *used) {
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        const char *name = commands[i]->name, *second = strchr(name, ' ');
        size_t first = second ? (size_t)(second - name) : strlen(name);
        if (strlen(words[0]) != first || memcmp(words[0], name, first) != 0) continue;
        if (second && (count < 2 || strcmp(words[1], second + 1) != 0)) continue;
        *used = second ? 2 : 1;
        return commands[i];
    }
    return NULL;
}

/* Whether this is the first word of two-word command names. */
static bool is_group(const char *word) {
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        const char *second = strchr(commands[i]->name, ' ');
        size_t first = second ? (size_t)(second - commands[i]->name) : 0;
        if (second && strlen(word) == first && memcmp(word, commands[i]->name, first) == 0) return true;
    }
    return false;
}

static int fail_unknown(int count, char **words) {
    if (!is_group(words[0])) return fail_usage(NULL, "no such command: %s", words[0]);
    if (count < 2) return fail_usage(NULL, "%s needs to be told what to do", words[0]);
    return fail_usage(NULL, "no such command: %s %s", words[0], words[1]);
}

static void print_indented(const char *lines) {
    while (*lines) {
        size_t size = strcspn(lines, "\n");
        printf("  %.*s\n", (int)size, lines);
        lines += size + (lines[size] == '\n');
    }
}

static void print_command_help(const cli_command *command) {
    printf("Usage: batten %s %s\n\n%s\n", command->name, command->usage, command->summary);
    if (command->details) printf("\n%s\n", command->details);
    const cli_option *option = command_option(command, 0);
    if (option) printf("\nOptions:\n");
    for (int i = 0; (option = command_option(command, i)) != NULL; i++) {
        char left[64];
        snprintf(left, sizeof left, "%s%s%s", option->name, option->value ? " " : "",
                 option->value ? option->value : "");
        printf("  %-22s %s\n", left, option->help);
    }
    printf("\nExample:\n");
    print_indented(command->example);
}

static void print_help(void) {
    printf("Usage: batten COMMAND ...\n\nShapes B-spline curves and surfaces. '-' is standard input or "
           "output.\n\n");
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        printf("  %-17s %s\n", commands[i]->name, commands[i]->summary);
    printf("\nbatten COMMAND --help says more, with an example. batten --version prints the version.\n"
           "\nExit status: 0 done, 1 the data are bad (one line on standard error), 2 wrong usage.\n");
}

/* --help may appear anywhere among the words, but after "--" it is a file name. */
static bool wants_help(int count, char **words) {
    for (int i = 0; i < count && strcmp(words[i], "--") != 0; i++) {
        if (strcmp(words[i], "--help") == 0 || strcmp(words[i], "-h") == 0) return true;
    }
    return false;
}

/* Flushes the output; if it has not reached its destination, the exit status says so. */
static int finish(int status) {
    if ((fflush(stdout) != 0 || ferror(stdout)) && status == EXIT_DONE) return fail_output("standard output");
    return status;
}

/* Occupies standard streams that are closed, so that no opened file becomes one by accident; using such a
 * stream still fails. */
static void hold_standard_streams(void) {
    for (int i = 0; i <= STDERR_FILENO; i++) {
        if (fcntl(i, F_GETFD) < 0) open("/dev/null", i == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

int main(int count, char **words) {
    hold_standard_streams();
    setvbuf(stdout, NULL, _IOFBF, 1 << 16); /* output is written at the end, in one piece */
    signal(SIGPIPE, SIG_IGN);               /* a reader that has gone, or a file at its size limit, */
    signal(SIGXFSZ, SIG_IGN);               /* is a write error and does not kill the program */
    if (count < 2) return fail_usage(NULL, "a command is missing");
    int used = 0;
    if (strcmp(words[1], "--help") == 0 || strcmp(words[1], "-h") == 0 || strcmp(words[1], "help") == 0) {
        const cli_command *about = count > 2 ? command_find(count - 2, words + 2, &used) : NULL;
        if (count > 2 && !about && !is_group(words[2])) return fail_unknown(count - 2, words + 2);
        if (about)
            print_command_help(about);
        else
            print_help();
        return finish(EXIT_DONE);
    }
    if (strcmp(words[1], "--version") == 0) {
        printf("batten %s\n", bat_version());
        return finish(EXIT_DONE);
    }
    const cli_command *command = command_find(count - 1, words + 1, &used);
    if (!command && is_group(words[1]) && wants_help(count - 2, words + 2)) {
        print_help();
        return finish(EXIT_DONE);
    }
    if (!command) return fail_unknown(count - 1, words + 1);
    const int from = 1 + used; /* where the command's own words begin */
    if (wants_help(count - from, words + from)) {
        print_command_help(command);
        return finish(EXIT_DONE);
    }
    cli_arguments arguments;
    int status = arguments_parse(command, count - from, words + from, &arguments);
    if (status) return status;
    if (command != &command_edit) progress_begin(command->name); /* the server waits, it is not at work */
    write_back_to(arguments_value(&arguments, OPTION_OUTPUT),
                  arguments_value(&arguments, OPTION_LOSSY) != NULL);
    status = arguments_value(&arguments, OPTION_LINES) ? run_lines(&arguments) : command->run(&arguments);
    progress_end();
    address_release();
    status = finish(status);
    remarks_show();
    return status;
}
