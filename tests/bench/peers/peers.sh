#!/bin/sh
# Other integrators on the towers, beside the exact method: for measuring only.  What is not installed is left out with a line.  "minimal" is plain C
# written for this one scene (minimal.c): the measure for each method.
# Writes FOLDER/peers.csv and prints a table: error is the largest relative one of the floors' peak accelerations, time processor time of one
# thread; the last column how many times longer than the exact method where that is as good.
# usage: peers.sh BUILD_FOLDER FOLDER ; PYTHON: the Python with SciPy and OpenSeesPy (else python3)
# OPENSEES_STEP: its least step (else 2e-5)
set -u
build=$1
out=$2
python=${PYTHON:-python3}
here=$(dirname "$0")
export PYTHONDONTWRITEBYTECODE=1 OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
mkdir -p "$out" || exit 1
csv=$out/peers.csv
echo "scene,method,setting,seconds,error" >"$csv"

rows() { # SCENE PROGRAM...: its rows, headed by the scene; what it says besides goes to a file
    scene=$1
    shift
    "$@" 2>"$out/peers.err" | sed -n "s/^[a-z][a-z0-9-]*,.*/$scene,&/p" >>"$csv"
}
minimal() { # WORDS...: its rows without those of thud, which are of another scene than those above
    "$build/peer-minimal" "$@" | grep '^minimal-'
}
has() { "$python" -c "import $1" >/dev/null 2>&1; }

words() { # SCENE: its preset, case and keys; none of the peers' contacts keeps what is indented, that of OpenSees pulls
    case $1 in
    concrete) echo "towers none contact.residual=recover" ;;
    rubber) echo "towers bumper" ;;
    classical) echo "towers none contact.law=kelvin-voigt contact.stiffness=2500kN/mm contact.restitution=0.6" ;;
    esac
}
minimal_words() { # SCENE: as the preset is written: the residual is kept
    case $1 in
    concrete) echo "towers none" ;;
    rubber) echo "towers bumper" ;;
    esac
}
for scene in concrete rubber classical; do
    # shellcheck disable=SC2046 # several words
    set -- $(words "$scene")
    rows "$scene" "$build/peer-exact" "$@"
    [ -x "$build/peer-cvode" ] && [ "$scene" != classical ] && rows "$scene" "$build/peer-cvode" "$@"
    # shellcheck disable=SC2046
    [ "$scene" = classical ] || rows "$scene" minimal $(minimal_words "$scene")
    [ "$scene" = rubber ] || "$build/peer-export" "$@" >"$out/$scene.json" || exit 1
done
[ -x "$build/peer-cvode" ] || echo "skipped: SUNDIALS CVODE is not installed (libsundials-dev)"
if has scipy.integrate; then
    rows concrete "$python" "$here/scipy_peer.py" "$out/concrete.json"
else
    echo "skipped: SciPy is not installed (python3-scipy, or PYTHON=a Python that has it)"
fi
if has openseespy.opensees; then
    rows classical "$python" "$here/opensees_peer.py" "$out/classical.json" "${OPENSEES_STEP:-2e-5}"
else
    echo "skipped: OpenSeesPy is not installed (PYTHON=a Python that has it)"
fi

for scene in concrete rubber classical; do
    awk -F, -v scene="$scene" '
        BEGIN {
            title["concrete"] = "concrete: Kelvin-Voigt without tension, indentation recovered"
            title["rubber"] = "rubber bumper"
            title["classical"] = "classical Kelvin-Voigt, pulling at the end"
        }
        $1 != scene { next }
        $2 == "reference" {
            printf "\ntowers, %s; the reference is confirmed to %.0e\n", title[scene], trust = $5
            printf "%-26s %9s %12s %10s %10s\n", "method", "setting", "time ms", "error", "to exact"
            next
        }
        $2 == "exact" { seconds[++n] = $4; error[n] = $5 }
        {
            best = 0 # the quickest exact run that is as good, or as good as can be told
            for (i = 1; i <= n; i++)
                if ((error[i] <= $5 || error[i] <= 2 * trust) && (!best || seconds[i] < best)) best = seconds[i]
            ratio = $2 == "exact" || !best ? "" : sprintf("%.4g", $4 / best)
            printf "%-26s %9s %12.4g %10.1e %10s\n", $2, $3, 1e3 * $4, $5, ratio
        }' "$csv"
done
"$here/chart.sh" "$out"
