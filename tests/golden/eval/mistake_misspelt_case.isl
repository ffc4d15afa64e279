#declare BallSize = 1;
sphere { 0, Ballsize }
