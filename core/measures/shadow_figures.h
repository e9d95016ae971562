#pragma once

#include "core/describe/figure.h"
#include "core/measures/statistics.h"

namespace noonmark {

const Figures<ShadowStatistics>& shadowFigures();

}  // namespace noonmark
