#!/bin/sh
# Names, in one line, the Debian packages whose headers the compiler does not find.  usage: need.sh COMPILER...
set -u
missing=""
command -v pkg-config >/dev/null 2>&1 || missing=" pkg-config"
for pair in stdio.h=libc6-dev yaml.h=libyaml-dev csv.h=libcsv-dev lapacke.h=liblapacke-dev ncurses.h=libncurses-dev zlib.h=zlib1g-dev; do
    printf '#include <stdio.h>\n#include <%s>\n' "${pair%=*}" | "$@" -E - >/dev/null 2>&1 || missing="$missing ${pair#*=}"
done
[ -z "$missing" ] && exit 0
echo "Missing to build thud:$missing (install with: make deps)" >&2
exit 1
