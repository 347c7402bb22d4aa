/* A drawing as text, read by libbatten-svg. */
#include <stdio.h>
#include <string.h>
#include <batten/svg_read.h>

int main(void) {
    static const char text[] = "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0L2 4'/></svg>";
    bat_document *drawing = NULL;
    bat_problem problem;
    if (bat_svg_read(text, strlen(text), NULL, &drawing, NULL, &problem) != BAT_OK) {
        fprintf(stderr, "%s: %s\n", problem.place, problem.message);
        return 1;
    }
    int count = bat_document_count(drawing);
    bat_document_free(drawing);
    return count == 1 ? 0 : 1;
}
