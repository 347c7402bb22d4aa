"""face.py SOURCE OUT: the type face of the page, cut out of SOURCE (Inter, the variable font) and written as WOFF2.

What is left: upright, weights from 400 to 600, the letters of European languages that Latin-1 and Latin Extended-A have,
and what the page's words need beside them. Equal sources give equal files: the folder of a build is named after them.
"""
import sys

from fontTools.subset import Options, Subsetter, parse_unicodes
from fontTools.ttLib import TTFont
from fontTools.varLib.instancer import instantiateVariableFont

WEIGHTS = (400, 600)
CHARACTERS = ("20-7E,A0-17F,2010-2015,2018-201E,2020-2022,2026,2030,2032,2033,2039,203A,2044,2070,2074-207E,20AC,2122,2190-2199,21BB,"
              "2212,2215,2220,2248,2260,2264,2265,2318,21E7,2325,2715,D7")
FEATURES = ["kern", "tnum"]  # the second: figures of one width, which fields and lists ask for


def main(source, out):
    font = TTFont(source, recalcTimestamp=False)
    options = Options(layout_features=FEATURES, flavor="woff2", notdef_outline=True, recalc_timestamp=False)
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=parse_unicodes(CHARACTERS))
    subsetter.subset(font)
    limits = {axis.axisTag: axis.defaultValue for axis in font["fvar"].axes}
    limits["wght"] = WEIGHTS
    font = instantiateVariableFont(font, limits)
    font.flavor = "woff2"
    font.save(out)


if __name__ == "__main__":
    main(*sys.argv[1:])
