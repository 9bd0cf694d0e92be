#!/bin/sh
# The library: what it shows, what it leaves alone, and that it gives the bytes that the program gives, from C and from Python.  TAP.
# DOOR_SCENES: how many scenes from Python.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
BUILD=${BUILD:-build/release}
CC=${CC:-cc}
LC_ALL=C
export LC_ALL

ok() { # WHAT STATUS
    if [ "$2" -eq 0 ]; then echo "ok - $1"; else
        echo "not ok - $1"
        head -20 "$tmp/out" | sed 's/^/# /'
    fi
}

# the header alone, as the first of a file, in C and in C++
mkdir "$tmp/include" && cp include/thud.h "$tmp/include"
echo '#include <thud.h>' >"$tmp/first.c"
for std in c99 c17; do
    $CC -std=$std -Wall -Wextra -Wpedantic -Werror -I"$tmp/include" -fsyntax-only "$tmp/first.c" >"$tmp/out" 2>&1
    ok "thud.h is whole alone in $std" $?
done
if command -v c++ >/dev/null 2>&1; then
    printf '#include <thud.h>\nint main() { struct thud *scene; return thud_open("", &scene, 0) + thud_version()[0]; }\n' >"$tmp/first.cc"
    c++ -x c++ -std=c++11 -Wall -Wextra -Wpedantic -Werror -I"$tmp/include" -fsyntax-only "$tmp/first.cc" >"$tmp/out" 2>&1
    ok "thud.h is C++ too" $?
else
    echo "ok - thud.h is C++ too # SKIP no c++"
fi

# the names of the manual, of the header and of both libraries are the same ones
grep -o 'thud_[a-z_]*(' include/thud.h | tr -d '(' | grep -v -x thud_close_ | sort -u >"$tmp/declared"
sed -n 's/^THUD_API .*[ *]\(thud_[a-z_]*\)(.*/\1/p' include/thud.h | sort >"$tmp/exported"
sed -n 's/^\.Fn \(thud_[a-z_]*\).*/\1/p; s/^\.Fo \(thud_[a-z_]*\).*/\1/p' man/thud.3 | sort -u >"$tmp/described"
diff "$tmp/exported" "$tmp/described" >"$tmp/out" 2>&1
ok "thud(3) describes every function and no other" $?
if nm "$BUILD/libthud.a" 2>/dev/null | grep -q -E '__(asan|tsan|gcov|ubsan|sanitizer)_'; then
    asan=$($CC -print-file-name=libasan.so)
    if [ -n "$python" ] && [ -f "$asan" ] && nm -D "$BUILD/libthud.so" 2>/dev/null | grep -q __asan_; then
        LD_PRELOAD=$asan ASAN_OPTIONS=detect_leaks=0 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=src/python:tests/door THUD_LIBRARY=$PWD/$BUILD/libthud.so \
            THUD=$THUD SCENES=6 "$python" tests/door/scenes.py >"$tmp/out" 2>&1 && ! grep -q '^not ok' "$tmp/out"
        ok "Python against the library with sanitizers" $?
    else
        echo "ok - Python against the library with sanitizers # SKIP no python3, or no such library"
    fi
    echo "ok - the libraries and their examples # SKIP built with instruments"
    exit 0
fi
nm -D -f posix "$BUILD/libthud.so" | awk '$2 == "T" || $2 == "D" || $2 == "B" || $2 == "R" { print $1 }' | sort | diff "$tmp/exported" - >"$tmp/out" 2>&1
ok "the shared library shows the functions of thud.h alone" $?
nm -g -f posix "$BUILD/libthud.a" 2>/dev/null | awk '$2 ~ /[TDBRVW]/ { print $1 }' | sort | diff "$tmp/exported" - >"$tmp/out" 2>&1
ok "and so does the static one" $?
nm -D -u -f posix "$BUILD/libthud.so" | sed 's/[@ ].*//' |
    grep -x -E 'f?puts|f?putc|putchar|v?f?printf|__v?f?printf_chk|fwrite|perror|stdout|stderr|stdin|exit|_exit|abort|signal|sigaction|setlocale|getenv|rand|srand|strtok' >"$tmp/out"
[ ! -s "$tmp/out" ]
ok "it prints nothing, ends nothing, handles no signal, looks at no environment" $?
nm -f sysv "$BUILD/libthud.a" 2>/dev/null | awk -F'|' '{ gsub(/ /, "", $7) } $7 ~ /^(\.data|\.bss|\.tdata|\.tbss|\*COM\*)/ && $7 !~ /^\.data\.rel\.ro/' >"$tmp/out"
[ ! -s "$tmp/out" ]
ok "it holds no writable data" $?

