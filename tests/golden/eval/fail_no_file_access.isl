#fopen Handle "x.txt" write
#write (Handle, 1)
#fclose Handle
