/* batten surface blend and surface match: a surface between two edges, or between an edge and a curve; an edge moved to meet another. */
#include "program.h"
#include "results.h"

#include <batten/sweep.h>

static const char *const CONTINUITY[] = {"G0", "G1", "G2", "G3"};
static const char *const SIDES[] = {"v0", "v1", "u0", "u1", "curve"}; /* as bat_side */
enum { CONTINUITY_COUNT = BAT_CONTINUITY_MAX + 1, SIDE_COUNT = 4, TO_CURVE = 4 };

typedef struct request {
    int side[2];
    bat_blend_options options;
    bat_surface *surface[2];
    bat_curve *curve;
} request;

static int read_request(const cli_arguments *arguments, request *r) {
    int first = 2, second = -1;
    int failed = arguments_choice(arguments, "--from", SIDES, SIDE_COUNT, &r->side[0]);
    if (!failed) failed = arguments_choice(arguments, "--to", SIDES, SIDE_COUNT + 1, &r->side[1]);
    if (!failed) failed = arguments_choice(arguments, "--continuity", CONTINUITY, CONTINUITY_COUNT, &first);
    if (!failed)
        failed = arguments_choice(arguments, "--continuity-to", CONTINUITY, CONTINUITY_COUNT, &second);
    if (!failed) failed = arguments_vector(arguments, "--tension", 2, r->options.tension);
    r->options.continuity[0] = first, r->options.continuity[1] = second < 0 ? first : second;
    for (int k = 0; k < 2 && !failed; k++)
        if (!(r->options.tension[k] >= 1e-3 && r->options.tension[k] <= 1e3))
            failed = fail_usage(arguments->command, "--tension: expected two numbers from 0.001 to 1000");
    return failed;
}

static int blend(const cli_arguments *arguments, const request *r) {
    bat_surface *made = NULL;
    const bat_side from = (bat_side)r->side[0];
    const bat_status status = r->curve
                                  ? bat_surface_blend_curve(r->surface[0], from, r->curve, &r->options, &made)
                                  : bat_surface_blend(r->surface[0], from, r->surface[1],
                                                      (bat_side)r->side[1], &r->options, &made);
    if (status == BAT_MEMORY) return fail_memory();
    if (status == BAT_ARGUMENT)
        return fail_data(arguments->operands[0], NULL,
                         "expected two open edges, or two closed ones, found an open and a closed one, or a "
                         "surface without that edge");
    if (status == BAT_SINGULAR)
        return fail_data(arguments->operands[0], NULL,
                         "expected edges that are apart, and surfaces that go on there, found others");
    if (status != BAT_OK) return fail_data(arguments->operands[0], NULL, "%s", bat_status_message(status));
    const int failed = write_surface(made, NULL);
    bat_surface_free(made);
    return failed;
}

static int fail_match(const cli_arguments *arguments, bat_status status) {
    const char *name = arguments->operands[0];
    if (status == BAT_MEMORY) return fail_memory();
    if (status == BAT_ARGUMENT)
        return fail_data(name, NULL,
                         "expected two open edges, or two closed ones, found an open and a closed one, or a "
                         "surface without that edge");
    if (status == BAT_SINGULAR)
        return fail_data(name, NULL,
                         "expected edges longer than a point, and surfaces that go on there, found others");
    return fail_data(name, NULL, "%s", bat_status_message(status));
}

static int match(const cli_arguments *arguments, const request *r) {
    bat_surface *made = NULL;
    double moved = 0;
    const bat_status status = bat_surface_match(r->surface[0], (bat_side)r->side[0], r->surface[1],
                                                (bat_side)r->side[1], r->options.continuity[0],
                                                r->options.tension[0], &made, &moved);
    if (status != BAT_OK) return fail_match(arguments, status);
    bat_text report = {0};
    bat_text_string(&report, "{\"moved\":");
    bat_text_number(&report, moved);
    bat_text_string(&report, "}");
    const int failed = write_surface(made, &report);
    bat_surface_free(made);
    return failed;
}

