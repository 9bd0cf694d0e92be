#!/usr/bin/perl
# Phrases that are not English an engineer would write: those of words.txt (a Perl expression, a tab, what to write) may not stand in the files named.
# Of C the strings and comments are read, split literals and wrapped comments joined; of other files the text, lines joined.
# usage: check-words.pl WORDS FILE...    a line `FILE: "phrase" (write: ...)` for each; exit status 1 if there are any
use strict;
use warnings;

my $list = shift @ARGV;
open my $words, '<', $list or die "$list: $!\n";
my @banned = map { chomp; [split /\t/, $_, 2] } grep { !/^#/ && /\t/ } <$words>;
my $found = 0;
for my $file (@ARGV) {
    open my $in, '<', $file or die "$file: $!\n";
    my $text = do { local $/; <$in> };
    my @parts;
    if ($file =~ /\.[ch]$/) {
        $text =~ s/"\s*\n\s*"//g;
        $text =~ s/\n\s*\*(?!\/)/ /g;
        push @parts, $& while $text =~ /"(?:[^"\\\n]|\\.)*"|\/\*.*?\*\//gs;
    } else {
        $text =~ s/^\.(Bd|D1).*?^\.(Ed|\S+)\n//gms if $file =~ /\.\d$/;
        @parts = split /\n{2,}|^\.(?:Pp|Sh|Ss|It|El|Bl).*$/m, $text;
    }
    for my $part (@parts) {
        next unless defined $part;
        (my $joined = $part) =~ s/\s+/ /g;
        for my $row (@banned) {
            while ($joined =~ /$row->[0]/g) {
                my $at = $-[0] > 30 ? $-[0] - 30 : 0;
                printf "%s: \"...%s...\" (write: %s)\n", $file, substr($joined, $at, $+[0] - $at + 20), $row->[1];
                $found = 1;
            }
        }
    }
}
exit $found;
