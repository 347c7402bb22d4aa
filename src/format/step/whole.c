/* Whether a face is all of its surface: then nothing bounds it but seams, there and back. */
#include "format/step/step.h"

#include <string.h>

enum {
    SEAMS = 4,  /* of a surface that is closed in both directions, each there and back */
    WORDS = 512 /* that say so, at most; where there are more, something else bounds the face */
};

typedef struct seams {
    int words; /* read */
    int count; /* SEAMS + 1: too many, or something else bounds it */
    double edge[SEAMS];
    bool there[SEAMS];
} seams;

/* The next word of an instance; false: it ends, or too much was read. */
static bool next_word(bat_step_place *at, seams *s, bat_step_token *word) {
    if (++s->words > WORDS) s->count = SEAMS + 1;
    if (s->count > SEAMS) return false;
    *word = bat_step_next(at);
    return word->type > BAT_STEP_BAD && word->mark != ';';
}

/* ORIENTED_EDGE('',*,*,#edge,.T.) */
static void add_edge(bat_step_place at, seams *out) {
    double edge = 0;
    bool there = true;
    bat_step_token token;
    while (next_word(&at, out, &token)) {
        if (token.type == BAT_STEP_OBJECT) edge = token.number;
        if (token.type == BAT_STEP_ENUM) there = token.size == 3 && memcmp(token.text, ".T.", 3) == 0;
    }
    if (out->count < SEAMS) out->edge[out->count] = edge, out->there[out->count] = there;
    out->count += out->count <= SEAMS;
}

/* The edges of what the instance refers to: bounds, loops, edges. */
static void gather(const bat_step_file *file, const bat_step_instance *of, int deep, seams *out) {
    bat_step_place at = of->body;
    bat_step_token token;
    while (next_word(&at, out, &token)) {
        const bat_step_instance *next = token.type == BAT_STEP_OBJECT ? bat_step_find(file, token.number)
                                                                      : NULL;
        if (!next) continue;
        bat_step_place inside = next->body;
        const bat_step_token name = bat_step_next(&inside);
        if (bat_step_is(&name, "ORIENTED_EDGE")) add_edge(inside, out);
        if (bat_step_is(&name, "FACE_BOUND") || bat_step_is(&name, "FACE_OUTER_BOUND") ||
            bat_step_is(&name, "EDGE_LOOP")) {
            if (deep > 0)
                gather(file, next, deep - 1, out);
            else
                out->count = SEAMS + 1;
        }
    }
}

bool bat_step_is_whole(const bat_step_file *file, const bat_step_instance *face) {
    seams found = {.count = 0};
    gather(file, face, 2, &found);
    if (found.count < 2 || found.count > SEAMS) return false;
    for (int i = 0; i < found.count; i++) {
        bool back = false;
        for (int k = 0; k < found.count; k++)
            back = back || (found.edge[k] == found.edge[i] && found.there[k] != found.there[i]);
        if (!back) return false;
    }
    return true;
}
