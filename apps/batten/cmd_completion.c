/* batten completion: what a shell proposes while a command is typed, made from the commands' tables. */
#include "io.h"
#include "program.h"
#include "results.h"

#include "text/text.h"

#include <string.h>

/* The first word of a name. */
static size_t first_word(const char *name) { return strcspn(name, " "); }

static const char *second_word(const char *name) {
    const char *space = strchr(name, ' ');
    return space ? space + 1 : NULL;
}

/* Whether an earlier command has the same first word. */
static bool is_repeated(const cli_command *const *all, size_t i) {
    const size_t size = first_word(all[i]->name);
    for (size_t k = 0; k < i; k++)
        if (first_word(all[k]->name) == size && memcmp(all[k]->name, all[i]->name, size) == 0) return true;
    return false;
}

/* Text inside single quotes of a shell. */
static void put_quoted(bat_text *text, const char *words) {
    bat_text_string(text, "'");
    for (; *words; words++)
        if (*words == '\'')
            bat_text_string(text, "'\\''");
        else
            bat_text_add(text, words, 1);
    bat_text_string(text, "'");
}

/* Words of an option's value that are proposed: "C0|C1|C2". NULL: any value. */
static const char *choices_of(const cli_command *command, const cli_option *option) {
    static const struct {
        const cli_command *command;
        const char *option, *words;
    } told[] = {{&command_frames, "--kind", "rmf|frenet|fixed"},
                {&command_tangents, "--mode", "round|faithful|paper|even"},
                {&command_tangents, "--default", "centripetal|uniform|chordal"},
                {&command_render, "--look", "shaded|zebra|curvature|mean|lines"},
                {&command_render, "--to", "svg|png|pdf|eps"},
                {&command_curve_region, "--operation", "union|difference|intersection|exclusion"}};
    for (size_t i = 0; i < sizeof told / sizeof *told; i++)
        if (told[i].command == command && strcmp(told[i].option, option->name) == 0) return told[i].words;
    const char *value = option->value;
    return value && strchr(value, '|') && !strpbrk(value, ", ()") ? value : NULL;
}

static void put_words(bat_text *text, const char *choices) {
    for (; *choices; choices++) bat_text_add(text, *choices == '|' ? " " : choices, 1);
}

typedef void put_option(bat_text *text, const cli_command *command, const cli_option *option);

static void each_option(bat_text *text, const cli_command *command, put_option *put) {
    static const cli_option help = {"--help", NULL, "what the command does, with an example"};
    const cli_option *option;
    for (int i = 0; (option = command_option(command, i)) != NULL; i++) put(text, command, option);
    put(text, command, &help);
}

/* ---- bash ---- */

static void bash_option(bat_text *text, const cli_command *command, const cli_option *option) {
    (void)command;
    bat_text_string(text, " ");
    bat_text_string(text, option->name);
}

static void bash_choice(bat_text *text, const cli_command *command, const cli_option *option) {
    const char *choices = choices_of(command, option);
    if (!choices) return;
    bat_text_string(text, "    '");
    bat_text_string(text, command->name);
    bat_text_string(text, " ");
    bat_text_string(text, option->name);
    bat_text_string(text, "') words='");
    put_words(text, choices);
    bat_text_string(text, "' ;;\n");
}

static void put_firsts(bat_text *text, const cli_command *const *all, size_t count) {
    for (size_t i = 0; i < count; i++) {
        if (is_repeated(all, i)) continue;
        bat_text_add(text, all[i]->name, first_word(all[i]->name));
        bat_text_string(text, " ");
    }
}

static void put_seconds(bat_text *text, const cli_command *const *all, size_t count, const char *group) {
    const size_t size = first_word(group);
    for (size_t i = 0; i < count; i++) {
        if (!second_word(all[i]->name) || first_word(all[i]->name) != size ||
            memcmp(all[i]->name, group, size) != 0)
            continue;
        bat_text_string(text, second_word(all[i]->name));
        bat_text_string(text, " ");
    }
}

