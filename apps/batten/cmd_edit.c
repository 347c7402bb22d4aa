/* batten edit: runs the editor in the browser, on one file. */
#include "gzip.h"
#include "drawing.h"
#include "io.h"
#include "program.h"
#include "replace.h"
#include "serve.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* Below the ports that systems assign, and without any that browsers block. */
enum { OWN_PORTS = 20000, OWN_PORTS_COUNT = 10000 };

/* Runs the browser in a separate process that need not be waited for. Its output is discarded. */
static void open_browser(const char *address, const sigset_t *signals) {
    pid_t child = fork();
    if (child == 0) {
        sigprocmask(SIG_UNBLOCK, signals, NULL);
        signal(SIGPIPE, SIG_DFL);
        signal(SIGXFSZ, SIG_DFL);
        if (fork() == 0) {
            int nowhere = open("/dev/null", O_RDWR);
            for (int i = 0; i < 3 && nowhere >= 0; i++) dup2(nowhere, i);
            execlp("xdg-open", "xdg-open", address, (char *)NULL);
        }
        _exit(0);
    }
    if (child > 0) waitpid(child, NULL, 0);
}

static bool has_display(void) {
    const char *x = getenv("DISPLAY"), *wayland = getenv("WAYLAND_DISPLAY");
    return (x && *x) || (wayland && *wayland);
}

/* Checks that the file can be read in its format, or can be created. Says what the user should know before
 * drawing. */
static int look_at(const char *path, const bat_format *format) {
    char *text;
    size_t size;
    io_stamp stamp;
    io_result loaded = io_load(path, &text, &size, &stamp);
    if (loaded != IO_DONE) return fail_data(path, NULL, "cannot be read: %s", io_message(loaded));
    if (!stamp.exists) {
        char folder[4096];
        const char *slash = strrchr(path, '/');
        snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - path) + 1 : 1, slash ? path : ".");
        if (access(folder, W_OK | X_OK) != 0)
            return fail_data(path, NULL, "cannot be made: %s", strerror(errno));
        remark("%s: not there yet; the first save makes it", path);
        return EXIT_DONE;
    }
    const char *wrong = gzip_open(&text, &size);
    if (wrong) return fail_data(path, NULL, "%s", wrong);
    drawing_file drawing;
    bat_problem problem;
    bat_status status = drawing_parse(text, size, format, NULL, &drawing, &problem);
    free(text);
    if (status != BAT_OK) return fail_problem(path, status, &problem);
    if (drawing_keeps_file(&drawing))
        drawing_remark_kept(path, &drawing);
    else
        drawing_remark_lost(path, &drawing);
    drawing_free(&drawing);
    if (io_read_only(path))
        remark("%s: is read-only; it cannot be saved here, download a copy instead", path);
    return EXIT_DONE;
}

/* Removes what a killed server has left beside the file. */
static void tidy_up(const char *path) {
    io_place place;
    if (!io_place_open(&place, path)) return;
    if (io_place_try_lock(&place)) io_remove_leftovers(&place);
    io_place_close(&place);
}

/* A port for the file that is the same at every start: the browser stores what belongs to a drawing by its
 * address. Computed from the file's name and its folder's inode, so it does not depend on how the path is
 * written. */
static int own_port(const char *path) {
    char folder[4096];
    const char *slash = strrchr(path, '/');
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - path) + 1 : 1, slash ? path : ".");
    struct stat about = {0};
    stat(folder, &about);
    uint64_t hash = 14695981039346656037u; /* FNV-1a */
    for (int i = 0; i < 64; i += 8) hash = (hash ^ ((uint64_t)about.st_ino >> i & 255)) * 1099511628211u;
    for (const char *c = slash ? slash + 1 : path; *c; c++) {
        hash = (hash ^ (unsigned char)*c) * 1099511628211u;
    }
    return OWN_PORTS + (int)(hash % OWN_PORTS_COUNT);
}

