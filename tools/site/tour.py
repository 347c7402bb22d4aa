"""The tour: ten pictures that the program makes, each with the command that makes it."""
import html
import subprocess

SIZE = "800x400"
# Title, what it shows, commands: the last one writes picture.png. They run in a folder with the repository's examples.
STEPS = [
    ("A drawing", "Lines are B-splines: few points, smooth everywhere. This car has one curve a line. It is an SVG file.",
     ["batten render examples/car.svg picture.png --size 800x336"]),
    ("Draw over it", "A pen goes over the roof, and the roof follows: where the pen was it has the stroke's shape, elsewhere nothing moves.",
     ["head -n 201 docs/pictures/car.journal > roof.journal", "batten replay roof.journal --output roof.svg",
      "batten render roof.svg picture.png --size 800x336"]),
    ("All of it redrawn", "Four strokes: roof, hood, shoulder, sill.",
     ["batten replay docs/pictures/car.journal --output redrawn.svg", "batten render redrawn.svg picture.png --size 800x336"]),
    ("Hairy strokes become one line", "Six quick strokes that overlap. The line is what all of them mean.",
     ["batten replay examples/demos/hairs.journal --output hairs.svg", "batten render hairs.svg picture.png --size 800x336"]),
    ("Sweep and detail", "A curve with levels: the back and the tail were pulled, and the scales ride along.",
     ["batten replay examples/demos/crocodile.journal --output crocodile.svg", "batten render crocodile.svg picture.png --size 800x336"]),
    ("Points in, a curve out", "Measured points become a curve within the tolerance that is asked for.",
     ["batten fit examples/roof.csv --tolerance 1 > fitted.json", "batten render fitted.json picture.png --size 800x400"]),
    ("Parallels", "The parallel of a curve at a distance, as a spline.",
     ["batten fit examples/roof.csv --tolerance 1 > fitted.json", "batten curve offset fitted.json --distance 12 > offset.json",
      "batten render offset.json picture.png --size 800x400"]),
    ("Surfaces", "A jug in space. What is hidden is fainter.",
     ["batten render examples/jug.batten picture.png --size 640x480"]),
    ("Is it fair?", "Zebra stripes show what the eye would miss: they bend where the curvature jumps.",
     ["batten render examples/jug.batten picture.png --look zebra --size 640x480"]),
    ("A relief", "Ornament on the jug, as a level of its surface: it rides along when the jug is bent.",
     ["batten render examples/space/relief.batten picture.png --view examples/space/relief-view.json"]),
]


def make(program, root, folder, aside):
    """HTML of the tour; the pictures go to folder/tour."""
    place = folder / "tour"
    place.mkdir(parents=True, exist_ok=True)
    bin_ = aside / "bin"
    bin_.mkdir()
    (bin_ / "batten").symlink_to(program)
    for name in ("examples", "docs"):
        (aside / name).symlink_to(root / name)
    out = ["<h1>A tour in ten pictures</h1>", "<p>The program made all of them, with the commands below each.</p>"]
    for number, (title, text, commands) in enumerate(STEPS, 1):
        for command in commands:
            subprocess.run(command, shell=True, cwd=aside, check=True, stdout=subprocess.DEVNULL,
                           env={"PATH": f"{bin_}:/usr/bin:/bin"})
        (aside / "picture.png").rename(place / f"{number}.png")
        shown = html.escape("\n".join(commands))
        out.append(f'<h2 id="{number}">{number}. {title}</h2><p>{text}</p><figure><img src="tour/{number}.png" alt="{html.escape(title)}">'
                   f"</figure><pre><code>{shown}</code></pre>")
    return "\n".join(out)
