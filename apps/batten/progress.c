#include "progress.h"

#include <errno.h>
#include <signal.h>
#include <stdbool.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

/* Written by the signal handler; the only such state in the program. */
static const char *volatile working;
static volatile sig_atomic_t seconds;

static void put(const char *text) {
    ssize_t ignored = write(STDERR_FILENO, text, strlen(text));
    (void)ignored;
}

/* A signal handler: calls only what is allowed in one. */
static void on_second(int number) {
    (void)number;
    int reason = errno;
    char digits[12], *at = digits + sizeof digits - 1;
    *at = '\0';
    seconds = seconds + 1;
    for (int left = (int)seconds; left > 0; left /= 10) *--at = (char)('0' + left % 10);
    put("\rbatten ");
    put(working);
    put(": ");
    put(at);
    put(" s");
    errno = reason;
}

static void set_timer(int interval) {
    struct itimerval timer = {.it_interval = {.tv_sec = interval}, .it_value = {.tv_sec = interval}};
    setitimer(ITIMER_REAL, &timer, NULL);
}

void progress_begin(const char *name) {
    if (!isatty(STDERR_FILENO)) return;
    struct sigaction action = {.sa_handler = on_second, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    if (sigaction(SIGALRM, &action, NULL) != 0) return;
    working = name;
    set_timer(1);
}

void progress_end(void) {
    if (!working) return;
    set_timer(0);
    if (seconds > 0) put("\r\033[K");
    working = NULL;
    seconds = 0;
}
