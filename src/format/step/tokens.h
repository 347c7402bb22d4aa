/* The words of a STEP file (ISO 10303-21): comments and white space are skipped. */
#ifndef BATTEN_FORMAT_STEP_TOKENS_H
#define BATTEN_FORMAT_STEP_TOKENS_H

#include <batten/base.h>

typedef enum bat_step_type {
    BAT_STEP_END, /* of the file */
    BAT_STEP_BAD,
    BAT_STEP_MARK,   /* one of ( ) , ; = * $ */
    BAT_STEP_NAME,   /* B_SPLINE_CURVE, ENDSEC, ISO-10303-21 */
    BAT_STEP_OBJECT, /* #12 */
    BAT_STEP_NUMBER,
    BAT_STEP_TEXT, /* 'it''s', with its quotes */
    BAT_STEP_ENUM, /* .T. */
    BAT_STEP_BITS  /* "0F" */
} bat_step_type;

typedef struct bat_step_token {
    bat_step_type type;
    char mark;
    double number; /* also of an object */
    const char *text;
    size_t size;
} bat_step_token;

typedef struct bat_step_place {
    const char *at, *end;
    long line; /* of `at`, from 1 */
} bat_step_place;

bat_step_token bat_step_next(bat_step_place *place);
bool bat_step_is(const bat_step_token *token, const char *name);

#endif
