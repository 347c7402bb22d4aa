#!/bin/sh
# The scripts run on Debian 12's node 18, not only on newer versions. Usage: check_node.sh ROOT
set -eu
cd "$1"
files=$(find tests bench web examples -name '*.mjs' -not -path '*/node_modules/*')
[ -n "$files" ] || exit 1
found=$(grep -nE 'import\.meta\.(dirname|filename)|node:test/reporters|Object\.groupBy|Promise\.withResolvers|\.to(Sorted|Reversed|Spliced)\(' $files || true)
[ -z "$found" ] || { echo "$found"; echo "node 18 does not have these (fileURLToPath(import.meta.url) for the path; events of run() for reports)"; exit 1; }
echo "$(echo "$files" | wc -l) files"
