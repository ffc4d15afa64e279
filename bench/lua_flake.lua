-- The flake of scenes/flake.pov in Lua 5.4, one table a component: the yardstick for isl's macros. Run by povray.sh.
--
--   lua5.4 bench/lua_flake.lua LEVELS vectors    vectors are tables with operators: the scene's loop as one writes it
--   lua5.4 bench/lua_flake.lua LEVELS numbers    coordinates are numbers in locals: only the components are tables
--
-- Prints: COMPONENTS components SECONDS seconds. The seconds are the processor's, for the loop alone.
local sqrt, sin, cos, acos, rad = math.sqrt, math.sin, math.cos, math.acos, math.rad

local levels, style = tonumber(arg[1]) or 5, arg[2] or "vectors"
local strength, support_per_radius = 9, sqrt(1.5)
local components = {}

-- V turned as +z would be turned to point along D: Rodrigues' formula about z × D.
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

local vector = {}
local function new_vector(x, y, z) return setmetatable({ x = x, y = y, z = z }, vector) end
vector.__add = function(a, b) return new_vector(a.x + b.x, a.y + b.y, a.z + b.z) end
vector.__mul = function(a, k) return new_vector(a.x * k, a.y * k, a.z * k) end

-- The nine directions in which a ball that points to +z bears children.
local directions = {}
local function add_direction(azimuth, elevation)
  directions[#directions + 1] = new_vector(cos(elevation) * cos(azimuth), cos(elevation) * sin(azimuth), sin(elevation))
end
for i = 0, 5 do add_direction(rad(15 + 60 * i), 0) end
for i = 0, 2 do add_direction(rad(45 + 120 * i), math.asin(sqrt(2 / 3))) end

local function flake_of_vectors(centre, radius, direction, level)
  components[#components + 1] = { centre = centre, radius = radius * support_per_radius, strength = strength }
  if level == levels then return end
  for i = 1, 9 do
    local v = directions[i]
    local child = new_vector(turned(v.x, v.y, v.z, direction.x, direction.y, direction.z))
    flake_of_vectors(centre + child * (radius * 4 / 3), radius / 3, child, level + 1)
  end
end

local function flake_of_numbers(x, y, z, radius, dx, dy, dz, level)
  components[#components + 1] = { x = x, y = y, z = z, radius = radius * support_per_radius, strength = strength }
  if level == levels then return end
  local reach = radius * 4 / 3
  for i = 1, 9 do
    local v = directions[i]
    local cx, cy, cz = turned(v.x, v.y, v.z, dx, dy, dz)
    flake_of_numbers(x + cx * reach, y + cy * reach, z + cz * reach, radius / 3, cx, cy, cz, level + 1)
  end
end

local begin = os.clock()
if style == "vectors" then
  flake_of_vectors(new_vector(0, 0, 0), 0.5, new_vector(0, 0, 1), 0)
else
  flake_of_numbers(0, 0, 0, 0.5, 0, 0, 1, 0)
end
print(string.format("%d components %.6f seconds", #components, os.clock() - begin))
