// How long Embree takes for the camera rays of a picture of spheres and round cones, on one thread: a yardstick for
// isl's own. Reads from standard input, whitespace between numbers:
//
//   camera  location direction right up (three numbers each), as `isl dump --stage database` has them
//   sphere  centre radius
//   cone    end_a radius_a end_b radius_b
//
// and prints: solids, seconds to build, processor seconds of single rays (rtcIntersect1) and of packets of 16
// (rtcIntersect16, as the lanes of a row of pixels), the share of rays that meet something.
//
// Embree's cone with flat ends (RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE) is no hull of two spheres; its round linear curve
// is: the same solid that isl has, with an even surface where limbs join. Spheres are its sphere points. Rays are
// single precision, as Embree has no other.
//
//   embree_solids WIDTH HEIGHT REPEATS < solids.txt
#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace {

using Vec3 = std::array<double, 3>;
/// x, y, z and radius: what Embree calls a vertex of a curve or point.
using Ball = std::array<float, 4>;

struct Camera {
  Vec3 location{}, direction{}, right{}, up{};
};

struct Input {
  Camera camera;
  std::vector<Ball> spheres;
  std::vector<Ball> cone_ends;  ///< two a cone
};

[[noreturn]] void fail(const std::string& message) {
  std::cerr << "embree_solids: " << message << '\n';
  std::exit(1);
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Vec3 read_vector(std::istream& in) {
  Vec3 v{};
  in >> v[0] >> v[1] >> v[2];
  return v;
}

Ball read_ball(std::istream& in) {
  Ball ball{};
  in >> ball[0] >> ball[1] >> ball[2] >> ball[3];
  return ball;
}

Input read_input(std::istream& in) {
  Input input;
  for (std::string word; in >> word;) {
    if (word == "camera") {
      input.camera.location = read_vector(in);
      input.camera.direction = read_vector(in);
      input.camera.right = read_vector(in);
      input.camera.up = read_vector(in);
    } else if (word == "sphere") {
      input.spheres.push_back(read_ball(in));
    } else if (word == "cone") {
      input.cone_ends.push_back(read_ball(in));
      input.cone_ends.push_back(read_ball(in));
    } else {
      fail("unknown word " + word);
    }
    if (!in) fail("a number is missing after " + word);
  }
  return input;
}

/// Copies into a buffer that Embree pads as it needs.
template <class T>
void set_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const std::vector<T>& values) {
  auto* const buffer = static_cast<T*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), values.size()));
  if (buffer == nullptr) fail("no memory for a buffer");
  std::copy(values.begin(), values.end(), buffer);
}

void attach(RTCDevice device, RTCScene scene, RTCGeometryType type, const std::vector<Ball>& balls) {
  if (balls.empty()) return;
  RTCGeometry geometry = rtcNewGeometry(device, type);
  set_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, balls);
  if (type == RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE) {
    std::vector<unsigned> firsts;  // a curve goes from its first vertex to the one behind it
    for (unsigned i = 0; i < balls.size(); i += 2) firsts.push_back(i);
    set_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, firsts);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

struct Rays {
  std::vector<Vec3> directions;
  Vec3 origin;
};

/// Through the middles of the pixels, row by row from the top, of length 1.
Rays camera_rays(const Camera& camera, int width, int height) {
  Rays rays{{}, camera.location};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double u = (x + 0.5) / width - 0.5, v = 0.5 - (y + 0.5) / height;
      Vec3 d{};
      double length2 = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        d[i] = camera.direction[i] + u * camera.right[i] + v * camera.up[i];
        length2 += d[i] * d[i];
      }
      for (double& component : d) component /= std::sqrt(length2);
      rays.directions.push_back(d);
    }
  }
  return rays;
}

constexpr float kFar = std::numeric_limits<float>::infinity();

std::size_t trace_singly(RTCScene scene, const Rays& rays) {
  std::size_t hits = 0;
  for (const Vec3& d : rays.directions) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit ray{};
    ray.ray = {static_cast<float>(rays.origin[0]),
               static_cast<float>(rays.origin[1]),
               static_cast<float>(rays.origin[2]),
               0,
               static_cast<float>(d[0]),
               static_cast<float>(d[1]),
               static_cast<float>(d[2]),
               0,
               kFar,
               ~0U,
               0,
               0};
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context, &ray);
    hits += ray.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
  }
  return hits;
}

constexpr std::size_t kPacket = 16;

std::size_t trace_packets(RTCScene scene, const Rays& rays) {
  std::size_t hits = 0;
  for (std::size_t first = 0; first < rays.directions.size(); first += kPacket) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    RTCRayHit16 packet{};
    alignas(64) std::array<int, kPacket> valid{};
    const std::size_t count = std::min(kPacket, rays.directions.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3& d = rays.directions[first + i];
      valid[i] = -1;
      packet.ray.org_x[i] = static_cast<float>(rays.origin[0]);
      packet.ray.org_y[i] = static_cast<float>(rays.origin[1]);
      packet.ray.org_z[i] = static_cast<float>(rays.origin[2]);
      packet.ray.dir_x[i] = static_cast<float>(d[0]);
      packet.ray.dir_y[i] = static_cast<float>(d[1]);
      packet.ray.dir_z[i] = static_cast<float>(d[2]);
      packet.ray.tfar[i] = kFar;
      packet.ray.mask[i] = ~0U;
      packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid.data(), scene, &context, &packet);
    for (std::size_t i = 0; i < count; ++i) hits += packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
  }
  return hits;
}

/// Median of `repeats` processor seconds of `trace`; `hits` is what the last returned.
template <class Trace>
double median_seconds(int repeats, std::size_t& hits, const Trace& trace) {
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i) {
    const double begin = processor_seconds();
    hits = trace();
    seconds.push_back(processor_seconds() - begin);
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) fail("usage: embree_solids WIDTH HEIGHT REPEATS < solids.txt");
  const int width = std::atoi(argv[1]), height = std::atoi(argv[2]), repeats = std::atoi(argv[3]);
  if (width < 1 || height < 1 || repeats < 1) fail("width, height and repeats are at least 1");
  const Input input = read_input(std::cin);

  RTCDevice device = rtcNewDevice("threads=1");
  if (device == nullptr) fail("no device");
  RTCScene scene = rtcNewScene(device);
  const double begin = processor_seconds();
  attach(device, scene, RTC_GEOMETRY_TYPE_SPHERE_POINT, input.spheres);
  attach(device, scene, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE, input.cone_ends);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  rtcCommitScene(scene);
  const double built = processor_seconds() - begin;
  if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE) fail("Embree reports an error");

  const Rays rays = camera_rays(input.camera, width, height);
  std::size_t hits = 0, packet_hits = 0;
  const double single = median_seconds(repeats, hits, [&] { return trace_singly(scene, rays); });
  const double packets = median_seconds(repeats, packet_hits, [&] { return trace_packets(scene, rays); });
  if (hits > packet_hits + packet_hits / 1000 || packet_hits > hits + hits / 1000) fail("packets meet something else");
  std::printf("%zu %.6f %.6f %.6f %.6f\n", input.spheres.size() + input.cone_ends.size() / 2, built, single, packets,
              static_cast<double>(hits) / static_cast<double>(rays.directions.size()));
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}
