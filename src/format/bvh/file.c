/* BVH as a format of drawings: a skeleton that moves. */
#include "document/format.h"
#include "kinds/kinds.h"
#include "text/json.h"
#include <batten/motion.h>

#include <string.h>

static int sniff(const char *text, size_t size) {
    static const char word[] = "HIERARCHY";
    const size_t at = bat_format_start(text, size), length = sizeof word - 1;
    return size - at > length && memcmp(text + at, word, length) == 0 ? 100 : 0;
}

/* The root's name is the drawing's best name for it. */
static bat_status document_of(const bat_take *take, bat_document **out) {
    const bat_style style = bat_style_defaults();
    const bat_motion_options options = {.size = sizeof options, .tolerance = 0, .levels = 3};
    bat_motion *motion = NULL;
    bat_object *object = NULL;
    bat_document *document = NULL;
    bat_status status = bat_motion_fit(take, &options, &motion, NULL);
    if (status == BAT_OK) status = bat_document_create(&document);
    if (status == BAT_OK)
        status = bat_object_create_skeleton(bat_document_new_id(document), "", &style, motion, NULL, &object);
    if (status == BAT_OK) status = bat_document_insert(document, bat_document_count(document), object);
    bat_object_release(object);
    bat_motion_free(motion);
    if (status == BAT_OK)
        *out = document;
    else
        bat_document_free(document);
    return status;
}

static bat_status read(const bat_reading *how, const char *text, size_t size, bat_document **out,
                       bat_svg_report *report, bat_problem *problem) {
    bat_take *take = NULL;
    (void)how, (void)report;
    bat_status status = bat_bvh_read(text, size, &take, problem);
    if (status != BAT_OK) return status;
    status = document_of(take, out);
    bat_take_free(take);
    return status == BAT_OK ? status : bat_problem_set(problem, status, "", bat_status_message(status));
}

/* The one skeleton there is; where it lies in the drawing is not written. */
static bat_status write(const bat_document *document, char **out, size_t *size, bat_problem *problem) {
    const bat_motion *motion = NULL;
    int count = 0;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_motion *found = bat_object_motion(bat_document_at(document, i), NULL);
        if (found) motion = found, count++;
    }
    if (count != 1)
        return bat_problem_set(problem, BAT_COUNT, "",
                               count ? "a .bvh file holds one skeleton, expected 1, found more"
                                     : "a .bvh file holds a skeleton, expected 1, found none");
    bat_take *take = NULL;
    bat_status status = bat_motion_sample(motion, &take);
    if (status == BAT_OK) status = bat_bvh_write(take, out, size);
    bat_take_free(take);
    return status == BAT_OK ? status : bat_problem_set(problem, status, "", bat_status_message(status));
}

const bat_format bat_format_of_bvh = {"bvh", "application/x-bvh", false, sniff, read, write};
