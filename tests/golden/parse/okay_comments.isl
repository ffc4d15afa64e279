// a line
/* a block /* with one nested */ still a comment */
sphere { <0, 0, 0>, 1 /* in between */ } // at the end