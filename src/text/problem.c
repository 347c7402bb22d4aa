/* What was wrong, in words: where, what was expected, and what was found. */
#include "text/json.h"
#include "text/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

bat_status bat_problem_set(bat_problem *problem, bat_status status, const char *place, const char *message) {
    if (problem) {
        snprintf(problem->place, sizeof problem->place, "%s", place);
        snprintf(problem->message, sizeof problem->message, "%s", message);
    }
    return status;
}

bat_status bat_problem_found(bat_problem *problem, bat_status status, const char *place, size_t index,
                             const char *expected, double found) {
    char number[BAT_NUMBER_ROOM] = "no number";
    if (!problem) return status;
    if (!isnan(found)) bat_number_print(found, number);
    snprintf(problem->place, sizeof problem->place, place, index);
    snprintf(problem->message, sizeof problem->message, "expected %.100s, found %.40s", expected, number);
    return status;
}

bool bat_problem_outside(bat_problem *problem, const char *place, size_t index, double low, double high,
                         double found) {
    char expected[2 * BAT_NUMBER_ROOM + 4], first[BAT_NUMBER_ROOM], last[BAT_NUMBER_ROOM];
    if (found >= low && found <= high) return false;
    if (problem) {
        bat_number_print(low, first), bat_number_print(high, last);
        snprintf(expected, sizeof expected, low < high ? "%s to %s" : "%s", first, last);
        bat_problem_found(problem, BAT_OK, place, index, expected, found);
    }
    return true;
}

bat_status bat_problem_inside(bat_problem *problem, bat_status status, const char *name) {
    const size_t room = problem ? sizeof problem->place : 0, length = strlen(name) + 1;
    if (!problem || status == BAT_OK || length >= room) return status;
    memmove(problem->place + length, problem->place, room - length);
    memcpy(problem->place, name, length - 1);
    problem->place[length - 1] = '.', problem->place[room - 1] = '\0';
    return status;
}