static int with_surfaces(const cli_arguments *arguments, request *r,
                         int (*make)(const cli_arguments *arguments, const request *r)) {
    int failed = arguments_one_input(arguments, 2, "the surfaces");
    if (!failed) failed = read_surface(arguments->operands[0], &r->surface[0]);
    if (!failed && r->side[1] == TO_CURVE) failed = read_curve(arguments->operands[1], &r->curve);
    if (!failed && r->side[1] != TO_CURVE) failed = read_surface(arguments->operands[1], &r->surface[1]);
    if (!failed) failed = make(arguments, r);
    bat_surface_free(r->surface[0]), bat_surface_free(r->surface[1]), bat_curve_free(r->curve);
    return failed;
}

static int run(const cli_arguments *arguments) {
    request r = {.side = {BAT_SIDE_U1, BAT_SIDE_U0}, .options = bat_blend_defaults()};
    const int failed = read_request(arguments, &r);
    return failed ? failed : with_surfaces(arguments, &r, blend);
}

static int run_match(const cli_arguments *arguments) {
    request r = {.side = {BAT_SIDE_U1, BAT_SIDE_U0}, .options = bat_blend_defaults()};
    int continuity = 2;
    int failed = arguments_choice(arguments, "--from", SIDES, SIDE_COUNT, &r.side[0]);
    if (!failed) failed = arguments_choice(arguments, "--to", SIDES, SIDE_COUNT, &r.side[1]);
    if (!failed)
        failed = arguments_choice(arguments, "--continuity", CONTINUITY, CONTINUITY_COUNT, &continuity);
    if (!failed) failed = arguments_number(arguments, "--tension", 1e-3, 1e3, &r.options.tension[0]);
    r.options.continuity[0] = continuity;
    return failed ? failed : with_surfaces(arguments, &r, match);
}

const cli_command command_surface_blend = {
    .name = "surface blend",
    .usage = "A B [--from SIDE] [--to SIDE] [--continuity G] [--continuity-to G] [--tension A,B]",
    .summary = "The surface between two edges, as smooth at each as asked.",
    .details =
        "A is a SURFACE, B a SURFACE or, with --to curve, a CURVE, which is met with G0. Every line across "
        "the edge goes on\nwith the continuity. The second edge is turned round where its ends are nearer "
        "so.",
    .example = "batten surface blend hood.json wing.json --from u1 --to u0 --continuity G2 > between.json",
    .operands = 2,
    .options = {{"--from", "u0|u1|v0|v1",
                 "the edge of A that it leaves: the line at the start or the end of u or v; u1"},
                {"--to", "u0|u1|v0|v1|curve", "the edge of B that it arrives at; u0"},
                {"--continuity", "G0|...|G3", "with A, and with B unless told; G2 by default"},
                {"--continuity-to", "G0|...|G3", "with B"},
                {"--tension", "A,B",
                 "factors on the speeds at both edges, which are the straight way's: 1,1"}},
    .run = run,
};

const cli_command command_surface_match = {
    .name = "surface match",
    .usage = "A B [--from SIDE] [--to SIDE] [--continuity G] [--tension A]",
    .summary = "Surface A, with an edge moved to meet an edge of surface B smoothly.",
    .details = "Only the rows of control points beside that edge change, as many as the continuity and one, "
               "after A has "
               "got the\ndegrees and the knots. \"report\": \"moved\", how far they moved at most.",
    .example = "batten surface match wing.json hood.json --from u0 --to u1 --continuity G2",
    .operands = 2,
    .options = {{"--from", "u0|u1|v0|v1",
                 "the edge of A that moves: the line at the start or the end of u or v; u1"},
                {"--to", "u0|u1|v0|v1", "the edge of B that it meets; u0 by default"},
                {"--continuity", "G0|...|G3", "G2 by default"},
                {"--tension", "A", "a factor on the speed across the edge; 1 by default"}},
    .run = run_match,
};
