/* The native twin of units.wasm. units run PROGRAM, or units read READER FILE...: what the program prints, then for the
 * program or for each file an empty line, the line "witness" and the witness's lines. */
#include "wasm/units.h"
#include "wasm/witness.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

_Noreturn void unit_stop(const char *why) {
    fprintf(stderr, "%s\n", why);
    exit(1);
}

static void read_file(const char *reader, const char *path) {
    enum { ROOM = 1 << 24 };
    static uint8_t bytes[ROOM];
    FILE *file = fopen(path, "rb");
    if (!file) unit_stop(path);
    size_t size = fread(bytes, 1, ROOM - 1, file);
    fclose(file);
    bytes[size] = 0;
    if (!unit_read(reader, bytes, size)) unit_stop(reader);
}

int main(int count, char **words) {
    if (count < 3) return 2;
    const bool run = strcmp(words[1], "run") == 0;
    if (run && unit_run(words[2], 0) != 0) unit_stop(words[2]);
    for (int i = run ? 2 : 3; i < count; i++) {
        if (!run) read_file(words[2], words[i]);
        printf("\nwitness\n%s", witness_take());
    }
    return 0;
}
