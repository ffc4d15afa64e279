// Without a folder for it nothing is written to a disk; the run itself reads back what it wrote.
#macro Say(Text) #debug concat(Text, "\n") #end
#macro Say_number(N) Say(str(N, 0, 3)) #end
#macro Say_if_open(F) Say(concat("open: ", str(defined(F), 0, 0))) #end

#fopen Out "values.txt" write
Say_number(defined(Out))
#write (Out, 1/3, ",", 1e10, ",", -1e-10, ",", 123456789, ", ", pi, ",\"a \\\"word\\\"\",", <1, 2>, ",", x + y/3, ",", <1, 2, 3, 4>, ",", (2 > 1), "\n")
#write (Out, "//" "no" "commas" 1 2)
#fclose Out
Say_number(defined(Out))

#declare Kept = array[2];
#fopen In "values.txt" read
#read (In, A, B, Kept[0], Kept[1], C, Word, V2, V3, V4, Last)
Say_number(A) Say_number(B) Say_number(Kept[0]) Say_number(Kept[1]) Say_number(C) Say(Word)
Say(vstr(2, V2, " ", 0, 3)) Say(vstr(3, V3, " ", 0, 3)) Say(vstr(4, V4, " ", 0, 3)) Say_number(Last)
Say_number(defined(In))

// The end of the file closes it; what was asked for beyond stays what it was.
#fopen Out "few.txt" write  #write (Out, "1, -2, 3")  #fclose Out
#fopen In "few.txt" read
#declare Count = 0;
#while (defined(In))
  #read (In, A, B)
  #declare Count = Count + 1;
  Say_number(A) Say_number(B)
#end
Say_number(Count)
#ifdef (In) Say("still open") #end
#fclose In   // of what is closed there is nothing to close

// A comma at the end keeps it open until the next #read.
#fopen Out "few.txt" append  #write (Out, ",") #fclose Out
#fopen In "few.txt" read
#read (In, A, B, C)
Say_number(defined(In))
#read (In, Nothing)
Say_number(defined(In))
Say_number(defined(Nothing))

// #read writes what #declare would: the innermost binding, a parameter's caller, a new global name.
#macro Read_into(P) #fopen Inner "few.txt" read #local L = 5; #read (Inner, P, L, Fresh) Say_number(L) #end
#declare Q = 0;
#declare L = 7;
Read_into(Q)
Say_number(Q) Say_number(L) Say_number(Fresh) Say_number(defined(Inner))
#fclose Inner

// A file written by the run can be included by it.
#fopen Out "made.inc" write  #write (Out, "#declare Made = ", 6*7, ";")  #fclose Out
#include "made.inc"
Say_number(Made)
#fopen Out "made.inc" write  #write (Out, "#declare Made = ", 43, ";")  #fclose Out
#include "made.inc"
Say_number(Made)
Say_number(file_exists("made.inc")) Say_number(file_exists("okay_files_lenient.isl")) Say_number(file_exists("none.inc")) Say_number(file_exists("/etc/passwd"))
