sphere { 0, 1 $ }
#debug “hello”
box { 0, 1 − 2 }
