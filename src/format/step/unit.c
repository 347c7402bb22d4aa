/* The unit of length of a STEP file. */
#include "format/step/step.h"

#include <string.h>

enum { DEEPEST = 4 }; /* a unit that is so many of another, which is ... */

/* Millimetres of a metre with a prefix; 0: none such. */
static double prefix_of(const bat_step_token *token) {
    static const struct {
        const char *name;
        double millimetres;
    } prefixes[] = {{".MILLI.", 1},    {".CENTI.", 10},  {".DECI.", 100}, {".DECA.", 1e4},
                    {".HECTO.", 1e5},  {".KILO.", 1e6},  {".MEGA.", 1e9}, {".GIGA.", 1e12},
                    {".MICRO.", 1e-3}, {".NANO.", 1e-6}, {".PICO.", 1e-9}};
    if (token->mark == '$') return 1000;
    for (size_t i = 0; token->type == BAT_STEP_ENUM && i < sizeof prefixes / sizeof *prefixes; i++)
        if (token->size == strlen(prefixes[i].name) &&
            memcmp(token->text, prefixes[i].name, token->size) == 0)
            return prefixes[i].millimetres;
    return 0;
}

/* What the last number and the last reference of an instance are, and the prefix of its SI_UNIT. */
typedef struct content {
    double number, object, prefix;
} content;

static content look(const bat_step_instance *instance) {
    content found = {0};
    bat_step_place at = instance->body;
    bool converted = false;
    for (bat_step_token token = bat_step_next(&at); token.type > BAT_STEP_BAD && token.mark != ';';
         token = bat_step_next(&at)) {
        if (token.type == BAT_STEP_NUMBER) found.number = token.number;
        if (bat_step_is(&token, "NAMED_UNIT")) converted = found.object > 0; /* what follows are dimensions */
        if (token.type == BAT_STEP_OBJECT && !converted) found.object = token.number;
        if (!bat_step_is(&token, "SI_UNIT")) continue;
        (void)bat_step_next(&at);
        token = bat_step_next(&at);
        found.prefix = prefix_of(&token);
    }
    return found;
}

/* CONVERSION_BASED_UNIT names a measure, which is a number of another unit. */
static double millimetres(const bat_step_file *file, const bat_step_instance *unit) {
    double factor = 1;
    for (int k = 0; unit && k < DEEPEST; k++) {
        content c = look(unit);
        if (c.prefix > 0) return factor * c.prefix;
        const bat_step_instance *measure = bat_step_find(file, c.object);
        if (!measure) return 0;
        c = look(measure);
        factor *= c.number;
        unit = bat_step_find(file, c.object);
    }
    return 0;
}

bat_status bat_step_unit(const bat_step_file *file, double *out, bat_problem *problem) {
    double found = 0;
    for (size_t i = 0; i < file->count; i++) {
        if (!(file->list[i].flags & BAT_STEP_UNITS)) continue;
        bat_step_place at = file->list[i].body;
        for (bat_step_token token = bat_step_next(&at); token.type > BAT_STEP_BAD && token.mark != ';';
             token = bat_step_next(&at)) {
            const bat_step_instance *unit = token.type == BAT_STEP_OBJECT ? bat_step_find(file, token.number)
                                                                          : NULL;
            if (!unit || !(unit->flags & BAT_STEP_LENGTH)) continue;
            const double value = millimetres(file, unit);
            if (!(value > 0 && value <= 1e12))
                return bat_step_wrong(&unit->body, BAT_UNSUPPORTED,
                                      "expected a unit of length, found one that is not known", problem);
            if (found != 0 && value != found)
                return bat_step_wrong(&unit->body, BAT_UNSUPPORTED,
                                      "expected one unit of length in the file, found two", problem);
            found = value;
        }
    }
    *out = found > 0 ? found : 1;
    return BAT_OK;
}
