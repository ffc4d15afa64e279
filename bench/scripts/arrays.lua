-- arrays.pov in Lua.
local count = 30000
local numbers = {}
local state = 1
for i = 0, count - 1 do
  state = state * 16807 % 2147483647
  numbers[i] = state
end
local gap = 1
while gap < count / 3 do
  gap = 3 * gap + 1
end
while gap >= 1 do
  for i = gap, count - 1 do
    local moved = numbers[i]
    local j = i - gap
    while j >= 0 and numbers[j] > moved do
      numbers[j + gap] = numbers[j]
      j = j - gap
    end
    numbers[j + gap] = moved
  end
  gap = gap // 3
end
local below = 300000
local crossed = {}
for i = 0, below - 1 do
  crossed[i] = 0
end
local primes = 0
for i = 2, below - 1 do
  if crossed[i] == 0 then
    primes = primes + 1
    for j = 2 * i, below - 1, i do
      crossed[j] = 1
    end
  end
end
print(string.format("%.0f %.0f %.0f", numbers[0], numbers[count // 2], primes))
