#fopen Out "x.txt" write
#write (Out, 1)
#macro Log() #fopen Log_file "log.txt" append #end
Log()
#fclose Out
