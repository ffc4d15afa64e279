5
sphere { 0, 1 7 }
union { 3 }
;
