/* Reads fields of CSV that the program itself has written. */
#pragma once

/* Ends the field at *at by a NUL, quotes taken off in place, and goes on to what comes after it. Returns what ended it:
 * a comma, a newline, or NUL. */
char thud_csv_field(char **at, const char **field);
