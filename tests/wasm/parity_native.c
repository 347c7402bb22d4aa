/* Prints the vectors' results: a line a section, its name and the bits of each number in hexadecimal. */
#include "wasm/parity.h"

#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(void) {
    enum { ROOM = 1 << 18 };
    double *values = malloc(ROOM * sizeof *values);
    if (!values) return 1;
    for (int i = 0; i < parity_section_count; i++) {
        parity_sink sink = {values, ROOM, 0};
        parity_sections[i].run(&sink);
        if (sink.count > ROOM) return fprintf(stderr, "%s: no room\n", parity_sections[i].name), 1;
        printf("%s:", parity_sections[i].name);
        for (size_t k = 0; k < sink.count; k++) {
            uint64_t bits;
            memcpy(&bits, values + k, sizeof bits);
            printf(" %" PRIx64, bits);
        }
        printf("\n");
    }
    free(values);
    return 0;
}
