#!/bin/sh
# Tables of storeys and joints as ETABS and SAP2000 write them, buildings by what is known, and what their storeys come to.  TAP.
# shellcheck source=tests/cli/program.sh
. "$(dirname "$0")/program.sh"
cd "$tmp" || exit 1
stiffness() { # NUMBERS of a thousand are quoted, as in a sheet saved as CSV
    cat <<'END'
TABLE:  Story Stiffness,,,,,,,,,,
Story,Output Case,Case Type,Step Type,Step Number,Shear X,Drift X,Stiff X,Shear Y,Drift Y,Stiff Y
,,,,,kN,mm,kN/m,kN,mm,kN/m
Story4,EQX,LinStatic,,,"1,200.0",2.000,"600,000.0",0,0.01,0
Story3,EQX,LinStatic,,,"2,100.0",3.500,"600,000.0",0,0.01,0
Story2,EQX,LinStatic,,,"2,700.0",4.500,"600,000.0",0,0.01,0
Story1,EQX,LinStatic,,,"3,000.0",5.000,"600,000.0",0,0.01,0
Story4,EQY,LinStatic,,,0,0.01,0,"1,200.0",4.000,"300,000.0"
Story3,EQY,LinStatic,,,0,0.01,0,"2,100.0",7.000,"300,000.0"
Story2,EQY,LinStatic,,,0,0.01,0,"2,700.0",9.000,"300,000.0"
Story1,EQY,LinStatic,,,0,0.01,0,"3,000.0",10.000,"300,000.0"
END
}
mass() { # with a byte-order mark and lines that end as on Windows
    printf '\357\273\277TABLE:  Mass Summary by Story\r\nStory,UX,UY,UZ\r\n,kg,kg,kg\r\n'
    printf 'Story4,"250,000.00","250,000.00",0\r\nStory3,320000,320000,0\r\nStory2,320000,320000,0\r\n'
    printf 'Story1,320000,320000,0\r\nBase,15000,15000,0\r\n'
}
stiffness >k.csv
mass >m.csv
# four storeys of 600 MN/m under 320, 320, 320 and 250 t: building A of towers
is "two tables, one case" gives 0 building import k.csv m.csv --set case=EQX
is "which storeys, direction and case" shows '^storeys Story1 to Story4, direction X, case EQX$'
is "the period of the same building" shows '^A: T1 0.3979 s, T2 0.1393 s'
is "a storey of it" shows '^     4       3      250      600    2.452$'
is "as keys of a preset" shows '^    mass: \[320 t, 320 t, 320 t, 250 t\]$'
is "with its stiffness" shows '^    stiffness: 600 MN/m$'
is "in the other order" gives 0 building import m.csv k.csv --set case=EQX
is "it is the same" shows '^A: T1 0.3979 s'
is "the other direction follows from the case" gives 0 building import k.csv m.csv --set case=EQY --json
is "by a factor of sqrt 2 in the period" shows '"direction": "Y",$'
is "to all its digits" shows '"mode": 1, "period_s": 0.5627315122'
is "as CSV" gives 0 building import k.csv m.csv --set case=EQX --csv
is "storey by storey" shows '^A,4,3,250000,600000000,2451662.5,,,$'
is "two cases" gives 3 building import k.csv m.csv
is "are listed" says '^thud: k.csv:2: 2 load cases: name one with --set case=NAME (EQX, EQY)$\|^k.csv:2: 2 load cases: name one with --set case=NAME (EQX, EQY)$'
is "a case that is not there" gives 3 building import k.csv m.csv --set case=WIND
is "too" says 'k.csv:2: there is no load case "WIND" (EQX, EQY)'
is "the other direction alone has no stiffness" gives 3 building import k.csv m.csv --set case=EQX --set direction=Y
is "and its storey is named" says 'direction: Story1 has no stiffness in direction Y'
is "no direction" gives 2 building import k.csv m.csv --set direction=Z
is "which there are" says 'direction: "Z" is not a direction (X, Y)'
is "no masses" gives 3 building import k.csv --set case=EQX
is "they are asked for" says 'mass: the tables have no masses'
is "masses by load, and a strength" gives 0 building import k.csv --set case=EQX --set area=240m2 --set 'load=[8 kPa, 8 kPa, 8 kPa, 6 kPa]' --set yield-coefficient=12%
# W = 240 m2 x 30 kPa = 7.2 MN, V_y = 0.12 W, u_y = V_y/k
is "V_y, u_y and V_y/W" shows '^     1       3   195.79      600      7.2    0.864     1.44       12$'

