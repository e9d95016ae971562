#pragma once

#include <QIODevice>

#include "core/engines/api/shadow_field.h"
#include "core/geo/frame.h"

namespace noonmark {

/// Writes a table of the receivers, RFC 4180 with a heading: x_m, y_m (local metres of the cell's centre),
/// lon_deg, lat_deg (WGS84), gross_min, and continuous_min if continuous shadow was computed. Rows run from
/// south to north, and within each from west to east. False if the device did not accept all data. About 10^6
/// rows a second.
bool writeCellsCsv(const ShadowField& field, const Frame& frame, QIODevice& device);

}  // namespace noonmark
