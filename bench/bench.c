/* bench: times Batten's kernels. --list, --filter TEXT, --json. Best and median of many runs. */
#define _POSIX_C_SOURCE 199309L
#include "bench.h"
#include "timing.h"

#include <stdbool.h>
#include <string.h>

int main(int argc, char **argv) {
    const bench_row *tables[] = {bench_rows_eval,  bench_rows_shape, bench_rows_levels, bench_rows_surface,
                                 bench_rows_wires, bench_rows_made,  bench_rows_moves,  bench_rows_editor};
    const char *filter = "";
    bool list = false, json = false;
    for (int i = 1; i < argc; i++) {
        if (!strcmp(argv[i], "--list"))
            list = true;
        else if (!strcmp(argv[i], "--json"))
            json = true;
        else if (!strcmp(argv[i], "--filter") && i + 1 < argc)
            filter = argv[++i];
        else {
            fprintf(stderr, "usage: bench [--list] [--filter TEXT] [--json]\n");
            return 2;
        }
    }
    if (!list && !json) printf("%-34s %12s %12s\n", "", "best", "median");
    for (size_t k = 0; k < sizeof tables / sizeof tables[0]; k++)
        for (const bench_row *row = tables[k]; row->name; row++) {
            char note[160] = "";
            if (!strstr(row->name, filter)) continue;
            if (list) {
                printf("%s\n", row->name);
                continue;
            }
            void *context = row->begin(row->variant);
            if (!context) {
                fprintf(stderr, "%s: cannot be set up\n", row->name);
                return 1;
            }
            const bench_time t = bench_measure(row->run, context);
            if (row->note) row->note(context, note, (int)sizeof note);
            row->end(context);
            if (json)
                bench_print("batten", row->name, row->unit, t, row->per, row->scale, note);
            else
                printf("%-34s %12.4g %12.4g %s %s\n", row->name, t.best * row->scale / row->per,
                       t.median * row->scale / row->per, row->unit, note);
        }
    return 0;
}
