/*
 * Figures 4 to 8 and Table 1 of the paper that the tangents hand comes from, with Eq. 7 as printed and put right
 * (docs/tangents.md). Checks what it says of them; with a file's name it draws them there, as SVG.
 *
 * Five points, chords 1 : 2.5 : 1, a direction asked for at the third and the fourth. Left, put right: the curve has
 * the directions asked for. Right, Eq. 7 as printed: the table's k, and other directions.
 */
#include <math.h>
#include <stdio.h>
#include <batten/batten.h>

static const double PI = 3.14159265358979323846;

/* As the table prints them: at each of the two points the angle to the incoming chord, to the outgoing one, and k, which is Eq. 7
 * as printed. */
static const struct {
    const char *caption;
    double in[2], out[2], k[2];
} FIGURES[] = {
    {"Fig. 4: horizontal at both", {45, 56.3}, {56.3, 45}, {.40689, .59311}},
    {"Fig. 5: incoming, then outgoing", {1.2, 100}, {100, 1.2}, {.81263, .18737}},
    {"Fig. 6: outgoing, then incoming", {100, 1.4}, {1.4, 100}, {.09059, .90941}},
    {"Fig. 7: incoming at both", {1.2, 1.4}, {100, 99}, {.81263, .90953}},
    {"Fig. 8: outgoing at both", {99, 99}, {1.6, 2.3}, {.09612, .24169}},
};
enum { FIGURE_COUNT = sizeof FIGURES / sizeof *FIGURES, POINTS = 5 };

/* The chord before the point over the one behind it. */
static double ratio(int which) { return which == 0 ? 2.5 : 1 / 2.5; }

/* Eq. 7 with two angles in degrees, the one in the fraction's upper half first. */
static double equation_7(double upper, double lower, int which) {
    return 1 / (1 + sqrt(sin(upper * PI / 180) / sin(lower * PI / 180) * ratio(which)));
}

/* By how many degrees the curve's polygon turns at a point: 101.3 in Fig. 4, elsewhere what the rounded angles add up to. */
static double corner(int figure, int which) { return FIGURES[figure].in[which] + FIGURES[figure].out[which]; }

static double angle(const double *a, const double *b) {
    return fabs(atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]));
}

/* The zigzag: its chords rise and fall so that each of the two corners turns by what the table's angles there add up to, and
 * the first asked direction of Fig. 4 is horizontal. Then the two directions. y grows downwards. */
static void set_up(int figure, double *points, double asked[2][2]) {
    double heading = -FIGURES[0].in[0] * PI / 180, x = 0, y = 0, headings[4];
    for (int i = 0; i < 4; i++) {
        double length = i == 2 ? 2.5 : 1;
        points[2 * i] = x, points[2 * i + 1] = y;
        if (i > 1) heading += (i == 2 ? 1 : -1) * corner(figure, i - 2) * PI / 180;
        headings[i] = i == 0 ? heading - 0.2 : heading;
        x += length * cos(headings[i]), y += length * sin(headings[i]);
    }
    points[8] = x, points[9] = y;
    for (int which = 0; which < 2; which++) {
        double from = headings[1 + which], side = which ? -1 : 1;
        double a = from + side * FIGURES[figure].in[which] * PI / 180;
        asked[which][0] = cos(a), asked[which][1] = sin(a);
    }
}

/* D_R of Eq. 5 at the point, for a k. */
static void built(const double *points, int i, double k, double out[2]) {
    for (int d = 0; d < 2; d++) {
        double c0 = points[2 * i + d] - points[2 * i - 2 + d], c1 = points[2 * i + 2 + d] - points[2 * i + d];
        out[d] = (1 - k) * (1 - k) / k * c0 + k * c1;
    }
}

static void arrow(FILE *file, const double *at, const double *d, const char *colour) {
    double length = 0.42, x = at[0] + length * d[0], y = at[1] + length * d[1];
    fprintf(file, "<path d='M%.4f %.4fL%.4f %.4fM%.4f %.4fL%.4f %.4fL%.4f %.4f' stroke='%s'/>\n", at[0],
            at[1], x, y, x - .13 * d[0] - .06 * d[1], y - .13 * d[1] + .06 * d[0], x, y,
            x - .13 * d[0] + .06 * d[1], y - .13 * d[1] - .06 * d[0], colour);
}

