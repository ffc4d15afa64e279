// POV-Ray accepts it; here it gets a remark where it begins.
#debug "one
two\n"