sed 's/,UY/,Twist/; 3s/kg/pood/' m.csv >unit.csv
is "an unknown unit" gives 3 building import k.csv unit.csv --set case=EQX
is "is told with line, column and name" says 'unit.csv:3:2: UX: "pood" is not a unit of a length or a mass (m, cm,.* t, kg'
sed 's/Story2,320000/Story2,-320000/' m.csv >minus.csv
is "a negative mass" gives 3 building import k.csv minus.csv --set case=EQX
is "too" says 'minus.csv:6:8: UX: the mass of Story2 is -320000 (above 0)'
sed 's/320000,320000,0/320000,32a,0/' m.csv >word.csv
is "no number" gives 3 building import k.csv word.csv --set case=EQX
is "too" says 'word.csv:5:15: UY: "32a" is not a number'
sed 2d k.csv >bare.csv
is "no names of columns" gives 3 building import bare.csv m.csv
is "are asked for" says 'bare.csv: no row names the columns of a table of storeys (Story or Joint, and Stiff X'
sed '/^,,,/d' k.csv >none.csv
is "no units" gives 3 building import none.csv m.csv --set case=EQX
is "are asked for" says 'none.csv:2:51: Shear X: no unit is given here or below: the unit of a force is needed (N, kN'
{ cat k.csv && sed -n 4p k.csv; } >twice.csv
is "a storey twice" gives 3 building import twice.csv m.csv --set case=EQX
is "is told" says 'twice.csv:12:24: Shear X: a second value of Story4 (one row for each storey'
sed 's/Story2/Level2/' m.csv >other.csv
is "another building" gives 3 building import k.csv other.csv --set case=EQX
is "is told" says 'other.csv:6: "Level2" does not occur in the other table'
sed '/Story2/d' m.csv >less.csv
is "a floor without mass" gives 3 building import k.csv less.csv --set case=EQX
is "is told" says 'less.csv: mass: Story2 has no mass in direction X'

# semicolons, decimal commas, kips: 1200 kN is 269.7724 kip
cat >v.csv <<'END'
TABLE:  "Story Forces"
Story;Output Case;Case Type;Location;P;VX;VY;T
;;;;Kip;Kip;Kip;Kip-ft
Story2;COMB1;Combination;Top;1,0;0;0;12
Story2;COMB1;Combination;Bottom;1,0;-269,7724;0;12
Story1;COMB1;Combination;Bottom;1,0;-1.348,8622;0;12
END
printf 'Story;Diaphragm;Output Case;UX;UY\n;;;in;in\nStory2;D1;COMB1;0,472441;0\nStory1;D1;COMB1;0,393701;0\n' >u.csv
is "shears of one table and displacements of another" gives 0 building import v.csv u.csv --set mass=320t --csv
# 1200 kN over 2 mm, 6000 kN over 10 mm
is "the quotient is the stiffness below" shows '^A,1,3,320000,59999[89][0-9.]*,\|^A,1,3,320000,6000[0-9.]*,'
is "and above" shows '^A,2,3,320000,\(59999[0-9.]*\|6000[0-9.]*\),'
is "shears alone" gives 3 building import v.csv --set mass=320t
is "are no stiffness" says 'v.csv: direction: Story1 has no stiffness in direction X (a stiffness, or a shear or forces, and a drift or displacements)'
sed 's/COMB1;Combination/COMB1;Combination;Max/; s/Case Type/&;Step Type/; 3s/;;/;;;/' v.csv >max.csv
sed -n '/Bottom/s/;Max;/;Min;/p' max.csv >min.csv
cat min.csv >>max.csv
sed 's/D1;COMB1/D1;COMB1;Max/; s/Output Case/&;Step Type/; 2s/;;;/;;;;/' u.csv >umax.csv
is "largest and least of a combination" gives 3 building import max.csv umax.csv --set case=COMB1 --set mass=320t
is "are two" says '2 load cases: name one with --set case=NAME (COMB1 Max, COMB1 Min)'
is "of which one is named" gives 0 building import max.csv umax.csv --set 'case=COMB1 Max' --set mass=320t
printf 'Story,Stiff X (Tonf/m),UX (Tonf-s\302\262/m)\nRoof,61182.97,32.631\nL1,61182.97,32.631\n' >tonf.csv
is "metric tons, with units beside the names" gives 0 building import tonf.csv --csv
is "600 MN/m and 320 t" shows '^A,1,3,320000.*,5999999[0-9.]*,'

