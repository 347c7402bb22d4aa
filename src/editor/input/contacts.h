/* Contacts: what each pointer that is down is doing. */
#ifndef BATTEN_EDITOR_INPUT_CONTACTS_H
#define BATTEN_EDITOR_INPUT_CONTACTS_H

#include "editor/session/context.h"
#include "editor/view/stage.h"
#include <batten/editor.h>

enum { BAT_CONTACTS_MAX = 16 };

typedef enum bat_duty {
    BAT_DUTY_TOOL,     /* drives the tool; at most one */
    BAT_DUTY_NAVIGATE, /* one pans; two pinch */
    BAT_DUTY_ORBIT,    /* turns the view (orbit.h) */
    BAT_DUTY_IGNORED   /* a palm, a second contact, a button without a function */
} bat_duty;

typedef struct bat_contact {
    uint32_t id;
    bat_device device;
    bat_duty duty;
    double at[2], start[2]; /* view pixels */
    double start_time;
    double far; /* the greatest distance from start so far */
} bat_contact;

typedef struct bat_contacts {
    bat_contact list[BAT_CONTACTS_MAX];
    int count;
    double turn; /* degrees that two fingers have turned; the view lags by the detent */
} bat_contacts;

/* What fingers have done and a pen that comes down may revert (fingers.h). */
typedef struct bat_fingers {
    bat_stage rest, moved;  /* the stage before fingers moved it, and as they left it */
    uint64_t before, after; /* history states before and after a finger's last dab; equal: it made no step */
    double time;            /* of that dab, ms */
} bat_fingers;

/* Index of a contact, or -1. */
int bat_contacts_find(const bat_contacts *contacts, bat_device device, uint32_t id);
/* The number of contacts with the duty; *first (may be NULL) is the index of the first. */
int bat_contacts_count(const bat_contacts *contacts, bat_duty duty, int *first);
void bat_contacts_remove(bat_contacts *contacts, int index);
/* Whether a touch is too large for a finger. */
bool bat_contact_is_palm(const bat_pointer *event);
/* Makes room for one more; a finger gives up its place for a pen or a mouse. False: there is no room. */
bool bat_contacts_room(bat_contacts *contacts, bat_device device);
/* Whether a pointer that is not down may hover: the only contacts down are resting fingers, and for a pen also
 * navigating ones. */
bool bat_contacts_clear(const bat_context *c);
/* A second contact navigates from here on: its turning starts from the view's angle. */
void bat_contacts_pinch(bat_context *c);
/* A navigating contact has moved to `to`: it pans, or together with the other one pinches, which zooms and turns.
 * Upright is a detent: the view stays upright while the fingers turn by up to DETENT degrees to either side. */
void bat_contacts_navigate(bat_context *c, int index, const double to[2]);

#endif
