#include "renderer/image/gif_file.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace isl::render {
namespace {

constexpr int kMostCodes = 4096;  // codes have at most 12 bits

/// Takes codes of a varying number of bits from bytes, the lowest bit first.
class CodeStream {
 public:
  explicit CodeStream(std::span<const unsigned char> bytes) : bytes_(bytes) {}

  /// −1 at the end.
  int next(int bits) {
    while (count_ < bits) {
      if (at_ == bytes_.size()) return -1;
      waiting_ |= static_cast<unsigned>(bytes_[at_++]) << count_;
      count_ += 8;
    }
    const int code = static_cast<int>(waiting_ & ((1u << bits) - 1));
    waiting_ >>= bits;
    count_ -= bits;
    return code;
  }

 private:
  std::span<const unsigned char> bytes_;
  std::size_t at_ = 0;
  unsigned waiting_ = 0;
  int count_ = 0;
};

/// An interlaced picture has its rows in this order: every 8th from 0, every 8th from 4, every 4th from 2, every 2nd
/// from 1.
std::vector<int> row_order(int height, bool is_interlaced) {
  std::vector<int> rows;
  constexpr std::array<std::pair<int, int>, 4> kPasses{{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
  if (is_interlaced) {
    for (const auto& [first, step] : kPasses) {
      for (int row = first; row < height; row += step) rows.push_back(row);
    }
  } else {
    for (int row = 0; row < height; ++row) rows.push_back(row);
  }
  return rows;
}

/// Each code stands for the string of another one and one number more.
class CodeTable {
 public:
  explicit CodeTable(int first_bits) : clear_(1 << first_bits), bits_(first_bits + 1), free_(clear_ + 2) {
    for (int i = 0; i < clear_; ++i) entries_[static_cast<std::size_t>(i)] = {-1, static_cast<unsigned char>(i), 1};
  }
  [[nodiscard]] int clear_code() const { return clear_; }
  [[nodiscard]] int end_code() const { return clear_ + 1; }
  [[nodiscard]] int bits() const { return bits_; }
  [[nodiscard]] int first_free() const { return free_; }
  void clear(int first_bits) {
    bits_ = first_bits + 1;
    free_ = clear_ + 2;
  }
  void add(int before, unsigned char number) {
    if (free_ == kMostCodes) return;
    entries_[static_cast<std::size_t>(free_++)] = {before, number,
                                                   entries_[static_cast<std::size_t>(before)].length + 1};
    if (free_ == 1 << bits_ && bits_ < 12) ++bits_;
  }
  [[nodiscard]] unsigned char first_of(int code) const {
    while (at(code).before >= 0) code = at(code).before;
    return at(code).number;
  }
  [[nodiscard]] int length(int code) const { return at(code).length; }
  /// Calls write(position in the string, number), from the last number to the first.
  template <class Write>
  void spell(int code, Write&& write) const {
    for (int position = length(code) - 1; code >= 0; code = at(code).before, --position)
      write(position, at(code).number);
  }

 private:
  struct Entry {
    int before;
    unsigned char number;
    int length;
  };
  [[nodiscard]] const Entry& at(int code) const { return entries_[static_cast<std::size_t>(code)]; }

  std::array<Entry, kMostCodes> entries_{};
  int clear_, bits_, free_;
};

}  // namespace

GifFile::GifFile(std::span<const unsigned char> bytes) : rest_(bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), std::min<std::size_t>(bytes.size(), 6));
  if (text != "GIF87a" && text != "GIF89a") {
    error_ = "it is not a GIF file";
    return;
  }
  rest_ = rest_.subspan(6);
  if (!read_header() && error_.empty()) error_ = "the file ends too early";
}

std::optional<int> GifFile::byte() {
  if (rest_.empty()) return std::nullopt;
  const int value = rest_.front();
  rest_ = rest_.subspan(1);
  return value;
}

std::optional<int> GifFile::word() {
  const auto low = byte(), high = byte();
  if (!low || !high) return std::nullopt;
  return *low | *high << 8;
}

