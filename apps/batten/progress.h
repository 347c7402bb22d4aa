/* Shows on a terminal that long work is in progress: the seconds so far, in one line that is cleared at the
 * end. */
#ifndef BATTEN_APPS_PROGRESS_H
#define BATTEN_APPS_PROGRESS_H

/* Shows progress from the first second on, when standard error is a terminal. name: the command's, static
 * storage. */
void progress_begin(const char *name);
/* Must be called before anything else is printed. Harmless when nothing was begun. */
void progress_end(void);

#endif
