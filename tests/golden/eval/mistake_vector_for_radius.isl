#declare Middle = <1, 2, 3>;
sphere { 0, Middle }
