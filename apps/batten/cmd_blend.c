/* batten blend, match. */
#include "curves.h"

#include <batten/blend.h>

#include <math.h>

static const char *const CONTINUITY[] = {"G0", "G1", "G2", "G3"}, *const ENDS[] = {"start", "end"};
enum { ENDS_COUNT = 2, CONTINUITY_COUNT = BAT_CONTINUITY_MAX + 1 };

/* What both commands are told: ends 0 or 1 of both curves. */
typedef struct joint {
    int ends[2], continuity;
} joint;

static int read_joint(const cli_arguments *arguments, joint *out) {
    *out = (joint){{1, 0}, 2};
    int failed = arguments_choice(arguments, "--from", ENDS, ENDS_COUNT, &out->ends[0]);
    if (!failed) failed = arguments_choice(arguments, "--to", ENDS, ENDS_COUNT, &out->ends[1]);
    if (!failed)
        failed = arguments_choice(arguments, "--continuity", CONTINUITY, CONTINUITY_COUNT, &out->continuity);
    return failed;
}

static int fail_joint(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b,
                      bat_status status) {
    for (int i = 0; i < 2; i++)
        if (bat_curve_is_closed(i ? b : a))
            return fail_data(arguments->operands[i], "closed", "expected an open curve, found a closed one");
    if (status == BAT_SINGULAR)
        return fail_data(arguments->operands[0], NULL,
                         "expected ends that are apart and have a tangent and a curvature, found others");
    return fail_curve(arguments, status);
}

static void put_finite(bat_text *text, double x) {
    if (isfinite(x))
        bat_text_number(text, x);
    else
        bat_text_string(text, "null");
}

static void put_jump(bat_text *text, const char *name, const bat_curve *a, bool a_end, const bat_curve *b,
                     bool b_end) {
    double jump[BAT_CONTINUITY_MAX + 1];
    bat_curve_jump(a, a_end, b, b_end, jump);
    bat_text_string(text, name);
    for (int k = 0; k < CONTINUITY_COUNT; k++) {
        bat_text_string(text, k ? "," : "[");
        put_finite(text, jump[k]);
    }
    bat_text_string(text, "]");
}

static int blend(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    joint at;
    bat_blend_options options = bat_blend_defaults();
    int second = -1, failed = read_joint(arguments, &at);
    if (!failed)
        failed = arguments_choice(arguments, "--continuity-to", CONTINUITY, CONTINUITY_COUNT, &second);
    if (!failed) failed = arguments_vector(arguments, "--tension", 2, options.tension);
    if (failed) return failed;
    options.continuity[0] = at.continuity;
    options.continuity[1] = second < 0 ? at.continuity : second;
    bat_curve *made = NULL;
    double variation;
    const bat_status status = bat_curve_blend(a, at.ends[0], b, at.ends[1], &options, &made, &variation);
    if (status == BAT_ARGUMENT && !bat_curve_is_closed(a) && !bat_curve_is_closed(b))
        return fail_usage(arguments->command, "--tension: expected two numbers from 0.001 to 1000");
    if (status != BAT_OK) return fail_joint(arguments, a, b, status);
    bat_text report = {0};
    bat_text_string(&report, "{\"variation\":");
    put_finite(&report, variation);
    put_jump(&report, ",\"jump_from\":", a, at.ends[0], made, false);
    put_jump(&report, ",\"jump_to\":", made, true, b, at.ends[1]);
    bat_text_string(&report, "}");
    failed = write_curve_reported(made, &report);
    bat_curve_free(made);
    return failed;
}

static int match(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    joint at;
    double tension = 1, moved;
    int failed = read_joint(arguments, &at);
    if (!failed) failed = arguments_number(arguments, "--tension", 1e-3, 1e3, &tension);
    if (failed) return failed;
    bat_curve *made = NULL;
    const bat_status status = bat_curve_match(a, at.ends[0], b, at.ends[1], at.continuity, tension, &made,
                                              &moved);
    if (status != BAT_OK) return fail_joint(arguments, a, b, status);
    bat_text report = {0};
    bat_text_string(&report, "{\"moved\":");
    bat_text_number(&report, moved);
    put_jump(&report, ",\"jump\":", made, at.ends[0], b, at.ends[1]);
    bat_text_string(&report, "}");
    failed = write_curve_reported(made, &report);
    bat_curve_free(made);
    return failed;
}

static int run_blend(const cli_arguments *arguments) { return with_curves(arguments, blend); }
static int run_match(const cli_arguments *arguments) { return with_curves(arguments, match); }

const cli_command command_blend = {
    .name = "blend",
    .usage = "CURVE CURVE [--continuity G] [--continuity-to G] [--from END] [--to END] [--tension A,B]",
    .summary = "A curve between the ends of two, with the least variation of curvature.",
    .details =
        "It leaves the end of the first and arrives at the start of the second. \"report\": \"variation\", "
        "and how far\nboth joints are from G0 to G3: \"jump_from\", \"jump_to\" (distance, radians, 1/unit, "
        "1/unit^2).",
    .example = "batten blend first.json second.json --continuity G3 > between.json",
    .operands = 2,
    .options = {{"--continuity", "G0|...|G3",
                 "with the first curve, and with the second unless told; G2 by default"},
                {"--continuity-to", "G0|...|G3", "with the second curve"},
                {"--from", "start|end", "which end of the first it leaves; end by default"},
                {"--to", "start|end", "which end of the second it arrives at; start by default"},
                {"--tension", "A,B",
                 "factors on the speeds at both ends, which are the best by themselves: 1,1"}},
    .run = run_blend,
};

const cli_command command_match = {
    .name = "match",
    .usage = "CURVE CURVE [--continuity G] [--from END] [--to END] [--tension A]",
    .summary = "The first curve, with an end moved to meet an end of the second smoothly.",
    .details = "Only the control points at that end change, as many as the continuity and one. \"report\": "
               "\"moved\", "
               "how far\nthey moved at most, and \"jump\", how far the joint is from G0 to G3.",
    .example = "batten match first.json second.json --continuity G2",
    .operands = 2,
    .options = {{"--continuity", "G0|...|G3", "G2 by default"},
                {"--from", "start|end", "which end of the first moves; end by default"},
                {"--to", "start|end", "which end of the second it meets; start by default"},
                {"--tension", "A",
                 "a factor on the length of the handle at the end that moves; 1 by default"}},
    .puts_back = true,
    .run = run_match,
};
