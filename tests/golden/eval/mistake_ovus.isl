ovus { -1, .5 }
ovus { 1, -.5 }
ovus { 1 }
ovus { <1, 2>, 1 }
ovus { 1, .5 open }
ovus { 1, .5 hierarchy }
ovus { 1, 3 sturm }
ovus { 1, 1/0 }
