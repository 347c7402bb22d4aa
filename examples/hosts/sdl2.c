/* The editor in a window, by SDL 2 and cairo: cc sdl2.c $(pkg-config --cflags --libs batten cairo sdl2) */
#include <SDL.h>
#include <batten/batten.h>

#include "paint.h"

int main(void) {
    bat_editor *editor = NULL;
    if (SDL_Init(SDL_INIT_VIDEO) || bat_editor_create(&editor) != BAT_OK) return 1;
    SDL_Window *window = SDL_CreateWindow("Batten", 0, 0, 900, 600, 0);
    SDL_Surface *w = SDL_GetWindowSurface(window);
    cairo_surface_t *s = cairo_image_surface_create_for_data(w->pixels, CAIRO_FORMAT_RGB24, w->w, w->h,
                                                             w->pitch);
    bat_editor_resize(editor, 900, 600, 1);
    for (SDL_Event e; SDL_WaitEvent(&e) && e.type != SDL_QUIT;) {
        bool moves = e.type == SDL_MOUSEMOTION, down = e.type == SDL_MOUSEBUTTONDOWN;
        bat_pointer p = {.device = BAT_DEVICE_MOUSE, .pressure = 0.5, .time = e.common.timestamp};
        p.x = moves ? e.motion.x : e.button.x, p.y = moves ? e.motion.y : e.button.y;
        p.buttons = down || (moves && e.motion.state & SDL_BUTTON_LMASK);
        p.phase = down ? BAT_POINTER_DOWN : p.buttons ? BAT_POINTER_MOVE : BAT_POINTER_HOVER;
        if (e.type == SDL_MOUSEBUTTONUP) p.phase = BAT_POINTER_UP;
        if (moves || down || e.type == SDL_MOUSEBUTTONUP) bat_editor_pointer(editor, 1, &p);
        if (SDL_PollEvent(NULL)) continue;
        paint(bat_editor_frame(editor), s), cairo_surface_flush(s), SDL_UpdateWindowSurface(window);
    }
    bat_editor_free(editor), SDL_Quit();
}
