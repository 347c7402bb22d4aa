/* What every DXF file of release 2007 has around its entities. */
#ifndef BATTEN_FORMAT_DXF_FRAME_H
#define BATTEN_FORMAT_DXF_FRAME_H

#include "text/text.h"

/* Objects are numbered by handles, which are written in hexadecimal; those below BAT_DXF_FIRST are the frame's own. */
enum { BAT_DXF_MODEL = 0x1F, BAT_DXF_LAYERS = 0x2, BAT_DXF_FIRST = 0x100 };

void bat_dxf_text(bat_text *to, int code, const char *value);
void bat_dxf_integer(bat_text *to, int code, int value);
void bat_dxf_real(bat_text *to, int code, double value);
void bat_dxf_handle(bat_text *to, int code, unsigned handle);
/* Up to the table of layers, which the caller fills in with `layers` records. after: a handle above all others. */
void bat_dxf_open(bat_text *to, unsigned after, int layers);
void bat_dxf_entities(bat_text *to); /* ends the table of layers; entities follow */
void bat_dxf_close(bat_text *to);

#endif
