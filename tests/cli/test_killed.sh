#!/bin/sh
# Studies killed at their writes go on to the same bytes; `make soak` does many.  TAP.
exec sh tests/soak/kill.sh "${KILLED_STUDIES:-4}"
