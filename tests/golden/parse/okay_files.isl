#fopen Out concat("a", ".txt") write
#write (Out, 1, ", ", <1, 2, 3>, "\n")
#write (Out uint8 [1, 2])
#fclose Out
#fopen In "a.txt" read
#read (In, A, B[1])
