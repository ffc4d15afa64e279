// The switches of the published solver: its optimisations (Sherstyuk 1999, §4), each measurable alone, and its normals.
// They are written after the solver's name, as in `paper:2,no-reject`. Only this table knows their names.
#pragma once

#include <string_view>

namespace isl::render {

struct PaperSwitches {
  bool on_demand = true;  ///< fields are interpolated when the ray gets there, not when they are met
  bool reject = true;     ///< stretches whose peaks do not add up to the threshold are skipped
  bool monotone = true;   ///< cubics whose control points are all on one side are not solved
  bool reuse = true;      ///< shading takes its weights from the interpolants
  bool permanent = true;  ///< clusters of fields are the lists of the grid's cells, not gathered from the whole ray
  bool pools = true;      ///< memory is kept from ray to ray
  bool eq10 = false;      ///< normals are the fields' unit normals weighted by their values, not the gradient

  friend bool operator==(const PaperSwitches&, const PaperSwitches&) = default;
};

struct PaperSwitch {
  std::string_view on, off;
  bool PaperSwitches::*is_on;
};

inline constexpr PaperSwitch kPaperSwitches[] = {
    {"on-demand", "no-on-demand", &PaperSwitches::on_demand},
    {"reject", "no-reject", &PaperSwitches::reject},
    {"monotone", "no-monotone", &PaperSwitches::monotone},
    {"reuse", "no-reuse", &PaperSwitches::reuse},
    {"permanent", "volatile", &PaperSwitches::permanent},
    {"pools", "no-pools", &PaperSwitches::pools},
    {"eq10", "no-eq10", &PaperSwitches::eq10},
};

inline constexpr PaperSwitches kPlainPaper{false, false, false, false, false, false, false};

}  // namespace isl::render
