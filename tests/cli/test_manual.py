"""The manual page renders without warnings and says what the program's own help says."""
import re
import shutil
import subprocess
import unittest

from program import ROOT, ProgramTest
from test_usage import COMMANDS

PAGE = ROOT / "docs" / "batten.1"


class Manual(ProgramTest):
    def test_renders_without_warnings(self):
        result = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z", str(PAGE)], capture_output=True, check=True)
        self.assertEqual(result.stderr, b"")

    def test_has_every_command_option_and_example(self):
        text = re.sub(r"\\f[BIRP]|\\-|\\\(en", lambda m: "-" if m[0] == "\\-" else "", PAGE.read_text())
        text = text.replace("\\", "")
        for name in COMMANDS:
            section = re.search(rf'(?m)^\.SS "?batten {name} (.*?)"?\n((?:(?!\.SS|\.SH).*\n)*)', text)
            self.assertIsNotNone(section, name)
            lines = self.done(*name.split(), "--help").decode().splitlines()
            self.assertEqual(f"Usage: batten {name} {section[1]}", lines[0])
            for line in lines:
                option = re.match(r"  (--[a-z-]+)", line)
                if option:
                    self.assertIn(option[1], section[2], name)


if __name__ == "__main__":
    unittest.main()
