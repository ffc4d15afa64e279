// Objects that are declared and not placed are not in the database.
#declare Unused = blob { kernel "quartic" sphere { 0, 1 pigment { rgb x } } }
#declare Used = sphere { 0, 2 pigment { rgb y } }
#declare Unused2 = union { sphere { 0, 3 } sphere { 0, 4 } }
Used
