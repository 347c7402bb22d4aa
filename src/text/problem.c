#include "text/json.h"

#include <stdio.h>

bat_status bat_problem_set(bat_problem *problem, bat_status status, const char *place, const char *message) {
    if (problem) {
        snprintf(problem->place, sizeof problem->place, "%s", place);
        snprintf(problem->message, sizeof problem->message, "%s", message);
    }
    return status;
}
