/* Objects as JSON that no reader takes. Included after cmocka.h. */
#ifndef BATTEN_TESTS_REFUSED_H
#define BATTEN_TESTS_REFUSED_H

#include <batten/format.h>
#include <stdio.h>
#include <string.h>

/* A document of the one object: it is said what is wrong with it, and where. */
static inline void object_refused(const char *object) {
    char text[512];
    bat_document *document = NULL;
    bat_problem problem = {"", ""};
    assert_true(snprintf(text, sizeof text, "{\"batten\":1,\"objects\":[%s]}", object) < (int)sizeof text);
    assert_int_not_equal(bat_document_read(text, strlen(text), &document, &problem), BAT_OK);
    assert_null(document);
    assert_true(problem.message[0] && problem.place[0]);
}

#endif
