#macro Forever(N) Forever(N + 1) #end
Forever(0)