/* port < 0: none was asked for. */
static int serve(const cli_arguments *arguments, const serve_file *file, int port) {
    const char *path = file->path;
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    sigaddset(&signals, SIGHUP);
    sigprocmask(SIG_BLOCK, &signals, NULL); /* before other threads start: only this one receives them */
    http_server *server;
    const char *wrong = serve_start(file, port < 0 ? own_port(path) : port, port > 0, &server);
    if (wrong && port < 0) wrong = serve_start(file, 0, false, &server);
    if (wrong) return fail_data(path, NULL, "cannot be served on port %d: %s", port < 0 ? 0 : port, wrong);
    char address[64];
    snprintf(address, sizeof address, "http://127.0.0.1:%d/", serve_port(server));
    bool opens = !arguments_value(arguments, "--no-open") && has_display();
    int failed = EXIT_DONE;
    if ((printf("%s\n", address) < 0 || fflush(stdout) != 0) && !opens) { /* nobody would learn the address */
        failed = fail_output("standard output");
    } else {
        clearerr(stdout);
        if (opens) open_browser(address, &signals);
        int signal_number;
        sigwait(&signals, &signal_number);
    }
    serve_stop(server);
    return failed;
}

/* The name of the drawing that is made of the file: NAME.batten beside it. */
static char *name_beside(const char *path) {
    const char *slash = strrchr(path, '/'), *dot = strrchr(slash ? slash : path, '.');
    const size_t stem = dot && dot > (slash ? slash + 1 : path) ? (size_t)(dot - path) : strlen(path);
    char *name = malloc(stem + sizeof ".batten");
    if (!name) return NULL;
    memcpy(name, path, stem);
    memcpy(name + stem, ".batten", sizeof ".batten");
    return name;
}

/* What a file of another format holds, as a drawing beside it. *text is to be freed with bat_free. */
static int begin_beside(const char *path, char **name, char **text, serve_file *file) {
    drawing_file drawing;
    struct stat there;
    *name = name_beside(path);
    if (!*name) return fail_memory();
    if (lstat(*name, &there) == 0)
        return fail_data(path, NULL, "the drawing of it, %s, is there already; edit that", *name);
    int failed = drawing_read(path, NULL, &drawing);
    if (failed) return failed;
    drawing_remark(path, &drawing);
    *file = (serve_file){.path = *name, .format = bat_format_named("batten")};
    failed = drawing_print(drawing.document, file->format, path, text, &file->start.size);
    drawing_free(&drawing);
    if (failed) return failed;
    file->start.text = *text;
    remark("%s: stays as it is; it is saved as %s", path, *name);
    return EXIT_DONE;
}

static int edit(const cli_arguments *arguments, const serve_file *file, int port) {
    io_remark_copy(file->path);
    const int failed = look_at(file->path, file->format);
    if (failed) return failed;
    remarks_show();
    tidy_up(file->path);
    return serve(arguments, file, port);
}

static int run(const cli_arguments *arguments) {
    const char *path = arguments->operands[0];
    serve_file file = {.path = path, .format = drawing_format(path)};
    long port = -1;
    int failed = arguments_integer(arguments, "--port", 0, 65535, &port);
    if (failed) return failed;
    const bool keeps = file.format && file.format->keeps;
    if (!keeps && access(path, F_OK) != 0) {
        char words[BAT_FORMATS_WORDS];
        bat_formats_words(".", true, words);
        return fail_usage(arguments->command, "%s: expected a file that is there, or a name that ends in %s",
                          path, words);
    }
    if (!serve_has_shell())
        return fail_data(path, NULL, "cannot be edited: this build has no editor (web/index.html)");
    if (!serve_has_module()) {
        return fail_data(
            path, NULL,
            "cannot be edited: this build has no batten.wasm (it needs clang 16, lld, wasi-libc)");
    }
    char *name = NULL, *text = NULL;
    if (!keeps) failed = begin_beside(path, &name, &text, &file);
    if (!failed) failed = edit(arguments, &file, (int)port);
    bat_free(text);
    free(name);
    return failed;
}

const cli_command command_edit = {
    .name = "edit",
    .usage = "FILE [--port N] [--no-open]",
    .summary = "Opens the editor in the browser on a drawing, or on any file that convert reads.",
    .details =
        "A server for this machine alone gives the editor and takes the drawing back when it is saved; "
        "Ctrl+C\n"
        "ends it. Its address is printed; with a display the browser opens it. A file that is not there is "
        "made\n"
        "by the first save. What is in a file that is no .svg, .svgz or .batten, such as a BVH, is saved "
        "beside it, as\n"
        "NAME.batten. Before a save that would lose something of an SVG, the editor asks.",
    .example = "batten edit car.svg",
    .operands = 1,
    .options = {{"--port", "N", "the port on 127.0.0.1, else the file's own; 0: any free one"},
                {"--no-open", NULL, "only print the address, do not open the browser"}},
    .run = run,
};
