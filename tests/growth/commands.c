/* Every command of the table, and all else that hosts do, on n things: how their work grows.
 * Usage: growth_commands [n [scene [command or act]]] */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "acts.h"
#include "editor/tables/tables.h"
#include "growth.h"
#include "scenes.h"

static const double MOST = 1.15;
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

/* In a process of its own, so that the editor stays as it was made. */
static bool perform_apart(bat_editor *editor, int choice, reading *result) {
    int ends[2], status = 0;
    if (pipe(ends) != 0) return false;
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        reading own = perform(editor, choice);
        _exit(write(ends[1], &own, sizeof own) == (ssize_t)sizeof own ? 0 : 1);
    }
    close(ends[1]);
    bool good = child > 0 && read(ends[0], result, sizeof *result) == (ssize_t)sizeof *result;
    close(ends[0]);
    if (child > 0) waitpid(child, &status, 0);
    return good && status == 0;
}

/* How much work a choice is for each n; false: it fails. The middle one need not be known (growth_judge) where the last is no more
 * than four times the first, and is taken to be as the first. */
static bool measure(bat_editor *editors[GROWTH_SIZES], int choice, bool *done, uint64_t work[GROWTH_SIZES]) {
    reading readings[GROWTH_SIZES];
    for (int k = 0; k < GROWTH_SIZES; k += 2)
        if (!perform_apart(editors[k], choice, &readings[k])) return false;
    readings[1] = readings[0];
    if (readings[2].work > 4 * readings[0].work && !perform_apart(editors[1], choice, &readings[1]))
        return false;
    for (int k = 0; k < GROWTH_SIZES; k++) work[k] = readings[k].work;
    if (choice < BAT_COMMAND_COUNT && readings[2].done) done[choice] = true;
    return true;
}

/* How many grow too fast; done[command] becomes true for those that found something to do. */
static int judge_scene(const growth_scene *scene, const char *only, bool *done) {
    bat_editor *editors[GROWTH_SIZES];
    int faults = 0;
    for (int k = 0, size = middle / 4; k < GROWTH_SIZES; k++, size *= 4) editors[k] = scene->make(size);
    for (int i = 0; name_of(i); i++) {
        uint64_t work[GROWTH_SIZES];
        if (only && strcmp(only, name_of(i)) != 0) continue;
        if (measure(editors, i, done, work)) {
            faults += growth_judge(scene->name, name_of(i), work, middle, MOST);
        } else {
            printf("%s: %s fails\n", scene->name, name_of(i));
            faults++;
        }
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
