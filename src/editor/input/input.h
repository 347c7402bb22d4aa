/* The present state of the input devices. */
#ifndef BATTEN_EDITOR_INPUT_INPUT_H
#define BATTEN_EDITOR_INPUT_INPUT_H

#include "editor/input/contacts.h"
#include "editor/input/orbit.h"
#include "editor/input/taken.h"
#include "editor/input/taps.h"
#include "editor/input/trail.h"

/* Points that are picked for a plane. */
typedef struct bat_three {
    bool on;
    int count;
    double at[3][3];
} bat_three;

/* A contact that is down and has not said where. */
typedef struct bat_awaited {
    bool on;
    bat_device device;
    uint32_t contact;
} bat_awaited;

typedef struct bat_input {
    bat_contacts contacts;
    bat_awaited awaited;
    bat_fingers fingers;
    bat_orbit orbit;
    bat_taps taps;
    bat_taken taken; /* the stroke under way, or that was taken away */
    bat_trail trail; /* of the pointer that drives the tool */
    bool holding_pan, pen_seen;
    double pan_time;   /* when the key that pans went down; below 0: a pointer was used meanwhile */
    double pen_time;   /* of the last pen event */
    bool pen_hovers;   /* as that event said */
    bool pen_near;     /* a pointer is over the drawing */
    double pen[2];     /* its last position, view pixels */
    bat_device points; /* its kind */
    unsigned brush;    /* trait of the tool for the pen's eraser end or barrel button; 0: neither */
    bool drawing_new;  /* the key that makes every stroke a new curve is held */
    bat_three three;
    bool calming; /* the fairing key is held */
} bat_input;

#endif
