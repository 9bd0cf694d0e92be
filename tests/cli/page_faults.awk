# What is wrong with the pages of a report, a line for each fault: texts over each other or beyond the margins, letters under 6 points, a table that
# goes over the end of a page without its caption on the next one, a page less than half full.  Reads report.md and then, of its PDF, what
# `pdftotext -raw -bbox` prints: the words in the order of the page's own content, so cell by cell.
# usage: awk -f page_faults.awk report.md words.html

function fault(text) { print text; faults++ }
function letters(text) { gsub(/&[a-z]+;|<br>|[^A-Za-z0-9]/, "", text); return text }
function min(a, b) { return a < b ? a : b }
function max(a, b) { return a > b ? a : b }
# from the top of a page to where its first table or figure ends; a text: 0
function first_block(p,    i, kind, end) {
    for (i = first[p]; i < first[p + 1]; i++) {
        if (word[i] != "Table" && word[i] != "Figure" || word[i + 1] !~ /^[0-9]+\.$/) continue
        if (i == first[p]) kind = "Table"
        else { end = word[i] == "Figure" && kind == "" && drawn[p] ? bottom[i] : top[i]; break }
    }
    return kind == "" && !end ? 0 : (end ? end : full) - margin_top
}

BEGIN { margin = 28.3; margin_top = 34; foot = 45; ascent = 1.164 } # points: 10 mm, 12 mm, 16 mm; height of a line of DejaVu in ems

# ---- report.md: the caption and the last row of each table, letters and digits alone ----
FNR == NR && /^[*][*]Table [0-9]+[.] / { gsub(/\\/, ""); gsub(/^[*][*]|[*][*]$/, ""); split($2, n, "."); table = n[1]; caption[table] = letters($0); next }
FNR == NR && table && /^[|]/ { gsub(/\\/, ""); last_row[table] = letters($0); tables = table; next }
FNR == NR && table && /^$/ && last_row[table] { table = 0 }
FNR == NR { next }

# ---- the words ----
/<page / { pages++; match($0, /width="[0-9.]+"/); width = substr($0, RSTART + 7, RLENGTH - 8); match($0, /height="[0-9.]+"/)
    height = substr($0, RSTART + 8, RLENGTH - 9); full = height - foot; first[pages] = words + 1; next }
/<word / {
    split($0, part, "\"")
    text = $0; sub(/^[^>]*>/, "", text); sub(/<\/word>.*/, "", text)
    if (part[4] + 0 > full) next # the foot of the page
    word[++words] = text; left[words] = part[2] + 0; top[words] = part[4] + 0; right[words] = part[6] + 0; bottom[words] = part[8] + 0
    said[pages] = said[pages] letters(text)
    if (bottom[words] > deepest[pages]) deepest[pages] = bottom[words]
}

END {
    first[pages + 1] = words + 1
    if (words < 500 || tables < 5) fault("few words or tables: " words + 0 ", " tables + 0)
    for (p = 1; p <= pages; p++) {
        for (i = first[p]; i < first[p + 1]; i++) {
            high = bottom[i] - top[i]; wide = right[i] - left[i]
            if (left[i] < margin - 1 || right[i] > width - margin + 1 || top[i] < margin_top - 6) fault("page " p ": beyond the margin: " word[i])
            if (word[i] ~ /[A-Za-z0-9][A-Za-z0-9][A-Za-z0-9]/ && min(high, wide) / ascent < 5.95) fault(sprintf("page %d: letters of %.1f points: %s", p, min(high, wide) / ascent, word[i]))
            for (k = first[p]; k < i; k++) # letters alone: without the room that a font keeps above and below them
                if (min(right[i], right[k]) - max(left[i], left[k]) > 1 && min(bottom[i], bottom[k]) - max(top[i], top[k]) > 0.4 * min(high, bottom[k] - top[k]))
                    fault("page " p ": over each other: " word[k] " | " word[i])
        }
        if (p > 1 && p < pages && deepest[p] < 0.5 * (margin_top + full) && first_block(p + 1) < full - deepest[p])
            fault(sprintf("page %d: %.0f %% full", p, 100 * (deepest[p] - margin_top) / (full - margin_top)))
    }
    for (t = 1; t <= tables; t++) {
        for (p = 1; p <= pages && !(at = index(said[p], caption[t])); p++) ;
        if (p > pages) { fault("table " t " is not in the PDF: " caption[t]); continue }
        rest = substr(said[p], at)
        while (!index(rest, last_row[t]) && p < pages) {
            rest = said[++p]
            if (index(rest, caption[t]) != 1) { fault("page " p ": table " t " goes on without its caption, or has another last row: " last_row[t]); break }
            across++
        }
    }
    printf "%d pages, %d tables, %d times over a page's end\n", pages, tables, across > "/dev/stderr"
    exit faults > 0
}
