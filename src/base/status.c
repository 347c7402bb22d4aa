#include <batten/base.h>

const char *bat_status_message(bat_status status) {
    switch (status) {
    case BAT_OK: return "done";
    case BAT_MEMORY: return "out of memory";
    case BAT_ARGUMENT: return "an argument is missing or out of range";
    case BAT_NUMBER: return "a number is not finite";
    case BAT_KNOTS: return "the knots decrease, repeat too often, or leave no domain";
    case BAT_COUNT: return "too few or too many points";
    case BAT_DEGREE: return "the degree is not between 1 and 7";
    case BAT_DIMENSION: return "the dimension is neither 2 nor 3, or differs";
    case BAT_PARAMETER: return "a parameter is outside the domain or not sorted";
    case BAT_TOLERANCE: return "the tolerance could not be met";
    case BAT_DOT: return "the stroke is too short";
    case BAT_FAR: return "the stroke is too far from the curve";
    case BAT_SYNTAX: return "the text does not parse";
    case BAT_SINGULAR: return "the system of equations has no unique solution";
    case BAT_UNSUPPORTED: return "this kind or version is not known";
    case BAT_STATE: return "the call is out of order";
    }
    return "unknown status";
}

const char *bat_version(void) { return BAT_VERSION; }
