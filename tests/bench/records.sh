# Sourced: $kobe, $northridge, $san_fernando as options take them: the real ground motions where they are found, else the shipped surrogates.
# THUD_RECORDS: the folder they are in
# shellcheck shell=sh disable=SC2034 # used by who sources this
kobe="kobe-surrogate.csv"
northridge="northridge-surrogate.csv"
san_fernando=san-fernando-surrogate.csv
for folder in ${THUD_RECORDS:+"$THUD_RECORDS"} ../shared/records ../../shared/records; do
    if [ -f "$folder/kobe-1995-kjma-000.AT2" ]; then
        kobe=$folder/kobe-1995-kjma-000.AT2
        northridge=$folder/northridge-1994-sylmar-converter-142-noheader.AT2
        san_fernando=$folder/san-fernando-1971-pacoima-dam-164.AT2
        break
    fi
done
