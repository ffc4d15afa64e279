#debug "a \"quote\", a \\ and a tab\t and \u00e9"
#debug "two
lines"
#debug ""
