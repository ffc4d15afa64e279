#break
