// Applied in the order in which they are written.
#declare Turn = transform { rotate 90*y translate x }
sphere { 0, 1 translate x rotate 90*z }
sphere { 0, 1 scale <1, 2, 3> matrix <1, 0, 0, 0, 1, 0, 0.5, 0, 1, 0, 0, 2> }
sphere { 0, 1 transform { Turn } }
sphere { 0, 1 transform Turn transform { Turn inverse } }
