/* Parses the words of the command line by a subcommand's table of options. */
#include "program.h"

#include "text/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const cli_option *command_option(const cli_command *command, int index) {
    static const cli_option
        lines = {OPTION_LINES, NULL, "an input a line of standard input, a result a line, in order"},
        output = {OPTION_OUTPUT, "FILE",
                  "the curve goes back to its place in the drawing, FILE#NAME, which is written to FILE"},
        lossy = {OPTION_LOSSY, NULL, "with -o: write over the input even when something of it is lost"};
    int own = 0;
    while (own < OPTIONS_MAX && command->options[own].name) own++;
    if (index < own) return &command->options[index];
    if (command->lines && index-- == own) return &lines;
    if (!command->puts_back) return NULL;
    return index == own ? &output : index == own + 1 ? &lossy : NULL;
}

static int option_index(const cli_command *command, const char *name, size_t size) {
    const cli_option *option;
    for (int i = 0; (option = command_option(command, i)) != NULL; i++)
        if (strlen(option->name) == size && memcmp(option->name, name, size) == 0) return i;
    return -1;
}

/* With --lines the first operand is standard input, which may be left out. */
static int place_lines(cli_arguments *out, int operands) {
    const char *output = arguments_value(out, OPTION_OUTPUT);
    if (output && !*output) {
        fail_usage(out->command, "%s needs FILE", OPTION_OUTPUT);
        return -1;
    }
    if (!arguments_value(out, OPTION_LINES)) return operands;
    if (output) {
        fail_usage(out->command, "%s goes with one curve, not with %s", OPTION_OUTPUT, OPTION_LINES);
        return -1;
    }
    if (operands && strcmp(out->operands[0], "-") == 0) return operands;
    if (operands >= out->command->operands) {
        fail_usage(out->command, "with %s the data are lines of standard input, found %s", OPTION_LINES,
                   out->operands[0]);
        return -1;
    }
    for (int i = operands; i > 0; i--) out->operands[i] = out->operands[i - 1];
    out->operands[0] = "-";
    return operands + 1;
}

int arguments_parse(const cli_command *command, int count, char **words, cli_arguments *out) {
    *out = (cli_arguments){.command = command};
    int operands = 0;
    bool only_operands = false;
    for (int i = 0; i < count; i++) {
        const char *word = words[i];
        if (!only_operands && strcmp(word, "--") == 0) {
            only_operands = true;
            continue;
        }
        if (only_operands || word[0] != '-' || word[1] == '\0') { /* "-" is an operand: a standard stream */
            if (word[0] == '\0') return fail_usage(command, "a file's name is empty");
            if (operands == command->operands + command->more)
                return fail_usage(command, "one word too many: %s", word);
            out->operands[operands++] = word;
            continue;
        }
        const char *equals = strchr(word, '=');
        size_t size = equals ? (size_t)(equals - word) : strlen(word);
        int index = option_index(command, word, size);
        if (index < 0) return fail_usage(command, "no such option: %s", word);
        const cli_option *option = command_option(command, index);
        if (out->values[index]) return fail_usage(command, "%s is given twice", option->name);
        if (!option->value) {
            if (equals) return fail_usage(command, "%s takes no value", option->name);
            out->values[index] = "";
        } else if (equals) {
            out->values[index] = equals + 1;
        } else {
            if (i + 1 == count) return fail_usage(command, "%s needs %s", option->name, option->value);
            out->values[index] = words[++i];
        }
    }
    operands = place_lines(out, operands);
    if (operands < 0) return EXIT_USAGE;
    if (operands < command->operands) return fail_usage(command, "expected: %s", command->usage);
    return EXIT_DONE;
}

const char *arguments_value(const cli_arguments *arguments, const char *name) {
    int index = option_index(arguments->command, name, strlen(name));
    return index < 0 ? NULL : arguments->values[index];
}

int arguments_choice(const cli_arguments *arguments, const char *name, const char *const *words, int count,
                     int *out) {
    const char *word = arguments_value(arguments, name);
    for (int i = 0; i < count && word; i++)
        if (strcmp(word, words[i]) == 0) {
            *out = i;
            return EXIT_DONE;
        }
    return word ? fail_usage(arguments->command, "%s: '%s' is none of its words", name, word) : EXIT_DONE;
}

/* Whether the text up to `end` is exactly one finite number. */
static bool number_between(const char *text, const char *end, double *out) {
    double value;
    if (bat_number_scan(text, end, &value) != end || !isfinite(value)) return false;
    *out = value;
    return true;
}

int arguments_number(const cli_arguments *arguments, const char *name, double low, double high, double *out) {
    const char *text = arguments_value(arguments, name);
    if (!text) return EXIT_DONE;
    double value;
    if (!number_between(text, text + strlen(text), &value)) {
        return fail_usage(arguments->command, "%s: expected a number, found '%s'", name, text);
    }
    if (value < low || value > high) {
        return fail_usage(arguments->command, "%s: %s is out of range, %g to %g", name, text, low, high);
    }
    *out = value;
    return EXIT_DONE;
}

