#include "cli/options/ini_file.h"

#include "cli/options/povray_options.h"
#include "grammar/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

namespace isl::cli {
namespace {

using std::string_view;

constexpr string_view kBlanks = " \t\r\f\v";

bool is_name_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Reads one file; `begin` and `end` of its settings and remarks are offsets into the whole text.
class IniReader {
 public:
  IniReader(string_view text, string_view section) : text_(text), section_(lower_case(section)) {}

  IniSettings read() {
    for (std::size_t begin = text_.starts_with("\xEF\xBB\xBF") ? 3 : 0; begin < text_.size();) {
      const std::size_t end = std::min(text_.find_first_of("\r\n", begin), text_.size());
      read_line(begin, end);
      begin = end + 1;
    }
    if (!section_.empty() && !has_section_) refuse_section();
    return std::move(result_);
  }

 private:
  void complain(std::size_t begin, std::size_t end, std::string message, std::string hint = {}) {
    if (is_chosen_) result_.remarks.push_back({Severity::error, begin, end, std::move(message), std::move(hint)});
  }

  void refuse_section() {
    is_chosen_ = true;
    const std::string hint =
        sections_.empty() ? "it has no sections" : fmt::format("it has {}", fmt::join(sections_, ", "));
    complain(0, 0, fmt::format("there is no section [{}]", section_), hint);
  }

  void read_line(std::size_t begin, std::size_t line_end) {
    const std::size_t end = end_of_content(begin, line_end);
    begin = skip_blanks(begin, end);
    if (begin == end) return;
    if (text_[begin] == '[') {
      read_section(begin, end);
      return;
    }
    while (begin < end) begin = skip_blanks(read_setting(begin, end), end);
  }

  /// The end of the line's content: it excludes a comment and the blanks before it.
  [[nodiscard]] std::size_t end_of_content(std::size_t begin, std::size_t end) const {
    char quote = '\0';
    std::size_t place = begin;
    for (; place < end; ++place) {
      const char c = text_[place];
      if (quote != '\0') {
        if (c == quote) quote = '\0';
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == ';' || c == '#') {
        break;
      }
    }
    while (place > begin && kBlanks.find(text_[place - 1]) != string_view::npos) --place;
    return place;
  }

  [[nodiscard]] std::size_t skip_blanks(std::size_t place, std::size_t end) const {
    return std::min(text_.find_first_not_of(kBlanks, place), end);
  }

  void read_section(std::size_t begin, std::size_t end) {
    const std::size_t close = text_.find(']', begin);
    if (close >= end) {
      is_chosen_ = true;
      complain(begin, end, "expected `]` at the end of the section's name");
      return;
    }
    const string_view name = text_.substr(begin + 1, close - begin - 1);
    is_chosen_ = !section_.empty() && lower_case(name) == section_;
    has_section_ = has_section_ || is_chosen_;
    sections_.push_back(fmt::format("[{}]", name));
  }

  /// Returns the end of the setting.
  std::size_t read_setting(std::size_t begin, std::size_t end) {
    if (text_[begin] == '+' || text_[begin] == '-') return read_switch(begin, end);
    std::size_t name_end = begin;
    while (name_end < end && is_name_character(text_[name_end])) ++name_end;
    const std::size_t equals = skip_blanks(name_end, end);
    if (name_end == begin || equals == end || text_[equals] != '=') {
      complain(begin, end, fmt::format("expected `Key=value`, found `{}`", text_.substr(begin, end - begin)),
               "a comment begins with `;`");
      return end;
    }
    const string_view key = text_.substr(begin, name_end - begin);
    const std::size_t value_begin = skip_blanks(equals + 1, end);
    const std::size_t value_end = end_of_value(value_begin, end);
    if (povray_option(key) == nullptr) {
      refuse_key(key, begin, name_end);
    } else {
      add({lower_case(key), unquoted(value_begin, value_end), true, false, begin, value_end});
    }
    return value_end;
  }

  std::size_t read_switch(std::size_t begin, std::size_t end) {
    const std::size_t word_end = end_of_word(begin, end);
    auto found = povray_switch(text_.substr(begin, word_end - begin));
    if (!found) {
      complain(begin, word_end, fmt::format("POV-Ray has no switch `{}`", text_.substr(begin, word_end - begin)));
      return word_end;
    }
    const std::size_t value_begin = word_end - found->value.size();
    add({std::string(found->option->key), unquoted(value_begin, word_end), found->on, true, begin, word_end});
    return word_end;
  }

  void refuse_key(string_view key, std::size_t begin, std::size_t end) {
    std::vector<string_view> keys;
    for (const PovrayOption& option : povray_options()) keys.push_back(option.key);
    const auto similar = grammar::closest(lower_case(key), keys);
    complain(begin, end, fmt::format("POV-Ray has no setting `{}`", key),
             similar ? fmt::format("did you mean `{}`?", *similar) : "");
  }

  /// The next blank outside quotes.
  [[nodiscard]] std::size_t end_of_word(std::size_t begin, std::size_t end) const {
    char quote = '\0';
    for (std::size_t place = begin; place < end; ++place) {
      const char c = text_[place];
      if (quote != '\0') {
        if (c == quote) quote = '\0';
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (kBlanks.find(c) != string_view::npos) {
        return place;
      }
    }
    return end;
  }

  /// A value continues over blanks, since names of folders and commands have some, until another setting begins.
  [[nodiscard]] std::size_t end_of_value(std::size_t begin, std::size_t end) const {
    std::size_t value_end = end_of_word(begin, end);
    while (value_end < end) {
      const std::size_t next = skip_blanks(value_end, end);
      if (starts_setting(next, end)) break;
      value_end = end_of_word(next, end);
    }
    return value_end;
  }

  [[nodiscard]] bool starts_setting(std::size_t begin, std::size_t end) const {
    if (povray_switch(text_.substr(begin, end - begin))) return true;
    std::size_t name_end = begin;
    while (name_end < end && is_name_character(text_[name_end])) ++name_end;
    const std::size_t equals = skip_blanks(name_end, end);
    return equals < end && text_[equals] == '=' && povray_option(text_.substr(begin, name_end - begin)) != nullptr;
  }

  [[nodiscard]] std::string unquoted(std::size_t begin, std::size_t end) const {
    const string_view value = text_.substr(begin, end - begin);
    const bool is_quoted = value.size() >= 2 && value.front() == value.back() && (value[0] == '"' || value[0] == '\'');
    return std::string(is_quoted ? value.substr(1, value.size() - 2) : value);
  }

  void add(IniSetting setting) {
    if (is_chosen_) result_.settings.push_back(std::move(setting));
  }

  string_view text_;
  std::string section_;
  bool is_chosen_ = true;  ///< the settings read now apply
  bool has_section_ = false;
  std::vector<std::string> sections_;
  IniSettings result_;
};

}  // namespace

IniSettings read_ini(string_view text, string_view section) { return IniReader(text, section).read(); }

}  // namespace isl::cli
