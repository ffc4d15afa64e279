-- numbers.pov in Lua.
local width, height = 400, 300
local total = 0
for row = 0, height - 1 do
  local ci = row / height * 2.4 - 1.2
  for column = 0, width - 1 do
    local cr = column / width * 3.2 - 2.2
    local zr, zi, turns = 0, 0, 0
    while turns < 25 and zr * zr + zi * zi < 4 do
      local next = zr * zr - zi * zi + cr
      zi = 2 * zr * zi + ci
      zr = next
      turns = turns + 1
    end
    total = total + turns
  end
end
print(string.format("%.0f", total))
