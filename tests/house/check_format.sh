#!/bin/sh
# Every C file of the project is formatted as by clang-format. Usage: check_format.sh ROOT
set -eu
cd "$1"
files=$(git ls-files --cached --others --exclude-standard '*.c' '*.h' 2> /dev/null ||
    find include src apps web/module tests fuzz bench examples -name '*.[ch]' -not -path '*/node_modules/*')
echo "$(echo "$files" | wc -l) files"
# A file may be deleted without the deletion being committed yet.
for file in $files; do [ ! -f "$file" ] || echo "$file"; done | xargs clang-format --dry-run -Werror
