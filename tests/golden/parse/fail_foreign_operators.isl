#if (A == 1 && B || C) A % 2 #end
#declare D = 2 ^ 3;