/* One of the ten pictures: the curve between the second and the fifth point with given directions. */
static void draw(FILE *file, double x, double y, const double *points, double asked[2][2],
                 const double *tangents, const bat_joint *joints) {
    bat_spline spline = {2, false, POINTS, points, tangents, NULL};
    bat_tangents_options options = bat_tangents_defaults();
    options.mode = BAT_TANGENTS_FAITHFUL;
    double *bezier = NULL;
    int segments = 0;
    if (!file || bat_tangents(&spline, &options, NULL, &segments, &bezier, NULL) != BAT_OK) return;
    fprintf(file, "<g transform='translate(%g %g) scale(62)' fill='none' stroke-width='.03'>\n<path d='", x,
            y);
    for (int i = 0; i < POINTS; i++)
        fprintf(file, "%c%.4f %.4f", i ? 'L' : 'M', points[2 * i], points[2 * i + 1]);
    fprintf(file, "' stroke='#c3c9d1' stroke-width='.016'/>\n<path d='M%.4f %.4f", bezier[8], bezier[9]);
    for (int i = 1; i < segments; i++) {
        const double *b = bezier + 8 * i;
        fprintf(file, "C%.4f %.4f %.4f %.4f %.4f %.4f", b[2], b[3], b[4], b[5], b[6], b[7]);
    }
    fprintf(file, "' stroke='#1f242b'/>\n");
    for (int which = 0; which < 2; which++) {
        const double *at = points + 2 * (2 + which);
        fprintf(file, "<circle cx='%.4f' cy='%.4f' r='.42' stroke='#8b95a1' stroke-width='.016'/>\n", at[0],
                at[1]);
        arrow(file, at, asked[which], "#7a3fd1");
        fprintf(file,
                "<text x='%.4f' y='%.4f' font-size='.2' fill='#59616c' text-anchor='middle'>k %.5f</text>\n",
                at[0], at[1] + (which ? .72 : -.56), joints[2 + which].k);
    }
    for (int i = 0; i < POINTS; i++)
        fprintf(file, "<circle cx='%.4f' cy='%.4f' r='.05' fill='#1f62d6'/>\n", points[2 * i],
                points[2 * i + 1]);
    fprintf(file, "</g>\n");
    bat_free(bezier);
}

static int check(int figure, FILE *file) {
    double points[2 * POINTS], asked[2][2], right[2 * POINTS] = {0}, wrong[2 * POINTS] = {0}, worst = 0;
    set_up(figure, points, asked);
    for (int which = 0; which < 2; which++) {
        /* The table's k are Eq. 7 with the table's angles, as both are printed. */
        double in = FIGURES[figure].in[which], out = FIGURES[figure].out[which];
        if (fabs(equation_7(in, out, which) - FIGURES[figure].k[which]) > 2e-5) return 1;
        int i = 2 + which;
        for (int d = 0; d < 2; d++) right[2 * i + d] = asked[which][d];
        built(points, i, FIGURES[figure].k[which], wrong + 2 * i);
    }
    bat_joint as_asked[POINTS], as_printed[POINTS];
    bat_spline spline = {2, false, POINTS, points, right, NULL};
    bat_tangents_options options = bat_tangents_defaults();
    options.mode = BAT_TANGENTS_FAITHFUL;
    if (bat_tangents(&spline, &options, as_asked, NULL, NULL, NULL) != BAT_OK) return 2;
    spline.tangents = wrong;
    if (bat_tangents(&spline, &options, as_printed, NULL, NULL, NULL) != BAT_OK) return 3;
    printf("%-32s", FIGURES[figure].caption);
    for (int which = 0; which < 2; which++) {
        int i = 2 + which;
        double off = angle(as_printed[i].right, asked[which]) * 180 / PI;
        /* Put right, the direction is the one asked for, and k is Eq. 7 with its two sines exchanged. */
        if (!(angle(as_asked[i].right, asked[which]) < 1e-9)) return 4;
        if (fabs(as_asked[i].k - equation_7(FIGURES[figure].out[which], FIGURES[figure].in[which], which)) >
            1e-9)
            return 5;
        /* As printed, k is the table's, and the two angles of the curve have changed places (to the degree: the
         * table rounds). */
        if (fabs(as_printed[i].k - FIGURES[figure].k[which]) > 1e-9) return 6;
        if (fabs(as_printed[i].angle_out * 180 / PI - FIGURES[figure].in[which]) > 1) return 7;
        worst = fmax(worst, off);
        printf("  %5.1f, %5.1f: printed %.5f, Eq. 7 %.5f, put right %.5f; off by %4.1f",
               FIGURES[figure].in[which], FIGURES[figure].out[which], FIGURES[figure].k[which],
               equation_7(FIGURES[figure].in[which], FIGURES[figure].out[which], which), as_asked[i].k, off);
    }
    printf(" degrees\n");
    if (figure == 0 ? fabs(worst - 11.3) > 0.1 : worst < 97) return 8;
    double y = 54 + 258 * figure;
    if (file)
        fprintf(file,
                "<text x='372' y='%g' font-size='15' font-weight='600' fill='#1f242b' "
                "text-anchor='middle'>%.6s</text>\n"
                "<text x='372' y='%g' font-size='13' fill='#1f242b' text-anchor='middle'>%s</text>\n",
                y + 118, FIGURES[figure].caption, y + 138, FIGURES[figure].caption + 8);
    draw(file, 40, y + 140, points, asked, right, as_asked);
    draw(file, 470, y + 140, points, asked, wrong, as_printed);
    return 0;
}

int main(int count, char **words) {
    FILE *file = count > 1 ? fopen(words[1], "w") : NULL;
    if (count > 1 && !file) return 20;
    if (file)
        fprintf(file,
                "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 760 1340' font-family='sans-serif'>\n"
                "<rect width='760' height='1340' fill='#fff'/>\n<text x='24' y='28' font-size='14' "
                "fill='#59616c'>"
                "put right</text>\n<text x='470' y='28' font-size='14' fill='#59616c'>Eq. 7 as "
                "printed</text>\n");
    int wrong = 0;
    for (int figure = 0; figure < FIGURE_COUNT && !wrong; figure++) {
        wrong = check(figure, file);
        if (wrong) printf("%s: claim %d does not hold\n", FIGURES[figure].caption, wrong);
    }
    if (file) {
        fprintf(file, "</svg>\n");
        if (fclose(file)) return 21;
    }
    return wrong;
}