# three tables in kips and feet, as Excel saves them: the raised 2 is one byte. 17130.5 and 21927 lb s2/ft are 250 and 320 t
{
    printf 'TABLE:  Story Stiffness\nStory,Output Case,Case Type,Step Type,Step Number,Step Label,Shear X,Drift X,Stiff X,Shear Y,Drift Y,Stiff Y\n'
    printf ',,,,,,kip,in,kip/in,kip,in,kip/in\n'
    for storey in ROOF L3 L2 L1; do printf '%s,SPECX,LinRespSpec,Max,,,0,0,3426.09,0,0,0\n' $storey; done
} >ek.csv
printf 'TABLE:  Mass Summary by Story\nStory,UX,UY,UZ\n,lb-s\262/ft,lb-s\262/ft,lb-s\262/ft\nROOF,17130.5,17130.5,0\nL3,21927,21927,0\nL2,21927,21927,0\nL1,21927,21927,0\nBase,1027,1027,0\n' >em.csv
printf 'TABLE:  Story Definitions\nTower,Name,Height,Master Story,Similar To,Splice Story,Splice Height,Color\n,,ft,,,,ft,\n' >eh.csv
printf 'T1,ROOF,12,Yes,None,No,,Blue\nT1,L3,12,No,ROOF,No,,Blue\nT1,L2,12,No,ROOF,No,,Blue\nT1,L1,15,No,None,No,,Blue\n' >>eh.csv
is "three tables of kips and feet" gives 0 building import ek.csv em.csv eh.csv --set direction=x
is "are the same building" shows '^A: T1 0.3979 s, T2 0.1393 s'
is "with its heights, and no noise of their unit" shows '^    height: \[4.572 m, 3.6576 m, 3.6576 m, 3.6576 m\]$'
# SAP2000: one joint of each floor, in any order that rises
cat >sapu.csv <<'END'
TABLE:  "JOINT DISPLACEMENTS"
Joint;OutputCase;CaseType;StepType;StepNum;U1;U2;U3;R1;R2;R3
Text;Text;Text;Text;Unitless;m;m;m;Radians;Radians;Radians
12;PUSH;LinStatic;;;0,005;0;0;0;0;0
27;PUSH;LinStatic;;;0,0095;0;0;0;0;0
3;PUSH;LinStatic;;;0,013;0;0;0;0;0
41;PUSH;LinStatic;;;0,015;0;0;0;0;0
END
cat >sapf.csv <<'END'
TABLE:  "JOINT LOADS - FORCE"
Joint;LoadPat;CoordSys;F1;F2;F3;M1;M2;M3
Text;Text;Text;KN;KN;KN;KN-m;KN-m;KN-m
12;PUSH;GLOBAL;300;0;0;0;0;0
27;PUSH;GLOBAL;600;0;0;0;0;0
3;PUSH;GLOBAL;900;0;0;0;0;0
41;PUSH;GLOBAL;1.200,0;0;0;0;0;0
END
is "forces and displacements of joints" gives 0 building import sapu.csv sapf.csv --set 'mass=[320 t, 320 t, 320 t, 250 t]'
is "are the same building" shows '^A: T1 0.3979 s, T2 0.1393 s, T3 0.09232 s$'
is "from its lowest joint" shows '^storeys 12 to 41, direction X, case PUSH$'
printf 'Story;S1;S2\n;kN/m;kN/m\nS1;700.000,5;-350.000,0\nS2;-350.000,0;350.000,0\n' >comma.csv
is "a matrix with decimal commas" gives 0 building import comma.csv --set mass=320t
is "has its two periods" shows '^   2  '

printf 'Story,F1,F2\nkN/m,,\nF1,700000,-350000\nF2,-350000,350000\n' >floors.csv
is "a matrix whose floors are called as forces are" gives 0 building import floors.csv
is "is a matrix" shows '^stiffness matrix, kN/m; 2 floors'

