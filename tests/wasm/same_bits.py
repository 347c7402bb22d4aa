"""Outputs of the parity program agree bit for bit; what a NaN's sign and payload are carries nothing.
Usage: same_bits.py EXPECTED OTHER..."""
import sys


def sections(path):
    with open(path, encoding="ascii") as file:
        for line in file:
            name, _, rest = line.partition(":")
            yield name, [int(word, 16) for word in rest.split()]


def is_nan(bits):
    return bits & 0x7ff0000000000000 == 0x7ff0000000000000 and bits & 0xfffffffffffff != 0


def differences(ours, theirs):
    yield from (k for k, (a, b) in enumerate(zip(ours, theirs)) if a != b and not (is_nan(a) and is_nan(b)))
    if len(ours) != len(theirs):
        yield min(len(ours), len(theirs))


faults = 0
expected = list(sections(sys.argv[1]))
for path in sys.argv[2:]:
    others = list(sections(path))
    if [name for name, _ in others] != [name for name, _ in expected] or len(expected) < 10:
        print(f"{path}: other sections, or too few")
        faults += 1
        continue
    for (name, ours), (_, theirs) in zip(expected, others):
        wrong = list(differences(ours, theirs))
        if wrong:
            print(f"{path}: {name}: {len(wrong)} of {len(ours)} numbers differ, the first is number {wrong[0]}")
            faults += 1
    print(f"{path}: {sum(len(values) for _, values in others)} numbers in {len(others)} sections")
sys.exit(1 if faults or len(sys.argv) < 3 else 0)
