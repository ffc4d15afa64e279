#declare List = array[3] { 1, 2, 3 }
#macro Lose(N) #ifdef (List) #undef List #end N #end
#macro Take(N) #debug str(N, 0, 0) #end
Take(List[Lose(1)])
#declare List = array[3] { 1, 2, 3 }
#macro Shrink(N) #declare List = array[1] { 7 } N #end
Take(List[Shrink(2)])
#declare Table = array[2][2] { { 1, 2 }, { 3, 4 } }
#macro Lose_table(N) #ifdef (Table) #undef Table #end N #end
Take(Table[0][Lose_table(1)])
