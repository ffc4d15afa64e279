// Each strip is compressed by itself, with the end of the one before as its dictionary, and ends on a whole byte. So
// the strips one after the other are one stream (as in M. Adler's pigz).
//
// The filters and the level were chosen by measurements on rendered pictures of 0.8 to 1 million pixels, 8 and 16 bits.
// Choosing between `sub` and `up` row by row, by the least sum of magnitudes, gives files as small as choosing among
// all five filters (`paeth` and `average` hardly ever win on pictures without grain). zlib's level 4, its first with
// lazy matching, takes a third to two thirds of the time of level 6; files grow by 1 to 8 %. The strategy for filtered
// data, which does not look for short repetitions, makes these files a tenth larger.
#include "renderer/image/png_data.h"

#include <zlib.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <thread>

namespace isl::render {
namespace {

constexpr int kLevel = 4;
constexpr int kStrategy = Z_DEFAULT_STRATEGY;
constexpr int kWindowBits = 15, kMemoryLevel = 8;  ///< zlib's own choices
constexpr std::size_t kWindow = std::size_t{1} << kWindowBits;
constexpr unsigned char kSub = 1, kUp = 2;

/// A strip is long enough that its own start (a window of text that is filtered twice) does not count, and short enough
/// that every core gets some.
constexpr std::size_t kStripBytes = std::size_t{1} << 19;

/// Filters one row after the other.
class Rows {
 public:
  Rows(const IslImage& image, int y)
      : image_(image),
        value_bytes_(image.planes[0].type == ISL_UINT8 ? 1 : 2),
        pixel_bytes_(value_bytes_ * static_cast<std::size_t>(image.plane_count)),
        y_(static_cast<std::size_t>(y)),
        above_(pixel_bytes_ * static_cast<std::size_t>(image.width)),
        row_(above_.size()),
        sub_(above_.size() + 1, kSub),
        up_(above_.size() + 1, kUp) {
    if (y_ > 0) interleave(y_ - 1, above_);
  }

  /// The next row: the filter's number, then the bytes. Valid until the next call.
  const std::vector<unsigned char>& next() {
    interleave(y_++, row_);
    // These are plain loops over plain pointers, which compilers turn into vectors.
    const std::size_t size = row_.size();
    const unsigned char *const row = row_.data(), *const above = above_.data();
    unsigned char *const sub = sub_.data() + 1, *const up = up_.data() + 1;
    std::copy(row, row + pixel_bytes_, sub);
    for (std::size_t i = pixel_bytes_; i < size; ++i)
      sub[i] = static_cast<unsigned char>(row[i] - row[i - pixel_bytes_]);
    for (std::size_t i = 0; i < size; ++i) up[i] = static_cast<unsigned char>(row[i] - above[i]);
    const bool is_sub = magnitudes(sub, size) < magnitudes(up, size);
    row_.swap(above_);
    return is_sub ? sub_ : up_;
  }

 private:
  /// The sum of the magnitudes of the bytes, taken as differences modulo 256.
  static std::uint64_t magnitudes(const unsigned char* values, std::size_t size) {
    std::uint64_t sum = 0;
    constexpr std::size_t kBlock = 4096;  // the sum of a block fits into 32 bits, so that more sums fit into a register
    for (std::size_t begin = 0; begin < size; begin += kBlock) {
      std::uint32_t block = 0;
      for (std::size_t i = begin; i < std::min(begin + kBlock, size); ++i)
        block += values[i] < 128 ? values[i] : 256u - values[i];
      sum += block;
    }
    return sum;
  }

  /// Writes one row of all planes, channel beside channel, the high byte first.
  void interleave(std::size_t y, std::vector<unsigned char>& row) const {
    const auto width = static_cast<std::size_t>(image_.width);
    for (std::size_t channel = 0; channel < static_cast<std::size_t>(image_.plane_count); ++channel) {
      unsigned char* out = row.data() + channel * value_bytes_;
      const void* const values = image_.planes[channel].values;
      if (value_bytes_ == 1) {
        const auto* const value = static_cast<const unsigned char*>(values) + y * width;
        for (std::size_t x = 0; x < width; ++x, out += pixel_bytes_) *out = value[x];
      } else {
        const auto* const value = static_cast<const unsigned short*>(values) + y * width;
        for (std::size_t x = 0; x < width; ++x, out += pixel_bytes_) {
          out[0] = static_cast<unsigned char>(value[x] >> 8);
          out[1] = static_cast<unsigned char>(value[x] & 0xFF);
        }
      }
    }
  }

  const IslImage& image_;
  std::size_t value_bytes_, pixel_bytes_;
  std::size_t y_;  ///< the next row
  std::vector<unsigned char> above_, row_, sub_, up_;
};

/// Rows y0 ≤ y < y1 and their compressed bytes.
struct Strip {
  int y0 = 0, y1 = 0;
  bool is_last = false;
  std::vector<unsigned char> bytes;
  uLong checksum = 0;
  std::size_t raw_bytes = 0;
};

/// zlib's compressor without a header, since strips have none.
class Deflater {
 public:
  Deflater() {
    if (deflateInit2(&stream_, kLevel, Z_DEFLATED, -kWindowBits, kMemoryLevel, kStrategy) != Z_OK)
      throw std::bad_alloc();
  }
  ~Deflater() { deflateEnd(&stream_); }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;

