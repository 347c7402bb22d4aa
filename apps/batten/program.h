/* Shared by the files of the program: subcommands, their arguments, and the reporting of failures. */
#ifndef BATTEN_APPS_PROGRAM_H
#define BATTEN_APPS_PROGRAM_H

#include <batten/format.h>

enum { EXIT_DONE = 0, EXIT_DATA = 1, EXIT_USAGE = 2 };
enum { OPTIONS_MAX = 16, OPERANDS_MAX = 256 };

typedef struct cli_option {
    const char *name;  /* "--at" */
    const char *value; /* name of its value in the help; NULL: it is a flag, without a value */
    const char *help;
} cli_option;

typedef struct cli_arguments cli_arguments;

/* One subcommand. --help, the manual page's synopsis and the shell's completion are made from it. */
typedef struct cli_command {
    const char *name;    /* a word, or two: "surface eval" */
    const char *usage;   /* what follows the name, as in the manual */
    const char *summary; /* one line */
    const char *details; /* lines, may be NULL */
    const char *example; /* lines */
    int operands;        /* how many are needed */
    int more;            /* how many more may follow */
    const char *words;   /* those that its operand may be, "bash|zsh|fish"; NULL: a file */
    bool lines;          /* its first operand may be many: --lines */
    bool puts_back;      /* its result is a curve, which may go back to its place in a drawing: -o FILE */
    cli_option options[OPTIONS_MAX];
    int (*run)(const cli_arguments *arguments);
} cli_command;

struct cli_arguments {
    const cli_command *command;
    const char *operands[OPERANDS_MAX];  /* NULL: left out */
    const char *values[OPTIONS_MAX + 3]; /* parallel to command_option; NULL: not given; flags: "" */
};

extern const cli_command command_edit, command_eval, command_nearest, command_frames, command_fit,
    command_sketch, command_tangents, command_levels, command_convert, command_render, command_simplify,
    command_compare, command_info, command_replay, command_surface_eval, command_surface_isocurve,
    command_surface_closest, command_surface_hit, command_surface_pick, command_surface_redraw,
    command_surface_sketch, command_cast, command_surface_intersect, command_surface_levels,
    command_surface_convert, command_wire, command_revolve, command_coons, command_loft, command_sweep,
    command_camera, command_motion, command_curve_length, command_curve_bounds, command_curve_curvature,
    command_curve_split, command_curve_join, command_curve_reverse, command_curve_elevate,
    command_curve_insert, command_curve_flatten, command_curve_arcs, command_curve_intersect,
    command_curve_distance, command_curve_offset, command_curve_region, command_curve_outline, command_width,
    command_completion, command_blend, command_match, command_surface_blend, command_surface_match;

/* All of them, in the order of the help. */
const cli_command *const *all_commands(size_t *count);

/* ---- arguments ---- */

#define OPTION_LINES "--lines"
#define OPTION_OUTPUT "-o"
#define OPTION_LOSSY "--lossy"

/* The options of a command: those of its table, then --lines, and -o with --lossy, where it takes them; NULL: no more. */
const cli_option *command_option(const cli_command *command, int index);
/* EXIT_DONE, or EXIT_USAGE after reporting what is wrong. */
int arguments_parse(const cli_command *command, int count, char **words, cli_arguments *out);
/* Wrong usage when more than one of the first `count` operands, which `names` names, is standard input. */
int arguments_one_input(const cli_arguments *arguments, int count, const char *names);
/* The option's value, or NULL when it was not given. */
const char *arguments_value(const cli_arguments *arguments, const char *name);
/* Which of the words the option is, in the order given; *out is unchanged when it was not given. */
int arguments_choice(const cli_arguments *arguments, const char *name, const char *const *words, int count,
                     int *out);
/* The option as one finite number with low <= number <= high; *out is unchanged when it was not given. */
int arguments_number(const cli_arguments *arguments, const char *name, double low, double high, double *out);
int arguments_integer(const cli_arguments *arguments, const char *name, long low, long high, long *out);
/* A list of numbers, "1,2.5,-3": *out is malloc'ed; NULL when the option was not given. */
int arguments_numbers(const cli_arguments *arguments, const char *name, double **out, size_t *count);
/* "2=0,3=1.5": for levels from 1 to most a gain within 1e6 each; given[level] becomes true, all else stays. */
int arguments_gains(const cli_arguments *arguments, const char *name, int most, double *gains, bool *given);
/* A list of places of `size` numbers, "0,1;0.5,1"; *count: how many places. */
int arguments_places(const cli_arguments *arguments, const char *name, size_t size, double **out,
                     size_t *count);
/* Exactly `size` numbers into out, which is unchanged when the option was not given. */
int arguments_vector(const cli_arguments *arguments, const char *name, size_t size, double *out);
/* "640x480": two integers from 1 to most. */
int arguments_product(const cli_arguments *arguments, const char *name, long most, long out[2]);

/* ---- failures: one line of valid UTF-8 on standard error ---- */

/* "batten NAME: message", and how to get help; returns EXIT_USAGE. */
int fail_usage(const cli_command *command, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* "FILE: PLACE: message" (place may be NULL or empty); returns EXIT_DATA. */
int fail_data(const char *file, const char *place, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* The same for a problem that a reader reported. */
int fail_problem(const char *file, bat_status status, const bat_problem *problem);
int fail_memory(void);
/* From now on lines are kept here, the last one, instead of on standard error; NULL: there again. */
void fail_into(char *line, size_t room);
/* A result cannot be written; errno says why. A reader that has gone, as in "| head -1", wants no more: the
 * program then ends like others, by SIGPIPE and without a message. */
int fail_output(const char *name);
/* What a failure from here on says at its end, too. */
void fail_also(const char *text);
/* A remark that is not a failure: one line. It waits to be shown; a failure throws it away, as does fail_into. */
void remark(const char *format, ...) __attribute__((format(printf, 1, 2)));
void remarks_show(void);

#endif
