/* A document with a small skeleton that walks. */
#ifndef BATTEN_TESTS_WALKING_H
#define BATTEN_TESTS_WALKING_H

#include <batten/batten.h>
#include "support/walker.h"

/* The motion of walker(seed, frames), fitted within `tolerance` degrees, as the object of that id. */
static bat_document *walking(int seed, size_t frames, double tolerance, bat_id id) {
    const bat_style style = bat_style_defaults();
    bat_take *take = walker(seed, frames);
    bat_motion_options options = bat_motion_defaults();
    bat_motion *motion = NULL;
    bat_object *object = NULL;
    bat_document *document = NULL;
    options.tolerance = tolerance;
    assert_int_equal(bat_motion_fit(take, &options, &motion, NULL), BAT_OK);
    assert_int_equal(bat_object_create_skeleton(id, "walker", &style, motion, NULL, &object), BAT_OK);
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    bat_object_release(object);
    bat_motion_free(motion), bat_take_free(take);
    return document;
}

#endif
