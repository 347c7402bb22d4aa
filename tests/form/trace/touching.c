/* Surfaces that touch, nearly touch or cross by little, beside what closed forms say: touching [COUNT [SCALE [FAR]]], of each
 * kind COUNT pairs (1,000 in all), SCALE times the size, moved by up to FAR sizes. Status 1: some counts are wrong, or differ
 * with the order. */
#include "form/trace/touching.h"

#include <stdio.h>

static bool is_wrong(const touching *t) {
    touching_count found[2];
    for (int turned = 0; turned < 2; turned++)
        if (!touching_find(t, turned, &found[turned]) || !touching_agree(t, &found[turned])) return true;
    if (found[0].along && found[1].along) return false;
    return found[0].branches != found[1].branches || found[0].contacts != found[1].contacts;
}

int main(int argc, char **argv) {
    const int count = argc > 1 ? atoi(argv[1]) : 112;
    const double scale = argc > 2 ? atof(argv[2]) : 1, far = argc > 3 ? atof(argv[3]) : 0;
    int all = 0;
    for (int kind = 0; kind < TOUCHING_KINDS; kind++) {
        int wrong = 0;
        for (int i = 0; i < count; i++) {
            touching t = touching_make((touching_kind)kind, i, scale, far);
            if (is_wrong(&t)) printf("%s %d is wrong\n", touching_names[kind], i), wrong++;
            touching_free(&t);
        }
        printf("%s: %d of %d pairs wrong\n", touching_names[kind], wrong, count);
        fflush(stdout), all += wrong;
    }
    return all > 0;
}
