#!/bin/sh
# Says why PROGRAM can make no terminal here; nothing where it can.  usage: no-terminal.sh PROGRAM     PTMX: the device that terminals come from
command -v "$1" >/dev/null 2>&1 || { echo "no $1"; exit; }
(: <"${PTMX:-/dev/ptmx}") 2>/dev/null || echo "no /dev/pts: no terminal can be made here"
