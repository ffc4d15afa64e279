sphere { 0, 1 }
/* one /* two */
