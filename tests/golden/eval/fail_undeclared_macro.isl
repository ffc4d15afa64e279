#macro Branch(N) #end
#declare A = Brunch(1);
