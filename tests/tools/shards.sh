#!/bin/sh
# One study in parts through GNU parallel and through a Slurm array of one node, both for real: a part is killed and run again, the parts are joined, and
# the bytes are those of one run.  Needs Debian's `parallel` and `slurm-wlm`; what is missing is skipped.  TAP.  usage: shards.sh [PARTS]
# A controller and a node daemon of Slurm's own run from a temporary folder without authentication, as long as the script does.
# shellcheck disable=SC2317 # functions are called through `is`
set -u
THUD=${THUD:-$PWD/thud}
parts=${1:-4}
tmp=$(mktemp -d) || exit 1
controller='' node=''
trap '[ -z "$node" ] || kill "$node" 2>/dev/null; [ -z "$controller" ] || kill "$controller" 2>/dev/null; sleep 1; rm -rf "$tmp"' EXIT
trap 'exit 1' HUP INT TERM
cd "$tmp" || exit 1
is() { # WHAT CONDITION...
    what=$1
    shift
    if "$@" >"$tmp/said" 2>&1; then echo "ok - $what"; else
        echo "not ok - $what"
        sed 's/^/# /' "$tmp/said"
    fi
}
records=$(dirname "$THUD")/records
cat >study.sh <<EOF
#!/bin/sh
exec "$THUD" fragility towers --quiet -j 1 \\
    --records "$records/kobe-surrogate.csv,$records/northridge-surrogate.csv,$records/san-fernando-surrogate.csv" --signs both \\
    --vary record.factor=0.25:1.5:0.25 --vary gap=5cm:25cm:2cm --cases none,bumper "\$@"
EOF
chmod +x study.sh
./study.sh -o whole >whole.txt 2>whole.err || { echo "not ok - the whole study"; sed 's/^/# /' whole.err; exit 1; }
same() { for file in fragility.csv fragility-curves.csv suite.csv; do cmp "whole/$file" "$1/$file" || return 1; done; }
folders() { i=1; while [ "$i" -le "$parts" ]; do printf '%s ' "$1$i"; i=$((i + 1)); done; }
lines() { wc -l <"$1/sweep.journal" 2>/dev/null || echo 0; }
# Starts a part and kills it as soon as some of its points are done.
kill_part() { # FOLDER
    ./study.sh --shard "$parts/$parts" -o "$1" >/dev/null 2>&1 &
    victim=$!
    tries=0
    while [ "$(lines "$1")" -lt 15 ] && [ "$tries" -lt 600 ]; do sleep 0.05; tries=$((tries + 1)); done
    kill -9 "$victim" 2>/dev/null
    wait "$victim" 2>/dev/null
    killed=$(lines "$1")
    [ "$killed" -ge 1 ] && ! "$THUD" fragility --merge "$1" -o "$1-early" >/dev/null 2>&1
}
# shellcheck disable=SC2046 # words
join() { "$THUD" fragility --quiet --merge $(folders "$1") -o "$2" >/dev/null; }

if command -v parallel >/dev/null 2>&1; then
    is "a part is killed half-way" kill_part "p$parts"
    is "GNU parallel runs all parts, the killed one from where it was" \
        sh -c "seq 1 $parts | parallel --will-cite -j 2 ./study.sh --shard {}/$parts -o p{}"
    is "joined" join p parallel-joined
    is "the bytes are those of one run" same parallel-joined
else
    echo "ok - GNU parallel # SKIP parallel is not installed"
fi

if ! command -v slurmctld >/dev/null 2>&1 || ! command -v slurmd >/dev/null 2>&1; then
    echo "ok - a Slurm array # SKIP slurm-wlm is not installed"
    exit 0
fi
if [ "$(id -u)" -ne 0 ]; then
    echo "ok - a Slurm array # SKIP slurmd needs root"
    exit 0
fi
slots=$(nproc)
host=$(hostname -s)
mkdir -p slurm/state slurm/spool
cat >slurm/slurm.conf <<EOF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/none
CredType=cred/none
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$tmp/slurm/state
SlurmdSpoolDir=$tmp/slurm/spool
SlurmctldPidFile=$tmp/slurm/slurmctld.pid
SlurmdPidFile=$tmp/slurm/slurmd.pid
SlurmctldLogFile=$tmp/slurm/slurmctld.log
SlurmdLogFile=$tmp/slurm/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SchedulerType=sched/backfill
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
NodeName=$host NodeAddr=127.0.0.1 CPUs=$slots State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
EOF
SLURM_CONF=$tmp/slurm/slurm.conf
export SLURM_CONF
slurmctld -D -c >slurm/ctld.out 2>&1 &
controller=$!
slurmd -D -N "$host" >slurm/d.out 2>&1 &
node=$!
tries=0
while ! sinfo -h -o %T 2>/dev/null | grep -q idle && [ "$tries" -lt 60 ]; do sleep 0.5; tries=$((tries + 1)); done
if ! sinfo -h -o %T 2>/dev/null | grep -q idle; then
    echo "ok - a Slurm array # SKIP no Slurm node comes up here"
    tail -n 5 slurm/ctld.out slurm/d.out slurm/slurmctld.log slurm/slurmd.log 2>/dev/null | sed 's/^/# /'
    exit 0
fi
array() { # waits until the array is over
    # shellcheck disable=SC2016 # expanded where the part runs
    sbatch --wait --array="1-$parts" -o "$tmp/slurm/%a.out" --wrap './study.sh --shard $SLURM_ARRAY_TASK_ID/'"$parts"' -o s$SLURM_ARRAY_TASK_ID'
}
is "a part is killed half-way (Slurm)" kill_part "s$parts"
is "a Slurm array runs all parts, the killed one from where it was" array
is "joined (Slurm)" join s slurm-joined
is "the bytes are those of one run (Slurm)" same slurm-joined
