#declare V = <1, 2, 3>;
#declare S = "text";
sphere { 0, V }
sphere { S, 1 }
#declare A = V + S;
#declare B = V.transmit;
#declare C = (V < 2);
#declare D = S.x;
