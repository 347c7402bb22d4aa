#!/usr/bin/env python3
"""Documents that Batten writes obey docs/batten.schema.json, and so does every example in docs/format.md; documents
that Batten refuses do not.

Usage: test_schema.py ROOT WRITE_DOCUMENTS   (a program that prints documents, one a record, ended by a zero byte)
"""
import json
import pathlib
import re
import subprocess
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)

root = pathlib.Path(sys.argv[1])
schema = json.loads((root / "docs/batten.schema.json").read_text())
jsonschema.Draft202012Validator.check_schema(schema)


document = jsonschema.Draft202012Validator(schema)
written = subprocess.run([sys.argv[2]], stdout=subprocess.PIPE, check=True).stdout.split(b"\0")[:-1]
assert len(written) >= 20, "too few documents"
for text in written:
    document.validate(json.loads(text))

text = (root / "docs/format.md").read_text()
examples = [json.loads(block) for block in re.findall(r"```json\n(.*?)```", text, re.S)]
parts = ["#/$defs/curve", "#/$defs/surface", "#/$defs/mesh", "#/$defs/view", "#/$defs/sweep", "#/$defs/move", "#/$defs/wires", "#/$defs/stroke", "#/$defs/spline", "#/$defs/shape", "#/$defs/relief", None, "#/$defs/paint", "#/$defs/markers"]
assert len(examples) == len(parts)
for example, part in zip(examples, parts):
    (document if part is None else jsonschema.Draft202012Validator({"$ref": part, "$defs": schema["$defs"]})).validate(example)

# One limit of ids: in the header, here, and in words.
header = (root / "include/batten/document.h").read_text()
ids = int(re.search(r"#define BAT_ID_MAX \(\(bat_id\)(\d+)\)", header)[1])
kinds = schema["$defs"]["object"]["properties"]
assert [kinds["id"]["maximum"], kinds["parent"]["maximum"], schema["properties"]["next"]["maximum"] - 1] == 3 * [ids]
assert f"| `id` | 1 to {ids}, each once |" in text and f"1 to {ids + 1}; may be left out" in text

example = examples[parts.index(None)]
for path, value in [(("batten",), 11), (("page",), [0, 0, -1, 1]), (("page",), [0, 0]), (("objects",), {}),
                    (("objects", 0, "id"), 0), (("objects", 0, "id"), ids + 1), (("next",), ids + 2), (("objects", 0, "kind"), "blob"), (("objects", 0, "curves"), []),
                    (("objects", 0, "style", "stroke"), "red"), (("objects", 0, "style", "opacity"), 2),
                    (("objects", 0, "curves", 0, "degree"), 8), (("objects", 0, "curves", 0, "points", 0), [1])]:
    broken = json.loads(json.dumps(example))
    at = broken
    for key in path[:-1]:
        at = at[key]
    at[path[-1]] = value
    assert not document.is_valid(broken), path
print(f"{len(written)} documents, {len(examples)} examples")
