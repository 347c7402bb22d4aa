/* The way that the pen has gone just now: as far as it went in BAT_TRAIL_TIME, guesses may run ahead of it. */
#ifndef BATTEN_EDITOR_INPUT_TRAIL_H
#define BATTEN_EDITOR_INPUT_TRAIL_H

enum { BAT_TRAIL_MAX = 64, BAT_TRAIL_TIME = 30 }; /* samples; ms */

typedef struct bat_trail {
    double at[BAT_TRAIL_MAX][2], time[BAT_TRAIL_MAX]; /* view pixels, ms; a ring */
    int count;                                        /* samples so far; only the last ones are there */
} bat_trail;

/* All zero is an empty trail. */
void bat_trail_add(bat_trail *trail, const double at[2], double time);
/* Draws a guess back towards the last sample; an empty trail leaves it alone. */
void bat_trail_bound(const bat_trail *trail, double guess[2]);

#endif
