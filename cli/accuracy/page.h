// The report as one page that needs no other file and no network.
#pragma once

#include "cli/accuracy/pictures.h"
#include "cli/accuracy/report.h"

#include <string>

namespace isl::cli {

[[nodiscard]] std::string accuracy_page(const AccuracyReport& report, const AccuracyPictures& pictures);

}  // namespace isl::cli
