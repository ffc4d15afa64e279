#declare Corner = <4, 5, 6>;
#declare Flat = Corner.xy;
