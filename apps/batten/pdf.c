#include "pdf.h"

#include "io.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

/* The header may stand anywhere in the first 1,024 bytes. */
bool pdf_is_one(const char *data, size_t size) {
    enum { HEAD = 1024 };
    static const char mark[] = "%PDF-";
    const size_t end = size < HEAD ? size : HEAD;
    for (size_t i = 0; i + sizeof mark - 1 <= end; i++)
        if (memcmp(data + i, mark, sizeof mark - 1) == 0) return true;
    return false;
}

bool pdf_is_postscript(const char *data, size_t size) {
    static const char mark[] = "%!PS", preview[] = "\xc5\xd0\xd3\xc6";
    return size >= 4 && (memcmp(data, mark, 4) == 0 || memcmp(data, preview, 4) == 0);
}

/* Starts it with the file `in` as its input and the pipe's end `out` as its output. */
static int start(int in, int out, pid_t *child) {
    /* or else a page whose size is no whole number of points is shrunk to one that is, and moved into its middle */
    static char *const words[] = {"pdftocairo", "-svg", "-noshrink", "-nocenter", "-f", "1",
                                  "-l",         "1",    "-",         "-",         NULL};
    posix_spawn_file_actions_t actions;
    int failed = posix_spawn_file_actions_init(&actions);
    if (failed) return failed;
    failed = posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
    if (!failed) failed = posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
    if (!failed) failed = posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    if (!failed) failed = posix_spawnp(child, words[0], &actions, NULL, words, environ);
    posix_spawn_file_actions_destroy(&actions);
    return failed;
}

/* Whether the program ended well. */
static bool ended(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return false;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

static const char *run(int in, char **svg, size_t *size) {
    int ends[2];
    pid_t child = 0;
    if (pipe(ends) != 0) return strerror(errno);
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    const int failed = start(in, ends[1], &child);
    close(ends[1]);
    if (failed) {
        close(ends[0]);
        return failed == ENOENT
                   ? "to read a PDF, pdftocairo is needed (package poppler-utils), which is not installed"
                   : strerror(failed);
    }
    const bool whole = io_drain(ends[0], svg, size);
    close(ends[0]); /* a program that still writes ends */
    const bool good = ended(child);
    if (whole && good && *size > 0) return NULL;
    if (whole) free(*svg);
    return whole ? "expected a PDF that pdftocairo can read, found none" : "the first page is too large";
}

const char *pdf_first_page(const char *data, size_t size, char **svg, size_t *svg_size) {
    FILE *file = tmpfile();
    const char *wrong = NULL;
    if (!file) return strerror(errno);
    if (fwrite(data, 1, size, file) != size || fflush(file) != 0 || fseek(file, 0, SEEK_SET) != 0)
        wrong = strerror(errno);
    if (!wrong) wrong = run(fileno(file), svg, svg_size);
    fclose(file);
    return wrong;
}
