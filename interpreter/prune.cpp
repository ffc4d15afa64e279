#include "interpreter/prune.h"

#include "interpreter/prune_column.h"
#include "interpreter/prune_functions.h"
#include "renderer/scene/edges.h"

#include <array>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace isl::interpreter {
namespace {

using scene::Database;

constexpr std::size_t kColumnCount = std::tuple_size_v<decltype(scene::kColumns)>;

class Pruner {
 public:
  explicit Pruner(Database& database) : database_(database) {
    for_each_column([this](auto& records, Column& places) { places.resize(records.size()); });
  }

  void run() {
    scene::for_each_root(database_, [this](const auto& record) { follow(record); });
    // Groups hold groups and textures hold textures: a work list instead of recursion, so that depth costs no stack.
    while (!pending_.empty()) {
      const Pending next = pending_.back();
      pending_.pop_back();
      next.follow(*this, next.record);
    }
    for_each_column([](auto& records, Column& places) { places.compact(records); });
    scene::for_each_root(database_, [this](auto& record) { renumber(record); });
    for_each_column([this](auto& records, Column& /*places*/) {
      for (auto& record : records) renumber(record);
    });
    FunctionRenumberer functions([this](scene::Pattern& pattern) { renumber(pattern); },
                                 [this](scene::Pigment& pigment) { renumber(pigment); });
    for (scene::FunctionPointer& function : database_.functions) function = functions.renumbered(function);
  }

 private:
  struct Pending {
    void (*follow)(Pruner&, std::uint32_t);
    std::uint32_t record;
  };

  template <class Visit>
  void for_each_column(const Visit& visit) {
    std::size_t i = 0;
    scene::for_each_column([&](const auto& column) { visit(database_.*column.records, places_[i++]); });
  }

  template <class Id>
  void reach(Id id) {
    constexpr std::size_t kColumn = scene::column_of<Id>();
    if (index(id) == scene::kNone || !places_[kColumn].reach(index(id))) return;
    pending_.push_back({[](Pruner& self, std::uint32_t record) {
                          self.follow((self.database_.*std::get<kColumn>(scene::kColumns).records)[record]);
                        },
                        index(id)});
  }

  /// Marks the records that this record refers to.
  template <class Record>
  void follow(const Record& record) {
    if constexpr (scene::HasEdges<const Record>) {
      scene::for_each_edge(record, [this](const auto& id) { reach(id); });
    }
  }

  void follow(const scene::FunctionPointer& function) {
    visit_records(function, {.pattern = [this](const scene::Pattern& pattern) { follow(pattern); },
                             .pigment = [this](const scene::Pigment& pigment) { follow(pigment); }});
  }

  template <class Record>
  void renumber(Record& record) {
    if constexpr (scene::HasEdges<Record>) {
      scene::for_each_edge(record, [this](auto& id) {
        using Id = std::remove_reference_t<decltype(id)>;
        if (index(id) == scene::kNone) return;
        id = Id{static_cast<std::underlying_type_t<Id>>(places_[scene::column_of<Id>()].place(index(id)))};
      });
    }
  }

  Database& database_;
  std::array<Column, kColumnCount> places_;  ///< in the order of scene::kColumns
  std::vector<Pending> pending_;
};

}  // namespace

void prune(Database& database) { Pruner(database).run(); }

}  // namespace isl::interpreter
