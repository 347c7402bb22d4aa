/* Every command of the table, and all else that hosts do, on n things: how their work grows.
 * Usage: growth_commands [n [scene [command or act]]] */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "acts.h"
#include "editor/choice/choice.h"
#include "editor/editor.h"
#include "editor/tables/tables.h"
#include "growth.h"
#include "scenes.h"

enum { MOST_CHOICES = 1000 };
static const double MOST = 1.15;
static const uint64_t NEVER = UINT64_MAX;
static int middle = 200; /* the middle one of three n */

typedef struct reading {
    uint64_t work;
    bool done; /* the command found something to do */
} reading;

/* Commands first, then acts; NULL: there are no more. */
static const char *name_of(int choice) {
    return choice < BAT_COMMAND_COUNT ? bat_command_at((bat_command_id)choice)->name
                                      : growth_acts[choice - BAT_COMMAND_COUNT].name;
}

/* Offsets and arrays are only shown at first: to keep them does the same work and more, and is what is counted. */
static const char *counted(bat_editor *editor, int choice) {
    const bool shown = choice == BAT_COMMAND_CURVE_OFFSET || choice == BAT_COMMAND_ARRAY;
    if (!shown || bat_editor_command(editor, name_of(choice)) != BAT_OK) return name_of(choice);
    return "accept";
}

static reading perform(bat_editor *editor, int choice) {
    reading result = {0, true};
    const char *name = counted(editor, choice);
    uint64_t before = growth_work;
    if (choice < BAT_COMMAND_COUNT) {
        result.done = bat_editor_command(editor, name) == BAT_OK;
        bat_editor_frame(editor);
    } else {
        growth_acts[choice - BAT_COMMAND_COUNT].perform(editor);
    }
    result.work = growth_work - before;
    return result;
}

/*
 * Performs choices, from one on up to the first that the editor does, in a process of its own, so that the editor stays as it was
 * made: what is refused changes nothing, unless it has taken another tool to say why. How many there are readings of; the next one
 * fails when the status is not 0.
 */
static int perform_apart(bat_editor *editor, int from, int end, reading *readings, int *status) {
    int ends[2], count = 0;
    *status = -1;
    if (pipe(ends) != 0) return 0;
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        reading own = {0};
        const bat_tool_id tool = editor->context.choice->tool;
        for (int i = from; i < end && !own.done && editor->context.choice->tool == tool; i++) {
            own = perform(editor, i);
            if (write(ends[1], &own, sizeof own) != (ssize_t)sizeof own) _exit(1);
        }
        _exit(0);
    }
    close(ends[1]);
    while (from + count < end &&
           read(ends[0], &readings[count], sizeof *readings) == (ssize_t)sizeof *readings)
        count++;
    close(ends[0]);
    if (child > 0) waitpid(child, status, 0);
    return count;
}

/* Readings of choices; those that fail are said and have none (NEVER). How many fail. */
static int perform_all(const growth_scene *scene, bat_editor *editor, int from, int end, reading *readings) {
    int faults = 0;
    for (int i = from, status; i < end; i++) {
        i += perform_apart(editor, i, end, &readings[i], &status) - 1;
        if (status == 0) continue;
        printf("%s: %s fails\n", scene->name, name_of(++i));
        readings[i].work = NEVER;
        faults++;
    }
    return faults;
}

/* What grows too fast from one size to the next, but for a step between two: it does so to the next but one, too. */
static bool grows_on(const growth_scene *scene, int choice, uint64_t mid, uint64_t last) {
    static reading more[MOST_CHOICES];
    bat_editor *editor = scene->make(16 * middle);
    const bool fails = perform_all(scene, editor, choice, choice + 1, more) > 0;
    bat_editor_free(editor);
    return fails || growth_judge(scene->name, name_of(choice), (uint64_t[]){mid, last, more[choice].work},
                                 4 * middle, MOST);
}

/* How many grow too fast; done[command] becomes true for those that found something to do. The middle one need not be known
 * (growth_judge) where the last is no more than four times the first, and is taken to be as the first. */
static int judge_scene(const growth_scene *scene, const char *only, bool *done) {
    static reading readings[GROWTH_SIZES][MOST_CHOICES];
    bat_editor *editors[GROWTH_SIZES];
    int faults = 0, from = 0, end = 0;
    while (name_of(end)) end++;
    if (only) {
        while (from < end && strcmp(only, name_of(from)) != 0) from++;
        end = from + (from < end);
    }
    for (int k = 0, size = middle / 4; k < GROWTH_SIZES; k++, size *= 4) editors[k] = scene->make(size);
    for (int k = 0; k < GROWTH_SIZES; k += 2)
        faults += perform_all(scene, editors[k], from, end, readings[k]);
    for (int i = from; i < end; i++) {
        reading *first = &readings[0][i], *mid = &readings[1][i], *last = &readings[2][i];
        if (first->work == NEVER || last->work == NEVER) continue;
        *mid = *first;
        if (last->work > 4 * first->work) faults += perform_all(scene, editors[1], i, i + 1, readings[1]);
        if (mid->work != NEVER &&
            growth_exceeds((uint64_t[]){first->work, mid->work, last->work}, middle, MOST))
            faults += grows_on(scene, i, mid->work, last->work);
        if (i < BAT_COMMAND_COUNT && last->done) done[i] = true;
    }
    for (int k = 0; k < GROWTH_SIZES; k++) bat_editor_free(editors[k]);
    return faults;
}

int main(int count, char **words) {
    static bool done[BAT_COMMAND_COUNT];
    int faults = 0, judged = 0;
    if (count > 1) middle = (int)strtol(words[1], NULL, 10);
    for (const growth_scene *scene = growth_scenes; scene->name; scene++) {
        if (count > 2 && strcmp(words[2], scene->name) != 0) continue;
        faults += judge_scene(scene, count > 3 ? words[3] : NULL, done);
        judged++;
    }
    for (int i = 0; i < BAT_COMMAND_COUNT && count < 3; i++) {
        if (done[i]) continue;
        printf("%s finds nothing to do in any scene\n", name_of(i));
        faults++;
    }
    printf("%d scenes, %d faults\n", judged, faults);
    return faults > 0 || judged == 0;
}
