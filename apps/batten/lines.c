#include "lines.h"

#include "address.h"
#include "io.h"

#include "text/text.h"

#include <stdlib.h>
#include <string.h>

enum { MESSAGE_ROOM = 2048 };

/* A result may have several lines, which JSON lets us join: a string has no line end inside. */
static void join_lines(bat_text *output, size_t from) {
    size_t to = from;
    for (size_t i = from; i < output->size; i++)
        if (output->data[i] != '\n') output->data[to++] = output->data[i];
    output->size = to;
}

static int run_line(const cli_arguments *arguments, const char *line, size_t size, bat_text *output) {
    char message[MESSAGE_ROOM] = "";
    const size_t from = output->size;
    io_stand_in(line, size, output);
    fail_into(message, sizeof message);
    const int failed = arguments->command->run(arguments);
    fail_into(NULL, 0);
    io_stand_in(NULL, 0, NULL);
    address_release();
    if (failed == EXIT_USAGE) { /* would fail every time */
        remark("%s", message);
        return failed;
    }
    if (failed) {
        output->size = from;
        bat_text_string(output, "{\"error\":");
        bat_text_json_string(output, message);
        bat_text_string(output, "}");
    }
    join_lines(output, from);
    bat_text_string(output, "\n");
    return failed;
}

int run_lines(const cli_arguments *arguments) {
    char *input;
    size_t size;
    int status = io_read("-", &input, &size);
    if (status) return status;
    bat_text output = {0};
    for (const char *at = input, *end = input + size; at < end;) {
        const char *stop = memchr(at, '\n', (size_t)(end - at));
        const size_t length = (size_t)((stop ? stop : end) - at);
        const int failed = run_line(arguments, at, length, &output);
        if (failed) status = failed;
        if (failed == EXIT_USAGE) break;
        at += length + (stop != NULL);
    }
    free(input);
    if (output.failed && status != EXIT_USAGE) status = fail_memory();
    if (status != EXIT_USAGE && !output.failed && output.size) {
        const int failed = io_write("-", output.data, output.size);
        if (failed) status = failed;
    }
    bat_text_free(&output);
    return status;
}
