/* Long work: a pen-up does no more after a thousand operations than after the first hundred, together with its share of the
 * compactions of the journal, which a host asks for whenever it has grown by a half. The journal stays within four times what
 * it is when compacted. */
#include "growth.h"
#include "support/pen.h"

#include <stdio.h>
#include <stdlib.h>

enum { LINES = 40, PERIOD = 200, OPERATIONS = 1200, WARM = PERIOD, GROWS = 1 << 18 };

static const double MOST = 1.2;

/* Draws the line of a row anew; the same strokes come again after each period. */
static void stroke(pen *p, int operation) {
    const int n = operation % PERIOD, row = n % LINES;
    const double x = 40 + 480 * (row % 2), y = 40 + 36 * (row / 2), bulge = (n * 7) % 13 - 6;
    p->time += 5000;
    pen_begin(p, pen_arch, (double[]){x, y, x + 400, y, bulge}, 100);
    pen_event(p, BAT_POINTER_UP, x + 400, y);
}

int main(void) {
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    uint64_t first = 0, last = 0;
    size_t size = 0, compact = 0;
    bat_editor_resize(editor, 1000, 800, 1);
    for (int i = 0; i < LINES; i++) stroke(&p, i);
    for (int i = 0; i < OPERATIONS; i++) {
        const uint64_t before = growth_work;
        stroke(&p, i);
        bat_editor_journal(editor, &size);
        if (size > compact + compact / 2 + GROWS) {
            if (bat_editor_compact(editor) != BAT_OK) abort();
            bat_editor_journal(editor, &compact);
        }
        if (i >= WARM && i < WARM + PERIOD) first += growth_work - before;
        if (i >= OPERATIONS - PERIOD) last += growth_work - before;
    }
    const double ratio = (double)last / (double)first;
    if (bat_editor_compact(editor) != BAT_OK) abort();
    bat_editor_journal(editor, &compact);
    printf("%d operations: %.3f of the work of the first; journal %zu, %zu when compacted\n", OPERATIONS,
           ratio, size, compact);
    bat_editor_free(editor);
    return ratio <= MOST && size <= 4 * compact ? 0 : 1;
}
