-- strings.pov in Lua.
local state, vowels, same = 1, 0, 0
local turned
for line = 1, 5000 do
  local text = ""
  for i = 1, 40 do
    state = (state * 421 + 1663) % 7875
    text = text .. string.char(65 + state % 26)
  end
  turned = ""
  for i = #text, 1, -1 do
    local letter = text:sub(i, i)
    if letter == "A" or letter == "E" or letter == "I" or letter == "O" or letter == "U" then
      vowels = vowels + 1
    end
    turned = turned .. letter
  end
  if turned:lower() == text:lower() then
    same = same + 1
  end
end
print(string.format("%.0f %.0f %s", vowels, same, turned))