# what is known: T of A is 0.39791 s, and goes with the root of the stiffness
is "cracked storeys" gives 0 building towers --set structures.1.cracked=0.5
is "half the stiffness" shows '^A: T1 0.5627 s'
is "in each row" shows '^     1       3      320      300    11.87$'
is "columns too" gives 0 run slab-against-columns --set structures.1.cracked=0.5 --json --quiet
is "uncracked with a period" gives 3 building towers --set structures.1.cracked=0.5 --set structures.1.period=0.9s
is "is a contradiction" says 'structures.1.cracked: the period gives the stiffness of the storeys as they are, cracked or not (period or cracked)'
is "a factor above 1" gives 3 building towers --set structures.1.cracked=1.5
is "is none" says 'structures.1.cracked: "1.5" is out of range (> 0, up to 1)\|structures.1.cracked: .*(> 0, up to 1)'
is "masses from area and load" gives 0 building towers --set structures.1.area=240m2 --set structures.1.load=8kPa --csv
is "240 m2 x 8 kPa is 1.92 MN" shows '^A,4,3,195785.5128[0-9.]*,600000000,19\(20000\|19999.9*[0-9]\),,,$'
is "a mass besides" gives 3 building towers --set structures.1.area=240m2 --set structures.1.load=8kPa --set structures.1.mass=300t
is "has no effect" says 'structures.1.mass: area and load of A give the masses of its floors'
is "an area alone" gives 3 building towers --set structures.1.area=240m2
is "needs a load" says 'structures.1.load: the load is not given (both give the masses: area: 240 m2, load: 8 kPa)'
is "a period of what is estimated" gives 0 building beside-unknown --set structures.2.period=0.5s
is "counts" shows '^B: T1 0.5 s'
is "and is no range any more" gives 0 gap beside-unknown --set structures.2.period=0.5s
is "of periods" [ "$(grep -c 'depending on the period' "$tmp/out")" -eq 0 ]
is "one stiffness of all storeys under a period" gives 3 sweep towers --set structures.1.period=0.9s --vary structures.1.stiffness=300MN/m:500MN/m:100MN/m
is "changes nothing" says 'structures.1.stiffness: the period of A, 0.9 s, gives the stiffness of its storeys: one value for all of them has no effect (structures.1.period'
is "that of one storey does" gives 0 building towers --set structures.1.period=0.9s --set structures.1.stiffness.1=300MN/m
is "at the same period" shows '^A: T1 0.9 s'
printf 'structures:\n  - {name: A, storeys: 2, mass: 300 t, stiffness: 500 MN/m, load: 8 kPa, area: 100 m2}\n' >both.yaml
is "a mass beside area and load in a preset" gives 3 building both.yaml
is "contradicts them, in its place" says 'both.yaml:2:33: structures.1.mass: area and load give another mass (mass, or area and load)'
cat >known.yaml <<'END'
structures:
  - {name: A, kind: shear, storeys: 3, period: 0.6 s, stiffness: 100 MN/m, load: [8 kPa, 8 kPa, 6 kPa], area: 200 m2, yield-coefficient: 10 %}
  - {name: B, kind: shear, storeys: 2, mass: 300 t, stiffness: 500 MN/m, cracked: 0.5}
record: {file: kobe-surrogate.csv, to: 2 s}
interfaces:
  - gap: 5 cm
analysis: {tail: 1 s}
END
is "a preset of all of them, in any order" gives 0 building known.yaml --csv
is "W is area times load" shows '^A,1,3,163154.5[0-9.]*,[0-9.]*,4400000,440000,'
is "its own JSON" gives 0 run known.yaml --json --quiet
sed -n '/"scene": {/,$p' out | sed '1s/.*/{/; $d' >again.yaml
is "is the same building" gives 0 building again.yaml --csv
cp out again.csv
"$THUD" building known.yaml --csv >known.csv
is "byte for byte" cmp -s again.csv known.csv
is "free bodies" gives 0 building rigid-concrete
is "have no storeys" shows '^No structure has storeys[.]$'
is "a scene as JSON" gives 0 building towers --json
is "with periods and storeys" shows '^    {"structure": "B", "storey": 6, "height_m": 3, "mass_kg": 250000, "stiffness_npm": 600000000, "weight_n": 2451662.5, "yield_shear_n": null'
