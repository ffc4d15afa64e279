#declare A = ( #local B = 2; );
#declare C = ( #local D = 2 D*3 );
#declare E = ( #local F = 2; F F );
