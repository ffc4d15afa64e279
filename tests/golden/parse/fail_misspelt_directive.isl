#delcare A = 1;
#whlie (A < 3) A #edn
#frobnicate A