bool GifFile::read_palette(int flags) {
  constexpr int kHasPalette = 0x80;
  if ((flags & kHasPalette) == 0) return true;
  const std::size_t size = std::size_t{2} << (flags & 7);
  if (rest_.size() < 3 * size) return false;
  palette_.clear();
  for (std::size_t i = 0; i < size; ++i) palette_.push_back({rest_[3 * i], rest_[3 * i + 1], rest_[3 * i + 2], 255});
  rest_ = rest_.subspan(3 * size);
  return true;
}

bool GifFile::skip_blocks() {
  for (;;) {
    const auto size = byte();
    if (!size || rest_.size() < static_cast<std::size_t>(*size)) return false;
    if (*size == 0) return true;
    rest_ = rest_.subspan(static_cast<std::size_t>(*size));
  }
}

bool GifFile::read_extension() {
  constexpr int kGraphicControl = 0xf9, kHasTransparent = 1;
  const auto kind = byte();
  if (!kind) return false;
  if (*kind == kGraphicControl && rest_.size() >= 5 && (rest_[1] & kHasTransparent) != 0) transparent_ = rest_[4];
  return skip_blocks();
}

bool GifFile::read_header() {
  constexpr int kExtension = 0x21, kPicture = 0x2c, kInterlaced = 0x40;
  const auto screen_width = word(), screen_height = word();
  const auto flags = byte(), background = byte(), aspect = byte();
  if (!screen_width || !screen_height || !flags || !background || !aspect || !read_palette(*flags)) return false;
  for (;;) {
    const auto mark = byte();
    if (!mark) return false;
    if (*mark == kExtension) {
      if (!read_extension()) return false;
      continue;
    }
    if (*mark != kPicture) {
      error_ = "it holds no picture";
      return false;
    }
    const auto left = word(), top = word(), width = word(), height = word();
    const auto picture_flags = byte();
    if (!left || !top || !width || !height || !picture_flags || !read_palette(*picture_flags)) return false;
    if (palette_.empty()) {
      error_ = "it has no palette";
      return false;
    }
    width_ = *width;
    height_ = *height;
    is_interlaced_ = (*picture_flags & kInterlaced) != 0;
    if (transparent_ >= 0 && transparent_ < static_cast<int>(palette_.size()))
      palette_[static_cast<std::size_t>(transparent_)][3] = 0;
    return true;
  }
}

std::vector<unsigned char> GifFile::codes() {
  std::vector<unsigned char> all;
  for (;;) {
    const auto size = byte();
    if (!size || *size == 0) return all;
    const std::size_t count = std::min(rest_.size(), static_cast<std::size_t>(*size));
    all.insert(all.end(), rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(count));
    rest_ = rest_.subspan(count);
  }
}

bool GifFile::read(std::span<std::byte> numbers) {
  const auto fail = [this](const char* why) {
    error_ = why;
    return false;
  };
  const auto first_bits = byte();
  if (!first_bits || *first_bits < 1 || *first_bits > 8) return fail("its pixels are broken");
  const std::vector<unsigned char> all = codes();
  CodeStream stream(all);
  CodeTable table(*first_bits);
  const std::vector<int> rows = row_order(height_, is_interlaced_);
  const auto width = static_cast<std::size_t>(width_);
  std::size_t done = 0;
  int last = -1;
  while (done < numbers.size()) {
    const int code = stream.next(table.bits());
    if (code < 0 || code == table.end_code()) return fail("the file ends too early");
    if (code == table.clear_code()) {
      table.clear(*first_bits);
      last = -1;
      continue;
    }
    // A code that is not in the table yet is the one that this step adds.
    if (code > table.first_free() || (last < 0 && code >= table.clear_code())) return fail("its pixels are broken");
    if (last >= 0) table.add(last, table.first_of(code < table.first_free() ? code : last));
    if (code >= table.first_free()) return fail("its pixels are broken");
    table.spell(code, [&](int position, unsigned char number) {
      const std::size_t pixel = done + static_cast<std::size_t>(position);
      if (pixel >= numbers.size()) return;
      const auto row = static_cast<std::size_t>(rows[pixel / width]);
      numbers[row * width + pixel % width] = static_cast<std::byte>(number);
    });
    done += static_cast<std::size_t>(table.length(code));
    last = code;
  }
  return true;
}

}  // namespace isl::render