/* A case for each first word of names with two: between both texts, its second words. */
static void put_groups(bat_text *text, const cli_command *const *all, size_t count, const char *before,
                       const char *after) {
    for (size_t i = 0; i < count; i++) {
        if (!second_word(all[i]->name) || is_repeated(all, i)) continue;
        bat_text_string(text, "    ");
        bat_text_add(text, all[i]->name, first_word(all[i]->name));
        bat_text_string(text, before);
        put_seconds(text, all, count, all[i]->name);
        bat_text_string(text, after);
    }
}

static void put_bash(bat_text *text, const cli_command *const *all, size_t count) {
    bat_text_string(text, "_batten() {\n"
                          "  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]}\n"
                          "  local command=${COMP_WORDS[1]} words=''\n"
                          "  COMPREPLY=()\n"
                          "  if ((COMP_CWORD == 1)); then\n"
                          "    COMPREPLY=($(compgen -W '");
    put_firsts(text, all, count);
    bat_text_string(text, "--help --version' -- \"$cur\"))\n    return\n  fi\n  case $command in\n");
    put_groups(text, all, count, ")\n      if ((COMP_CWORD == 2)); then\n        COMPREPLY=($(compgen -W '",
               "' -- \"$cur\"))\n        return\n      fi\n      command=\"$command ${COMP_WORDS[2]}\" ;;\n");
    bat_text_string(text, "  esac\n  case \"$command $prev\" in\n");
    for (size_t i = 0; i < count; i++) each_option(text, all[i], bash_choice);
    bat_text_string(text, "  esac\n  if [[ -z $words && $cur == -* ]]; then\n    case $command in\n");
    for (size_t i = 0; i < count; i++) {
        bat_text_string(text, "    '");
        bat_text_string(text, all[i]->name);
        bat_text_string(text, "') words='");
        each_option(text, all[i], bash_option);
        bat_text_string(text, "' ;;\n");
    }
    bat_text_string(text, "    esac\n  fi\n  if [[ -z $words && $cur != -* ]]; then\n    case $command in\n");
    for (size_t i = 0; i < count; i++) {
        if (!all[i]->words) continue;
        bat_text_string(text, "    '");
        bat_text_string(text, all[i]->name);
        bat_text_string(text, "') words='");
        put_words(text, all[i]->words);
        bat_text_string(text, "' ;;\n");
    }
    bat_text_string(text, "    esac\n  fi\n"
                          "  [[ -n $words ]] && COMPREPLY=($(compgen -W \"$words\" -- \"$cur\"))\n"
                          "}\n"
                          "complete -o default -F _batten batten\n");
}

/* ---- zsh ---- */

static void zsh_option(bat_text *text, const cli_command *command, const cli_option *option) {
    bat_text_string(text, " \\\n        ");
    bat_text line = {0};
    bat_text_string(&line, option->name);
    bat_text_string(&line, "[");
    for (const char *at = option->help; *at; at++) {
        if (strchr("[]:\\", *at)) bat_text_string(&line, "\\");
        bat_text_add(&line, at, 1);
    }
    bat_text_string(&line, "]");
    if (option->value) {
        const char *choices = choices_of(command, option);
        bat_text_string(&line, ":value:");
        bat_text_string(&line, choices ? "(" : "_files");
        if (choices) put_words(&line, choices);
        if (choices) bat_text_string(&line, ")");
    }
    char *data = NULL;
    size_t size;
    text->failed = bat_text_finish(&line, &data, &size) != BAT_OK || text->failed;
    if (data) put_quoted(text, data);
    bat_free(data);
}

static void put_zsh(bat_text *text, const cli_command *const *all, size_t count) {
    bat_text_string(text, "#compdef batten\n_batten() {\n  local command=$words[2]\n"
                          "  if ((CURRENT == 2)); then\n    compadd -- ");
    put_firsts(text, all, count);
    bat_text_string(text, "--help --version\n    return\n  fi\n  case $command in\n");
    put_groups(text, all, count, ")\n      if ((CURRENT == 3)); then\n        compadd -- ",
               "\n        return\n      fi\n      command=\"$command $words[3]\" ;;\n");
    bat_text_string(text, "  esac\n  case $command in\n");
    for (size_t i = 0; i < count; i++) {
        bat_text_string(text, "    ");
        put_quoted(text, all[i]->name);
        bat_text_string(text, ")\n      _arguments");
        each_option(text, all[i], zsh_option);
        bat_text_string(text, " \\\n        '*:");
        bat_text_string(text, all[i]->words ? "word:(" : "file:_files");
        if (all[i]->words) put_words(text, all[i]->words);
        bat_text_string(text, all[i]->words ? ")' ;;\n" : "' ;;\n");
    }
    bat_text_string(text, "  esac\n}\n"
                          "if [[ $zsh_eval_context[-1] == loadautofunc ]]; then _batten \"$@\"\n"
                          "else compdef _batten batten\nfi\n");
}