  void set_dictionary(const std::vector<unsigned char>& text) {
    deflateSetDictionary(&stream_, text.data(), static_cast<uInt>(text.size()));
  }
  /// Precondition: `out` has as much room from `used` on as room_for() returns.
  void add(const std::vector<unsigned char>& text, int flush, std::vector<unsigned char>& out, std::size_t& used) {
    stream_.next_in = const_cast<Bytef*>(text.data());  // zlib's type; zlib only reads it
    stream_.avail_in = static_cast<uInt>(text.size());
    stream_.next_out = out.data() + used;
    stream_.avail_out = static_cast<uInt>(out.size() - used);
    deflate(&stream_, flush);
    used = out.size() - stream_.avail_out;
  }
  /// The room that this many bytes of text and the mark of a flush need.
  [[nodiscard]] std::size_t room_for(std::size_t text) { return deflateBound(&stream_, static_cast<uLong>(text)) + 16; }

 private:
  z_stream stream_{};
};

/// The end of the filtered text before the strip, as far back as the compressor can look.
std::vector<unsigned char> text_before(const IslImage& image, const Strip& strip, std::size_t row_bytes) {
  const int rows = std::min(strip.y0, static_cast<int>((kWindow + row_bytes - 1) / row_bytes));
  std::vector<unsigned char> text;
  Rows before(image, strip.y0 - rows);
  for (int i = 0; i < rows; ++i) {
    const std::vector<unsigned char>& row = before.next();
    text.insert(text.end(), row.begin(), row.end());
  }
  if (text.size() > kWindow) text.erase(text.begin(), text.end() - kWindow);
  return text;
}

void compress(const IslImage& image, std::size_t row_bytes, Strip& strip) {
  Deflater deflater;
  if (strip.y0 > 0) deflater.set_dictionary(text_before(image, strip, row_bytes));
  strip.raw_bytes = row_bytes * static_cast<std::size_t>(strip.y1 - strip.y0);
  strip.bytes.resize(deflater.room_for(strip.raw_bytes));
  strip.checksum = adler32(0, nullptr, 0);
  std::size_t used = 0;
  Rows rows(image, strip.y0);
  for (int y = strip.y0; y < strip.y1; ++y) {
    const std::vector<unsigned char>& row = rows.next();
    strip.checksum = adler32(strip.checksum, row.data(), static_cast<uInt>(row.size()));
    const int flush = y + 1 < strip.y1 ? Z_NO_FLUSH : strip.is_last ? Z_FINISH : Z_SYNC_FLUSH;
    deflater.add(row, flush, strip.bytes, used);
  }
  strip.bytes.resize(used);
}

std::vector<Strip> strips_of(const IslImage& image, std::size_t row_bytes) {
  const int rows = static_cast<int>(std::max<std::size_t>(1, kStripBytes / row_bytes));
  std::vector<Strip> strips;
  for (int y = 0; y < image.height; y += rows) {
    Strip& strip = strips.emplace_back();
    strip.y0 = y;
    strip.y1 = std::min(y + rows, image.height);
    strip.is_last = strip.y1 == image.height;
  }
  return strips;
}

void compress_all(const IslImage& image, std::size_t row_bytes, int threads, std::vector<Strip>& strips) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::exception_ptr> failures(strips.size());
  const auto work = [&] {
    for (std::size_t i = next++; i < strips.size(); i = next++) {
      try {
        compress(image, row_bytes, strips[i]);
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
  };
  std::vector<std::thread> helpers;
  for (std::size_t i = 1; i < std::min(static_cast<std::size_t>(threads), strips.size()); ++i)
    helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace

std::vector<std::vector<unsigned char>> png_data(const IslImage& image, int threads) {
  const std::size_t value_bytes = image.planes[0].type == ISL_UINT8 ? 1 : 2;
  const std::size_t row_bytes =
      1 + static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.plane_count) * value_bytes;
  std::vector<Strip> strips = strips_of(image, row_bytes);
  compress_all(image, row_bytes, threads, strips);

  // The stream begins as in RFC 1950 (a window of 32 kB, a fast level, no preset dictionary) and ends with Adler's
  // checksum.
  std::vector<std::vector<unsigned char>> pieces{{0x78, 0x5E}};
  uLong checksum = adler32(0, nullptr, 0);
  for (Strip& strip : strips) {
    checksum = adler32_combine(checksum, strip.checksum, static_cast<z_off_t>(strip.raw_bytes));
    pieces.push_back(std::move(strip.bytes));
  }
  pieces.front().insert(pieces.front().end(), pieces[1].begin(), pieces[1].end());
  pieces.erase(pieces.begin() + 1);
  for (int shift = 24; shift >= 0; shift -= 8)
    pieces.back().push_back(static_cast<unsigned char>(checksum >> shift & 0xFF));
  return pieces;
}

}  // namespace isl::render
