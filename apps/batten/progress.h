/* Long work shows on a terminal that it goes on: the seconds so far, one line that is cleared at the end. */
#ifndef BATTEN_APPS_PROGRESS_H
#define BATTEN_APPS_PROGRESS_H

/* From the first second on, when standard error is a terminal. name: the command's, static storage. */
void progress_begin(const char *name);
/* Before anything else is printed. Harmless when nothing was begun. */
void progress_end(void);

#endif
