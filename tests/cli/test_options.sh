#!/bin/sh
# Exit statuses of what is typed: a value that an option cannot take is wrong usage, whatever the command; what a preset, a record or KEY=VALUE says is
# input.  Messages begin with the option and quote what was typed in one way.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"

record=records/kobe-surrogate.csv
refused() { # STATUS WORDS...: the status, one line, what was typed not between backticks
    wanted=$1
    shift
    is "$wanted: $*" gives "$wanted" "$@"
    is "in one line, quoted as everywhere" plainly
}
# shellcheck disable=SC2016 # backticks as they are
plainly() { [ "$(wc -l <"$tmp/err")" -eq 1 ] && ! sed 's/`thud [^`]*`//g' "$tmp/err" | grep -q '`' && [ ! -s "$tmp/out" ]; }
option() { # OPTION VALUE COMMAND...: wrong usage, said of the option
    name=$1
    value=$2
    shift 2
    refused 2 "$@" "$name" "$value"
    is "said of the option" says "^thud: $name: "
}

for command in run sweep; do
    option --method fast $command towers
    option --step 5 $command towers
    option --tolerance 10 $command towers
done
for command in run sweep bench stability; do
    option --peak 0.8 $command towers
    option --peak '5 kg' $command towers
    option --dt soon $command towers
    option --unit furlong $command towers
    option --case nine $command towers
done
option --modes x run towers
option -j 0 run towers
option --format gif run towers
option --size 5x5 run towers
option --font '' run towers
option --sign 2 run towers
option --factor abc run towers
option --from 5 run towers
option --cases foo sweep towers
option --shard 3/2 sweep towers -o "$tmp/x"
option --without foo sweep towers
option --cost foo bench towers
option --methods foo bench towers
option --patience 0s bench towers
option --unit furlong record info "$record"
option --peak 5 record info "$record"
option --dt x record info "$record"
option --column x record info "$record"
option --baseline foo record info "$record"
option --damping foo record spectrum "$record"
option --periods 1:2 record spectrum "$record"

refused 2 record fly
refused 2 help fly
refused 2 help run sweep
refused 2 run towers --set gap
refused 2 record synthesize --set seed
refused 3 run towers --set gap=5
refused 3 run towers --set gpa=5cm
refused 3 sweep towers --vary gap=5:25:1
refused 3 record synthesize --set duration=5m
refused 3 run towers --record nowhere.csv
refused 3 run nowhere.yaml
refused 3 record info nowhere.csv