int arguments_integer(const cli_arguments *arguments, const char *name, long low, long high, long *out) {
    double value = (double)low;
    int status = arguments_number(arguments, name, (double)low, (double)high, &value);
    if (status || !arguments_value(arguments, name)) return status;
    if (value != floor(value)) {
        return fail_usage(arguments->command, "%s: expected a whole number, found '%s'", name,
                          arguments_value(arguments, name));
    }
    *out = (long)value;
    return EXIT_DONE;
}

int arguments_gains(const cli_arguments *arguments, const char *name, int most, double *gains, bool *given) {
    const char *text = arguments_value(arguments, name);
    if (text && !*text) return fail_usage(arguments->command, "%s: expected LEVEL=GAIN,..., found ''", name);
    for (const char *at = text; at && *at;) {
        char *end = NULL, *last = NULL;
        const long level = strtol(at, &end, 10);
        const double gain = end != at && *end == '=' ? strtod(end + 1, &last) : 0;
        if (!last || last == end + 1 || (*last != '\0' && *last != ',') || (*last == ',' && last[1] == '\0'))
            return fail_usage(arguments->command, "%s: expected LEVEL=GAIN,..., found '%s'", name, text);
        if (level < 1 || level > most)
            return fail_usage(arguments->command, "%s: expected levels from 1 to %d, found %ld", name, most,
                              level);
        if (!(gain >= -1e6 && gain <= 1e6))
            return fail_usage(arguments->command, "%s: expected gains within 1e6, found '%s'", name, text);
        gains[level] = gain, given[level] = true;
        at = *last ? last + 1 : last;
    }
    return EXIT_DONE;
}

/* Reads numbers separated by commas, with a semicolon after every size-th (size 0: never). */
static int read_numbers(const cli_arguments *arguments, const char *name, size_t size, double **out,
                        size_t *count) {
    const char *text = arguments_value(arguments, name);
    *out = NULL;
    *count = 0;
    if (!text) return EXIT_DONE;
    size_t room = 1;
    for (const char *at = text; *at; at++) room += *at == ',' || *at == ';';
    double *numbers = malloc(room * sizeof *numbers);
    if (!numbers) return fail_memory();
    const char *at = text;
    for (size_t i = 0; i < room; i++) {
        size_t length = strcspn(at, size ? ",;" : ",");
        if (!number_between(at, at + length, &numbers[i])) {
            free(numbers);
            return fail_usage(arguments->command, "%s: expected a number, found '%.*s'", name, (int)length,
                              at);
        }
        const char *behind = at + length;
        if (size && *behind != ((i + 1) % size ? ',' : i + 1 == room ? '\0' : ';')) {
            free(numbers);
            return fail_usage(arguments->command, "%s: expected %zu numbers in each place, found others",
                              name, size);
        }
        at = behind + 1;
        if (!*behind) room = i + 1;
    }
    *out = numbers;
    *count = size ? room / size : room;
    return EXIT_DONE;
}

int arguments_numbers(const cli_arguments *arguments, const char *name, double **out, size_t *count) {
    return read_numbers(arguments, name, 0, out, count);
}

int arguments_places(const cli_arguments *arguments, const char *name, size_t size, double **out,
                     size_t *count) {
    return read_numbers(arguments, name, size, out, count);
}

int arguments_vector(const cli_arguments *arguments, const char *name, size_t size, double *out) {
    double *numbers;
    size_t count;
    int failed = arguments_numbers(arguments, name, &numbers, &count);
    if (failed || !numbers) return failed;
    if (count == size) memcpy(out, numbers, size * sizeof *out);
    free(numbers);
    return count == size
               ? EXIT_DONE
               : fail_usage(arguments->command, "%s: expected %zu numbers, found %zu", name, size, count);
}

int arguments_one_input(const cli_arguments *arguments, int count, const char *names) {
    int inputs = 0;
    for (int i = 0; i < count; i++) inputs += strcmp(arguments->operands[i], "-") == 0;
    if (inputs < 2) return EXIT_DONE;
    return fail_usage(arguments->command, "only one of %s can be standard input", names);
}

int arguments_product(const cli_arguments *arguments, const char *name, long most, long out[2]) {
    const char *text = arguments_value(arguments, name);
    if (!text) return EXIT_DONE;
    char *end;
    long w = strtol(text, &end, 10), h = 0;
    if (end != text && (*end == 'x' || *end == 'X')) {
        const char *second = end + 1;
        h = strtol(second, &end, 10);
        if (end == second) h = 0;
    }
    if (w < 1 || h < 1 || w > most || h > most || *end) {
        const cli_option *option = command_option(arguments->command,
                                                  option_index(arguments->command, name, strlen(name)));
        return fail_usage(arguments->command, "%s: expected %s, 1x1 to %ldx%ld, found '%s'", name,
                          option->value, most, most, text);
    }
    out[0] = w;
    out[1] = h;
    return EXIT_DONE;
}
