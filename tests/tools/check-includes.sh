#!/bin/sh
# Direction of the layers: base <- core <- study <- {io, plot} <- app <- {cli, tui} <- main.  TAP.
# A file includes only its own layer and those to its left, names the layer, and takes of another layer only public headers.
# usage: check-includes.sh [TREE]
set -u
cd "${1:-.}" || exit 2

may_include() { # LAYER: the layers it may include
    case $1 in
    base) echo base ;;
    core) echo base core ;;
    study) echo base core study ;;
    io | plot) echo base core study "$1" ;;
    app) echo base core study io plot app ;;
    cli | tui) echo base core study io plot app "$1" ;;
    main) echo base core study io plot app cli tui ;;
    esac
}

status=0
for layer in base core study io plot app cli tui main; do
    allowed=" $(may_include "$layer") "
    if [ "$layer" = main ]; then files=src/main.c; else files=$(find "src/$layer" "include/$layer" -name '*.[ch]' 2>/dev/null); fi
    wrong=""
    for f in $files; do
        [ -f "$f" ] || continue
        # shellcheck disable=SC2013 # a header's name has no blanks
        for header in $(sed -n 's/^[ \t]*#[ \t]*include[ \t]*"\([^"]*\)".*/\1/p' "$f"); do
            to=${header%%/*}
            if [ "$to" = "$header" ]; then
                wrong="$wrong
# $f: \"$header\" does not name its layer"
            elif ! case $allowed in *" $to "*) true ;; *) false ;; esac; then
                wrong="$wrong
# $f: \"$header\" points against the arrows"
            elif [ "$to" != "$layer" ] && [ ! -f "include/$header" ]; then
                wrong="$wrong
# $f: \"$header\" is private to $to"
            fi
        done
    done
    if [ -z "$wrong" ]; then
        echo "ok - $layer includes only:$allowed"
    else
        echo "not ok - $layer includes only:$allowed$wrong"
        status=1
    fi
done
exit $status
