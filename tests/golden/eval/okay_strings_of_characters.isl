// Characters are counted, not bytes.
#macro Say(V) #debug concat(str(V, 0, 0), "\n") #end
Say(strlen("h\u00e9\u20ac"))
Say(asc("\u20ac"))
#debug concat(substr("h\u00e9\u20acy", 2, 2), chr(233), "\n")
Say(strcmp("\u00e9", "z"))
#debug concat(datetime(7305.5), "\n")
