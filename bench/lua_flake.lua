-- The flake of scenes/flake.pov in Lua 5.4: one table a component. The yardstick for isl's macros; run by povray.sh.
--
--   lua5.4 bench/lua_flake.lua LEVELS     prints: COMPONENTS components SECONDS seconds
--
-- Written to run fast: coordinates are plain numbers in locals, so that the only tables made are the components.
local sqrt, sin, cos, acos, rad = math.sqrt, math.sin, math.cos, math.acos, math.rad

local levels = tonumber(arg[1]) or 5
local strength, support_per_radius = 9, sqrt(1.5)

-- The nine directions in which a ball that points to +z bears children, flat: x, y, z, x, y, z, …
local directions = {}
local function add_direction(azimuth, elevation)
  local n = #directions
  directions[n + 1] = cos(elevation) * cos(azimuth)
  directions[n + 2] = cos(elevation) * sin(azimuth)
  directions[n + 3] = sin(elevation)
end
for i = 0, 5 do add_direction(rad(15 + 60 * i), 0) end
for i = 0, 2 do add_direction(rad(45 + 120 * i), math.asin(sqrt(2 / 3))) end

-- (vx, vy, vz) turned as +z would be turned to point along (dx, dy, dz): Rodrigues' formula about z × d.
local function turned(vx, vy, vz, dx, dy, dz)
  if dz >= 0.9999 then return vx, vy, vz end
  if dz <= -0.9999 then return -vx, vy, -vz end
  local length = sqrt(dx * dx + dy * dy)
  local ax, ay = -dy / length, dx / length
  local angle = acos(dz)
  local c, s = cos(angle), sin(angle)
  local along = (ax * vx + ay * vy) * (1 - c)
  return vx * c + ay * vz * s + ax * along, vy * c - ax * vz * s + ay * along, vz * c + (ax * vy - ay * vx) * s
end

local components = {}
local function flake(x, y, z, radius, dx, dy, dz, level)
  components[#components + 1] = { x = x, y = y, z = z, radius = radius * support_per_radius, strength = strength }
  if level == levels then return end
  local reach = radius * 4 / 3
  for i = 1, 27, 3 do
    local cx, cy, cz = turned(directions[i], directions[i + 1], directions[i + 2], dx, dy, dz)
    flake(x + cx * reach, y + cy * reach, z + cz * reach, radius / 3, cx, cy, cz, level + 1)
  end
end

local begin = os.clock()
flake(0, 0, 0, 0.5, 0, 0, 1, 0)
print(string.format("%d components %.6f seconds", #components, os.clock() - begin))

-- LEVELS and a second word: the components too, to compare them with isl's.
if arg[2] == "list" then
  for _, c in ipairs(components) do
    print(string.format("%.6f %.6f %.6f %.6f", c.x, c.y, c.z, c.radius))
  end
end
