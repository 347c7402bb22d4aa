#include "editor/choice/choice.h"
#include "editor/session/session.h"

void bat_choice_follow(bat_context *c) {
    bat_choice *choice = c->choice;
    const bat_document *document = c->session->document;
    bat_selection_prune(&choice->selection, document);
    if (choice->layer && bat_document_find(document, choice->layer) < 0) choice->layer = 0;
    if (choice->entered && bat_document_find(document, choice->entered) < 0) choice->entered = 0;
}

void bat_choice_free(bat_choice *choice) {
    bat_selection_free(&choice->selection);
    bat_selection_free(&choice->isolation.kept);
    bat_selection_free(&choice->repetition.of);
}

void bat_choice_forget(bat_context *c) {
    bat_selection_clear(&c->choice->selection);
    bat_isolate_end(c);
    c->choice->layer = c->choice->entered = 0;
    c->choice->repetition.count = 0;
    c->choice->writing = (bat_writing){0};
}
