/* batten replay: runs a journal of the editor. */
#include "drawing.h"
#include "io.h"
#include "program.h"
#include "results.h"

#include <batten/editor.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int print_digest(const bat_document *document) {
    char digest[17];
    snprintf(digest, sizeof digest, "%016llx", (unsigned long long)bat_document_digest(document));
    bat_text text = {0};
    bat_text_string(&text, "{\"digest\":\"");
    bat_text_string(&text, digest);
    bat_text_string(&text, "\",\"objects\":");
    bat_text_integer(&text, (uint64_t)bat_document_count(document));
    bat_text_string(&text, ",\"curves\":");
    bat_text_integer(&text, (uint64_t)drawing_curve_count(document));
    bat_text_string(&text, "}");
    return write_text(&text);
}

static int save(const bat_document *document, const char *journal, const char *out) {
    char *text;
    size_t size;
    int failed = drawing_print(document, bat_format_called(out), journal, &text, &size);
    if (failed) return failed;
    failed = io_write(out, text, size);
    bat_free(text);
    return failed;
}

static bat_status replayed(const char *text, size_t size, void *editor, bat_problem *problem) {
    return bat_editor_replay(editor, text, size, false, problem);
}

static bat_status replayed_and_checked(const char *text, size_t size, void *editor, bat_problem *problem) {
    return bat_editor_replay(editor, text, size, true, problem);
}

static int replay(const cli_arguments *arguments, bat_editor *editor) {
    const char *name = arguments->operands[0], *out = arguments_value(arguments, "--output");
    bool check = arguments_value(arguments, "--check");
    bat_problem problem;
    int failed = read_data(name, check ? replayed_and_checked : replayed, editor, &problem);
    if (failed) return failed;
    const char *broken = check ? bat_editor_check(editor) : NULL;
    if (broken) return fail_data(name, NULL, "%s", broken);
    if (out) failed = save(bat_editor_document(editor), name, out);
    return failed ? failed : print_digest(bat_editor_document(editor));
}

static int run(const cli_arguments *arguments) {
    const char *out = arguments_value(arguments, "--output");
    if (out && !bat_format_called(out)) {
        char words[BAT_FORMATS_WORDS];
        bat_formats_words(".", false, words);
        return fail_usage(arguments->command, "%s: expected a name that ends in %s", out, words);
    }
    bat_editor *editor;
    if (bat_editor_create(&editor) != BAT_OK) return fail_memory();
    int failed = replay(arguments, editor);
    bat_editor_free(editor);
    return failed;
}

const cli_command command_replay = {
    .name = "replay",
    .usage = "JOURNAL [--check] [--output OUT]",
    .summary = "Runs a journal of the editor and prints the digest of the document it leads to.",
    .details = "With --check the digests noted in the journal and the document's invariants are compared "
               "after every\n"
               "entry; the first difference ends it with status 1.",
    .example = "batten replay session.journal --check --output session.svg",
    .operands = 1,
    .options = {{"--check", NULL, "compare digests and invariants after every entry"},
                {"--output", "OUT", "write the document, too: .batten, .svg or .json"}},
    .run = run,
};
