-- calls.pov in Lua.
local function fibonacci(n)
  if n < 2 then
    return n
  else
    return fibonacci(n - 1) + fibonacci(n - 2)
  end
end
local function turn(x, y, angle)
  return x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle)
end
local total = fibonacci(27)
local px, py = 1, 0
for i = 1, 200000 do
  px, py = turn(px, py, 0.001)
end
print(string.format("%.0f %.6f %.6f", total, px, py))
