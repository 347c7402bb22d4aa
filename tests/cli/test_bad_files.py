"""Bad files of every format that is read: one line that says where, what was expected and what was found; nothing is written."""
import gzip
import re
import unittest

from program import ProgramTest

GLYPH = '<glyph name="a" format="2"><outline><contour>%s</contour></outline></glyph>'
STEP = "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n%s\nENDSEC;\nEND-ISO-10303-21;\n"
BVH = "HIERARCHY\nROOT Hips\n{\n\tOFFSET 0 0 0\n\tCHANNELS %s\n\tEnd Site\n\t{\n\t\tOFFSET 0 1 0\n\t}\n}\nMOTION\n%s"

OBJ = "v 0 0 0\nv 1 1 0\ncstype bspline\ndeg 1\ncurv 0 1 1 2\nparm u %s\nend\n"

# name, content, what the line has to hold
BAD = [
    ("a.json", "", "expected .*found"),
    ("a.json", "{", "expected .*found"),
    ("a.json", '{"degree":3', "line 1, column 12.*expected .*found"),
    ("a.json", '{"degree":3,"points":[[0,0]]}', "knots: expected .*found none"),
    ("a.json", '{"points":[[0,0]]}', "degree: expected .*found none"),
    ("a.json", '{"degree":"three","knots":[0,0,1,1],"points":[[0,0],[1,1]]}', "degree: expected .*found text"),
    ("a.json", '{"degree":1,"knots":[0,0,1,1],"points":[[0,0],[1]]}', "points.*expected .*found"),
    ("a.json", '{"degree":1,"knots":[0,1,0,1],"points":[[0,0],[1,1]]}', "knots"),
    ("a.json", '{"degree":1,"knots":[0,0,1,1],"points":[[0,0],[1e999,1]]}', "expected .*found|too large"),
    ("a.json", '{"degree":9,"knots":[0,1],"points":[[0,0]]}', "degree.*1.*7"),
    ("a.jsonl", '{"degree":1,"knots":[0,0,1,1],"points":[[0,0],[1,1]]}\nnonsense\n', "line 2"),
    ("a.jsonl", "", "expected .*found (none|nothing)"),
    ("a.batten", '{"batten":1}', "objects: expected .*found none"),
    ("a.batten", '{"batten":99,"objects":[]}', "99"),
    ("a.batten", '{"batten":1,"objects":[{"kind":"path"}]}', "expected .*found none"),
    ("a.batten", '{"batten":1,"objects":[7]}', "expected .*found number 7"),
    ("a.batten", '{"batten":1,"objects":[]', "expected .*found"),
    ("a.svg", "", "expected .*found"),
    ("a.svg", "<svg", "line 1"),
    ("a.svg", "<svg><g></svg>", "line 1"),
    ("a.svg", '<svg xmlns="http://www.w3.org/2000/svg">\n<path d="M0 0L1 1">\n', "line 3"),
    ("a.svg", "<html><body/></html>", "expected an svg element.*found"),
    ("a.svgz", gzip.compress(b"<svg><g>")[:-9], "gzip|line|packed"),
    ("a.dxf", "", "expected .*found"),
    ("a.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\nnorth\n", "line 8.*expected .*found"),
    ("a.dxf", "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n", "expected .*found none"),
    ("a.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\nten\n1\n", "line 7.*expected .*found"),
    ("a.obj", "", "expected .*found"),
    ("a.obj", "v 0 0\n", "line 1.*expected .*found"),
    ("a.obj", "v 0 0 0\nf 1 2 3\n", "line 2.*expected .*found|line 2.*vertex"),
    ("a.obj", OBJ % "0 0 1 1e75", "line 7: parm: expected knots up to 1e30.*found"),
    ("a.obj", OBJ % "0 1 0 1", "line 7: parm: expected knots that neither fall.*found"),
    ("a.obj", "v 0 0 zero\n", "line 1.*expected .*found"),
    ("a.glif", "", "expected .*found"),
    ("a.glif", GLYPH % '<point x="1" y="2" type="swirl"/>', "expected .*found"),
    ("a.glif", GLYPH % '<point x="here" y="2" type="line"/>', "expected .*found"),
    ("a.glif", "<glyph", "line 1"),
    ("a.bvh", "", "expected .*found"),
    ("a.bvh", "HIERARCHY\nROOT Hips\n{\n", "line [34].*expected .*found"),
    ("a.bvh", BVH % ("3 Zrotation Xrotation Sideways", "Frames: 1\nFrame Time: 0.1\n0 0 0\n"), "line 5.*expected .*found"),
    ("a.bvh", BVH % ("3 Zrotation Xrotation Yrotation", "Frames: 2\nFrame Time: 0.1\n0 0 0\n"), "expected .*found"),
    ("a.bvh", BVH % ("3 Zrotation Xrotation Yrotation", "Frames: 1\nFrame Time: 0\n0 0 0\n"), "expected .*found"),
    ("a.csv", "", "expected .*found"),
    ("a.csv", "x,y\n1,2\n3,north\n", "line 3.*expected .*found"),
    ("a.csv", "x,y\n1,2\n", "expected .*found"),
    ("a.geojson", '{"type":"LineString"}', "coordinates.*expected .*found none|expected coordinates, found none"),
    ("a.geojson", '{"type":"Point","coordinates":[0,0]}', "expected a LineString or a Polygon, found"),
    ("a.igs", "", "expected .*found"),
    ("a.igs", "not an IGES file\n", "line 1|expected .*found"),
    ("a.stp", STEP % "#1=CARTESIAN_POINT('',(0.,0.));", "expected .*found"),
    ("a.stp", "ISO-10303-21;\nDATA;\n#1=B_SPLINE", "expected .*found|line 3"),
    ("a.eps", "%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 9 9\nnewpath\n", "found PostScript.*PDF"),
    ("a.ai", "%!PS-Adobe-3.0\n%%Creator: Adobe Illustrator(TM) 7.0\n", "found PostScript.*PDF"),
    ("a.eps", b"\xc5\xd0\xd3\xc6 \x00\x00\x00", "found PostScript"),
    ("a.pdf", "%PDF-1.4\nnothing", "pdftocairo"),
]


class Bad(ProgramTest):
    def test_one_line_says_what_is_wrong(self):
        self.assertGreaterEqual(len(BAD), 40)
        wrong = []
        for name, content, words in BAD:
            path = self.folder / name
            path.write_bytes(content if isinstance(content, bytes) else content.encode())
            said = self.run_program("convert", path, self.folder / "out.svg")
            line = said.stderr.decode()
            if said.returncode != 1 or line.count("\n") != 1 or name not in line or not re.search(words, line):
                wrong.append(f"{name} {content[:60]!r}: {said.returncode} {line!r}")
            if (self.folder / "out.svg").exists():
                wrong.append(f"{name} {content[:60]!r}: something was written")
                (self.folder / "out.svg").unlink()
        self.assertEqual("\n".join(wrong), "")


if __name__ == "__main__":
    unittest.main()
