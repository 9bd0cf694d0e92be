# Whether the tables of a folder are as its datapackage.json says: each one there, its columns in their order, as many cells in each
# row, numbers where numbers stand; no cell empty in a column whose description does not allow it, or that the caller names
# (-v allowed="FILE:COLUMN ..."); what impulses leave empty only with -v impulses=1.  Prints what is wrong.  usage: awk -f check_tables.awk FOLDER/datapackage.json
function complain(text) {
    if (!(text in told))
        print text
    told[text] = 1
}
function value(line, key,    at) { # of a member whose value is a text
    at = index(line, "\"" key "\": \"")
    if (!at)
        return ""
    line = substr(line, at + length(key) + 5)
    match(line, /^([^"\\]|\\.)*/)
    return substr(line, 1, RLENGTH)
}
function cells(line,    n, i, rest) { # into cell[1..n]
    if (index(line, "\"") == 0)
        return split(line, cell, ",")
    for (n = 0; ; line = substr(line, 2)) {
        if (substr(line, 1, 1) == "\"") {
            match(line, /^"([^"]|"")*"/)
            cell[++n] = substr(line, 2, RLENGTH - 2)
        } else {
            match(line, /^[^,]*/)
            cell[++n] = substr(line, 1, RLENGTH)
        }
        line = substr(line, RLENGTH + 1)
        if (line == "")
            return n
    }
}
function check(name,    path, line, n, i, heads, rows) {
    path = folder "/" name
    heads = 0
    while ((getline line <path) > 0) {
        if (!heads && line ~ /^#/)
            continue
        n = line == "" ? 0 : cells(line)
        if (n != columns)
            complain(name ": " n " cells for " columns " columns")
        for (i = 1; i <= n; i++) {
            if (!heads && cell[i] != column[i])
                complain(name ": column " i " is " cell[i] ", described as " column[i])
            else if (heads && cell[i] == "" && !may[i])
                complain(name ": an empty cell in " column[i])
            else if (heads && type[i] != "string" && cell[i] != "" && cell[i] !~ /^-?([0-9]+([.][0-9]*)?(e[-+]?[0-9]+)?|inf)$/)
                complain(name ": " cell[i] " in " column[i])
        }
        if (heads)
            rows++
        heads = 1
    }
    close(path)
    if (!heads)
        complain(name ": not there")
}
BEGIN {
    package = ARGV[1]
    folder = package
    sub(/\/[^\/]*$/, "", folder)
    count = split(allowed, word, " ")
    for (i = 1; i <= count; i++)
        named[word[i]] = 1
    while ((getline line <package) > 0) {
        if (line ~ /"path": /) {
            if (table != "")
                check(table)
            table = value(line, "path")
            columns = 0
            tables++
            base = table
            sub(/.*\//, "", base)
        } else if (line ~ /"type": /) {
            column[++columns] = value(line, "name")
            type[columns] = value(line, "type")
            help = value(line, "description")
            may[columns] = (help ~ /empty|no value|no number|not known/ && (impulses || help !~ /impulses/)) || ((base ":" column[columns]) in named)
        }
    }
    if (table != "")
        check(table)
    if (!tables)
        print "no table is described"
}