/* ---- fish ---- */

static void fish_condition(bat_text *text, const char *name) {
    const char *second = second_word(name);
    bat_text_string(text, "complete -c batten -n '__fish_seen_subcommand_from ");
    bat_text_add(text, name, first_word(name));
    if (second) {
        bat_text_string(text, "; and __fish_seen_subcommand_from ");
        bat_text_string(text, second);
    }
    bat_text_string(text, "'");
}

static void fish_option(bat_text *text, const cli_command *command, const cli_option *option) {
    const char *choices = choices_of(command, option);
    const bool is_long = option->name[1] == '-';
    fish_condition(text, command->name);
    bat_text_string(text, is_long ? " -l " : " -s ");
    bat_text_string(text, option->name + (is_long ? 2 : 1));
    bat_text_string(text, choices ? " -x -a '" : option->value ? " -r" : "");
    if (choices) put_words(text, choices);
    bat_text_string(text, choices ? "' -d " : " -d ");
    put_quoted(text, option->help);
    bat_text_string(text, "\n");
}

static void put_fish(bat_text *text, const cli_command *const *all, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const char *second = second_word(all[i]->name);
        if (!is_repeated(all, i)) {
            bat_text_string(text, "complete -c batten -n __fish_use_subcommand -f -a ");
            bat_text_add(text, all[i]->name, first_word(all[i]->name));
            if (!second) bat_text_string(text, " -d "), put_quoted(text, all[i]->summary);
            bat_text_string(text, "\n");
        }
        if (second) {
            bat_text_string(text, "complete -c batten -n '__fish_seen_subcommand_from ");
            bat_text_add(text, all[i]->name, first_word(all[i]->name));
            bat_text_string(text, "; and not __fish_seen_subcommand_from ");
            put_seconds(text, all, count, all[i]->name);
            bat_text_string(text, "' -f -a ");
            bat_text_string(text, second);
            bat_text_string(text, " -d ");
            put_quoted(text, all[i]->summary);
            bat_text_string(text, "\n");
        }
        each_option(text, all[i], fish_option);
        if (!all[i]->words) continue;
        fish_condition(text, all[i]->name);
        bat_text_string(text, " -f -a '");
        put_words(text, all[i]->words);
        bat_text_string(text, "'\n");
    }
}

static int run(const cli_arguments *arguments) {
    static const struct {
        const char *name;
        void (*put)(bat_text *text, const cli_command *const *all, size_t count);
    } shells[] = {{"bash", put_bash}, {"zsh", put_zsh}, {"fish", put_fish}};
    size_t count;
    const cli_command *const *all = all_commands(&count);
    bat_text text = {0};
    for (size_t i = 0; i < sizeof shells / sizeof *shells; i++) {
        if (strcmp(arguments->operands[0], shells[i].name) != 0) continue;
        shells[i].put(&text, all, count);
        return write_text(&text);
    }
    return fail_usage(arguments->command, "expected bash, zsh or fish, found %s", arguments->operands[0]);
}

const cli_command command_completion = {
    .name = "completion",
    .usage = "bash|zsh|fish",
    .summary = "Prints what a shell needs to complete commands, options and their words.",
    .details = "In bash: source <(batten completion bash). zsh: put the text into a file called _batten in a "
               "folder of\n$fpath. fish: batten completion fish > "
               "~/.config/fish/completions/batten.fish",
    .example = "batten completion bash > ~/.local/share/bash-completion/completions/batten",
    .operands = 1,
    .words = "bash|zsh|fish",
    .run = run,
};