# the example, against either library
root=$PWD
libs=$(sed -n 's/^Libs.private: //p' "$BUILD/thud.pc")
# shellcheck disable=SC2086 # several words
{
    $CC -std=c17 -Wall -Wextra -Werror -I"$tmp/include" tests/door/peaks.c -L"$BUILD" -Wl,-rpath,"$root/$BUILD" -lthud -o "$tmp/shared" &&
        $CC -std=c17 -Wall -Wextra -Werror -I"$tmp/include" tests/door/peaks.c "$BUILD/libthud.a" $libs -o "$tmp/static"
} >"$tmp/out" 2>&1
ok "the example is built against both" $?
n=0
while read -r scene; do
    options=
    for word in $scene; do options="$options${options:+ --set }$word"; done
    # shellcheck disable=SC2086
    (cd records && "$THUD" run $options --json --quiet) >"$tmp/program" 2>"$tmp/out"
    for kind in shared static; do
        preset=${scene%% *}
        # shellcheck disable=SC2086
        (cd records && "$tmp/$kind" --json "$root/presets/$preset.yaml" ${scene#"$preset"}) >"$tmp/library" 2>>"$tmp/out"
        cmp "$tmp/program" "$tmp/library" >>"$tmp/out" 2>&1 && n=$((n + 1))
    done
done <<END
towers
towers gap=12cm bumper.thickness=4cm
towers-yielding
rigid-bumper
three-in-a-row
slab-against-columns
towers analysis.modes=2 analysis.method=newmark
END
[ $n -eq 14 ]
ok "it gives the bytes of run --json ($n of 14)" $?
(cd records && "$tmp/shared" "$root/presets/towers.yaml" gap=12) >"$tmp/out" 2>&1
[ $? -eq 3 ] && grep -q '^peaks: gap: "12" has no unit; give a length' "$tmp/out"
ok "its errors are those of the program" $?

# every part of the header in one program
{ $CC -std=c17 -Wall -Wextra -Werror -I"$tmp/include" tests/door/parts.c -L"$BUILD" -Wl,-rpath,"$root/$BUILD" -lthud -lm -o "$tmp/parts"; } >"$tmp/out" 2>&1
ok "a program with every part of thud.h is built" $?
memory=
if command -v valgrind >/dev/null 2>&1; then memory='valgrind -q --leak-check=full --error-exitcode=9'; fi
# shellcheck disable=SC2086
(cd records && $memory "$tmp/parts" "$root/presets/rigid-concrete.yaml") >"$tmp/out" 2>&1 && grep -q '^column: forc_n, did you mean force_n?$' "$tmp/out" && grep -q '^left 7.5 mm at 2.5e+06 N$' "$tmp/out"
ok "and runs${memory:+ under valgrind}" $?

# Python
if [ -z "$python" ]; then
    echo "ok - Python # SKIP no python3"
    exit 0
fi
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=src/python:tests/door THUD_LIBRARY=$root/$BUILD/libthud.so THUD=$THUD SCENES=${DOOR_SCENES:-25} "$python" tests/door/scenes.py >"$tmp/python" 2>"$tmp/out"
status=$?
cat "$tmp/python"
[ $status -eq 0 ] || ok "Python" 1
localedef --no-archive -i de_DE -f UTF-8 "$tmp/de_DE.UTF-8" >/dev/null 2>&1
if LOCPATH=$tmp LC_ALL=de_DE.UTF-8 "$python" -c 'import locale; locale.setlocale(locale.LC_ALL, ""); assert locale.localeconv()["decimal_point"] == ","' 2>/dev/null; then
    PYTHONDONTWRITEBYTECODE=1 LOCPATH=$tmp LC_ALL=de_DE.UTF-8 PYTHONPATH=src/python:tests/door THUD_LIBRARY=$root/$BUILD/libthud.so THUD=$THUD SCENES=3 \
        "$python" tests/door/scenes.py >"$tmp/out" 2>&1 && ! grep -q '^not ok' "$tmp/out"
    ok "it writes a point where the program around it writes a comma" $?
else
    echo "ok - it writes a point where the program around it writes a comma # SKIP no such locale can be made"
fi

# the package: installed, and how it finds the library
places() { # WHAT PATTERN: what importing it says without a library
    (cd "$tmp" && env -u THUD_LIBRARY PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$package" "$python" -c 'import thud; print(thud.version)') >"$tmp/out" 2>&1
    grep -q "$2" "$tmp/out"
    ok "$1" $?
}
package=$tmp/usr/share/thud # as installed
mkdir -p "$tmp/usr/share" "$tmp/usr/lib"
cp -r src/python "$package"
LD_LIBRARY_PATH='' PKG_CONFIG_PATH=$tmp/none places "without a library it says where it looked" "  $package/libthud.so.0: "
printf 'libdir=%s\nName: thud\nDescription: x\nVersion: 0\n' "$root/$BUILD" >"$tmp/thud.pc"
if command -v pkg-config >/dev/null 2>&1; then
    PKG_CONFIG_PATH=$tmp places "it finds the library by pkg-config" '^[0-9]*\.[0-9]'
fi
ln -s "$root/$BUILD/libthud.so" "$package/libthud.so.0"
PKG_CONFIG_PATH=$tmp/none places "it finds the library beside itself" '^[0-9]*\.[0-9]'
mv "$package/libthud.so.0" "$tmp/usr/lib"
PKG_CONFIG_PATH=$tmp/none places "and that of its installation, under any prefix" '^[0-9]*\.[0-9]'
rm "$tmp/usr/lib/libthud.so.0"
if "$python" -m venv "$tmp/venv" >/dev/null 2>&1 && "$tmp/venv/bin/python" -c 'import setuptools, wheel' 2>/dev/null; then
    "$tmp/venv/bin/pip" install -q --no-index --no-build-isolation --no-deps "$package" >"$tmp/out" 2>&1 &&
        (cd "$tmp" && THUD_LIBRARY=$root/$BUILD/libthud.so venv/bin/python -c 'import thud; print(thud.__file__, thud.run("rigid-concrete").contacts.force[0])') >>"$tmp/out" 2>&1
    ok "pip installs it" $?
else
    echo "ok - pip installs it # SKIP no venv with setuptools and wheel"
fi
cells='import json, os; [exec("".join(c["source"]), globals()) for c in json.load(open("src/python/pounding.ipynb"))["cells"] if c["cell_type"] == "code"]; assert len(forces) > 1000 and max(forces) > 1e6'
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=src/python THUD_LIBRARY=$root/$BUILD/libthud.so "$python" -c "$cells" >"$tmp/out" 2>&1
ok "the cells of the notebook run" $?
