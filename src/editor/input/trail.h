/* The pen's recent trail: predictions may run ahead of the pen by as much as it has travelled in the last
 * BAT_TRAIL_TIME ms. */
#ifndef BATTEN_EDITOR_INPUT_TRAIL_H
#define BATTEN_EDITOR_INPUT_TRAIL_H

enum { BAT_TRAIL_MAX = 64, BAT_TRAIL_TIME = 30 }; /* samples; ms */

typedef struct bat_trail {
    double at[BAT_TRAIL_MAX][2], time[BAT_TRAIL_MAX]; /* view pixels, ms; a ring */
    int count;                                        /* samples so far; only the last ones are stored */
} bat_trail;

/* All zero is an empty trail. */
void bat_trail_add(bat_trail *trail, const double at[2], double time);
/* Pulls a prediction back towards the last sample; an empty trail leaves it unchanged. */
void bat_trail_bound(const bat_trail *trail, double guess[2]);

#endif
