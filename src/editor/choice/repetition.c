#include "editor/choice/repetition.h"
#include "base/matrix.h"
#include "editor/choice/choice.h"
#include "editor/session/history.h"
#include "editor/session/session.h"
#include <string.h>

static bool is_same(const bat_selection *a, const bat_selection *b) {
    return a->count == b->count &&
           (a->count == 0 || !memcmp(a->ids, b->ids, (size_t)a->count * sizeof *a->ids));
}

static bool is_identity(const double m[6]) {
    return m[0] == 1 && m[1] == 0 && m[2] == 0 && m[3] == 1 && m[4] == 0 && m[5] == 0;
}

bool bat_repetition_is_of_selection(const bat_context *c) {
    return is_same(&c->choice->selection, &c->choice->repetition.of);
}

/* Whether that state is behind the present one: the step that led to it has not been undone. */
static bool is_past(const bat_history *history, uint64_t state) {
    for (int i = history->done - 1; i >= 0; i--)
        if (history->steps[i].after == state) return true;
    return false;
}

/* How many of the moves have not been undone. */
static int standing(const bat_context *c) {
    const bat_repetition *r = &c->choice->repetition;
    int count = r->count;
    while (count > 0 && !is_past(&c->session->history, r->moves[count - 1].state)) count--;
    return count;
}

static void begin(bat_context *c, const double matrix[6], const double box[4], bat_string label,
                  bool copies) {
    bat_repetition *r = &c->choice->repetition;
    const bat_selection *selection = &c->choice->selection;
    r->count = 0;
    if (is_identity(matrix)) return;
    bat_selection_clear(&r->of);
    for (int i = 0; i < selection->count; i++)
        if (bat_selection_append(&r->of, selection->ids[i]) != BAT_OK) return;
    bat_selection_sort(&r->of);
    r->copies = copies;
    r->label = label;
    memcpy(r->box, box, sizeof r->box);
    memcpy(r->moves[0].matrix, matrix, sizeof r->moves[0].matrix);
    r->moves[0].state = c->session->history.state;
    r->count = 1;
}

/* One more move of the copies. The first, which made them, stays. */
static void go_on(bat_context *c, int count, const double matrix[6]) {
    bat_repetition *r = &c->choice->repetition;
    if (count == BAT_REPETITION_MOVES) {
        memmove(r->moves + 1, r->moves + 2, (BAT_REPETITION_MOVES - 2) * sizeof *r->moves);
        count--;
    }
    bat_repetition_move *move = &r->moves[count];
    bat_matrix_compose(matrix, r->moves[count - 1].matrix, move->matrix);
    move->state = c->session->history.state;
    r->count = count + 1;
}

void bat_repetition_note(bat_context *c, const double matrix[6], const double box[4], bat_string label) {
    const bat_repetition *r = &c->choice->repetition;
    const int count = r->count && r->copies && bat_repetition_is_of_selection(c) ? standing(c) : 0;
    if (is_identity(matrix)) return;
    if (count > 0)
        go_on(c, count, matrix);
    else
        begin(c, matrix, box, label, false);
}

void bat_repetition_note_copies(bat_context *c, const double matrix[6], const double box[4]) {
    begin(c, matrix, box, BAT_STRING_STEP_DUPLICATE, true);
}

bool bat_repetition_is_known(const bat_context *c) { return c->choice->repetition.count > 0; }

const double *bat_repetition_matrix(const bat_context *c) {
    const bat_repetition *r = &c->choice->repetition;
    const int count = standing(c);
    return r->moves[(count > 0 ? count : r->count) - 1].matrix;
}

bool bat_repetition_of_copies(const bat_context *c, double matrix[6]) {
    const bat_repetition *r = &c->choice->repetition;
    if (!r->count || !r->copies || !bat_repetition_is_of_selection(c) || standing(c) == 0) return false;
    memcpy(matrix, bat_repetition_matrix(c), 6 * sizeof *matrix);
    return true;
}
