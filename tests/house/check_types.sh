#!/bin/sh
# The JavaScript of the shell conforms to its JSDoc types. Usage: check_types.sh ROOT
set -eu
cd "$1"
tsc=tests/web/node_modules/.bin/tsc
[ -x $tsc ] || { echo "npm ci in tests/web first"; exit 1; }
config=web/jsconfig.json
$tsc --project "$config" --noEmit
