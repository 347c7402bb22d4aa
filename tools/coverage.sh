#!/bin/sh
# Branch coverage of src/ by the C tests, the examples, the seeds of the fuzz targets, the journals and the drawings of
# this repository, nearly all in one native program (tests/wasm), and by the tests of the program (tests/cli). One line
# per file: the share of branch outcomes that are taken, how many there are, how many are never taken; worst first, the
# total of src/ last.
# Usage: tools/coverage.sh [FILE...]: for the files given, also lists each condition that never holds or always holds.
set -eu
cd "$(dirname "$0")/.."
tree=build/coverage
cmake --preset coverage --log-level=WARNING > /dev/null
cmake --build --preset coverage > $tree/build.log || { tail -40 $tree/build.log; exit 1; }
rm -rf $tree/runs
mkdir $tree/runs

# One line per run: its name and the program's arguments.
{
    sed -n 's/^    {"\(.*\)", \(unit\|call\)_.*/\1 run \1/p' $tree/tests/wasm/units_list.c
    for folder in fuzz/corpus/*; do
        target=fuzz_${folder##*/}
        echo "$target read $target" "$folder"/*
    done
    echo svg read svg $(git ls-files '*.svg')
    echo journal read journal $(git ls-files '*.journal' fuzz/corpus/journal)
    echo text read text $(git ls-files '*.csv' '*.json' '*.batten' fuzz/corpus)
} > $tree/runs.txt
cut -d' ' -f1 $tree/runs.txt | sort > $tree/runs.names
$tree/tests/unit_tests | sort > $tree/all.txt
xargs -P "$(nproc)" -L 1 sh -c 'name=$1 && shift
    LLVM_PROFILE_FILE=$0/runs/$name.profraw "$0/units" "$@" > "$0/runs/$name.log" 2>&1 ||
        { echo "$name failed:"; tail -3 "$0/runs/$name.log"; exit 1; }' $tree < $tree/runs.txt
# The tests that are not in it: those that need the calls on the stack, or make solves fail (tests/wasm/programs.cmake).
for name in $(comm -23 "$tree/all.txt" "$tree/runs.names"); do
    LLVM_PROFILE_FILE=$tree/runs/$name.profraw $tree/tests/unit_tests $name > $tree/runs/$name.log 2>&1 ||
        { echo "$name failed:"; tail -3 $tree/runs/$name.log; exit 1; }
done
# The program's processes share eight profile files. Left out: tests of the server, the disk and signals, not of src/.
LLVM_PROFILE_FILE=$PWD/$tree/runs/cli-%8m.profraw ctest --test-dir $tree -R '^cli_' \
    -E 'crowd|kill|levels_oracle|races|streams' -j "$(nproc)" > $tree/cli.log || { tail -40 $tree/cli.log; exit 1; }
llvm-profdata merge -sparse $tree/runs/*.profraw -o $tree/all.profdata
rm $tree/runs/*.profraw

llvm-cov export $tree/units -object $tree/batten -object $tree/tests/unit_tests -instr-profile=$tree/all.profdata > $tree/all.json
jq -r '[.data[0].files[] | select(.filename | test("(^|/)src/")) |
        {name: (.filename | sub(".*?src/"; "src/")), all: .summary.branches.count, none: .summary.branches.notcovered}] |
        (sort_by(if .all == 0 then 1 else 1 - .none / .all end) | .[]),
        {name: "src", all: (map(.all) | add), none: (map(.none) | add)} | select(.all > 0) |
        "\((1000 * (.all - .none) / .all | floor) / 10)\t\(.all)\t\(.none)\t\(.name)"' $tree/all.json
for file; do
    jq -r --arg file "$file" '.data[0].files[] | select(.filename | endswith("/" + $file)) | .branches[] |
        select(.[4] == 0 or .[5] == 0) |
        "\($file):\(.[0]):\(.[1]): never\(if .[4] == 0 then " true" else "" end)\(if .[5] == 0 then " false" else "" end)"' \
        $tree/all.json
done
