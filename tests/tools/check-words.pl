#!/usr/bin/perl
# Plain English: phrases of words.txt (a Perl expression, a tab, what to write) must not occur, sentences and paragraphs must be short.
# Of C, strings and comments are read, with split literals and wrapped comments joined; of other files the text, with lines joined.
# A row of words.txt that begins with + names text that may be longer, with the reason.
# usage: check-words.pl WORDS FILE...    a line for each fault, then counts of sentences by page and by kind of text; exit status 1 if there is a fault
#        check-words.pl --over N WORDS FILE...    lists the sentences of more than N words
use strict;
use warnings;

my $over = @ARGV && $ARGV[0] eq '--over' ? (splice @ARGV, 0, 2)[1] : 0;
my $list = shift @ARGV;
open my $words, '<', $list or die "$list: $!\n";
my @rows = map { chomp; [split /\t/, $_, 2] } grep { !/^#/ && /\t/ } <$words>;
my @banned = grep { $_->[0] !~ /^\+/ } @rows;
my @kept = map { substr $_->[0], 1 } grep { $_->[0] =~ /^\+/ } @rows;
my $inline = qr/^(Ns|No|Cm|Ar|Fl|Pa|Ql|Li|Va|Ic|Op|Pq|Em|Sy|Ev|Nm|Xr|Sx|Fn|Ft|Fa|Vt|Dq|Dv|In|Xo|Xc)$/;
my $found = 0;
my %count; # page or kind of text -> sentences, over 25 words, over 30 words

sub fault { print @_, "\n"; $found = 1; }

# The text of an mdoc(7) block without its macros; $_[0]: the block
sub plain {
    my @lines = split /\n/, $_[0];
    for (@lines) {
        if (s/^\.(\w+)\s*//) {
            $_ = join ' ', grep { $_ !~ $inline } split;
            s/ ([.,:;)])(?= |$)/$1/g;
        }
        s/[.!?]$/$&\0/; # a sentence ends with its line
    }
    (my $text = join ' ', @lines) =~ s/\\&|\\\w\b//g;
    return $text;
}

# The texts of a file as pairs of kind (messages, comments, or the page) and text
sub parts {
    my ($file, $text) = @_;
    my @parts;
    if ($file =~ /\.[ch]$/) {
        $text =~ s/"\s*\n\s*"//g;
        while ($text =~ m{"((?:[^"\\\n]|\\.)*)"|/\*(.*?)\*/|'(?:[^'\\]|\\.)+'}gs) {
            if (defined $1) {
                my $string = $1;
                $string =~ s/\\n|\||<\/?(?:p|t[dhr]|li|h\d|div|caption|figcaption)\b[^>]*>/ .  /g;
                $string =~ s/<[^>]*>/ /g;
                push @parts, ['messages', $string];
            } elsif (defined $2) {
                (my $comment = $2) =~ s/\n\s*\* ?/\n/g;
                $comment =~ s/^ {2,}.*$//gm; # formulas and lists
                push @parts, map { ['comments', $_] } split /\n\s*\n/, $comment;
            }
        }
    } elsif ($file =~ /\.\d$/) {
        $text =~ s/^\.Bd.*?^\.Ed\n|^\.Rs.*?^\.Re\n|^\.(?:D1|Dl|\\").*?\n|^\.Sh SYNOPSIS.*?(?=^\.Sh)/.Pp\n/gms;
        push @parts, map { [$file, plain($_)] } grep { defined } split /^\.(?:Pp|Sh|Ss|It|Bl|El|D[dt]|Os|Nd)\b.*\n/m, $text;
    } else {
        push @parts, map { [$file, $_] } grep { !/^ {4}/m } split /\n{2,}|^\s*[-|#]|\|/m, $text;
    }
    return @parts;
}

for my $file (@ARGV) {
    open my $in, '<', $file or die "$file: $!\n";
    my $text = do { local $/; <$in> };
    (my $raw = $text) =~ s/"\s*\n\s*"//g;
    $raw =~ s/\n\s*\*(?!\/)/ /g if $file =~ /\.[ch]$/;
    $raw =~ s/^\.(Bd|D1).*?^\.(Ed|\S+)\n//gms if $file =~ /\.\d$/;
    for my $part ($file =~ /\.[ch]$/ ? $raw =~ /"(?:[^"\\\n]|\\.)*"|\/\*.*?\*\//gs : split /\n{2,}|^\.(?:Pp|Sh|Ss|It|El|Bl).*$/m, $raw) {
        (my $joined = $part) =~ s/\s+/ /g;
        for my $row (@banned) {
            while ($joined =~ /$row->[0]/g) {
                my $at = $-[0] > 30 ? $-[0] - 30 : 0;
                fault("$file: \"...", substr($joined, $at, $+[0] - $at + 20), "...\" (write: $row->[1])");
            }
        }
    }
    for my $part (parts($file, $text)) {
        my ($kind, $joined) = @$part;
        $joined =~ s/\s+/ /g;
        next if grep { $joined =~ /$_/ } @kept;
        fault("$file: a paragraph of more than 8 lines: \"", substr($joined, 0, 60), "...\"") if $file =~ /thud\.1$/ && length $joined > 8 * 70;
        for my $sentence (split /\0|(?<!\b[A-Z]|\b[ei]\.[ge])(?<!\bFig|.\bal|.\beq|\bvol|\bch)[.!?](?=["')]*(?:\s|$))/, $joined) {
            my $length = () = $sentence =~ /\S*[A-Za-z%]\S*/g;
            next if $length < 3;
            my $sum = $count{$kind} //= [0, 0, 0];
            $sum->[0]++;
            $sum->[1]++ if $length > 25;
            $sum->[2]++ if $length > 30;
            print "$file: $length words: $sentence\n" if $over && $length > $over;
        }
    }
}
for my $page (grep { /^man/ && $count{$_}[2] * 100 >= $count{$_}[0] * 3 } sort keys %count) {
    fault("$page: 3 % of the sentences have more than 30 words");
}
printf "%s: %d sentences, %d over 25 words, %d over 30\n", $_, @{ $count{$_} } for sort keys %count;
exit $found;
