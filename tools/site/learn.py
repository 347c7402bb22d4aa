"""The pages of Learn (docs/learn): the session of each, which opens in the editor, and what its film shows."""
import html
import json

import sessions

# Where the session of each comes from, or the tool whose session it is; how it is seen; what its film shows.
PAGES = {
    "draw": ("docs/pictures/car.journal", None, "The roof and the hood of a car are drawn over, and follow the pen."),
    "levels": ("examples/demos/crocodile.journal", None, "The back of a crocodile is bent, and its scales come along."),
    "tangents": (None, None, "Four points are placed, each with its direction, and a curve goes through them."),
    "surfaces": ("examples/space/turned.journal", "examples/space/turned-view.json", "A jug is made from its profile, and follows when the profile changes."),
    "camera": ("examples/demos/flight.journal", "camera", "A flight round a car, as the camera sees it."),
}


def journals(program, root):
    """The lines of each session, and how it is seen (films.make)."""
    made = sessions.sessions(program, root)
    return {name: (sessions.lines_of(root / path) if path else made[name][0],
                   json.loads((root / view).read_text(encoding="utf-8")) if view and view != "camera" else view)
            for name, (path, view, _) in PAGES.items()}


def head(name, shown):
    """What stands under a page's title: its film, where it is shown, and the way to open its session in the editor."""
    film = f'<figure><img src="{name}.gif" width="640" alt="{html.escape(PAGES[name][2])}"></figure>' if shown else ""
    fetched = f'<link rel="prefetch" href="{name}.journal">'  # so that it opens without a network, too
    return f'{fetched}{film}<p><a class="button" href="../../#play=manual/learn/{name}.journal">Open this in the editor</a></p>'
