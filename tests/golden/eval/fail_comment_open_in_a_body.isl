// An error for POV-Ray 3.7 too, called or not: "No */ closing comment found".
#macro A() /* #end
