#macro Inner(R) sphere { 0, Missing } #end
#macro Outer(R) Inner(R) #end
Outer(1)
