// The depth of the values that hold others of their kind, and the one limit for all of them
// (renderer/scene/value_depth.h). A loop can nest values without nesting its text:
// `#declare P = pigment { gradient x pigment_map { [0 P] [1 rgb 1] } }`. So every record has its depth from the moment
// when it is made, and readers check it at the end of a value's block.
#pragma once

#include "base/check.h"
#include "renderer/scene/edges.h"
#include "renderer/scene/value_depth.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <vector>

namespace isl::interpreter {

/// True for the columns whose records count: those that values within values are made of. Other records either hold no
/// values or, as groups do, are walked without recursion.
template <class Id>
inline constexpr bool kHasDepth = std::is_same_v<Id, scene::PigmentId> || std::is_same_v<Id, scene::PigmentMapId> ||
                                  std::is_same_v<Id, scene::NormalId> || std::is_same_v<Id, scene::NormalMapId> ||
                                  std::is_same_v<Id, scene::TextureId> || std::is_same_v<Id, scene::TexturePatternId> ||
                                  std::is_same_v<Id, scene::TextureMapId> || std::is_same_v<Id, scene::ImageId> ||
                                  std::is_same_v<Id, scene::FunctionId>;

class ValueDepths {
 public:
  /// Called for each record before it is appended to the column of Id, as number `place`.
  template <class Id, class Record>
  void append(const Record& record, [[maybe_unused]] std::size_t place) {
    if constexpr (kHasDepth<Id>) {
      auto& depths = depths_[scene::column_of<Id>()];
      ISL_DCHECK(depths.size() == place, "{} depths of {} records", depths.size(), place);
      depths.push_back(of(record));
    }
  }

  /// The depth of a record, or of one that is not in the database: 0 if it holds no pattern. What its layers are laid
  /// over counts, but layers do not count one by one, since walks over layers are loops.
  template <class Record>
  [[nodiscard]] std::uint8_t of(const Record& record) const {
    if constexpr (std::is_same_v<Record, scene::FunctionPointer>) {
      return saturated(record->pattern_depth);
    } else if constexpr (std::is_enum_v<Record>) {
      return of_id(record);
    } else {
      std::uint32_t deepest = 0;
      scene::for_each_edge(record, [&](auto id) { deepest = std::max<std::uint32_t>(deepest, of_id(id)); });
      constexpr bool kHasPattern = requires { record.pattern.kind; };
      return saturated(deepest + (kHasPattern ? 1 : 0));
    }
  }

 private:
  static std::uint8_t saturated(std::uint32_t depth) { return static_cast<std::uint8_t>(std::min(depth, 255U)); }

  template <class Id>
  [[nodiscard]] std::uint8_t of_id(Id id) const {
    if constexpr (kHasDepth<Id>) {
      if (index(id) != scene::kNone) return depths_[scene::column_of<Id>()][index(id)];
    }
    return 0;
  }

  std::array<std::vector<std::uint8_t>, std::tuple_size_v<decltype(scene::kColumns)>> depths_;
};
static_assert(scene::kMaxValueDepth < 255);

}  // namespace isl::interpreter
