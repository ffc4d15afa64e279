#declare Ball = sphere { 0, 1 }
#declare Low = minextent(Ball);
