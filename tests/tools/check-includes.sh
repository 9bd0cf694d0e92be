#!/bin/sh
# Direction of the layers: base <- ground <- core <- study <- {io, plot} <- app <- lab <- {cli, tui} <- main; the door beside lab.  TAP.
# A file includes only its own layer and those to its left, names the layer, and takes of another layer only public headers (of app and lab, which are
# never installed, any).  thud.h, which is installed, is for base, which has its errors from there, and for door, which is behind it.  The rooms of a layer (its sub-folders) form no circle, and a header in include/ has a reader outside its layer.
# usage: check-includes.sh [TREE]
set -u
cd "${1:-.}" || exit 2

may_include() { # LAYER: the layers it may include
    case $1 in
    base) echo base ;;
    ground) echo base ground ;;
    core) echo base ground core ;;
    study) echo base ground core study ;;
    io | plot) echo base ground core study "$1" ;;
    app) echo base ground core study io plot app ;;
    lab | door) echo base ground core study io plot app "$1" ;; # what is installed does without the laboratory
    cli | tui) echo base ground core study io plot app lab "$1" ;;
    main) echo base ground core study io plot app lab cli tui ;; # which do without the door
    esac
}

status=0
for layer in base ground core study io plot app lab cli tui door main; do
    allowed=" $(may_include "$layer") "
    if [ "$layer" = main ]; then files=src/main.c; else files=$(find "src/$layer" "include/$layer" -name '*.[ch]' 2>/dev/null); fi
    wrong=""
    for f in $files; do
        [ -f "$f" ] || continue
        # shellcheck disable=SC2013 # a header's name has no blanks
        for header in $(sed -n 's/^[ \t]*#[ \t]*include[ \t]*"\([^"]*\)".*/\1/p' "$f"); do
            to=${header%%/*}
            case $layer/$header in base/thud.h | door/thud.h) continue ;; esac
            if [ "$to" = "$header" ]; then
                wrong="$wrong
# $f: \"$header\" does not name its layer"
            elif ! case $allowed in *" $to "*) true ;; *) false ;; esac; then
                wrong="$wrong
# $f: \"$header\" points against the arrows"
            elif [ "$to" != "$layer" ] && [ "$to" != app ] && [ "$to" != lab ] && [ "$layer" != main ] && [ ! -f "include/$header" ]; then
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

includes=$(find src include -name '*.[ch]' 2>/dev/null | while read -r f; do sed -n "s|^[ \t]*#[ \t]*include[ \t]*\"\([^\"]*\)\".*|$f \1|p" "$f"; done)
for layer in core study io plot app lab tui; do
    arrows=$(printf '%s\n' "$includes" | awk -v layer="$layer" '
        { n = split($1, from, "/"); m = split($2, to, "/") }
        from[2] == layer && to[1] == layer && n == 4 && m == 3 && from[3] != to[2] { print from[3], to[2] }' | sort -u)
    circle=$(printf '%s\n' "$arrows" | tsort 2>&1 >/dev/null)
    if [ -z "$circle" ]; then
        echo "ok - the rooms of $layer form no circle"
    else
        echo "not ok - the rooms of $layer form no circle"
        printf '%s\n' "$circle" | sed 's/^/# /'
        status=1
    fi
done
writers=$(grep -lE '(dialog\.mode|redraw\.(wanted|now)) (=|\|=) |n?printf\((tui->)?said\.text|said\.(text\[0\]|role) = ' src/tui/*/*.c 2>/dev/null | grep -v '/document/ask\.c$')
if [ -z "$writers" ]; then
    echo "ok - one file of the terminal changes what is said, what is asked, and whether it is drawn"
else
    echo "not ok - one file of the terminal changes what is said, what is asked, and whether it is drawn"
    printf '%s\n' "$writers" | sed 's/^/# /'
    status=1
fi
private=$(printf '%s\n' "$includes" | awk '
    { split($1, from, "/"); split($2, to, "/") }
    from[2] != to[1] { read[$2] = 1 }
    from[1] == "include" { read[$2] = 1 }
    END { while (("find include -name \"*.h\"" | getline line) > 0) { sub("include/", "", line); if (!(line in read)) print "# include/" line } }')
if [ -z "$private" ]; then
    echo "ok - every header in include/ is read outside its layer"
else
    echo "not ok - every header in include/ is read outside its layer"
    printf '%s\n' "$private"
    status=1
fi
exit $status
