/* Messages about a stroke that is done, or that failed. */
#include "editor/edit/making.h"
#include "editor/session/notice.h"
#include "editor/tables/tables.h"
#include "editor/tools/sketch/parts.h"
#include <batten/levels.h>
#include <stdio.h>

bat_string bat_sketching_outcome(const bat_edit *edit, bool strayed, bool closed) {
    if (strayed) return BAT_STRING_NOTICE_STRAYED;
    if (edit->kind == BAT_EDIT_JOIN) return BAT_STRING_NOTICE_JOINED;
    if ((edit->kind == BAT_EDIT_NEW || edit->kind == BAT_EDIT_CLOSE) && closed)
        return BAT_STRING_NOTICE_CLOSED;
    return BAT_STRING_COUNT;
}

/* A level whose spans are long compared to the stroke cannot follow it. */
static bool too_short(const bat_edit *edit, const bat_sketch_report *report) {
    return edit->kind == BAT_EDIT_LEVEL && report->spans > 0 && report->spans < BAT_LEVEL_SPANS_LEAST &&
           report->max_error > edit->options.tolerance;
}

void bat_sketching_say_done(bat_context *c, const bat_edit *edit, const bat_sketch_report *report,
                            bool strayed, bool closed) {
    if (!too_short(edit, report)) {
        const bat_string outcome = bat_sketching_outcome(edit, strayed, closed);
        if (edit->kind == BAT_EDIT_NEW && outcome == BAT_STRING_COUNT && bat_making_offers_revolving(c))
            bat_notice_revolves(c);
        else
            bat_notice(c, outcome);
        return;
    }
    char number[32];
    snprintf(number, sizeof number, "%.3g", report->max_error / edit->options.pixel);
    bat_notice_value(c, BAT_STRING_NOTICE_SHORT, number);
}

void bat_sketching_say_failed(bat_context *c, const bat_sketching *s, bat_status status) {
    if (status == BAT_DOT)
        bat_notice(c, BAT_STRING_NOTICE_DOT);
    else if (status == BAT_STATE && s->nothing)
        bat_notice(c, BAT_STRING_NOTICE_NOTHING_TO_REDRAW);
    else if (status == BAT_STATE && s->edit.kind == BAT_EDIT_LEVEL)
        bat_notice(c, BAT_STRING_NOTICE_MUTED);
    else
        bat_notice_failure(c, status);
}

void bat_sketching_say_dropped(bat_context *c, const bat_sketching *s, bool refused, bool left) {
    char number[32];
    snprintf(number, sizeof number, "%zu", s->dropped);
    if (refused)
        bat_notice_value(c, BAT_STRING_NOTICE_LANDED_NOT, number);
    else if (s->dropped)
        bat_notice_value(c, BAT_STRING_NOTICE_NOT_LANDED, number);
    else if (left)
        bat_notice(c, BAT_STRING_NOTICE_BESIDE);
}
