#include "editor/choice/choice.h"
#include "editor/session/notice.h"

bool bat_isolate_end(bat_context *c) {
    bat_isolation *isolation = &c->choice->isolation;
    if (!isolation->on) return false;
    isolation->on = false;
    bat_selection_clear(&isolation->kept);
    bat_notice(c, BAT_STRING_NOTICE_NOT_ISOLATED);
    return true;
}
