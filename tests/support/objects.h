/* Shared by tests of kinds of objects. Include after cmocka.h. */
#ifndef BATTEN_TESTS_OBJECTS_H
#define BATTEN_TESTS_OBJECTS_H

#include <batten/format.h>
#include <stdio.h>
#include <string.h>

/* A document with one object; takes ownership of it. */
static inline bat_document *of_one(bat_object *object) {
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    bat_object_release(object);
    return document;
}

/* Checks that reading a document of this one object is refused, with a reason and a place. */
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
