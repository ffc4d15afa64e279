#fopen Out "bad.txt" write  #write (Out, "1 2")  #fclose Out
#fopen In "bad.txt" read
#read (In, A)
#fopen In "bad.txt" read
#declare N = 3;
#fopen N "bad.txt" read
#write (In, 1)
#read (Out, A)
#read (N, A)
#fopen Out2 "bad.txt" write
#read (Out2, A)
#write (Out2, sphere { 0, 1 })
#write (Out2, uint8 "text")
#fopen Gone "none.txt" read
#fopen Gone2 "/etc/passwd" read
#read (In, 3)
#macro Inner() #fopen In3 "word.txt" read  #read (In3, A) #end
#fopen Out3 "word.txt" write  #write (Out3, "\nhello")  #fclose Out3
Inner()
