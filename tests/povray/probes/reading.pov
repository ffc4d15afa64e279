// #fopen, #read, #fclose, file_exists: values of every kind, the end of a file, reading it again.
#version 3.7;
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 9), "\n") #end
#fopen In "reading.csv" read
#read (In, A, B, C, D, E)
Say("one", A) Say("minus", B) Say("much", C) Say("a quarter", D) Say("a point alone", E)
#read (In, V, W, K)
#debug concat(vstr(3, V, " ", 0, 3), " / ", vstr(2, W, " ", 0, 3), " / ", vstr(5, K, " ", 0, 3), "\n")
#read (In, S)
#debug concat("[", S, "]\n")
#read (In, S, T, N)
#debug concat("[", S, "] [", T, "] ", str(N, 0, 0), "\n")
#ifdef (In) Say("open", 1) #else Say("open", 0) #end
#read (In, S, N)
#debug concat("[", S, "] ", str(N, 0, 0), "\n")
#ifdef (In) Say("at the end", 1) #else Say("at the end", 0) #end
#declare Count = 0;
#fopen In "reading.csv" read
#while (defined(In)) #ifdef (X) #undef X #end #read (In, X) #declare Count = Count + 1; #end
Say("values until the end", Count)
#fopen In "reading.csv" read
#fopen Again "reading.csv" read
#read (In, A, B) #read (Again, C)
Say("two at once", A + 10*B + 100*C)
#fclose In
#fclose Again
#ifdef (In) Say("closed", 0) #else Say("closed", 1) #end
#declare Table = array[4] { 0, 0, 0, 0 }
#fopen In "reading.csv" read
#for (I, 0, 3, 2) #read (In, Table[I], Table[I+1]) #end
#fclose In
Say("into an array", Table[1] + 10*Table[3])
#macro Take(P) #fopen In "reading.csv" read #read (In, P) #fclose In #end
#declare Taken = 5;
Take(Taken)
Say("into a parameter", Taken)
Say("exists", file_exists("reading.csv"))
Say("does not exist", file_exists("no_such_file.csv"))
#declare File = concat("read", "ing.csv");
#fopen In File read #read (In, A) #fclose In
Say("a name from a variable", A)
