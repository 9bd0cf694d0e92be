#!/bin/sh
# base, core and study touch no file, terminal, clock, environment or global state and print nothing.  TAP.
# What their objects leave undefined is held against a list of pure functions; writable data are refused.
# usage: check-pure.sh ARCHIVE
set -u
cd "$(dirname "$1")" || exit 2 # nm's lines begin with the name it was given, which shall have no blank
archive=$(basename "$1")
pure="
    __divdc3 __muldc3 cabs
    acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh erf erfc exp exp2 expm1 fabs floor fma fmax fmin fmod frexp
    hypot ldexp llrint llround log log10 log1p log2 logb lrint lround modf nearbyint nextafter pow remainder rint round scalbn sin
    sincos sinh sqrt tan tanh tgamma trunc
    malloc calloc realloc free
    memchr memcmp memcpy memmove memset
    strchr strcmp strcpy strcspn strdup strlen strncmp strncpy strndup strpbrk strrchr strspn strstr
    __memcpy_chk __memmove_chk __memset_chk __strcpy_chk __strncpy_chk
    snprintf vsnprintf __snprintf_chk __vsnprintf_chk
    strtod strtold strtol strtoul qsort bsearch abs
    __assert_fail __stack_chk_fail _GLOBAL_OFFSET_TABLE_"
case $(nm "$archive" 2>/dev/null) in
*__asan_* | *__gcov_* | *__sanitizer_cov* | *__ubsan_*)
    echo "ok - the core is pure # SKIP built with instruments"
    exit 0
    ;;
esac
strange=$(nm -A -f posix "$archive" | awk -v pure="$pure" '
    BEGIN { n = split(pure, p); for (i = 1; i <= n; i++) known[p[i]] = 1 }
    $3 == "U" || $3 == "w" || $3 == "v" { if (!($2 in where)) where[$2] = $1; next }
    { known[$2] = 1 }
    END { for (s in where) if (!(s in known) && s !~ /^LAPACKE_/) print "# " where[s] " uses " s }' | sort)
written=$(nm -A -f sysv "$archive" | awk -F'|' '
    { gsub(/ /, "", $7) }
    $7 ~ /^(\.data|\.bss|\.tdata|\.tbss|\*COM\*)/ && $7 !~ /^\.data\.rel\.ro/ { gsub(/ +/, " ", $1); print "# " $1 " can be written (" $7 ")" }')
status=0
if [ -z "$strange" ]; then echo "ok - the core calls only pure functions"; else
    echo "not ok - the core calls only pure functions"
    echo "$strange"
    status=1
fi
if [ -z "$written" ]; then echo "ok - the core holds no writable data"; else
    echo "not ok - the core holds no writable data"
    echo "$written"
    status=1
fi
exit $status
