#pragma once

#include <QIODevice>

#include "core/engines/api/shadow_field.h"
#include "core/geo/frame.h"

namespace noonmark {

/// A table of the receivers, RFC 4180 with a header line: x_m, y_m (local metres of the cell's centre),
/// lon_deg, lat_deg (WGS84), gross_min, and continuous_min where runs were counted. Rows from the south, in
/// each from the west. False when the device would not take everything. Some 10^6 rows a second.
bool writeCellsCsv(const ShadowField& field, const Frame& frame, QIODevice& device);

}  // namespace noonmark
