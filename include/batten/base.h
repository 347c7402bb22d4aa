/*
 * Batten: status codes, limits and the export macro that every public header shares.
 *
 * Threads: distinct objects can be used on distinct threads freely, and so can copies, whatever they share. Calls
 * that take an object as const can run at the same time on the same object; any other call needs exclusive access to
 * it. There are no mutable globals.
 */
#ifndef BATTEN_BASE_H
#define BATTEN_BASE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(_WIN32) && defined(BATTEN_DLL) /* dllexport: being built as a DLL; dllimport: used as one */
#define BAT_API __declspec(BATTEN_DLL)
#elif defined(__GNUC__) && !defined(_WIN32)
#define BAT_API __attribute__((visibility("default")))
#else
#define BAT_API
#endif

#define BAT_VERSION "0.2.0"

enum {
    BAT_DEGREE_MAX = 7,      /* degrees run from 1 to 7 */
    BAT_DIMENSION_MAX = 3,   /* points have 2 or 3 coordinates */
    BAT_POINTS_MAX = 1 << 24 /* control points of one curve, samples of one stroke */
};

/*
 * A function that can fail returns a bat_status and leaves its outputs untouched unless it returns BAT_OK
 * (BAT_TOLERANCE is the one exception: the best result found is handed over with it). Every such call can return
 * BAT_MEMORY, and BAT_ARGUMENT if a pointer is NULL that must not be; the comments name the other statuses. Functions
 * that return something else accept NULL only where the comment says so. The numbers are never reused.
 */
typedef enum bat_status {
    BAT_OK = 0,
    BAT_MEMORY = 1,       /* an allocation failed; nothing changed */
    BAT_ARGUMENT = 2,     /* an argument is null or out of its stated range */
    BAT_NUMBER = 3,       /* a number is NaN or infinite, or so large that arithmetic overflows */
    BAT_KNOTS = 4,        /* knots decrease, repeat too often, or leave no domain */
    BAT_COUNT = 5,        /* too few or too many points */
    BAT_DEGREE = 6,       /* degree outside 1..7 */
    BAT_DIMENSION = 7,    /* dimension other than 2 or 3, or two curves that differ in it */
    BAT_PARAMETER = 8,    /* a parameter lies outside the domain, or parameters are not sorted */
    BAT_TOLERANCE = 9,    /* the tolerance could not be met; the best result is handed over */
    BAT_DOT = 10,         /* a stroke too short to mean anything */
    BAT_FAR = 11,         /* a stroke too far from the curve to be meant for it */
    BAT_SYNTAX = 12,      /* text that does not parse */
    BAT_SINGULAR = 13,    /* a system of equations has no unique solution */
    BAT_UNSUPPORTED = 14, /* well-formed, but a kind or version that is not known */
    BAT_STATE = 15        /* a call out of order (no stroke begun, nothing to undo) */
} bat_status;

/*
 * Counts of points and samples are size_t, and more than BAT_POINTS_MAX points in a curve, a spline or a stroke give
 * BAT_COUNT; degrees, dimensions, knots, segments, levels, indices, and counts of objects and of an object's curves
 * are int. Arguments come in one order everywhere: what the call is about, dimension, degree and closedness, how
 * many, the data, options, results. Files, other text of any length, and bytes are a pointer and their size; names,
 * keys and numbers as text end with a zero.
 */

/*
 * A call that takes ownership of an object takes it whatever status it returns: after a failure the object is gone,
 * and the caller frees nothing. In the same way bat_x_live_commit ends a session and bat_svg_reader_finish a reader
 * whatever they return. All other calls borrow for the duration of the call, copy, or retain what is
 * reference-counted (bat_document_insert). The result of a create, a copy or a read is the caller's to free.
 *
 * Options begin with the size of their struct, which bat_x_defaults sets (bat_x_options_init where inline functions
 * cannot be called). So a program goes on working when a later version of the library adds members at the end: those
 * that the program does not know of keep their defaults. A size below that of version 0.2 gives BAT_ARGUMENT.
 * Wherever a call takes options, NULL means the defaults. All other structs (data such as bat_stroke and bat_style,
 * results such as bat_sketch_report) stay as they are for as long as the shared library keeps its SONAME.
 */

/* One short English line, without a full stop; never NULL, static storage. */
BAT_API const char *bat_status_message(bat_status status);

/* The library's version, "major.minor.patch"; static storage. */
BAT_API const char *bat_version(void);

/* What was wrong with what was read: the place ("line 3, column 14" or "curves[2].knots[7]"), and what was
 * expected and what was found there. */
typedef struct bat_problem {
    char place[96];
    char message[160];
} bat_problem;

#ifdef __cplusplus
}
#endif
#endif
