/* A straight line as a curve: its middle is where it must be. */
#include <stdio.h>
#include <string.h>
#include <batten/batten.h>

int main(void) {
    const double knots[] = {0, 0, 1, 1}, points[] = {0, 0, 2, 4};
    bat_curve *line = NULL;
    bat_status status = bat_curve_create(2, 1, false, 2, points, 4, knots, &line);
    if (status != BAT_OK) {
        fprintf(stderr, "%s\n", bat_status_message(status));
        return 1;
    }
    double middle[2];
    bat_curve_eval(line, 0.5, 0, middle);
    bat_curve_free(line);
    printf("%s %g %g\n", bat_version(), middle[0], middle[1]);
    return strcmp(bat_version(), BAT_VERSION) == 0 && middle[0] == 1 && middle[1] == 2 ? 0 : 1;
}
